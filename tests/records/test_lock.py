"""Two runs never write in one course at once, and a lock goes with its holder."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.problem.roster import Student
from corollary.records.course import create_course
from corollary.records.lock import BeingGraded, one_writer


def test_a_second_writer_is_told_and_the_next_one_may(tmp_path: Path) -> None:
    course = create_course(tmp_path / "course", [Student("ada")])
    before = sorted(path.name for path in (course.folder / ".corollary").iterdir())
    with one_writer(course), pytest.raises(BeingGraded, match="another run is grading"), one_writer(course):
        pass
    with one_writer(course):
        assert sorted(path.name for path in (course.folder / ".corollary").iterdir()) == before
