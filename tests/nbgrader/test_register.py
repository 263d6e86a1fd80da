"""A course graded by us, seen through nbgrader's own eyes: its commands, its API, its pages."""

from __future__ import annotations

import copy
import csv
import os
import sqlite3
import subprocess
import sys
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing
from dataclasses import replace
from functools import partial
from pathlib import Path
from textwrap import dedent

import nbformat
import pytest
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell

pytest.importorskip("nbgrader")

from nbgrader.api import Gradebook

from corollary.answers.verdict import Follows, Mistaken, Right, Unmarked, Unread, Verdict
from corollary.atomic import write_whole
from corollary.grading.part_grades import Grade, Marked, PartGrade
from corollary.grading.submission import MarkedSubmission, Submission
from corollary.nbgrader.config import NotOurs
from corollary.nbgrader.gradebook import GradebookLocked, NotRegistered, gradebook, programs_on_path
from corollary.nbgrader.graded import graded
from corollary.nbgrader.register import register
from corollary.nbgrader.written_marks import synchronized, write_graded
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import Bank
from corollary.problem.late_penalty import IN_TIME
from corollary.problem.problem_set import ProblemSet, read_set
from corollary.problem.roster import Student
from corollary.problem.variant import Variant, at, chapter
from corollary.records.deadlines import Terms
from corollary.records.files import Course, create_course
from corollary.records.submissions import settle_time
from corollary.sandbox.job import CellRun

FILES = {
    "problems/impulse/kick.md": """\
        ---
        code: X12.5
        title: Kicking a ball
        source: Exercise 12.5
        given:
          m:  {is: mass, value: 0.43, from: 0.30, to: 0.60, step: 0.01, unit: kg}
          v:  {is: speed, value: 20, from: 8, to: 35, step: 0.5, unit: m/s}
        ---
        A ball of mass {{m}} gets the speed {{v}}.

        ## Momentum {#a .value unit="kg m/s" points=1}
        What is its momentum?

        ## Words {#b .explain points=3}
        Why?
        """,
    "problems/impulse/force.md": """\
        ---
        code: P12.1
        title: A program
        source: Project 12.1
        given:
          k: {is: stiffness, value: 1000, from: 500, to: 1500, step: 100, unit: N/m}
        ---
        A spring of stiffness {{k}}.

        ## Program {#a .code .plot points=4 function="force(x)"}
        Write and plot the force.
        """,
    "problems/sets/week_1.md": """\
        ---
        title: Week 1
        due: 2026-12-04T23:59+00:00
        credit: {late: 0.5}
        problems: [X12.5, {code: P12.1, weight: 2}]
        ---
        """,
}
ADA, BOB, EVE = Student("ada", "Ada", "Lovelace"), Student("bob", "Bob", "Boole"), Student("eve")
ON_TIME = "2026-12-04 21:03:11.500000 UTC"


def record(
    course: Course,
    problem_set: ProblemSet,
    works: Iterable[Marked],
    notebooks: Mapping[str, NotebookNode | None],
) -> None:
    """Marks into the gradebook and the records, and marked notebooks into `autograded/`, one student after the other."""
    given = synchronized(course).by_student(problem_set.name)
    with gradebook(course) as book:
        for one in works:
            found = MarkedSubmission(one, notebooks.get(one.student.id), {})
            work = graded(problem_set, Submission(one.student, b"", {}, IN_TIME, "fingerprint"), found)
            write_graded(course, problem_set, [work], given, book)


def manual_scores(course: Course, set_name: str) -> dict[str, dict[str, float]]:
    """What people gave: student -> key of the part -> points."""
    found: dict[str, dict[str, float]] = {}
    with gradebook(course) as book:
        for submission in book.assignment_submissions(set_name):
            for graded in submission.notebooks:
                for grade in graded.grades:
                    if grade.manual_score is not None:
                        found.setdefault(submission.student.id, {})[grade.name] = grade.manual_score
    return found


@pytest.fixture(scope="module")
def week(tmp_path_factory: pytest.TempPathFactory) -> ProblemSet:
    bank = tmp_path_factory.mktemp("bank")
    for name, text in FILES.items():
        write_whole(bank / name, dedent(text))
    return read_set(Bank(bank), bank / "problems/sets/week_1.md")


def chapters_own(week: ProblemSet) -> NotebookNode:
    return notebook(worksheet(week, Student(""), [chapter(problem) for problem in week.problems]))


