"""What statements must say for their answer to be the only one."""

from __future__ import annotations

import re

import pytest
from tests.chapter_problems import PROBLEMS

from corollary.problem.bank import chapter_bank, find

BANK = chapter_bank()
FORWARD_EULER = re.compile(r"forward Euler.*not accepted|the Euler–Cromer method", re.IGNORECASE)


def statement(code: str) -> str:
    problem = find(BANK, code)
    return " ".join([problem.statement, *(part.text for part in problem.parts)]).replace("\n", " ")


def test_what_is_elastic_is_said_where_balls_are_compared():
    """A ball may bounce and lose energy all the same; only then is the ratio of the impulses 2."""
    text = statement("X12.9")
    assert "the collision is elastic: ball and book together lose no kinetic energy" in text
    assert "which stays on the book" in text
    assert "nothing holds it" in text


@pytest.mark.parametrize(
    "code",
    [
        problem.code
        for problem in PROBLEMS
        if any("dt" in part.text and "code" in part.answer_types for part in problem.parts)
    ],
)
def test_a_program_that_steps_is_told_which_methods_count(code):
    assert FORWARD_EULER.search(statement(code)), code
