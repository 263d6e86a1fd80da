"""Formulas as texts where they are least expected: what is largest, and a letter in an exponent."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from corollary.api import key, load_bank, solve
from corollary.derive.load import NotDerivable
from corollary.problem.bank import Bank, find

BANK = Path(__file__).with_name("bank")
PYTHON = '''\
"""A gutter."""
from corollary.author import derivation, optimum, step, unknowns
from corollary.laws import law


def derive(T1, V1, V2, kappa, b):
    T2, h = unknowns("T2 h")
    return derivation(
        step(T2, "No heat.", law("Adiabatic", "T2*V2^(kappa - 1) = T1*V1^(kappa - 1)"), answers="a"),
        optimum(h, "Best.", of=GOAL, over=h, between=(0, "b/2"), answers="b"),
    )
'''


def in_python(folder: Path, goal: str) -> Bank:
    problem = (BANK / "problems" / "heat" / "compression.md").read_text(encoding="utf-8")
    for name, text in (
        ("problems/gutter.md", problem),
        ("solutions/gutter.py", PYTHON.replace("GOAL", goal)),
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return Bank(folder)


def test_a_power_with_a_letter_in_its_exponent_and_an_optimum_in_text():
    found = key(solve(find(load_bank(BANK), "ONE.4")))
    assert found.truths["a"].values == pytest.approx((295 * (2.0 / 0.8) ** 0.4,), rel=1e-12)
    assert found.truths["b"].values == pytest.approx((0.30 / 4,), rel=1e-12)  # twice as wide as high


@pytest.mark.parametrize("goal", ['"h*(b - 2*h)"', "h*(b - 2*h)"])
def test_the_python_word_takes_a_text_too(tmp_path, goal):
    found = key(solve(find(in_python(tmp_path, goal), "ONE.4")))
    assert found.truths["b"].values == pytest.approx((0.075,), rel=1e-12)


def test_a_letter_without_a_meaning_is_named(tmp_path):
    with pytest.raises(NotDerivable, match=re.escape("what does w mean")):
        solve(find(in_python(tmp_path, '"h*(b - 2*w)"'), "ONE.4"))
