"""Physics as a question: statements, givens, parts, variants, problem sets. Nothing here knows an answer."""
