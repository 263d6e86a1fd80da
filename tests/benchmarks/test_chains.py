"""What follows from a wrong answer is carried, in every pair of parts; what does not follow is not."""

from __future__ import annotations

import pytest
from chains import measure


@pytest.mark.parametrize(
    ("code", "why"),
    [
        ("E12.3.1", "a force a million times too small, multiplied by the time in place of divided"),
        ("X12.3", "a loss of nothing, from an energy that was halved"),
        ("X12.10", "an energy that cancels, but for the rounding of the speed before"),
        ("S12.5r", "a height that goes with the tenth power of what was written in three figures"),
    ],
)
@pytest.mark.parametrize("figures", [3, pytest.param(4, marks=pytest.mark.whole)])
def test_a_chain_is_carried(code, why, figures):
    found = measure(1, figures, [code])
    assert found["chains"] > 10
    assert found["carried_percent"] == 100, (why, found["missed"])
    assert found["broken_carried"] == 0, found["missed"]


@pytest.mark.whole
def test_chains_of_the_whole_chapter_are_carried():
    found = measure(1, 3, [])
    assert found["chains"] > 2000
    assert found["carried_percent"] >= 98, found["missed"]
    assert found["broken_carried"] == 0, found["missed"]
