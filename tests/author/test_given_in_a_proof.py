"""A derivation may use what the question states, without writing why it holds, and need not write it at all."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from corollary.answers.verdict import Mistaken, Right, Unmarked, Wrong
from corollary.api import judge, load_bank, solve
from corollary.derive.load import NotDerivable
from corollary.problem.bank import Bank, find
from corollary.problem.diagnostic import Malformed

BANK = Path(__file__).with_name("bank")
GIVEN = ' given="w^2 = k/m"'


def changed(folder: Path, old: str, new: str) -> Bank:
    for name in ("problems/oscillations/spring.md", "solutions/oscillations/spring.md"):
        text = (BANK / name).read_text(encoding="utf-8")
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text.replace(old, new), encoding="utf-8")
    return Bank(folder)


def verdict(bank: Bank, *lines: str):
    return judge(find(bank, "ONE.5"), {"b": list(lines)}).parts[1].verdict


@pytest.mark.parametrize(
    "lines",
    [
        ("v = A*w", "w^2 = k/m", "v^2 = A^2*k/m", "m*v^2 = k*A^2"),
        ("v = A*w", "m*v^2 = m*A^2*w^2", "m*v^2 = k*A^2"),
        ("v = A*w", "m*v^2 = k*A^2"),
        ("k = m*w^2", "v = A*w", "m*v^2 = m*A^2*w^2", "m*v^2 = k*A^2"),
        ("w = sqrt(k/m)", "v = A*w", "v = A*sqrt(k/m)", "m*v^2 = k*A^2"),
    ],
)
def test_the_given_equation_is_a_step_that_needs_no_reason(lines):
    assert isinstance(verdict(load_bank(BANK), *lines), Right)


def test_without_it_the_same_lines_wait_for_a_person(tmp_path):
    found = verdict(changed(tmp_path, GIVEN, ""), "v = A*w", "w^2 = k/m", "m*v^2 = k*A^2")
    assert isinstance(found, Unmarked)


@pytest.mark.parametrize(
    ("lines", "kind"),
    [
        (("w^2 = k/m", "m*v^2 = k*A^2"), Wrong),  # the law is missing: that is the claim alone
        (("w^2 = k/m", "v^2 = A^2*k/m", "m*v^2 = k*A^2"), Wrong),  # that is the claim in other letters
        (("w^2 = k/m",), Wrong),  # what is given is no proof
        (("m*v^2 = k*A^2",), Wrong),
        (("v = A*w", "w^2 = m/k", "m*v^2 = k*A^2"), Wrong),
        (("v = A*w", "v^2 = A^2*w", "m*v^2 = k*A^2"), Mistaken),
    ],
)
def test_what_is_given_makes_nothing_else_right(lines, kind):
    assert isinstance(verdict(load_bank(BANK), *lines), kind)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (GIVEN, ' given="w^2 = m/k"', "w^2 = m/k is given, and does not hold for the answers"),
        (GIVEN, ' given="w^2 = k/Q"', "Q is neither given nor found"),
        (GIVEN, ' given="w^2"', "is no equation; write one, such as w^2 = k/m"),
        (GIVEN, ' given="w^2 < k/m"', "is no equation"),
        ('unit="m/s" points=1', 'unit="m/s" given="w^2 = k/m"', "only .proof parts have given equations"),
    ],
)
def test_what_cannot_be_given_is_refused(tmp_path, old, new, words):
    place = changed(tmp_path, old, new)
    with pytest.raises((NotDerivable, Malformed), match=re.escape(words)):
        solve(find(place, "ONE.5"))


def test_an_item_of_the_solution_says_the_same(tmp_path):
    place = changed(tmp_path, GIVEN, "")
    path = tmp_path / "solutions" / "oscillations" / "spring.md"
    text = path.read_text(encoding="utf-8")
    path.write_text(
        text.replace("- line: `v = A*w`", "- given: As the question says, `w^2 = k/m`\n- line: `v = A*w`"),
        encoding="utf-8",
    )
    assert isinstance(verdict(place, "v = A*w", "w^2 = k/m", "m*v^2 = k*A^2"), Right)
