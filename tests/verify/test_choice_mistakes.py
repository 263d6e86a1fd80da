"""A choice whose right option is said to be a mistake: one of both is wrong."""

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
