"""Problem files written for a test, and read."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from textwrap import dedent

import pytest

from corollary.problem.diagnostic import Malformed
from corollary.problem.problem import Problem
from corollary.problem.reader import read_problem

FRONT = """\
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, from: 0.1, to: 0.9, step: 0.1, unit: kg}
  v: {is: speed, value: 3, from: 1, to: 5, step: 1, unit: m/s}
"""
BODY = """\
A cart of {{m}} rolls at {{v}}.

## Momentum {#a .value unit="kg*m/s" points=1}
How large is its momentum?
"""

Write = Callable[..., Path]


@pytest.fixture
def write(tmp_path) -> Write:
    """`write(front, body, name=…)` puts a problem below problems/carts/ and gives its path."""

    def put(front: str = FRONT, body: str = BODY, name: str = "cart") -> Path:
        path = tmp_path / "problems" / "carts" / f"{name}.md"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"---\n{dedent(front).strip()}\n---\n{dedent(body)}", encoding="utf-8")
        return path

    return put


@pytest.fixture
def read(write) -> Callable[..., Problem]:
    """A problem that can be read."""
    return lambda *words, **named: read_problem(write(*words, **named))


@pytest.fixture
def complaints(write) -> Callable[..., list[tuple[int, str]]]:
    """What is said of a problem that cannot be read: (line, sentence)."""

    def said(*words, **named) -> list[tuple[int, str]]:
        path = write(*words, **named)
        with pytest.raises(Malformed) as raised:
            read_problem(path)
        assert all(complaint.path == path for complaint in raised.value.complaints)
        assert str(raised.value).startswith("cart.md:")
        return [(complaint.line, complaint.sentence) for complaint in raised.value.complaints]

    return said
