"""How an answer is read is said back before it is handed in."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type
from corollary.formula.value import Real, Text
from corollary.problem.reader import read_problem

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
LINE = PROBLEM.part("a")
PLANE = replace(LINE, answer_types=("vector",), components=("x", "y"))


@pytest.mark.parametrize(
    ("part", "given", "readable", "text"),
    [
        (LINE, Text("8.6 kg m/s"), True, "read as 8.6 kg m/s (2 figures)"),
        (LINE, Text("9 kg m/s"), True, "read as 9 kg m/s (1 figure)"),
        (LINE, Real(8.612345678), True, "read as 8.61235 kg m/s"),
        (LINE, Text(""), False, "no answer yet"),
        (PLANE, Text("(3.25, 4.5) kg m/s"), True, "read as (3.25 kg m/s, 4.5 kg m/s)"),
        (PLANE, Text("(3.2, 4.5) kg m/s"), True, "read as (3.2 kg m/s, 4.5 kg m/s) (2 figures)"),
    ],
)
def test_numbers_are_said_back_with_their_figures_where_these_are_the_same(part, given, readable, text):
    found = answer_type(part.answer_type).preview(given, question_of(PROBLEM, part))
    assert (found.ok, found.text) == (readable, text)


def test_another_unit_is_no_answer_and_a_missing_one_is():
    preview = answer_type("value").preview
    wrong, missing = (preview(Text(each), question_of(PROBLEM, LINE)) for each in ("8.6 kg", "8.6"))
    assert (wrong.ok, missing.ok) == (False, True)
    assert "is a mass" in wrong.text
    assert missing.text == "read as 8.6, taken in kg m/s; better write 8.6 kg m/s"
