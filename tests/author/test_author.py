"""What a solution imports: its words, programs beside it, and inputs and judges by name."""

from __future__ import annotations

import importlib
import subprocess
import sys

import pytest

import corollary.author as author
from corollary.derive.load import load
from corollary.grading.programs import FAMILIES
from corollary.problem.bank import Bank, chapter_bank, find

PROBLEM = """\
---
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.5, unit: kg}
---
A cart.

## Momentum {#a .code function="momentum(v)"}
Program it.
"""
SOLUTION = """\
from corollary.author import code, derivation, file


def derive():
    return derivation(
        code("a", "Twice.", inputs=lambda given, draw: [], judge=print, example=file("cart/momentum.py")),
    )
"""
PROGRAM = """\
import matplotlib.pyplot as plt
import numpy as np


def momentum(v):
    import math
    return 2 * v
"""


def test_a_program_beside_the_solution_is_shown_without_the_imports_of_every_notebook(tmp_path):
    for path, text in (
        ("problems/cart.md", PROBLEM),
        ("solutions/cart.py", SOLUTION),
        ("solutions/cart/momentum.py", PROGRAM),
    ):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    bank = Bank(tmp_path)
    (entry,) = load(bank, find(bank, "X1.1")).derivation.entries
    assert entry.example == "def momentum(v):\n    import math\n    return 2 * v\n"
    assert entry.statement.line == 6


@pytest.mark.parametrize(("family", "names"), FAMILIES.items())
def test_what_a_family_offers_is_what_it_defines(family, names):
    module = importlib.import_module(f"corollary.grading.programs.{family}")
    offered = {
        name for name, value in vars(module).items()
        if callable(value) and value.__module__ == module.__name__ and (name.startswith("judge_") or name.endswith("_inputs"))
    }  # fmt: skip
    assert offered == set(names)
    for name in names:
        assert getattr(author, name).__name__ == name


def test_a_name_that_nobody_offers():
    with pytest.raises(ImportError, match="cannot import name 'judge_pendulum'"):
        from corollary.author import judge_pendulum  # noqa: F401


def test_a_judge_of_a_family_judges():
    """(k, q) as `contact()` of the cradle returns them: q = 1 sets all balls in motion."""
    called = type("Called", (), {"returned": (1e7, 1.0), "inputs": {}})
    fault = author.judge_contact({"m": 0.1, "v0": 1.0}, [called])
    assert isinstance(fault, author.Fault)
    assert "the middle ball keeps" in fault.sentence


def test_a_problem_without_a_simulation_is_solved_without_the_scenes():
    """The scenes take longer to load than the problem to solve."""
    done = subprocess.run([sys.executable, "-c", SOLVED], capture_output=True, text=True, check=True)
    assert "corollary.author" in done.stdout.split()
    assert "corollary.scenes.catalogue" not in done.stdout.split()


SOLVED = """
import sys
from corollary.derive.solve import solve
from corollary.problem.bank import chapter_bank, find
for code in ("X12.5", "S12.6"):
    assert solve(chapter_bank(), find(chapter_bank(), code)).unknowns
print(*sys.modules)
"""


def test_the_chapter_has_programs_of_both_kinds():
    entries = load(chapter_bank(), find(chapter_bank(), "P12.14")).derivation.entries
    programs = [entry for entry in entries if isinstance(entry, author.Code | author.Plot)]
    assert len(programs) == 4
    assert all("import" not in entry.example and entry.example.strip() for entry in programs)
