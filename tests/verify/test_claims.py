"""Limits and special cases that an author claims: proven, or said with line and what holds instead."""

from __future__ import annotations

import pytest

STEPS = """\
return derivation(
    step(p, "Mass times velocity.", momentum(p, m, v), answers="a"),
    step(F, "Per time.", mean_force(F, p, t), answers="b"),
    CLAIM,
)
"""


@pytest.mark.parametrize(
    "claim",
    [
        "limit(F, t, oo, 0)",
        "limit(1/t**2 + F*0, t, 0, oo)",
        "limit(F, v, 0, 0, 'who stands needs no force')",
        "limit((m*(v + t) - m*v)/t, t, 0, m)",
        "at(v=0, p=0, F=0)",
        "at('as if', m=3*p/v, p=F*t)",
        "at(F=p/t)",
    ],
)
def test_what_holds_is_proven(verified, claim):
    checked = verified(STEPS.replace("CLAIM", claim))
    assert checked.ok, checked.complaints
    assert checked.checks["laws put back"] == 3  # two laws, and the claim


@pytest.mark.parametrize(
    ("claim", "words"),
    [
        ("limit(F, v, 0, F)", "the limit of F for v to 0 is 0, not F"),
        ("limit(p, t, 0, 0)", "it does not depend on t, it is m*v everywhere"),
        ("limit(F, F, 0, 0)", "F is found, and depends on givens"),
        ("at(F=2*p/t)", "at any numbers: F is m*v/t, not 2*p/t"),
        ("at(v=0)", "at v = 0: it claims nothing"),
        ("at(q=0, p=0)", "q is neither given nor found"),
        ("at(t=0, F=0)", "at t = 0: F has no value"),
    ],
)
def test_what_does_not_hold_is_said_with_its_line(verified, claim, words):
    checked = verified(STEPS.replace("CLAIM", claim))
    assert len(checked.complaints) == 1, checked.complaints
    assert checked.complaints[0].startswith("cart.py:11: ")
    assert words in checked.complaints[0]


@pytest.mark.parametrize(
    ("claim", "where"),
    [
        ("at(v=0, p=m)", "at v = 0: "),
        ("at(v=t, F=m)", "at v = t: "),
        ("at(m=2.5, F=2.5*v/t)", "at m = 5/2: "),
        ("at(F=p)", "at any numbers: "),
        ("limit(F, t, oo, 1)", "the limit of F for t to oo: "),
        ("limit(F, t, 2, m*v/t)", "the limit of F for t to 2: "),
    ],
)
def test_what_is_set_equal_measures_the_same(verified, claim, where):
    complaints = verified(STEPS.replace("CLAIM", claim)).complaints
    assert complaints
    assert all(each.startswith(f"cart.py:11: {where}") for each in complaints), complaints
    assert all("cannot be compared" in each for each in complaints), complaints


@pytest.mark.parametrize(
    ("condition", "outcome"),
    [
        ("Or(v < 0, t > 0)", "proven"),
        ("Not(And(v < 0, t > 0))", "proven"),
        ("And(Or(v < 0, t > 0), Or(p > 0, F < 0))", "proven"),
        ("Or(v < 0, t < 0)", "counter-example"),
        ("And(Or(v < 0, t > 0), Or(p < 0, F < 0))", "counter-example"),
    ],
)
def test_what_is_always_so_joins_relations(verified, condition, outcome):
    body = "from sympy import And, Not, Or\n" + STEPS.replace("CLAIM", f'always("it moves", {condition})')
    (claimed,) = [each for each in verified(body).obligations if each.kind == "claimed"]
    assert claimed.outcome == outcome
