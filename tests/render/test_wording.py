"""Points, durations and verdicts as people read them."""

from __future__ import annotations

import pytest

from corollary.figure.colour import contrast
from corollary.render.wording import LOOKS, points, spell

POINTS = [(1, "1"), (0.5, "0.5"), (2.346, "2.35"), (10, "10"), (0, "0"), (-0.001, "0"), (1e5, "100000")]


@pytest.mark.parametrize(("value", "said"), POINTS)
def test_points_are_written_as_people_do(value, said):
    assert points(value) == said


def test_the_look_of_verdicts_differs_and_ink_is_readable():
    assert len({look.colour for look in LOOKS.values()}) == len(LOOKS)
    assert contrast("#1b1b1b", "#f5f6f8") > 7
    assert contrast("#55595f", "#f5f6f8") >= 4.5
    assert contrast("#00538a", "#ffffff") >= 4.5


LENGTHS = [
    (0.2, "0 s"),
    (59.4, "59 s"),
    (59.6, "1 min"),
    (91, "2 min"),
    (3599, "1 h"),
    (7500, "2 h 5 min"),
    (86400, "1 day"),
    (2 * 86400 + 3700, "2 days 1 h"),
]


@pytest.mark.parametrize(("seconds", "words"), LENGTHS)
def test_a_length_of_time_is_spelt_in_its_leading_units(seconds: float, words: str):
    assert spell(seconds) == words
