"""Directions in words behind a number."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.answer import Formulas, Numbers, Unclear
from corollary.answers.option_names import option_named
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type
from corollary.formula.plain_text import text
from corollary.formula.value import Text
from corollary.problem.part import Option
from corollary.problem.reader import read_problem
from corollary.units.unit import unit

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
VALUE = PROBLEM.part("a")


def read(typed, part=VALUE):
    return answer_type(part.answer_type).read(Text(typed), question_of(PROBLEM, part))


@pytest.mark.parametrize(
    ("typed", "value"),
    [
        ("3 kg m/s to the right", 3), ("3 kg m/s to the left", -3), ("-3 kg m/s (to the left)", -3), ("-3 Ns, i.e. downwards", -3), ("3 Ns downwards", -3), ("3 Ns (up)", 3),
        ("3 Ns in the positive direction", 3), ("3 Ns in the negative x-direction", -3), ("3 Ns, backwards.", -3),
    ],
)  # fmt: skip
def test_a_direction_is_a_sign(typed, value):
    found = read(typed)
    assert isinstance(found, Numbers), found
    assert found.values == (value,)
    assert found.in_words


def test_a_formula_turns_too():
    assert isinstance(read("m v to the left"), Formulas)


@pytest.mark.parametrize(
    "typed",
    [
        "-3 Ns to the right",
        "-3 kg m/s to the left",
        "-3 Ns downwards",
        "3 Ns in the direction of the kick",
        "3 Ns away from the wall",
        "-3 Ns gained",
    ],
)
def test_words_that_do_not_tell_the_sign_have_two_readings(typed):
    found = read(typed)
    assert isinstance(found, Unclear)
    assert {reading.values[0] for reading in found.readings if isinstance(reading, Numbers)} == {3, -3}


def test_an_energy_has_no_direction_but_may_be_lost():
    energy = replace(VALUE, unit=unit("J"))
    turned = read("3 J to the left", energy)
    assert isinstance(turned, Unclear)
    assert not turned.readings
    found = read("a loss of 3 J", energy)
    assert isinstance(found, Numbers)
    assert found.values == (-3,)
    asked = read("a loss of 3 J", replace(energy, title="Energy lost"))
    assert isinstance(asked, Numbers)
    assert asked.values == (3,)


def test_a_formula_keeps_its_sign_where_the_words_agree():
    found = read("m*v to the right")
    assert isinstance(found, Formulas)
    assert text(found.trees[0]) == "m*v"


def test_a_choice_asks_for_one_letter():
    letter = replace(VALUE, answer_types=("choice",), options=(Option("a", "one"), Option("b", "two")))
    assert answer_type("choice").heading(question_of(PROBLEM, letter)) == "One letter."
    assert option_named(letter, "b") == "(B)"
