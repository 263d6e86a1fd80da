"""Dates, the share that late work keeps, and what may be seen by now: marks and pages follow without running a notebook again."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

import pytest

pytest.importorskip("nbgrader")

from corollary.course.grade import Outcome, grade_set
from corollary.grading.solutions import Solutions
from corollary.records.deadlines import Extension, write_extension
from corollary.records.files import Course, one_writer, open_course
from corollary.records.origin import set_of
from corollary.sandbox.runner import Runner

pytestmark = pytest.mark.usefixtures("one_zygote")
SET = "---\ntitle: One exercise\ndue: 2026-03-02T12:00+00:00\ncredit: {late: 0.8}\nreveal: after due\nproblems:\n  - X12.5\n---\nOne exercise.\n"
LONG_AFTER = datetime(2026, 6, 1, tzinfo=UTC)
WHEN = {"ada": "2026-03-01 09:00:00 UTC", "ben": "2026-03-02 11:00:00 UTC", "cyd": "2026-03-03 10:00:00 UTC"}


def no_notebook() -> None:
    pytest.fail("a notebook was run")


def marked(
    course: Course, *, begin: Callable[[], None] = no_notebook, regrade: bool = False, dry_run: bool = False
) -> Outcome:
    bank, problem_set = set_of(course, str(course.folder.parent / "one.md"))
    with one_writer(course):
        return grade_set(
            course, problem_set, Solutions(bank), partial(Runner, require=1),
            jobs=1, begin=begin, now=LONG_AFTER, regrade=regrade, dry_run=dry_run,
        )  # fmt: skip


@pytest.fixture
def course(handed_in: Path) -> Course:
    """All right but for ben's first answer; cyd is a day late; solutions may be seen."""
    (handed_in.parent / "one.md").write_text(SET)
    for student, when in WHEN.items():
        (handed_in / "submitted" / student / "one" / "timestamp.txt").write_text(when)
    paper = handed_in / "submitted/ben/one/one.ipynb"
    paper.write_text(paper.read_text().replace("X12_5_a = ", "X12_5_a = 7777 + 0 *"))
    opened = open_course(handed_in)
    found = marked(opened, begin=lambda: None)
    assert {one: each.points for one, each in found.records.items()} == {"ada": 5.0, "ben": 4.0, "cyd": 4.0}
    return opened


def written(course: Course) -> dict[str, bytes]:
    """Everything that a student or a person sees of it."""
    files = [each for step in ("autograded", "feedback") for each in (course.folder / step).rglob("one.*")]
    files += (course.folder / ".corollary" / "pages").rglob("*.json")
    assert len(files) == 9
    return {str(each.relative_to(course.folder)): each.read_bytes() for each in files}


def points_again(course: Course) -> dict[str, float]:
    """The marks without a run; and a regrade, which runs everything, writes the same, to the byte."""
    found = {one: each.points for one, each in marked(course).records.items()}
    before = written(course)
    assert any("X12_5" in name or b"X12_5" in content for name, content in before.items())
    ran: list[bool] = []
    marked(course, begin=lambda: ran.append(True), regrade=True)
    assert ran
    assert written(course) == before
    return found


@pytest.mark.whole
def test_another_share_for_late_work(course: Course):
    file = course.folder.parent / "one.md"
    file.write_text(SET.replace("late: 0.8", "late: 0.5"))
    tried = marked(course, dry_run=True)
    assert [(each.student, each.before, each.after) for each in tried.changed] == [("cyd", 4.0, 2.5)]
    assert [each.why for each in tried.changed] == ["changed: what late work keeps"]
    assert points_again(course) == {"ada": 5.0, "ben": 4.0, "cyd": 2.5}


@pytest.mark.whole
def test_another_date_for_everybody(course: Course):
    file = course.folder.parent / "one.md"
    file.write_text(SET.replace("2026-03-02T12", "2026-03-05T12"))
    assert points_again(course) == {"ada": 5.0, "ben": 4.0, "cyd": 5.0}


def test_another_time_of_handing_in(course: Course):
    (course.folder / "submitted/ada/one/timestamp.txt").write_text("2026-03-04 10:00:00 UTC")
    assert points_again(course) == {"ada": 4.0, "ben": 4.0, "cyd": 4.0}


def test_who_gets_more_time_after_solutions_were_seen_sees_none_in_the_own_page(course: Course):
    page = course.folder / "feedback/ben/one/one.html"
    assert "The answer is" in page.read_text()
    write_extension(course, "one", "ben", Extension(datetime(2026, 7, 1, tzinfo=UTC)))
    assert points_again(course)["ben"] == 4.0
    assert "The answer is" not in page.read_text()
    shutil.rmtree(course.folder / ".corollary/extensions")
    assert points_again(course)["ben"] == 4.0
    assert "The answer is" in page.read_text()


@pytest.mark.parametrize(
    ("before", "after"),
    [("title: One exercise", "title: One exercise"), ("X12.5", "{code: X12.5, parts: [a, b]}")],
)
def test_what_a_run_may_tell_is_run(course: Course, before: str, after: str):
    file = course.folder.parent / "one.md"
    file.write_text(SET.replace(before, after))
    ran: list[bool] = []
    marked(course, begin=lambda: ran.append(True))
    assert bool(ran) == (before != after)
