"""Variants: an index is a point of the grid and back, and no value is ever rounded."""

from __future__ import annotations

import re
from fractions import Fraction
from math import pi, prod

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.chapter_problems import PROBLEMS

from corollary.problem.bank import chapter_bank, find
from corollary.problem.statement import filled
from corollary.problem.variant import OutOfRange, at, chapter, chosen, first_broken, in_print, size, written


def place(variant) -> int:
    """The index, worked out from the values alone."""
    index = 0
    for given_ in variant.problem.givens:
        steps = (variant.values[given_.symbol] - given_.grid.first) / (given_.grid.step or 1)
        assert steps.denominator == 1
        assert 0 <= steps < given_.grid.count
        index = index * given_.grid.count + int(steps)
    return index


@given(st.sampled_from(PROBLEMS), st.integers(0, 2**80))
def test_an_index_is_a_point_of_the_grid_and_back(problem, number):
    index = number % size(problem)
    assert place(at(problem, index)) == index


def test_a_small_grid_is_walked_once_and_whole(read):
    problem = read()
    every = [tuple(at(problem, index).values.values()) for index in range(size(problem))]
    assert len(set(every)) == len(every) == 9 * 5
    assert every[0] == (Fraction(1, 10), 1)
    assert every[-1] == (Fraction(9, 10), 5)


@pytest.mark.parametrize("index", [-1, 45])
def test_beyond_the_grid(read, index):
    with pytest.raises(OutOfRange, match="variants 0 to 44"):
        at(read(), index)


@given(st.sampled_from(PROBLEMS), st.integers(0, 2**80))
def test_si_values_are_the_nearest_doubles(problem, number):
    variant = at(problem, number % size(problem))
    for given_ in problem.givens:
        exact = variant.values[given_.symbol] * given_.unit.factor
        value = variant.si[given_.symbol]
        if given_.unit.pi == 0:
            assert value == float(exact)
        else:
            assert value == pytest.approx(float(exact) * pi**given_.unit.pi, rel=4e-16)


def test_the_chapters_own_numbers_keep_the_physics():
    for problem in PROBLEMS:
        assert first_broken(chapter(problem), hard_only=True) is None
        assert prod(given_.grid.count for given_ in problem.givens) == size(problem)


FRONT = """\
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: -1, to: 1, step: 0.5, unit: kg}
  d: {is: depth, value: 30, unit: cm}
require:
  - m > 0
  - 1/d > 2 1/m
where: m != 0.5 kg
"""


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"M": 1}, r"M is not among the givens of X1\.1 \(m, d\)"),
        ({"m": 0}, r"X1\.1 needs m > 0, but m = 0\.0\s*kg"),
        ({"m": Fraction(-1, 2)}, "needs m > 0, but m = −0.5"),
        ({"d": 0}, r"needs 1/d > 2 1/m, but d = 0\s*cm"),
        ({"d": 60}, "needs 1/d > 2 1/m"),
    ],
)
def test_values_against_the_physics(read, values, words):
    with pytest.raises(OutOfRange, match=words):
        chosen(
            read(FRONT, "{{m}}\n\n## A {#a .value}\n"),
            {name: Fraction(value) for name, value in values.items()},
        )


def test_values_by_hand_may_lie_anywhere_the_physics_holds(read):
    variant = chosen(read(FRONT, "{{m}}\n\n## A {#a .value}\n"), {"m": Fraction(10) ** 150})
    assert variant.si == {"m": 1e150, "d": 0.3}
    assert variant.index is None
    assert variant.label == "X1.1#own"
    assert first_broken(variant) is None


def test_drawing_keeps_where_too(read):
    problem = read(FRONT, "{{m}}\n\n## A {#a .value}\n")
    kept = [
        at(problem, index).values["m"]
        for index in range(size(problem))
        if first_broken(at(problem, index)) is None
    ]
    assert kept == [1]


@pytest.mark.parametrize(
    ("row", "index", "text"),
    [
        ("{is: x, value: 0.5, from: 0, to: 1, step: 0.25, unit: kg}", 2, "0.50 kg"),
        ("{is: x, value: 30, unit: deg}", 0, "30°"),
        ("{is: x, value: -1.5, unit: m/s}", 0, "−1.5 m/s"),
        ("{is: x, value: 3}", 0, "3"),
        ("{is: x, value: 6.6e-34, unit: J s}", 0, "6.6 · 10⁻³⁴ J s"),
        ("{is: x, value: -12e7, unit: m}", 0, "−1.2 · 10⁸ m"),
        ("{is: x, value: 1.20e-5, unit: 1/K}", 0, "1.20 · 10⁻⁵ 1/K"),
        ("{is: x, value: 6.40e23, unit: kg}", 0, "6.40 · 10²³ kg"),
        ("{is: x, value: 6.40e3, unit: kg}", 0, "6400 kg"),
        ("{is: x, value: 3e-5, from: 1e-5, to: 9e-5, step: 0.5e-5, unit: m}", 4, "3.0 · 10⁻⁵ m"),
        ("{is: x, value: 1/3, unit: m}", 0, "0.333333 m"),
    ],
)
def test_a_given_as_it_is_read(read, row, index, text):
    problem = read(
        f"code: X1.1\ntitle: A\ngiven:\n  x: {row}", "{{x}} and {{ x | number }}\n\n## A {#a .value}\n"
    )
    variant = at(problem, index)
    assert written(variant, "x").replace("\N{NO-BREAK SPACE}", " ").startswith(text)
    first, second = filled(problem.statement, variant).split(" and ")
    assert first == written(variant, "x")
    assert first.startswith(in_print(second))


def test_values_that_differ_are_told_apart_in_the_sentence_that_says_so():
    """The atom needs d < b: with values that agree in six figures the sentence shows the others, too."""
    problem = find(chapter_bank(), "catching_an_atom")
    b = Fraction("0.18380000000001")
    with pytest.raises(OutOfRange) as refused:
        chosen(problem, {"b": b, "d": b + Fraction(1, 10**13)})
    found = dict(re.findall(r"(\w+) = (\S+)", str(refused.value)))
    assert Fraction(found["d"]) > Fraction(found["b"])
