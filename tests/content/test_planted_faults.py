"""Faults planted in problems that hold: each is found, by the check that is named for it."""

from __future__ import annotations

import pytest
from tests.content.planted_faults import BASES, PLANTED, Base, Planted

from corollary.problem.bank import Bank, find
from corollary.problem.diagnostic import Malformed
from corollary.verify.checked import Checked
from corollary.verify.verify import verify

WORDS = {
    "printed": (" prints ",),
    "confirm": ("does not hold for the answers: a sign or a term is wrong",),
    "special case": (" at ",),
    "dimension": ("the dimensions do not fit", "the answer is not in"),
    "condition": ("cannot be compared",),
    "one root": ("2 answers (",),
    "mistake is the truth": ("100% of the draws may not be assigned",),
}
"""The sentence of each check that complains of its own."""
QUICK = (
    "impulse with a minus",
    "a little kinetic energy created",
    "the wall may just be too high",
    "slides and rests",
)


def verified(folder, base: Base) -> Checked:
    for room in ("problems", "solutions"):
        (folder / room / "carts").mkdir(parents=True)
    (folder / "problems/carts/cart.md").write_text(base.problem, encoding="utf-8")
    (folder / "solutions/carts/cart.py").write_text('"""A cart."""\n\n' + base.solution, encoding="utf-8")
    bank = Bank(folder)
    return verify(bank, find(bank, "X1.1"), 10)


def finds(folder, base: Base, check: str) -> bool:
    """Whether the check complains, or an obligation of that kind is not proven for the whole grid, with the numbers."""
    try:
        checked = verified(folder, base)
    except Malformed as error:
        return any(words in str(each) for each in error.complaints for words in WORDS.get(check, ()))
    if check == "redrawn":
        return any(each.kind == "mistake apart" and each.numbers for each in checked.obligations)
    if any(words in each for each in checked.complaints for words in WORDS.get(check, ())):
        return True
    return not checked.ok and any(
        each.kind == check and each.outcome == "counter-example" and each.numbers
        for each in checked.obligations
    )


@pytest.mark.parametrize(
    "planted",
    [
        pytest.param(each, id=each.name, marks=() if each.name in QUICK else pytest.mark.whole)
        for each in PLANTED
    ],
)
def test_each_is_found_by_its_check(tmp_path, planted: Planted):
    base = BASES[planted.base]
    assert (base.problem + base.solution).count(planted.old) == 1
    faulty = Base(*(text.replace(planted.old, planted.new) for text in (base.problem, base.solution)))
    assert finds(tmp_path, faulty, planted.check)


@pytest.mark.whole
@pytest.mark.parametrize("name", BASES)
def test_without_a_fault_they_hold(tmp_path, name):
    checked = verified(tmp_path, BASES[name])
    assert checked.ok, checked.complaints
    assert {each.outcome for each in checked.obligations} == {"proven"}


def test_there_are_enough_of_them():
    assert len({each.name for each in PLANTED}) == len(PLANTED) >= 40
    assert {each.check for each in PLANTED} >= {
        "value exists",
        "one case",
        "not created",
        "one root",
        "redrawn",
        *WORDS,
    }