@pytest.fixture(scope="module")
def registered(week: ProblemSet, tmp_path_factory: pytest.TempPathFactory) -> Course:
    """Made once, with a PATH on which there is no alembic: nbgrader needs it to make a gradebook."""
    course = create_course(tmp_path_factory.mktemp("made") / "mech", [ADA, BOB])
    before, os.environ["PATH"] = os.environ["PATH"], "/usr/bin:/bin"
    try:
        register(course, week, chapters_own(week))
    finally:
        os.environ["PATH"] = before
    return course


@pytest.fixture
def course(registered: Course, tmp_path: Path) -> Course:
    """A copy of the course, before anybody handed in."""
    subprocess.run(["cp", "-a", str(registered.folder), str(tmp_path / "mech")], check=True)
    return Course(tmp_path / "mech", registered.key)


def variants(week: ProblemSet, student: Student) -> list[Variant]:
    return [at(problem, sum(student.id.encode()) % 10) for problem in week.problems]


def hand_in(
    course: Course, week: ProblemSet, student: Student, stamp: str | None = ON_TIME, **answers: str
) -> NotebookNode:
    nb = notebook(worksheet(week, student, variants(week, student)))
    for cell in nb.cells:
        cell.source = answers.get(cell.id, cell.source)
    write_whole(course.notebook("submitted", student.id, week.name), file_text(nb))
    if stamp is not None:
        write_whole(course.place("submitted", student.id, week.name) / "timestamp.txt", stamp)
    return nb


def marked(
    week: ProblemSet, student: Student, *verdicts: tuple[Verdict, float], late_share: float = 1.0
) -> Marked:
    left = iter(verdicts)
    grades = []
    for variant in variants(week, student):
        parts = []
        for part in variant.problem.parts:
            verdict, points = next(left)
            feedback = "Think of $p = mv$." if points == 0 else ""
            parts.append(
                PartGrade(
                    part, verdict, points, part.points * week.weight(variant.problem), "8.6 N s", feedback
                )
            )
        grades.append(Grade(variant, tuple(parts)))
    picture = {"output_type": "stream", "name": "stdout", "text": "drawn\n"}
    runs = (CellRun("P12_1_a_plot", "ok", (picture,), 0.1, ""), CellRun("mine", "ok", (picture,), 0.1, ""))
    return Marked(
        student, tuple(grades), runs, (), "namespaces", "", 0.0 if late_share == 1 else 3600.0, late_share
    )


GOOD = ((Right(), 1.0), (Unmarked("a person reads this"), 0.0), (Right(), 8.0))
POOR = ((Mistaken("You divided."), 0.25), (Unread("nothing", blank=True), 0.0), (Unmarked("not tested"), 0.0))


