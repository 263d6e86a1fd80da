"""What students read of the chapter before they answer, in every format: all that is given and asked, with units, and no answer."""

from __future__ import annotations

from functools import cache

import pytest
from tests.chapter_problems import PROBLEMS
from tests.content.question_texts import question_texts
from tests.pdf_text import text_of

from corollary.derive.solution import Solution
from corollary.grading.assign import admitted
from corollary.grading.key import Key
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import exercise
from corollary.problem.bank import chapter_bank, find
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.roster import Student
from corollary.problem.sampling import sample
from corollary.problem.statement import holes
from corollary.render.targets.pdf import write_exercise
from corollary.verify.question_text import QuestionText, leaks, missing

BANK = chapter_bank()
SOLUTIONS = Solutions(BANK)
VARIANTS = 5
QUICK = ("X12.5",)
LMS = ("the Moodle question", "the QTI item")


@cache
def keys(code: str) -> tuple[Key, ...]:
    solution: Solution = SOLUTIONS.of(find(BANK, code))
    every = (admitted(solution, variant)[0] for variant in sample(solution.problem, 40))
    return tuple(
        key for key, _ in zip((each for each in every if each is not None), range(VARIANTS), strict=False)
    )


def texts(key: Key) -> dict[str, str]:
    found = question_texts(SOLUTIONS, key)
    return found | {"the PDF": text_of(write_exercise(exercise(key.variant), Student("", ""), ""))}


def not_for_this_text(what: Part | Given, key: Key, text: str) -> bool:
    """Whether it is a part that the LMS cannot ask, or whose unit is typed there; or a given that only parts not asked name."""
    problem = key.variant.problem
    if isinstance(what, Part):
        return what.title not in text or "and its unit" in text  # which the student is asked to write
    asked = [problem.statement, *(part.text for part in problem.parts if part.title in text)]
    return not any(what.symbol in hole.letters for each in asked for hole in holes(each))


def faults(code: str) -> list[str]:
    every = [QuestionText(key, texts(key)) for key in keys(code)]
    found = [sentence for _, sentence in leaks(every)]
    for shown in every[:2]:
        for name, text in shown.texts.items():
            if name == "the figure" or name.endswith("each part alone"):
                continue
            for what, sentence in missing(QuestionText(shown.key, {name: text})):
                if not (name in LMS and not_for_this_text(what, shown.key, text)):
                    found.append(f"{name}: {sentence}")
    return found


@pytest.mark.parametrize(
    "code",
    [
        pytest.param(problem.code, marks=() if problem.code in QUICK else pytest.mark.whole)
        for problem in PROBLEMS
    ],
)
def test_all_that_is_asked_is_said_and_no_answer(code: str) -> None:
    assert not faults(code)
