"""Files beside a solution: imported or loaded late, read anew when they change, forgotten afterwards, and part of its state."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType

import pytest

from corollary.derive.load import NotDerivable, source, sources
from corollary.derive.statements import Code
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.problem.variant import chapter
from corollary.programs import Called

PROBLEM = """\
---
code: {code}
title: A cart
given:
  m: {{is: mass, value: 0.5, unit: kg}}
  v: {{is: speed, value: 3, unit: m/s}}
---
A cart.

## Momentum {{#a .value unit="kg*m/s"}}
How large?
"""
SOLUTION = """\
from corollary.author import derivation, unknowns
from momenta import momentum_step


def derive(m, v):
    p, = unknowns("p")
    return derivation(momentum_step(p))
"""
HELPER = """\
from corollary.author import step
from corollary.laws import law
from formulas import FORMULA


def momentum_step(p):
    return step(p, "So.", law("Momentum", FORMULA), answers="a")
"""


def bank(folder: Path, formula: str) -> tuple[Bank, Problem]:
    for name, text in {
        "problems/carts/cart.md": PROBLEM.format(code="X1.1"),
        "solutions/carts/cart.py": SOLUTION,
        "solutions/carts/momenta.py": HELPER,
        "solutions/carts/formulas.py": f"FORMULA = {formula!r}\n",
    }.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    here = Bank(folder)
    return here, here["X1.1"]


def momentum(here: Bank, problem: Problem) -> float:
    """By a new command: what is cached counts, what is in memory does not."""
    return Solutions(here).key(chapter(problem)).truths["a"].values[0]


def test_a_module_beside_a_solution_is_imported_and_read_anew(tmp_path):
    here, problem = bank(tmp_path, "p = m*v")
    assert momentum(here, problem) == 1.5
    before = source(here, problem)
    bank(tmp_path, "p = v*m + m*v")
    assert momentum(here, problem) == 3.0
    assert source(here, problem) != before
    assert not list(tmp_path.rglob("*.pyc"))


def test_two_banks_may_have_modules_of_one_name(tmp_path):
    one, other = bank(tmp_path / "one", "p = m*v"), bank(tmp_path / "other", "p = 2*m*v")
    assert [momentum(*one), momentum(*other), momentum(*one)] == [1.5, 3.0, 1.5]
    assert not {"momenta", "formulas"} & sys.modules.keys()
    assert not any("one" in each and "solutions" in each for each in sys.path)


def test_a_module_that_fails_is_named(tmp_path):
    here, problem = bank(tmp_path, "p = m*v")
    (tmp_path / "solutions" / "carts" / "formulas.py").write_text("FORMULA = 1/0\n")
    with pytest.raises(NotDerivable, match=r"^formulas.py:1: cannot be loaded: ZeroDivisionError"):
        momentum(here, problem)
    (tmp_path / "solutions" / "carts" / "formulas.py").write_text("FORMULA = (\n")
    with pytest.raises(NotDerivable, match=r"^formulas.py:1: is not Python: '\(' was never closed"):
        momentum(here, problem)


PROGRAM = """\
from corollary.author import code, derivation, file, module, step, unknown
from corollary.laws import law

CART = module("cart/judge_cart.py")


def derive(m, v):
    return derivation(
        step(unknown("p"), "So.", law("Momentum", "p = m*v"), answers="a"),
        code("b", "So.", inputs=CART.cart_inputs, judge=CART.judge_cart, example=file("cart/program.py")),
    )
"""
JUDGE = """\
from dataclasses import dataclass
from constants import TWICE
from momenta import momentum


@dataclass(frozen=True)
class Cart:
    m: float
    v: float


def cart_inputs(given, draw):
    from late import MASS
    return [{"m": MASS, "v": draw(1.0, 2.0)}]


def judge_cart(given, called):
    cart = Cart(2.0, called[0].inputs["v"])
    return None if called[0].returned == (TWICE * momentum(cart),) else Fault("No.")
