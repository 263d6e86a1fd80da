"""Points of parts, problems and submissions added up, late ones by their share, and earlier marks kept behind today's."""

from __future__ import annotations

from dataclasses import replace

import pytest

from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.part_grades import Grade, Marked
from corollary.grading.points import grade
from corollary.messages import language
from corollary.problem.roster import Student


@pytest.fixture
def stone(key) -> Grade:
    """The sign is right and the weight is right; nothing else is answered."""
    made = key("T1")
    return grade(made, judge(made, {"d": from_json("b"), "i": from_json("4.905 N")}))


def marked(*grades: Grade, late_share: float = 1.0) -> Marked:
    return Marked(Student("ada"), grades, (), (), "none", "", 0.0, late_share)


def test_points_are_those_of_the_parts_and_a_late_share_takes_its_part(stone):
    assert (stone["d"].points, stone["i"].points) == (1.0, 1.0)
    assert stone["d"].part.id == "d"
    assert (stone.points, stone.out_of) == (2.0, 11.0)
    assert marked(stone).points == 2.0
    late = marked(stone, replace(stone), late_share=0.75)
    assert (late.points, late.out_of) == (3.0, 22.0)
    assert not late.machine_failed


def test_a_part_that_is_not_there_has_no_grade(stone):
    with pytest.raises(StopIteration):
        stone["z"]


def test_earlier_marks_stand_behind_those_of_today(stone):
    parts = {each.part.id: each for each in stone.parts}
    today = Grade(stone.variant, (parts["d"],))
    before = Grade(stone.variant, (parts["i"],))
    (both,) = marked(today).joined((before,)).grades
    assert [each.part.id for each in both.parts] == ["d", "i"]
    assert both.points == 2.0
    assert [each.points for each in marked().joined((before,)).grades] == [1.0]


def advised(key, answers: dict[str, object], code: str = "T1") -> str:
    made = key(code)
    found = grade(made, judge(made, {part: from_json(answer) for part, answer in answers.items()}))
    return " ".join(found[part].feedback for part in answers)


def test_a_law_without_a_source_is_named_and_a_given_by_its_meaning(key):
    said = advised(key, {"i": "3.333 N"})
    assert "Weight" in said
    assert "the mass of the stone" in said
    with language("de"):
        other = advised(key, {"i": "3.333 N"})
    assert "mass of the stone" in other
    assert "the mass of the stone" not in other
