"""Points, durations and verdicts as people read them."""

from __future__ import annotations

import re
from importlib.resources import files

import pytest

from corollary.render.wording import LOOKS, points, spell

POINTS = [(1, "1"), (0.5, "0.5"), (2.346, "2.35"), (10, "10"), (0, "0"), (-0.001, "0"), (1e5, "100000")]


@pytest.mark.parametrize(("value", "said"), POINTS)
def test_points_are_written_as_people_do(value, said):
    assert points(value) == said


def test_every_verdict_has_a_colour_of_its_own():
    style = files("corollary.render").joinpath("templates", "page.css").read_text(encoding="utf-8")
    colours = {name: re.search(rf"--{name}: (#[0-9a-f]{{6}});", style) for name in LOOKS}
    assert len({found[1] for found in colours.values() if found}) == len(LOOKS)


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
