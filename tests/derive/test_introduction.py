"""A worked solution says what its letters stand for, those that occur in it and no others."""

from __future__ import annotations

from tests.derive.conftest import ASKS, FRONT

from corollary.derive.introduction import introduced
from corollary.messages import language

STEPS = 'return derivation(step(p, "Mass times velocity.", momentum(p, m, v), answers="a"))'


def test_the_givens_that_occur_are_named(solved):
    solution = solved(STEPS)
    assert introduced(solution, solution.problem) == ["*Letters:* $m$ (mass), $v$ (speed).", ""]
    with language("de"):
        assert introduced(solution, solution.problem)[0].startswith("*Buchstaben:* $m$ (")


def test_a_given_that_stands_in_no_law_but_in_what_it_comes_to_is_named(solved):
    found = solved('return derivation(step(p, "So.", law("Two", "p = 2*q", q=m*v), answers="a"))')
    assert introduced(found, found.problem)[0] == "*Letters:* $m$ (mass), $v$ (speed)."


def test_a_constant_of_nature_has_a_line_of_its_own(solved):
    found = solved(
        'c = sympy.Symbol("c", positive=True)\nreturn derivation(step(F, "So.", law("Energy", "F = m*c^2", c=c), answers="a"))',
        front=FRONT.replace("require:", "constants: [c]\nrequire:"),
        asks=ASKS.replace("kg*m/s", "J"),
    )
    assert introduced(found, found.problem)[0] == "*Letters:* $m$ (mass)."