def command(course: Course, *words: str) -> str:
    environment = os.environ | {"PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"}
    line = [sys.executable, "-m", "nbgrader", *words]
    done = subprocess.run(
        line, cwd=course.folder, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout + done.stderr


@pytest.fixture
def book(course: Course) -> Iterator[Gradebook]:
    with Gradebook(f"sqlite:///{course.gradebook}", "mech") as book:
        yield book


def grades(book: Gradebook, student: str) -> dict[str, tuple[float | None, float | None, bool]]:
    book.db.expire_all()
    (one,) = book.find_submission("week_1", student).notebooks
    return {
        grade.name: (grade.auto_score, grade.manual_score, grade.needs_manual_grade) for grade in one.grades
    }


@pytest.mark.whole
def test_stock_commands_work_on_what_we_wrote(course: Course, week: ProblemSet):
    explained = hand_in(course, week, ADA, X12_5_b="Because <script>alert(1)</script> of $F$.")
    late = hand_in(course, week, BOB, "2026-12-05 00:59:00 UTC")
    record(
        course,
        week,
        [marked(week, ADA, *GOOD), marked(week, BOB, *POOR, late_share=0.5)],
        {"ada": explained, "bob": late},
    )

    assert "ada (Lovelace, Ada)" in command(course, "db", "student", "list")
    place = course.place("feedback", "ada", "week_1")
    ours = (place / "week_1.html").read_text()
    assert "Feedback for Ada Lovelace" in ours
    assert (place / "timestamp.txt").read_text() == ON_TIME, "ngshare asks for it"
    write_whole(place / "week_1.html", "feedback on older marks")
    command(course, "generate_feedback", "week_1")
    assert [path.name for path in place.glob("*.html")] == ["week_1.html"], "one page a student"
    assert (place / "week_1.html").read_text() == ours
    assert (course.place("feedback", "ada", "week_1") / "timestamp.txt").read_text() == ON_TIME
    command(course, "export")
    rows = {row["student_id"]: row for row in csv.DictReader((course.folder / "grades.csv").open())}
    assert {name: float(row["score"]) for name, row in rows.items()} == {"ada": 9.0, "bob": 0.125}
    assert float(rows["bob"]["late_submission_penalty"]) == 0.125
    assert rows["ada"]["max_score"] == "12.0"
    assert rows["ada"]["duedate"] == "2026-12-04 23:59:00"


def test_formgrader_sees_the_students_as_graded(course: Course, week: ProblemSet):
    from nbgrader.apps import NbGraderAPI
    from nbgrader.coursedir import CourseDirectory
    from traitlets.config import Config

    nb = hand_in(course, week, ADA)
    bare = hand_in(course, week, BOB, stamp=None)
    garbled = hand_in(course, week, EVE, stamp="soon")
    for student in ("bob", "eve"):
        settle_time(course, "week_1", student, Terms())
    record(
        course,
        week,
        [marked(week, each, *GOOD) for each in (ADA, BOB, EVE)],
        {"ada": nb, "bob": bare, "eve": garbled},
    )
    settings = Config({"CourseDirectory": {"root": str(course.folder), "course_id": "mech"}})
    api = NbGraderAPI(CourseDirectory(config=settings), config=settings)
    assert api.get_autograded_students("week_1") == {"ada", "bob", "eve"}
    shown = api.get_submission("week_1", "ada")
    assert (shown["score"], shown["max_score"], shown["needs_manual_grade"], shown["autograded"]) == (
        9.0,
        12.0,
        True,
        True,
    )
    assert (course.place("autograded", "bob", "week_1") / "timestamp.txt").is_file()


def test_the_release_is_what_we_would_hand_out_ourselves(course: Course, week: ProblemSet):
    ours, theirs = chapters_own(week), nbformat.read(course.notebook("release", ".", "week_1"), as_version=4)
    assert [(cell.id, cell.source, cell.metadata) for cell in ours.cells] == [
        (cell.id, cell.source, cell.metadata) for cell in theirs.cells
    ]


def test_scores_flags_and_comments(course: Course, week: ProblemSet, book: Gradebook):
    nb = hand_in(course, week, ADA, X12_5_b="Because.")
    record(course, week, [marked(week, ADA, *GOOD)], {"ada": nb})
    assert grades(book, "ada") == {
        "X12_5_a": (1.0, None, False),
        "X12_5_b": (None, None, True),
        "P12_1_a": (8.0, None, False),
    }
    record(course, week, [marked(week, ADA, *POOR)], {"ada": nb})
    assert grades(book, "ada") == {
        "X12_5_a": (0.25, None, False),
        "X12_5_b": (0.0, None, False),
        "P12_1_a": (None, None, True),
    }
    (one,) = book.find_submission("week_1", "ada").notebooks
    assert {comment.name: comment.comment for comment in one.comments} == {
        "X12_5_a_answer": None,
        "X12_5_b": "Think of $p = mv$.",
        "P12_1_a_answer": "Think of $p = mv$.",
        "P12_1_a_plot": None,
    }


def test_what_a_person_gave_is_kept_and_shown_again_only_for_another_answer(
    course: Course, week: ProblemSet, book: Gradebook
):
    nb = hand_in(course, week, ADA, X12_5_b="Because.")
    record(course, week, [marked(week, ADA, *GOOD)], {"ada": nb})
    grade = book.find_grade("X12_5_b", "week_1", "week_1", "ada")
    comment = book.find_comment("X12_5_b", "week_1", "week_1", "ada")
    grade.manual_score, grade.needs_manual_grade, comment.manual_comment = 2.5, False, "Well said."
    book.db.commit()
    assert manual_scores(course, "week_1") == {"ada": {"X12_5_b": 2.5}}

    record(course, week, [marked(week, ADA, *GOOD)], {"ada": nb})
    assert grades(book, "ada")["X12_5_b"] == (None, 2.5, False)

    other = hand_in(course, week, ADA, X12_5_b="Because of the impulse.")
    record(course, week, [marked(week, ADA, *GOOD)], {"ada": other})
    assert grades(book, "ada")["X12_5_b"] == (None, 2.5, True)
    assert book.find_comment("X12_5_b", "week_1", "week_1", "ada").comment == "Well said."
    assert manual_scores(course, "week_1") == {"ada": {"X12_5_b": 2.5}}


def test_the_late_share_is_taken_from_what_a_person_gave_too(
    course: Course, week: ProblemSet, book: Gradebook
):
    nb = hand_in(course, week, ADA, X12_5_b="Because.")
    late = marked(week, ADA, *GOOD, late_share=0.5)
    record(course, week, [late], {"ada": nb})
    grade = book.find_grade("X12_5_b", "week_1", "week_1", "ada")
    grade.manual_score = 3.0
    book.db.commit()
    record(course, week, [late], {"ada": nb})
    book.db.expire_all()
    assert book.find_submission("week_1", "ada").notebooks[0].late_submission_penalty == 6.0
    record(course, week, [replace(late, late_share=1.0)], {"ada": nb})
    book.db.expire_all()
    assert book.find_submission("week_1", "ada").notebooks[0].late_submission_penalty is None


def broken(nb: NotebookNode, how: str) -> NotebookNode | None:
    nb = copy.deepcopy(nb)
    by_id = {cell.id: cell for cell in nb.cells}
    match how:
        case "no cells":
            nb.cells = []
        case "missing":
            nb.cells = [cell for cell in nb.cells if not cell.id.startswith("X12_5_a")]
        case "doubled":
            nb.cells += copy.deepcopy(nb.cells)
        case "no metadata":
            for cell in nb.cells:
                cell.metadata = nbformat.from_dict({})
        case "worthless points":
            by_id["X12_5_a"].metadata["nbgrader"]["points"] = 1000
        case "future schema":
            by_id["X12_5_a"].metadata["nbgrader"] = {"schema_version": 99}
        case "other kind":
            by_id["X12_5_b"]["cell_type"], by_id["X12_5_a_answer"]["cell_type"] = "code", "raw"
        case "reversed":
            nb.cells.reverse()
        case "unopened":
            return None
    return nb


@pytest.mark.parametrize(
    "how",
    [
        "no cells",
        "missing",
        "doubled",
        "no metadata",
        "worthless points",
        "future schema",
        "other kind",
        "reversed",
        "unopened",
    ],
)
def test_a_broken_submission_is_recorded_like_any_other(
    course: Course, week: ProblemSet, book: Gradebook, how: str
):
    from nbgrader.nbgraderformat import MetadataValidator

    nb = broken(hand_in(course, week, ADA, X12_5_a_answer="X12_5_a = 8.6"), how)
    record(course, week, [marked(week, ADA, *GOOD)], {"ada": nb})
    assert grades(book, "ada")["X12_5_a"] == (1.0, None, False)
    written = nbformat.read(course.notebook("autograded", "ada", "week_1"), as_version=4)
    nbformat.validate(written)
    MetadataValidator().validate_nb(written)
    cells = {cell.id: cell for cell in written.cells}
    assert len(cells) == len(written.cells)
    assert "Right" in cells["X12_5_a"].outputs[0].data["text/plain"]
    expected = "None" if how in {"no cells", "missing", "unopened"} else "8.6"
    assert f"X12_5_a = {expected}" in cells["X12_5_a_answer"].source


def test_the_marked_notebook_shows_what_the_student_added_where_it_stood(course: Course, week: ProblemSet):
    nb = hand_in(course, week, ADA)
    place = next(n for n, cell in enumerate(nb.cells) if cell.id == "X12_5_a_answer")
    nb.cells.insert(place, new_code_cell("helper = 3", id="mine"))
    stopped = replace(marked(week, ADA, *GOOD), trouble="The notebook was stopped: it ran out of memory.")
    record(course, week, [stopped], {"ada": nb})
    written = nbformat.read(course.notebook("autograded", "ada", "week_1"), as_version=4)
    sources = [cell.source for cell in written.cells]
    at_helper = sources.index("helper = 3")
    assert written.cells[at_helper].outputs[0].text == "drawn\n"
    assert "nbgrader" not in written.cells[at_helper].metadata
    assert [cell.id for cell in written.cells][at_helper - 1 : at_helper + 2 : 2] == [
        "X12_5_a_text",
        "X12_5_a_answer",
    ]
    assert "ran out of memory" in sources[1]


def test_registering_again_takes_up_changes(course: Course, week: ProblemSet, book: Gradebook):
    changed = replace(week, title="Week one", due=None)
    create_course(course.folder, [ADA, replace(BOB, last_name="Bool"), EVE])
    register(course, changed, chapters_own(changed))
    assert (
        "# Week one" in nbformat.read(course.notebook("release", ".", "week_1"), as_version=4).cells[0].source
    )
    assert book.find_assignment("week_1").duedate is None
    assert {student.id: student.last_name for student in book.students} == {
        "ada": "Lovelace",
        "bob": "Bool",
        "eve": None,
    }


def test_parts_that_are_gone_stay_under_recorded_work_and_new_ones_are_added(
    course: Course, week: ProblemSet, book: Gradebook
):
    record(course, week, [marked(week, ADA, *GOOD)], {"ada": hand_in(course, week, ADA)})
    kick = week.problems[0]
    first, *rest = kick.parts
    changed = replace(kick, parts=(*rest, replace(first, id="z")))
    shorter = replace(week, problems=(changed,), weights=week.weights[:1])
    register(course, shorter, chapters_own(shorter))
    register(course, shorter, chapters_own(shorter))
    names = {cell.name for cell in book.find_notebook("week_1", "week_1").grade_cells}
    assert {kick.answer_name(part) for part in (*kick.parts, *changed.parts)} <= names
    scores = {
        grade.name: grade.auto_score for grade in book.find_submission("week_1", "ada").notebooks[0].grades
    }
    assert scores[kick.answer_name(first)] == GOOD[0][1]
    assert scores[changed.answer_name(changed.parts[-1])] is None


def test_who_was_recorded_before_an_accident_stays_recorded(
    course: Course, week: ProblemSet, book: Gradebook
):
    def until_the_power_goes() -> Iterator[Marked]:
        yield marked(week, ADA, *GOOD)
        raise KeyboardInterrupt

    nb = hand_in(course, week, ADA)
    with pytest.raises(KeyboardInterrupt):
        record(course, week, until_the_power_goes(), {"ada": nb})
    assert grades(book, "ada")["X12_5_a"][0] == 1.0
    assert len(book.assignment_submissions("week_1")) == 1
    record(
        course,
        week,
        [marked(week, ADA, *GOOD), marked(week, BOB, *POOR)],
        {"ada": nb, "bob": hand_in(course, week, BOB)},
    )
    assert len(book.assignment_submissions("week_1")) == 2


def test_a_locked_gradebook_is_said_in_one_sentence(
    course: Course, week: ProblemSet, monkeypatch: pytest.MonkeyPatch
):
    nb = hand_in(course, week, ADA)
    monkeypatch.setattr(sqlite3.dbapi2, "connect", partial(sqlite3.dbapi2.connect, timeout=0.2))
    other = sqlite3.connect(course.gradebook, isolation_level=None)
    other.execute("BEGIN IMMEDIATE")
    try:
        with pytest.raises(GradebookLocked, match="is locked by another program"):
            record(course, week, [marked(week, ADA, *GOOD)], {"ada": nb})
    finally:
        other.rollback()
        other.close()
    assert not course.notebook("autograded", "ada", "week_1").exists()
    record(course, week, [marked(week, ADA, *GOOD)], {"ada": nb})


def test_a_new_gradebook_has_the_tables_and_the_revision_that_nbgraders_own_has(
    course: Course, tmp_path: Path
):
    with programs_on_path(), Gradebook(f"sqlite:///{tmp_path / 'theirs.db'}"):
        pass

    def told(path: Path) -> tuple[list[tuple[str, str]], list[tuple[str]]]:
        with closing(sqlite3.connect(path)) as base:
            tables = base.execute("SELECT name, sql FROM sqlite_master WHERE type = 'table'").fetchall()
            return sorted(
                (name, " ".join(sql.split())) for name, sql in tables if name != "alembic_version"
            ), base.execute("SELECT version_num FROM alembic_version").fetchall()

    assert told(course.gradebook) == told(tmp_path / "theirs.db")


def test_an_unknown_set_is_said(course: Course, week: ProblemSet):
    other = replace(week, name="week_9")
    with pytest.raises(NotRegistered, match="does not know week_9"):
        record(course, other, [marked(week, ADA, *GOOD)], {})


def test_somebody_elses_course_is_left_alone(tmp_path: Path, week: ProblemSet):
    course = create_course(tmp_path / "mech", [ADA])
    (course.folder / "nbgrader_config.py").write_text("c = get_config()\n")
    with pytest.raises(NotOurs, match="was not written by corollary"):
        register(course, week, chapters_own(week))
    assert not course.gradebook.exists()


def test_an_own_line_in_the_config_stays(course: Course, week: ProblemSet):
    config = course.folder / "nbgrader_config.py"
    config.write_text(config.read_text() + "c.CourseDirectory.ignore = ['x']\n")
    register(course, week, chapters_own(week))
    assert config.read_text().endswith("c.CourseDirectory.ignore = ['x']\n")


def test_follows_counts_as_earned(course: Course, week: ProblemSet, book: Gradebook):
    parts = ((Follows(("a",)), 1.0), *GOOD[1:])
    record(course, week, [marked(week, BOB, *parts)], {"bob": hand_in(course, week, BOB)})
    assert grades(book, "bob")["X12_5_a"] == (1.0, None, False)
