"""Dates in a course that is graded: lateness is each student's own, and nothing is revealed before it may be."""

from __future__ import annotations

import json
from datetime import UTC, datetime, timedelta
from functools import partial
from pathlib import Path

import pytest
from click.testing import CliRunner
from nbgrader.api import Gradebook

from corollary.atomic import write_whole
from corollary.cli.commands import app
from corollary.course.export import marks_table
from corollary.course.grade import Outcome, grade_set
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank
from corollary.records.deadlines import Extension, write_extension
from corollary.records.files import open_course
from corollary.records.marks_table import Notation
from corollary.records.origin import set_of, write_origin
from corollary.records.report_model import report_record
from corollary.sandbox.runner import Runner

pytestmark = pytest.mark.usefixtures("one_zygote")
DUE = datetime(2026, 12, 4, 22, 59, 59, 999999, tzinfo=UTC)  # the end of the day in Oslo
DAY = timedelta(days=1)
SET = (
    "---\ntitle: One exercise\ndue: 2026-12-04\nreveal: yes\ncredit: {late: 0.5}\nproblems:\n  - X12.5\n---\n"
)
WORKED = "Worked solution"


@pytest.fixture
def course(handed_in: Path, tmp_path: Path) -> Path:
    """Ada came in time, Ben an hour late, Cyd too, with a day more."""
    (tmp_path / "one.md").write_text(SET)
    (handed_in / "corollary.toml").write_text('timezone = "Europe/Oslo"\n')
    for student, moment in (("ada", DUE), ("ben", DUE + DAY / 24), ("cyd", DUE + DAY / 24)):
        stamp = f"{moment:%Y-%m-%d %H:%M:%S.%f} UTC"
        write_whole(handed_in / "submitted" / student / "one" / "timestamp.txt", stamp)
    write_extension(open_course(handed_in), "one", "cyd", Extension(DUE + DAY))
    return handed_in


def grade(course: Path, now: datetime, text: str = SET, runner: type[Runner] = Runner) -> Outcome:
    (course.parent / "one.md").write_text(text)
    opened = open_course(course)
    bank, problem_set = set_of(opened, str(course.parent / "one.md"))
    return grade_set(opened, problem_set, Solutions(bank), partial(runner, require=0), jobs=1, now=now)


def pages(course: Path) -> dict[str, str]:
    return {
        each: (course / "feedback" / each / "one" / "one.html").read_text() for each in ("ada", "ben", "cyd")
    }


def points(outcome: Outcome) -> dict[str, float]:
    return {student: record.points for student, record in outcome.records.items()}


def test_lateness_is_ones_own_and_solutions_wait_for_everybodys_date(course: Path):
    outcome = grade(course, DUE)
    assert points(outcome) == {"ada": 5.0, "ben": 2.5, "cyd": 5.0}
    assert not [student for student, page in pages(course).items() if WORKED in page]
    again = grade(course, DUE)
    assert (again.graded, set(again.skipped)) == ((), {"ada", "ben", "cyd"})

    # The date has passed: those for whom it has read the solution, and nobody's points move.
    later = grade(course, DUE + DAY / 2)
    assert set(later.graded) == {"ada", "ben"}
    assert points(later) == points(outcome)
    assert [student for student, page in pages(course).items() if WORKED in page] == ["ada", "ben"]
    assert set(grade(course, DUE + 2 * DAY).graded) == {"cyd"}
    assert all(WORKED in page for page in pages(course).values())


def test_what_may_be_seen_by_now_is_added_without_running_anything(course: Path):
    """The page, the record and the marked notebook are those that a run of every notebook would have made."""
    path = course / "submitted" / "ada" / "one" / "one.ipynb"
    notebook = json.loads(path.read_text())
    for cell in notebook["cells"]:
        if cell["id"] == "X12_5_c_answer":
            cell["source"] = "X12_5_c = 1e9"
    path.write_text(json.dumps(notebook))
    grade(course, DUE)

    class NeverRun(Runner):
        def execute(self, job):
            raise AssertionError("a notebook was run")

    later = grade(course, DUE + 2 * DAY, runner=NeverRun)
    assert set(later.graded) == {"ada", "ben", "cyd"}
    assert later.changed == ()
    rendered, records = pages(course), later.records
    assert "The answer is" in rendered["ada"]
    assert all(WORKED in page for page in rendered.values())
    marked = (course / "autograded/ada/one/one.ipynb").read_text()
    assert grade(course, DUE + 2 * DAY).graded == ()
    opened = open_course(course)
    bank, problem_set = set_of(opened, str(course.parent / "one.md"))
    again = grade_set(
        opened,
        problem_set,
        Solutions(bank),
        partial(Runner, require=0),
        jobs=1,
        now=DUE + 2 * DAY,
        regrade=True,
    )
    assert (pages(course), again.records) == (rendered, records)
    assert (course / "autograded/ada/one/one.ipynb").read_text() == marked


