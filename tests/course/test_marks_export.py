"""Marks of a real graded course in the files that LMSs take: late, wrong, waiting, missing and excused, by the command."""

from __future__ import annotations

import csv
import io
import json
import os
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from tests import forked

from corollary.course.demo.players import right_sources
from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.deadlines import Extension, write_extension

from .conftest import COMMAND, grade
from .importers import Canvas, Refused, moodle

pytestmark = pytest.mark.whole

SET = """---
title: Week 1, impulse
due: 2026-09-01
timezone: UTC
credit: {late: 0.5}
problems:
  - X12.5
  - {code: X12.1, weight: 2}
---
Two exercises.
"""
FORMULA = '=HYPERLINK("https://example.org";"click")'
ROSTER = [
    Student("007", "Ada", "Lovelace", "ada@uio.no", (("ID number", "007"),)),
    Student("0100", FORMULA, "Łukasiewicz-Østby", "ben@uio.no", (("ID number", "0100"),)),
    Student("cyd", "Cyd", "Missing", "cyd@uio.no", (("ID number", "0101"),)),
    Student("dag", "Dag", "Excused", "dag@uio.no", (("ID number", "0102"),)),
]


@dataclass(frozen=True, slots=True)
class Done:
    status: int
    document: dict[str, Any]
    errors: str
    folder: Path

    @property
    def text(self) -> str:
        assert "files" in self.document, self.errors
        (name,) = self.document["files"]
        return (self.folder / name).read_bytes().decode()

    @property
    def rows(self) -> list[dict[str, str]]:
        return list(csv.DictReader(io.StringIO(self.text, newline="")))


