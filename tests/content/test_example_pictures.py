"""The example banks show what a picture is for: one to answer a question by, and one of what is to be seen."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.problem.pictures import pictures_of, unused
from corollary.problem.reader import read_problem

FIELDS = Path(__file__).parents[2] / "examples/banks/corollary-fields/src/corollary_fields/problems"


@pytest.mark.parametrize(
    ("problem", "shows", "kind"),
    [
        ("circuits/capacitor_discharge.md", ["capacitor_discharge_trace.png"], "data:image/png;"),
        ("optics/grating.md", ["grating_spots.svg"], "data:image/svg+xml;"),
    ],
)
def test_a_picture_comes_along(problem, shows, kind):
    path = FIELDS / problem
    read = read_problem(path)
    assert [each.name for each in pictures_of(path)] == shows
    assert sum(text.count(kind) for text in (read.statement, *(part.text for part in read.parts))) == 1
    assert not unused(path)