def test_moving_the_date_moves_lateness_alone_and_accuses_nobody(course: Path):
    before = points(grade(course, DUE + 2 * DAY))
    moved = grade(course, DUE + 2 * DAY, SET.replace("due: 2026-12-04", "due: 2026-12-05"))
    assert before == {"ada": 5.0, "ben": 2.5, "cyd": 5.0}
    assert points(moved) == {"ada": 5.0, "ben": 5.0, "cyd": 5.0}
    assert not [record.notes for record in moved.records.values() if record.notes]
    hidden = grade(course, DUE + 2 * DAY, SET.replace("reveal: yes", "reveal: no"))
    assert points(hidden) == before
    assert not [record.notes for record in hidden.records.values() if record.notes]
    assert not [student for student, page in pages(course).items() if WORKED in page]


def test_excused_is_blank_and_not_nothing(course: Path):
    write_extension(open_course(course), "one", "ben", Extension(excused=True))
    outcome = grade(course, DUE + 2 * DAY)
    report = outcome.report
    assert (report.excused, report.missing, [one.student for one in report.handed_in]) == (
        ("ben",),
        (),
        ["ada", "cyd"],
    )
    assert report.mean == 5.0
    assert report_record(report)["excused"] == ["ben"]
    assert "Excused" in outcome.page.read_text(encoding="utf-8")
    opened = open_course(course)
    _, problem_set = set_of(opened, str(course.parent / "one.md"))
    table = marks_table(opened, [problem_set], "sets", Notation())
    assert [table.cell(student, table.columns[0]) for student in table.students] == ["5", "", "5"]


def test_the_page_and_the_gradebook_have_ones_own_deadline(course: Path):
    grade(course, DUE + 2 * DAY)
    found = pages(course)
    assert "due Friday 4 December 2026, 23:59 (Europe/Oslo)" in found["ada"]
    assert "due Saturday 5 December 2026, 23:59 (Europe/Oslo)" in found["cyd"]
    with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
        dates = {each.student.id: each.duedate for each in book.assignment_submissions("one")}
    utc = DUE.replace(tzinfo=None)
    assert dates == {"ada": utc, "ben": utc, "cyd": utc + DAY}


def test_a_course_from_before_there_were_settings_keeps_its_marks(graded: Path):
    (graded / "corollary.toml").unlink()
    opened = open_course(graded)
    bank, problem_set = set_of(opened, "one")
    outcome = grade_set(opened, problem_set, Solutions(bank), partial(Runner, require=0), jobs=1)
    assert (outcome.graded, len(outcome.skipped), set(points(outcome).values())) == ((), 3, {5.0})
    assert not (graded / "corollary.toml").exists()


def test_more_time_after_solutions_were_out_is_warned_of_and_what_is_held_back_said(
    course: Path, monkeypatch: pytest.MonkeyPatch
):
    """By the command, so by the clock: everything here is years ago or ahead."""
    (course.parent / "one.md").write_text(
        SET.replace("2026-12-04", "2020-12-04").replace("reveal: yes", "reveal: after extensions")
    )
    write_origin(open_course(course), "one", chapter_bank(), course.parent / "one.md")
    (course / ".corollary" / "extensions" / "one" / "cyd.json").unlink()
    monkeypatch.chdir(course)

    def run(*words: str) -> str:
        done = CliRunner().invoke(app, list(words), catch_exceptions=False)
        assert done.exit_code == 0, done.stderr
        return " ".join(done.stderr.split())

    until = ("2999-12-11", "18:00")
    assert "worked solutions" not in run("extend", "cyd", "one", *until)
    run("extend", "cyd", "one", "--remove")
    assert "held back" not in run("grade", "one", "--yes")
    assert all(WORKED in page for page in pages(course).values())
    assert run("extend", "ben", "one", *until).startswith(
        "warning: worked solutions of one stand in 3 feedback pages already, with other numbers and the same formulas: "
        "ben may have seen them. The next corollary grade one takes them out until Wednesday 11 December 2999, 18:00"
    )
    told = run("grade", "one", "--yes")
    assert "keeps worked solutions off all feedback pages until then and removed from 3 pages" in told
    assert not any(WORKED in page for page in pages(course).values())
    again = run("grade", "one", "--yes")
    assert again.endswith("reveal: after extensions keeps worked solutions off all feedback pages until then")
