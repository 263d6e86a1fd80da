"""What a solution imports: its words, programs beside it, and the files of their judges."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

import corollary.author as author
from corollary.derive.load import load
from corollary.grading.programs.convergence import Called
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


JUDGE = """\
import numpy as np
from corollary.programs import Fault

TWICE = 2.0


def cart_inputs(given, draw):
    return [{"v": given["m"]}, {"v": draw(1.0, 2.0)}]


def judge_cart(given, called, factor=TWICE):
    wrong = [each for each in called if not np.allclose(each.returned, factor * each.inputs["v"])]
    return Fault(f"{len(wrong)} calls are wrong.") if wrong else None
"""


def test_a_judge_beside_the_solution_is_loaded_when_it_is_first_called(tmp_path):
    """What it imports may take a while: until then it is a name, checked against the file."""
    (tmp_path / "judge_cart.py").write_text(JUDGE, encoding="utf-8")
    cart = author.module(str(tmp_path / "judge_cart.py"))
    with forgotten("corollary.programs"):
        judge, inputs = cart.judge_cart, cart.cart_inputs
        assert judge.__name__ == "judge_cart"
        assert "corollary.programs" not in sys.modules
        cases = inputs({"m": 0.5}, lambda low, high: low)
        assert cases == [{"v": 0.5}, {"v": 1.0}]
        assert "corollary.programs" in sys.modules
    called = [Called(case, (2 * case["v"],)) for case in cases]
    assert judge({}, called) is None
    assert judge({}, called, factor=3.0).sentence == "2 calls are wrong."
    assert cart.TWICE == 2.0


@contextmanager
def forgotten(name: str) -> Iterator[None]:
    """A module as if nobody had imported it yet."""
    before = sys.modules.pop(name, None)
    try:
        yield
    finally:
        if before is not None:
            sys.modules[name] = before


def test_a_judge_that_is_not_there_is_named(tmp_path):
    (tmp_path / "judge_cart.py").write_text(JUDGE, encoding="utf-8")
    with pytest.raises(
        AttributeError, match=r"judge_cart\.py has no judge_car \(did you mean judge_cart\?\)"
    ):
        _ = author.module(str(tmp_path / "judge_cart.py")).judge_car
    with pytest.raises(FileNotFoundError, match=r"there is no file judge_tram\.py in .*"):
        author.module(str(tmp_path / "judge_tram.py"))


def test_a_judge_of_the_chapter_judges():
    """(k, q) as `contact()` of the cradle returns them: q = 1 sets all balls in motion."""
    entries = load(chapter_bank(), find(chapter_bank(), "P12.14")).derivation.entries
    (contact,) = (each for each in entries if isinstance(each, author.Code) and each.statement.part == "j")
    fault = contact.judge({"m": 0.1, "v0": 1.0}, [Called({}, (1e7, 1.0))])
    assert isinstance(fault, author.Fault)
    assert "the middle ball keeps" in fault.sentence


def test_a_problem_without_a_simulation_is_solved_without_the_scenes():
    """The scenes take longer to load than the problem to solve, and so does what judges its programs."""
    done = subprocess.run([sys.executable, "-c", SOLVED], capture_output=True, text=True, check=True)
    assert "corollary.author" in done.stdout.split()
    assert not {"corollary.derive.ready_scenes", "corollary.programs", "numpy"} & set(done.stdout.split())


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
