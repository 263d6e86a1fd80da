"""Choices: an option said to be a mistake that is right, and options of several relations, of which exactly one must hold."""

from __future__ import annotations

import pytest

PROBLEM = """\
---
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed, value: 3, from: 1, to: 5, step: 0.1, unit: m/s}
  t: {is: time, value: 2, from: 2, to: 5, step: 0.1, unit: s}
---
A cart of {{m}} has {{v}} after {{t}}.

## Momentum {#a .value unit="kg*m/s"}
How large is it?

## Twice as fast {#b .choice}
Twice the speed, and the momentum is
- (a) the same
- (b) larger
"""
SOLUTION = """\
return derivation(
    step(p, "Mass times velocity.", momentum(p, m, v), answers="a"),
    choice("b", "It grows with the speed.", a=%s, b=%s, mistakes={"a": "It grows with the speed."}),
)
"""


@pytest.mark.parametrize(("a", "b", "ok"), [("2*p < p", "2*p > p", True), ("2*p > p", "2*p < p", False)])
def test_the_right_option_has_no_mistake(verified, a, b, ok):
    checked = verified(SOLUTION % (a, b), problem=PROBLEM, count=60)
    assert checked.ok == ok, checked.complaints
    if not ok:
        assert checked.complaints[0].startswith(
            "cart.py:10: option a of part b is right for all of 60 variants"
        )


ONE_OPTION = "exactly one option of part b holds"


@pytest.mark.parametrize(
    ("b", "why"),
    [
        ("sympy.And(v >= t, v <= 2*t)", ""),
        ("sympy.Not(sympy.Or(v < t, v > 2*t))", ""),
        ("sympy.And(v >= t, v < 2*t)", ONE_OPTION),  # none at v = 2 t
        ("sympy.And(v >= t, v <= 3*t)", ONE_OPTION),  # both at v = 3 t
    ],
)
def test_exactly_one_of_joined_options_holds(verified, b, why):
    body = f"""
import sympy
return derivation(
    step(p, "Mass times velocity.", momentum(p, m, v), answers="a"),
    choice("b", "So.", a=sympy.Or(v < t, v > 2*t), b={b}),
)
"""
    problem = PROBLEM.replace("from: 1, to: 5, step: 0.1, unit: m/s", "from: 1, to: 9, step: 0.5, unit: m/s")
    checked = verified(body, problem=problem.replace("unit: s}", "unit: m/s}"), count=60)
    said = [each for each in checked.complaints if "option" in each]
    assert why in said[0] if why else not said, checked.complaints
    (settled,) = [each for each in checked.obligations if each.claim == ONE_OPTION]
    assert settled.outcome == ("counter-example" if why else "proven")
