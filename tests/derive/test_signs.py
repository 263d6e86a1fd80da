"""What conditions say of the signs of givens."""

from __future__ import annotations

import pytest

from corollary.derive.given_signs import symbol_of
from corollary.problem.reader import read_problem

PROBLEM = """\
---
code: S.1
title: Signs
given:
  a: {is: a, value: 2, from: 1, to: 3, step: 1}
  b: {is: b, value: 5, from: 4, to: 6, step: 1}
  c: {is: c, value: 8, from: 7, to: 9, step: 1}
require:
REQUIRE
---
?

## A {#a .value}
?
"""


def signs(tmp_path, *require):
    path = tmp_path / "signs.md"
    path.write_text(
        PROBLEM.replace("REQUIRE", "\n".join(f"  - {each}" for each in require)), encoding="utf-8"
    )
    problem = read_problem(path)
    return {name: symbol_of(problem, name) for name in "abc"}


@pytest.mark.parametrize(
    ("require", "positive", "nonnegative"),
    [
        (["0 < a < b"], "ab", "ab"),
        (["0 <= a < b <= c"], "bc", "abc"),
        (["0 <= a <= b"], "", "ab"),
        (["c > b", "b > a", "a >= 0"], "bc", "abc"),
        (["a < b"], "", ""),
        (["0 < a", "b < a"], "a", "a"),
    ],
)
def test_a_chain_from_zero_makes_positive(tmp_path, require, positive, nonnegative):
    found = signs(tmp_path, *require)
    assert "".join(name for name in found if found[name].is_positive) == positive
    assert "".join(name for name in found if found[name].is_nonnegative) == nonnegative


def test_a_chain_to_zero_makes_negative(tmp_path):
    found = signs(tmp_path, "-100 < a < b <= 0")
    assert found["a"].is_negative
    assert found["b"].is_nonpositive
    assert found["b"].is_negative is None
