"""A course's nbgrader_config.py: written once, left to its owner, and still good after an update of the program."""

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


def test_a_course_made_by_an_older_version_finds_our_classes_where_they_are_now(course: Course) -> None:
    write_config(course)
    path = course.folder / "nbgrader_config.py"
    path.write_text(path.read_text() + "c.ExecutePreprocessor.timeout = 77\n")
    now = path.read_bytes()
    former = now.replace(b"corollary.nbgrader.autograde", b"corollary.deliver.nbgrader_autograde")
    former = former.replace(b"RecordMarks", b"MarksKept").replace(b"LatenessInMarks", b"LatenessKept")
    path.write_bytes(former)
    assert path.read_bytes() != now
    assert settings(course).Autograde.exporter_class.__module__ == "corollary.nbgrader.autograde"
    assert path.read_bytes() == now


def test_a_config_of_somebody_elses_is_left_alone(course: Course) -> None:
    (course.folder / "nbgrader_config.py").write_text("c = get_config()\n")
    with pytest.raises(NotOurs, match="was not written by corollary"):
        check_config(course.folder)


def test_a_course_made_before_the_exchange_was_ours_gets_it_before_what_its_owner_has_set(
    course: Course,
) -> None:
    write_config(course)
    path = course.folder / "nbgrader_config.py"
    text = path.read_text()
    start, end = text.index("\n# The exchange gives"), text.index("\n# The source notebooks")
    path.write_text(text[:start] + text[end:] + 'c.ExchangeFactory.submit = "mine.Submit"\n')
    assert "ReleaseOwnSheets" not in path.read_text()
    found = settings(course)
    assert found.ExchangeFactory.release_assignment == "corollary.nbgrader.exchange.ReleaseOwnSheets"
    assert found.ZipCollectApp.collector_plugin == "corollary.nbgrader.zip_collect.OwnerCollector"
    assert found.ExchangeFactory.submit == "mine.Submit"
    before = path.read_bytes()
    settings(course)
    assert path.read_bytes() == before


def test_a_course_made_before_its_feedback_was_released_by_us_gets_that_once(course: Course) -> None:
    write_config(course)
    path = course.folder / "nbgrader_config.py"
    now = path.read_text()
    line = next(each for each in now.splitlines() if "ReleaseOwnFeedback" in each)
    path.write_text(now.replace(f"{line}\n", "") + "c.ExecutePreprocessor.timeout = 77\n")
    assert settings(course).ExchangeFactory.release_feedback.endswith(".ReleaseOwnFeedback")
    path.write_text(now.replace(line, f"# {line}"))
    assert "release_feedback" not in settings(course).ExchangeFactory
