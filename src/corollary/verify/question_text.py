"""The question of a problem as it is handed out, before any format: looked through for what is missing, and for answers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from corollary.answers.registry import answer_type
from corollary.derive.solution import Solution
from corollary.formula.errors import Undefined
from corollary.grading.key import Key, make_key
from corollary.notebook.worksheet import Exercise, exercise
from corollary.problem.sampling import sample
from corollary.verify.checked import Tally
from corollary.verify.statement import QuestionText, formula_leaks, leaks, missing

VARIANTS = 4  # a number that is the answer in each of them is no chance


def check_question(solution: Solution, own: Key, tally: Tally) -> None:
    """Complains of answers that stand in the text, and notes givens and units that do not, and formulas of numbers asked for; `own` is the key of the chapter's numbers."""
    problem, every = solution.problem, [_question_text(own)]
    for variant in sample(problem, VARIANTS, salt="question"):
        with suppress(Undefined):  # such numbers are never dealt
            every.append(_question_text(make_key(solution, variant)))
    tally.count("statement", len(problem.givens) + len(problem.parts))
    for part, sentence in leaks(every):
        tally.complain(f"{problem.path.name}:{part.line}: {sentence}")
    for what, sentence in (*missing(every[0]), *formula_leaks(every[0])):
        tally.note(f"{problem.path.name}:{what.line}: {sentence}")


def _question_text(key: Key) -> QuestionText:
    return QuestionText(key, _texts(exercise(key.variant)))


def _texts(asked: Exercise) -> dict[str, str]:
    found = {"the statement": "\n\n".join([asked.statement, *_of_parts(asked)])}
    return found | ({"the figure": f"{asked.figure_alt} {asked.figure}"} if asked.figure else {})


def _of_parts(asked: Exercise) -> Iterator[str]:
    for prompt in asked.prompts:
        yield from (prompt.part.title, prompt.text, *(option.text for option in prompt.options))
        for name in prompt.part.answer_types:
            yield answer_type(name).heading(prompt.question)
            yield answer_type(name).blank(prompt.question)
