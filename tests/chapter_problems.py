"""The chapter's problems, read once for all lists of cases."""

from corollary.problem.bank import chapter_bank, load

PROBLEMS = load(chapter_bank())
