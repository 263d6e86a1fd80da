"""How many variants there are, held against counting them one by one."""

from __future__ import annotations

import pytest

from corollary.problem.count import variants
from corollary.problem.variant import at, first_broken, size

GIVENS = """\
code: X1.1
title: A cart
given:
  a: {is: a, value: 1, from: 0, to: 6, step: 1}
  b: {is: b, value: 1, from: -3, to: 3, step: 0.5}
  c: {is: c, value: 10, from: 10, to: 90, step: 20, unit: deg}
  d: {is: d, value: 1}
"""


@pytest.mark.parametrize(
    "conditions",
    [
        "", "where: a > 2", "where: [a > b, b*b < 4]", "where: [a > 2, c < pi/3]", "require: [a*b >= d]", "where: [1/a > 0.2]",
        "where: [a != b, b != sin(c)]", "where: a > 100", "where: [sqrt(b) < 1, a < c]",
    ],
)  # fmt: skip
def test_exact_where_it_can_be(read, conditions):
    problem = read(GIVENS + conditions, "## A {#a .value}\n")
    one_by_one = sum(first_broken(at(problem, index)) is None for index in range(size(problem)))
    assert size(problem) == 7 * 13 * 5
    assert variants(problem) == (one_by_one, True)


def test_a_problem_without_givens(read):
    assert variants(read("code: X1.1\ntitle: A", "## A {#a .value}\n")) == (1, True)


def test_a_great_grid_without_conditions_is_exact(read):
    rows = "".join(f"  x{n}: {{is: x, value: 0, from: 0, to: 999, step: 1}}\n" for n in range(8))
    assert variants(read("code: X1.1\ntitle: A\ngiven:\n" + rows, "## A {#a .value}\n")) == (10**24, True)


def test_a_great_grid_tied_together_is_estimated(read):
    """Of a square, the half above the diagonal: 4000 points of a fixed sample, four standard deviations of a fair coin."""
    rows = "".join(f"  {n}: {{is: x, value: 0, from: 0, to: 999, step: 1}}\n" for n in "xy")
    number, exact = variants(
        read("code: X1.1\ntitle: A\nwhere: x < y\ngiven:\n" + rows, "## A {#a .value}\n")
    )
    assert not exact
    assert abs(number / 10**6 - 0.4995) < 4 * 0.5 / 4000**0.5 + 1e-3  # of which three figures are told
