"""Faults planted in problems that hold: each is found, by the check that is named for it."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.content.planted_faults import BASES, PLANTED, WORDS, Planted, evidence, verified

QUICK = (
    "impulse with a minus",
    "a little kinetic energy created",
    "the wall may just be too high",
    "slides and rests",
)


@pytest.mark.parametrize(
    "planted",
    [
        pytest.param(each, id=each.name, marks=() if each.name in QUICK else pytest.mark.whole)
        for each in PLANTED
    ],
)
def test_each_is_found_by_its_check(tmp_path, planted: Planted):
    assert (BASES[planted.base].problem + BASES[planted.base].solution).count(planted.old) == 1
    assert evidence(tmp_path, planted)


@pytest.mark.whole
@pytest.mark.parametrize("name", BASES)
def test_without_a_fault_they_hold(tmp_path, name):
    checked = verified(tmp_path, BASES[name])
    assert checked.ok, checked.complaints
    dealt = [each for each in checked.obligations if not each.by.startswith("redrawn otherwise")]
    assert {each.outcome for each in dealt} == {"proven"}


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


def test_the_table_has_each_with_its_check():
    table = Path(__file__).parents[2] / "benchmarks/results/planted_faults.md"
    rows = [line.split(" | ") for line in table.read_text(encoding="utf-8").splitlines() if " | " in line]
    listed = [(row[0].removeprefix("| "), row[3]) for row in rows[1:]]
    assert listed == [(each.name, each.check) for each in PLANTED]
