"""Small problems with solutions, written for a test."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from textwrap import dedent, indent

import pytest

from corollary.derive.load import NotDerivable
from corollary.derive.solution import Solution
from corollary.derive.solve import solve
from corollary.problem.bank import Bank
from corollary.problem.reader import read_problem

FRONT = """\
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.1, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed, value: 3, from: 1, to: 5, step: 1, unit: m/s}
  t: {is: time, value: 2, from: 1, to: 4, step: 1, unit: s}
require:
  - m > 0
  - v > 0
  - t > 0
"""
ASKS = '## Momentum {#a .value unit="kg*m/s" points=1}\nHow large?\n'
OPENING = """\
\"\"\"A cart.\"\"\"
import sympy
from corollary.author import *
from corollary.laws import *

def derive(m, v, t):
    p, q, F = unknowns("p q F")
"""
"""The body of derive begins on line 8."""

Make = Callable[..., Bank]


@pytest.fixture
def make(tmp_path) -> Make:
    """`make(body, asks=…)` puts a problem and its solution into a bank; `body` is the body of derive, `whole` the whole file."""

    def put(
        body: str = "", *, asks: str = ASKS, front: str = FRONT, whole: str | bytes | None = None
    ) -> Bank:
        problem, solution = (tmp_path / folder / "carts" for folder in ("problems", "solutions"))
        for folder in (problem, solution):
            folder.mkdir(parents=True, exist_ok=True)
        (problem / "cart.md").write_text(f"---\n{front}---\nA cart.\n\n{asks}", encoding="utf-8")
        source = OPENING + indent(dedent(body).strip("\n"), "    ") + "\n" if whole is None else whole
        (solution / "cart.py").write_bytes(source if isinstance(source, bytes) else source.encode())
        return Bank(tmp_path)

    return put


def problem_of(bank: Bank):
    return read_problem(bank.problems / "carts" / "cart.md")


@pytest.fixture
def solved(make) -> Callable[..., Solution]:
    def solve_it(*words, **named) -> Solution:
        bank = make(*words, **named)
        return solve(bank, problem_of(bank))

    return solve_it


@pytest.fixture
def refused(make) -> Callable[..., tuple[int, str]]:
    """What is said of a solution that does not derive what it should: (line, sentence)."""

    def said(*words, **named) -> tuple[int, str]:
        bank = make(*words, **named)
        with pytest.raises(NotDerivable) as raised:
            solve(bank, problem_of(bank))
        assert raised.value.path == Path(bank.folder / "solutions" / "carts" / "cart.py")
        assert str(raised.value).startswith("cart.py:")
        assert "\n" not in str(raised.value)
        return raised.value.line, raised.value.sentence

    return said
