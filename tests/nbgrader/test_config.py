"""A course's nbgrader_config.py: written once, and left to its owner."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.nbgrader.config import NotOurs, check_config, write_config
from corollary.nbgrader.gradebook import settings
from corollary.problem.roster import Student
from corollary.records.files import Course, create_course

pytest.importorskip("nbgrader", reason="needs nbgrader: pip install '.[nbgrader]'")


@pytest.fixture
def course(tmp_path: Path) -> Course:
    return create_course(tmp_path / "mech", [Student("ada")])


def test_what_the_owner_adds_stays(course: Course) -> None:
    write_config(course)
    path = course.folder / "nbgrader_config.py"
    path.write_text(path.read_text() + "c.ExecutePreprocessor.timeout = 77  # caf\u00e9\n", encoding="utf-8")
    before = path.read_bytes()
    write_config(course)
    assert settings(course).ExecutePreprocessor.timeout == 77
    assert path.read_bytes() == before


def test_a_config_of_somebody_elses_is_left_alone(course: Course) -> None:
    (course.folder / "nbgrader_config.py").write_text("c = get_config()\n")
    with pytest.raises(NotOurs, match="was not written by corollary"):
        check_config(course.folder)