"""
JUDGED = {
    "cart/judge_cart.py": JUDGE,
    "cart/constants.py": "TWICE = 2.0\n",
    "cart/late.py": "MASS = 2.0\n",
    "momenta.py": "def momentum(cart):\n    return cart.m * cart.v\n",
    "cart/program.py": "def momentum(m, v):\n    return 2 * m * v\n",
}


def judged_bank(folder: Path) -> tuple[Bank, Problem]:
    """A problem with a program, whose judge lies in a folder with what it imports, and imports what lies beside the solution."""
    here, problem = bank(folder, "p = m*v")
    problem.path.write_text(
        PROBLEM.format(code="X1.1") + '\n## Program {#b .code function="momentum(m, v)"}\nProgram it.\n',
        encoding="utf-8",
    )
    for name, text in {"cart.py": PROGRAM, **JUDGED}.items():
        path = folder / "solutions" / "carts" / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return here, here["X1.1"]


def code_of(here: Bank, problem: Problem) -> Code:
    (entry,) = (each for each in Solutions(here).of(problem).entries if isinstance(each, Code))
    return entry


def test_a_judge_imports_what_lies_in_its_folder_and_beside_the_solution_and_is_forgotten(tmp_path):
    one, other = judged_bank(tmp_path / "one"), judged_bank(tmp_path / "other")
    (tmp_path / "other/solutions/carts/cart/constants.py").write_text("TWICE = 3.0\n")
    entries, path = [code_of(*one), code_of(*other)], list(sys.path)
    for entry, factor in zip(entries * 2, (2.0, 3.0) * 2, strict=True):
        (inputs,) = entry.inputs({}, lambda low, high: high)
        assert inputs == {"m": 2.0, "v": 2.0}
        assert entry.judge({}, [Called(inputs, (factor * 4.0,))]) is None
    assert sys.path == path
    assert not any(
        "/solutions/" in (getattr(module, "__file__", None) or "") for module in [*sys.modules.values()]
    )
    assert not list(tmp_path.rglob("*.pyc"))


def test_a_module_of_that_name_that_is_loaded_already_is_in_nobodys_way(tmp_path, monkeypatch):
    here, problem = judged_bank(tmp_path)
    others = {name: ModuleType(name) for name in ("constants", "momenta", "late")}
    for name, module in others.items():
        monkeypatch.setitem(sys.modules, name, module)
    entry = code_of(here, problem)
    (inputs,) = entry.inputs({}, lambda low, high: high)
    assert entry.judge({}, [Called(inputs, (8.0,))]) is None
    assert {name: sys.modules[name] for name in others} == others


@pytest.mark.parametrize("name", JUDGED)
def test_a_change_of_a_judge_of_what_it_imports_and_of_an_example_is_a_change_of_the_solution(tmp_path, name):
    here, problem = judged_bank(tmp_path)
    before = source(here, problem)
    assert source(here, problem) == before
    file = tmp_path / "solutions" / "carts" / name
    file.write_text(file.read_text() + "# changed\n")
    assert source(here, problem) != before


def test_a_judge_that_is_edited_is_the_one_that_judges(tmp_path):
    here, problem = judged_bank(tmp_path)
    call = Called({"v": 1.0}, (8.0,))
    assert code_of(here, problem).judge({}, [Called({"v": 1.0}, (4.0,))]) is None
    file = tmp_path / "solutions" / "carts" / "cart" / "judge_cart.py"
    file.write_text(JUDGE.replace("Cart(2.0", "Cart(4.0"))
    assert code_of(here, problem).judge({}, [call]) is None


@pytest.mark.parametrize(
    "text", ["long" * 80 + ".py", "one\ntwo.py", "nul\0.py", "/nowhere/at/all.py", "..py"]
)
def test_a_text_that_ends_like_a_file_and_is_none_does_no_harm(tmp_path, text):
    here, problem = judged_bank(tmp_path)
    before = sources(here, problem)
    file = tmp_path / "solutions" / "carts" / "cart.py"
    file.write_text(PROGRAM + f"\n\nTEXT = {text!r}\n")
    assert sources(here, problem).keys() == before.keys()
