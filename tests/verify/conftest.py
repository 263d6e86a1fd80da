"""A problem and its solution written for a test, and verified."""

from __future__ import annotations

from collections.abc import Callable
from textwrap import dedent, indent

import pytest

from corollary.problem.bank import Bank, find
from corollary.verify.checked import Checked
from corollary.verify.verify import verify

PROBLEM = """\
---
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.2, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed, value: 3, from: 1, to: 5, step: 1, unit: m/s}
  t: {is: time, value: 2, from: 2, to: 5, step: 1, unit: s}
require:
  - m > 0
---
A cart. It is of {{m}}, and has {{v}} after {{t}}.

## Momentum {#a .value unit="kg*m/s"}
How large?

## Force {#b .value unit="N"}
How large?
"""
OPENING = '''\
"""A cart."""

from corollary.author import *
from corollary.laws import *

def derive(m, v, t):
    p, F = unknowns("p F")
'''
GOOD = """\
return derivation(
    step(p, "Mass times velocity.", momentum(p, m, v), answers="a"),
    step(F, "Per time.", mean_force(F, p, t), answers="b",
         mistakes=[mistake("You multiplied.", law("F", "F = p*t", F=F, p=p, t=t))]),
    printed("a", "1.5 kg m/s", "(1.1)"),
)
"""


@pytest.fixture
def verified(tmp_path) -> Callable[..., Checked]:
    """`verified(body, more, problem)`: the body of derive (from line 8), what stands below it, and the problem's text."""

    def put(body: str = GOOD, more: str = "", problem: str = PROBLEM, count: int = 20) -> Checked:
        for folder in ("problems", "solutions"):
            (tmp_path / folder / "carts").mkdir(parents=True)
        (tmp_path / "problems" / "carts" / "cart.md").write_text(problem, encoding="utf-8")
        text = OPENING + indent(dedent(body), "    ") + more
        (tmp_path / "solutions" / "carts" / "cart.py").write_text(text, encoding="utf-8")
        bank = Bank(tmp_path)
        return verify(bank, find(bank, "X1.1"), count)

    return put


@pytest.fixture
def good() -> str:
    return GOOD


@pytest.fixture
def problem() -> str:
    return PROBLEM
