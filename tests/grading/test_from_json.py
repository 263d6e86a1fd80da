"""Answers of JSON, and what else an author's hand may give, as inert data."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from corollary.formula.value import Exact, Items, Named, Nothing, Real, Refused, Text
from corollary.grading.from_json import finite, from_json


@pytest.mark.parametrize(
    ("given", "value"),
    [
        (None, Nothing()),
        (3, Exact(Fraction(3))),
        (Fraction(1, 3), Exact(Fraction(1, 3))),
        (2.5, Real(2.5)),
        ("3 m", Text("3 m")),
        ([1, [2]], Items((Exact(Fraction(1)), Items((Exact(Fraction(2)),), (1,))), (2,))),
        ([[1.0, 2.0], [3.0, 4.0]], Items((Items((Real(1.0), Real(2.0)), (2,)), Items((Real(3.0), Real(4.0)), (2,))), (2, 2))),
        ({"W": "3 N down"}, Named(("W",), (Text("3 N down"),))),
    ],
)  # fmt: skip
def test_json_is_data(given, value):
    assert from_json(given) == value


@pytest.mark.parametrize(
    ("given", "kind"), [({}, "dict"), ({1, 2}, "set"), (b"3", "bytes"), (object(), "object")]
)
def test_what_no_answer_is_is_refused_by_its_name(given, kind):
    assert from_json(given) == Refused("has a type that no answer can have", kind)


def test_true_is_no_number():
    assert isinstance(from_json(True), Refused)


def test_numbers_beyond_the_doubles_are_words():
    assert [finite(each) for each in (1.5, math.inf, -math.inf, math.nan)] == [1.5, "inf", "-inf", "nan"]
