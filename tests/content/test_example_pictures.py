"""The example banks show what a picture is for: one to answer a question by, and one of what is to be seen."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.problem.packed_pictures import pictures_of, unused
from corollary.problem.reader import read_problem

FIELDS = Path(__file__).parents[2] / "examples/banks/corollary-fields/src/corollary_fields/problems"
BANKS = FIELDS.parents[3]
PLAYED = ("energy", "gravitation", "kinematics", "newton", "oscillations", "rotation")
STEADY = {"pump_power"}  # water, of which only the power is asked


def test_every_problem_has_a_figure_and_what_moves_a_scene():
    problems = [
        path
        for path in BANKS.glob("*/src/*/problems/*/*.md")
        if "." not in path.stem and path.parent.name != "sets"
    ]
    assert len(problems) >= 60
    assert [path.stem for path in problems if not read_problem(path).figure] == []
    moving = [path for path in problems if path.parent.name in PLAYED and path.stem not in STEADY]
    solutions = [Path(str(path).replace("/problems/", "/solutions/")).with_suffix(".py") for path in moving]
    assert [path.stem for path in solutions if "\ndef scene(" not in path.read_text(encoding="utf-8")] == []


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