@pytest.fixture(scope="module")
def graded_once(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Ada has all right, and late; Łukasiewicz one part wrong; Dag handed in and is excused; Cyd nothing."""
    folder = tmp_path_factory.mktemp("lms")
    (folder / "week_1.md").write_text(SET.replace("timezone: UTC\n", ""))
    bank = chapter_bank()
    problem_set, solutions = find_set(bank, str(folder / "week_1.md")), Solutions(bank)
    made = generate(folder / "course", problem_set, ROSTER, solutions)
    for student in ROSTER:
        if student.id == "cyd":
            continue
        sheet = worksheet(problem_set, student, made.assigned[student.id].variants)
        keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
        sources = right_sources(sheet, keys)
        if student.id == "0100":
            sources["X12_5_a_answer"] = f"{sheet.prompts[0].name} = 1e9"
        path = made.course.notebook("submitted", student.id, "week_1")
        path.parent.mkdir(parents=True)
        path.write_text(filled_in(sheet, sources), encoding="utf-8")
        when = "2026-09-05" if student.id == "007" else "2026-08-05"
        path.with_name("timestamp.txt").write_text(f"{when} 10:00:00.000000 UTC\n")
    done = grade(made.course.folder, name="week_1")
    assert done.status == 0, done.errors
    write_extension(made.course, "week_1", "dag", Extension(excused=True))
    return folder


@pytest.fixture
def folder(graded_once: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(graded_once, tmp_path / "term"))


def export(folder: Path, *words: str, sets: tuple[str, ...] = ("week_1",)) -> Done:
    line = [str(COMMAND), "export", *sets, "--course", "course", "--json", *words]
    done = forked.run(
        line,
        cwd=folder,
        env=dict(os.environ),
        capture_output=True,
        encoding="utf-8",
        timeout=120,
        check=False,
    )
    return Done(done.returncode, json.loads(done.stdout) if done.stdout else {}, done.stderr, folder)


def points(folder: Path) -> dict[str, float]:
    line = [str(COMMAND), "report", "week_1", "--course", "course", "--json"]
    done = forked.run(line, cwd=folder, capture_output=True, encoding="utf-8", timeout=120, check=True)
    return {name: each["points"] for name, each in json.loads(done.stdout)["students"].items()}


def test_moodle_gets_ids_with_their_zeros_marks_after_lateness_and_blanks(folder: Path) -> None:
    done = export(folder, "--to", "moodle-grades")
    assert (done.status, done.document["files"]) == (0, ["export/week_1-moodle-grades.csv"])
    assert list(done.rows[0]) == ["First name", "Last name", "ID number", "Email address", "Week 1, impulse"]
    marks = {row["ID number"]: row["Week 1, impulse"] for row in done.rows}
    assert (marks["0101"], marks["0102"]) == ("", "")
    of_report = points(folder)
    assert float(marks["007"]) == of_report["007"] > 0
    assert float(marks["0100"]) == of_report["0100"] > of_report["007"]  # one part wrong, and in time
    assert [row["Last name"] for row in done.rows][1] == "Łukasiewicz-Østby"
    assert done.rows[1]["First name"] == f"'{FORMULA}"
    assert done.document["waiting"] == ["007", "0100"]
    assert (
        "2 students with parts that wait for marking; their points are not in the marks yet: 007, 0100"
        in done.errors
    )


def test_canvas_reads_its_columns_its_second_row_and_the_title(folder: Path) -> None:
    """What `GradebookImporter` asks for: Student, ID, both of SIS, Section, in this order, then titles."""
    done = export(folder, "--to", "canvas-grades", "--round", "1")
    header, points_row, *rows = list(csv.reader(io.StringIO(done.text, newline="")))
    assert header == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Week 1, impulse"]
    assert points_row[0].strip() == "Points Possible"
    assert float(points_row[-1]) == sum(points_possible(folder))
    assert rows[0][:5] == ["Lovelace, Ada", "", "", "", ""]  # the roster was not Canvas's
    assert "students are matched by name alone" in done.errors
    assert [row[-1] for row in rows][2:] == ["", ""]
    assert float(rows[0][-1]) == pytest.approx(points(folder)["007"], abs=0.05)


def points_possible(folder: Path) -> list[float]:
    problem_set = find_set(chapter_bank(), str(folder / "week_1.md"))
    return [
        part.points * problem_set.weight(problem)
        for problem in problem_set.problems
        for part in problem.parts
    ]


def test_a_column_for_each_part_adds_up_to_that_of_the_set(folder: Path) -> None:
    of_set = export(folder, "--to", "moodle-grades").rows
    of_parts = export(folder, "--to", "moodle-grades", "--columns", "parts", "--round", "6").rows
    titles = [title for title in of_parts[0] if title.startswith("Week 1")]
    assert titles[0] == "Week 1, impulse X12.5 a"
    for whole, parts in zip(of_set, of_parts, strict=True):
        given = [float(parts[title]) for title in titles if parts[title]]
        if whole["Week 1, impulse"]:
            assert sum(given) == pytest.approx(float(whole["Week 1, impulse"]), abs=0.01)
        else:
            assert not given
    assert of_parts[0]["Week 1, impulse X12.1 d"] == ""  # waits for a person


def test_csv_has_every_part_and_total_and_an_excuse_is_blank(folder: Path) -> None:
    rows = {row["id"]: row for row in export(folder, "--to", "csv").rows}
    assert list(rows["007"])[:5] == ["id", "first_name", "last_name", "email", "X12.5 a"]
    assert (rows["007"]["X12.5 a"], rows["0100"]["X12.5 a"], rows["dag"]["X12.5 a"]) == ("1", "0", "")
    assert (rows["cyd"]["total"], rows["dag"]["total"]) == ("", "")
    assert float(rows["007"]["total"]) == points(folder)["007"]
    assert float(rows["cyd"]["out_of"]) == sum(points_possible(folder))
    sets = export(folder, "--to", "csv", "--columns", "sets", "--out-of", "100", "--blank", "-").rows
    assert list(sets[0]) == ["id", "first_name", "last_name", "email", "Week 1, impulse"]
    assert [row["Week 1, impulse"] for row in sets][2:] == ["-", "-"]
    assert float(sets[0]["Week 1, impulse"]) == pytest.approx(
        100 * points(folder)["007"] / sum(points_possible(folder)), abs=0.01
    )


def test_a_file_of_the_lms_is_filled_in(folder: Path) -> None:
    text = (
        "\ufeffStudent;ID;SIS User ID;SIS Login ID;Section;Week 1, impulse (4411)\r\n"
        "    Points Possible;;;;;20,00\r\n"
        "Lovelace, Ada;2001;0x;007;Physics;\r\n"
        "Nobody, Ned;2009;0y;ned;Physics;\r\n"
    )
    (folder / "gradebook.csv").write_bytes(text.encode())
    done = export(folder, "--to", "canvas-grades", "--template", "gradebook.csv")
    mark = f"{points(folder)['007']:g}".replace(".", ",")
    assert done.text == text.replace("007;Physics;", f"007;Physics;{mark}")
    assert (done.document["strangers"], done.document["absent"]) == (
        ["Nobody, Ned 2009"],
        ["0100", "cyd", "dag"],
    )
    assert "1 student in the file but not in the course, so unchanged: Nobody, Ned 2009" in done.errors
    assert "3 students in the course but not in the file: 0100, cyd, dag" in done.errors


def test_two_sets_are_two_columns(folder: Path) -> None:
    (folder / "week_2.md").write_text((folder / "week_1.md").read_text().replace("Week 1, impulse", "Week 2"))
    done = export(folder, "--to", "moodle-grades", sets=("week_1", "week_2.md"))
    course = folder / "course"
    assert (done.status, done.errors.splitlines()[-1]) == (
        2,
        f"corollary: no submission of week_2 is graded in {course}; run corollary grade week_2 --course {course} first",
    )
    shutil.copytree(course / ".corollary/graded/week_1", course / ".corollary/graded/week_2")
    done = export(folder, "--to", "moodle-grades", sets=("week_1", "week_2.md"))
    assert (done.document["sets"], done.document["files"]) == (
        ["week_1", "week_2"],
        ["export/week_1-week_2-moodle-grades.csv"],
    )
    assert [list(row.values())[4:] for row in done.rows][2:] == [["", ""], ["", done.rows[3]["Week 2"]]]
    assert float(done.rows[3]["Week 2"]) > 0  # excused in the first week only
    assert done.rows[0]["Week 1, impulse"] == done.rows[0]["Week 2"] != ""


MOODLE = {"007": "ada", "0100": "luk", "0101": "cyd", "0102": "dag"}
IN_CANVAS = Canvas(
    {
        "2001": ("Lovelace, Ada", "S-1", "ada"),
        "2002": (f"Łukasiewicz-Østby, {FORMULA}", "S-2", "luk"),
        "2003": ("Missing, Cyd", "S-3", "cyd"),
    }
)


@pytest.mark.parametrize("words", [(), ("--blank", "-"), ("--round", "0"), ("--out-of", "100")])
@pytest.mark.parametrize("decimal", [".", ","])
def test_moodles_rules_take_the_file_in_any_language(
    folder: Path, words: tuple[str, ...], decimal: str
) -> None:
    done = export(folder, "--to", "moodle-grades", *words)
    title = "Week 1, impulse"
    found = moodle(done.text.encode(), "ID number", MOODLE, title, decimal)
    of_file = {MOODLE[row["ID number"]]: row[title] for row in done.rows}
    assert found == {who: None if mark in ("", "-") else float(mark) for who, mark in of_file.items()}
    assert found["ada"]
    assert (found["cyd"], found["dag"]) == (None, None)
    by_mail = moodle(
        done.text.encode(),
        "Email address",
        {row["Email address"]: row["ID number"] for row in done.rows},
        title,
    )
    assert by_mail["007"] == found["ada"]
    with pytest.raises(Refused, match="nobody is 0102"):
        moodle(done.text.encode(), "ID number", {"007": "ada", "0100": "luk", "0101": "cyd"}, title)


def test_a_template_with_decimal_commas_is_taken_where_moodle_speaks_so(folder: Path) -> None:
    text = '\ufeffID-Nummer,"Aufgabe: Week 1, impulse (Punkte)"\r\n007,"1,50"\r\n0100,-\r\n'
    (folder / "grades.csv").write_text(text, encoding="utf-8", newline="")
    title = "Aufgabe: Week 1, impulse (Punkte)"
    done = export(folder, "--to", "moodle-grades", "--template", "grades.csv", "--column", title)
    found = moodle(done.text.encode(), "ID-Nummer", MOODLE, title, ",")
    assert found == {"ada": points(folder)["007"], "luk": points(folder)["0100"]}
    with pytest.raises(Refused, match="is not a number"):
        moodle(done.text.encode(), "ID-Nummer", MOODLE, title, ".")


def test_a_mark_that_moodle_refuses_is_said(folder: Path) -> None:
    done = export(folder, "--to", "moodle-grades", "--out-of", "200")
    with pytest.raises(Refused, match="too large"):
        moodle(done.text.encode(), "ID number", MOODLE, "Week 1, impulse")
    assert "Moodle takes no file with a mark above 100" in done.errors


@pytest.mark.parametrize("template", [False, True])
def test_canvas_rules_find_everybody_and_ask_about_none(folder: Path, template: bool) -> None:
    words: tuple[str, ...] = ()
    if template:
        head = "Student;ID;SIS User ID;SIS Login ID;Section;Week 1, impulse (4411)"
        names = {number: about[0].replace('"', '""') for number, about in IN_CANVAS.students.items()}
        lines = [f'"{name}";{number};;;A;' for number, name in names.items()]
        (folder / "gradebook.csv").write_text(
            "\n".join([head, "    Points Possible;;;;;1.234,00", *lines, ""])
        )
        words = ("--template", "gradebook.csv")
    done = export(folder, "--to", "canvas-grades", *words)
    found, asked, out_of = IN_CANVAS.taken(done.text.encode(), "Week 1, impulse")
    assert float(found["2001"]) == points(folder)["007"]
    assert found["2003"] == ""
    assert asked == ([] if template else ["Excused, Dag"])  # who is in our course and not in Canvas's
    assert out_of == (1234 if template else sum(points_possible(folder)))


REFUSED = [
    (("--to", "md", "--round", "1"), "--round is for marks, and md holds none; leave it out"),
    (
        ("--to", "moodle-grades", "--column", "x"),
        "--column names a column of a template; give the file with --template",
    ),
    (("--to", "moodle-grades", "--template", "none.csv"), "none.csv:1: cannot be read"),
]


@pytest.mark.parametrize(("words", "sentence"), REFUSED)
def test_what_does_not_fit_is_refused(folder: Path, words: tuple[str, ...], sentence: str) -> None:
    done = export(folder, *words)
    assert (done.status, done.document) == (2, {})
    assert sentence in done.errors
    assert not (folder / "export").exists()
