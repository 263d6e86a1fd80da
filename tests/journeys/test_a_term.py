"""A term as an instructor lives it, by the commands alone: from Moodle's list of participants to the marks in Moodle."""

from __future__ import annotations

import csv
import html
import io
import json
import os
import re
import shutil
import sqlite3
import sys
import time
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from tests import forked

pytestmark = pytest.mark.term
BIN = Path(sys.executable).parent
ENVIRONMENT = {**os.environ, "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}", "TZ": "America/New_York"}
REPOSITORY = Path(__file__).parents[2]

# As Moodle of a German university gives it: semicolons, Windows-1252.
PARTICIPANTS = """\
Vorname;Nachname;E-Mail-Adresse;ID-Nummer
Ada;Lovelace;ada@example.org;1001
Björn;Ångström;bjorn@example.org;1002
Chloé;Dupont;chloe@example.org;1003
Dev;Patel;dev@example.org;1004
Eve;Smith;eve@example.org;1005
Finn;O'Hara;finn@example.org;1006
"""
SET = """\
---
title: Week 1
opens: 2024-03-01
due: 2024-03-08
reveal: after extensions
credit: {mistaken: 0.25, late: 0.8}
problems:
  - X12.5
  - S12.1
---
The first week.
"""
OUT_OF = 12.0
NAMES = {
    "1001": "Ada Lovelace",
    "1002": "Björn Ångström",
    "1003": "Chloé Dupont",
    "1004": "Dev Patel",
    "1005": "Eve Smith",
    "1006": "Finn O'Hara",
}
# Moodle's grading worksheet; its times are the course's. Björn was a day late, all others in time.
WORKSHEET = (
    "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Last modified (submission)\n"
    + "".join(
        f'Participant 9{n},{name},{email},Submitted for grading,,12.00,Yes,"{day}, {day_of_march} March 2024, 9:30 PM"\n'
        for n, name, email, day, day_of_march in [
            ("01", "Ada Lovelace", "ada@example.org", "Thursday", 7),
            ("02", "Björn Ångström", "bjorn@example.org", "Saturday", 9),
            ("03", "Chloé Dupont", "chloe@example.org", "Friday", 8),
            ("04", "Dev Patel", "dev@example.org", "Friday", 8),
            ("05", "Eve Smith", "eve@example.org", "Friday", 8),
            ("06", "Finn O'Hara", "finn@example.org", "Friday", 8),
        ]
    )
)


@dataclass(frozen=True, slots=True)
class Done:
    status: int
    out: str
    err: str

    @property
    def document(self) -> dict[str, Any]:
        return json.loads(self.out)


@dataclass(frozen=True, slots=True)
class Term:
    """A course of one bank of its own; `run` is the command in the course's folder."""

    folder: Path

    @property
    def course(self) -> Path:
        return self.folder / "mechanics"

    def run(self, *words: object, program: str = "corollary", fails: bool = False) -> Done:
        line = [BIN / program, *words]
        here = self.course if self.course.is_dir() else self.folder
        done = forked.run(line, cwd=here, env=ENVIRONMENT)
        assert "Traceback" not in done.stderr, done.stderr
        if not fails:
            assert done.returncode == 0, (line, done.stdout, done.stderr)
        return Done(done.returncode, done.stdout, done.stderr)

    def keys(self, student: str) -> dict[str, Any]:
        """The right answers to a student's own numbers, by part, as the key has them."""
        parts: dict[str, Any] = {}
        for code in ("X12.5", "S12.1"):
            shown = self.run("show", code, "--student", student, "--json").document
            given = [f"--set={name}={value!r}" for name, value in shown["given"].items()]
            key = self.run("key", code, *given, "--json").document["parts"]
            parts |= {f"{code.replace('.', '_')}_{part}": row for part, row in key.items()}
        return parts


def answered(notebook: bytes, answers: Mapping[str, object]) -> bytes:
    """The notebook with these answers typed into it."""
    sheet = json.loads(notebook)
    for cell in sheet["cells"]:
        name = cell["id"].removesuffix("_answer")
        if cell["id"].endswith("_answer") and name in answers:
            cell["source"] = f"{name} = {answers[name]!r}"
        elif cell["cell_type"] == "markdown" and name in answers:  # what is explained is written as text
            cell["source"] = answers[name]
    return json.dumps(sheet).encode()


def right(keys: Mapping[str, Any]) -> dict[str, object]:
    """What a good student types."""
    answers: dict[str, object] = {}
    for name, row in keys.items():
        if "value" in row:
            answers[name] = row["value"]
        elif "choice" in row:
            answers[name] = row["choice"]
        else:
            answers[name] = "Momentum is conserved, for nothing else acts in so short a time."
    return answers


def bank_in(folder: Path) -> Path:
    """A bank of one's own, with two of the chapter's problems, so that they can be corrected."""
    bank = folder / "bank"
    for code in ("kicking_a_ball", "meteor_impact"):
        for kind in ("problems", "solutions"):
            (found,) = (REPOSITORY / kind).rglob(f"{code}.md")
            place = bank / found.relative_to(REPOSITORY)
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(found, place)
    (bank / "problems" / "sets").mkdir()
    (bank / "problems" / "sets" / "week1.md").write_text(SET)
    return bank


def zipped(files: Mapping[str, bytes]) -> bytes:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return made.getvalue()


def unzipped(path: Path) -> dict[str, bytes]:
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


@pytest.fixture(scope="module")
def term(tmp_path_factory: pytest.TempPathFactory) -> Term:
    """A course in Berlin, run from New York, with the set generated for Moodle's participants."""
    made = Term(tmp_path_factory.mktemp("term"))
    bank = bank_in(made.folder)
    made.course.mkdir()
    (made.course / "corollary.toml").write_text(f'timezone = "Europe/Berlin"\nbank = "{bank}"\n')
    participants = made.folder / "participants.csv"
    participants.write_bytes(PARTICIPANTS.encode("cp1252"))
    generated = made.run("generate", "week1", "--roster", participants, "--course", ".")
    assert "so every hand-in counts as late" in generated.err
    return made


@pytest.fixture(scope="module")
def given_out(term: Term) -> dict[str, bytes]:
    """The notebook that each student has from Moodle."""
    worksheet = term.folder / "worksheet.csv"
    worksheet.write_text(WORKSHEET, encoding="utf-8-sig")
    done = term.run(
        "release", "week1", "--to", "moodle", "--ids", worksheet, "-o", term.folder / "out", "--json"
    )
    (archive,) = (term.folder / "out").glob("*.zip")
    assert done.document
    files = unzipped(archive)
    people = {name: student for student, name in NAMES.items()}
    return {people[name.split("_")[0]]: content for name, content in files.items()}


@pytest.fixture(scope="module")
def collected(term: Term, given_out: dict[str, bytes]) -> dict[str, Any]:
    """What Moodle's "download all submissions" holds, taken into the course."""
    work: dict[str, dict[str, bytes]] = {}
    for student in ("1001", "1002", "1003"):
        answers = right(term.keys(student))
        if student == "1003":  # Chloé takes the mean force for the impulse
            answers["X12_5_b"] = answers["X12_5_c"]
        work[student] = {"week1.ipynb": answered(given_out[student], answers)}
    work["1004"] = {"week1 (1).ipynb": answered(given_out["1004"], right(term.keys("1004")))}
    work["1005"] = {"week1.pdf": b"%PDF-1.4 a scan"}
    work["1006"] = {"week1.ipynb": answered(given_out["1001"], right(term.keys("1001")))}  # Ada's sheet
    files = {
        f"{NAMES[student]}_9{student[-2:]}_assignsubmission_file_/{name}": content
        for student, files in work.items()
        for name, content in files.items()
    }
    archive = term.folder / "PHYS1-Week 1-2291.zip"
    archive.write_bytes(zipped(files))
    return term.run("collect", "week1", archive, "--times", term.folder / "worksheet.csv", "--json").document


@pytest.fixture(scope="module")
def graded(term: Term, collected: dict[str, Any]) -> dict[str, Any]:
    return term.run("grade", "week1", "--json").document["students"]


def test_everybody_has_a_sheet_of_their_own(term: Term, given_out: dict[str, bytes]) -> None:
    assert set(given_out) == set(NAMES)
    for student, content in given_out.items():
        assert content == (term.course / "release" / student / "week1" / "week1.ipynb").read_bytes()
        assert "Friday 8 March 2024, 23:59 (Europe/Berlin)" in content.decode()
    numbers = [term.run("show", "X12.5", "--student", each, "--json").document["given"] for each in NAMES]
    assert len({json.dumps(each) for each in numbers}) == len(NAMES)


def test_what_came_back_is_taken_or_named(term: Term, collected: dict[str, Any]) -> None:
    assert {each["student"] for each in collected["accepted"]} == {"1001", "1002", "1003", "1004", "1006"}
    assert [(each["student"], each["why"]) for each in collected["unusable"]] == [
        ("1005", "is not a notebook; ask for week1.ipynb")
    ]
    assert "made for 1001" in " ".join(collected["conflicts"])
    assert collected["missing"] == ["1005"]


def test_marks_are_fair_to_everybody(graded: dict[str, Any]) -> None:
    waiting = {each: row["parts"]["S12_1_d"]["verdict"] for each, row in graded.items()}
    assert set(waiting.values()) == {"unmarked"}, (waiting, graded["1006"])
    assert graded["1001"]["points"] == graded["1004"]["points"] == OUT_OF - 2
    assert graded["1002"]["points"] == pytest.approx(0.8 * (OUT_OF - 2)), "a day late"
    assert graded["1003"]["parts"]["X12_5_b"]["verdict"] == "mistaken"
    assert graded["1003"]["points"] == OUT_OF - 2 - 0.75
    assert graded["1006"]["points"] < 4, "the neighbour's numbers are not Finn's"
    assert "1005" not in graded


def test_marks_by_hand_are_everywhere_at_once(
    term: Term, graded: dict[str, Any], chromium: Any, jupyter: Any
) -> None:
    """Ada's in formgrader, in a browser; Dev's by the command."""
    extension = "--ServerApp.jpserver_extensions={'nbgrader.server_extensions.formgrader': True}"
    with jupyter("server", term.course, term.folder, extension) as address:
        page = chromium.new_page()
        page.goto(f"{address}/formgrader/submissions/{submitted_notebook(term, '1001')}/")
        page.wait_for_selector("#S12_1_d")
        page.wait_for_load_state("networkidle")
        page.fill("#S12_1_d", "1.5")
        page.keyboard.press("Tab")
        while manual_score(term, "1001", "S12_1_d") != 1.5:
            time.sleep(0.1)
        page.close()
    term.run("mark", "week1", "--set", "1004/S12.1d=2")
    parts = term.run("report", "week1", "--json").document["parts"]
    assert sum(part["counts"]["by_hand"] for part in parts) == 2
    totals = {row["id"]: row["total"] for row in exported(term, "csv", "week1")}
    assert (totals["1001"], totals["1004"]) == ("11.5", "12")
    term.run("grade", "week1")
    read = {
        each: words((term.course / "feedback" / each / "week1" / "week1.html").read_bytes())
        for each in ("1001", "1004")
    }
    assert "11.5 of 12 points" in read["1001"]
    assert "12 of 12 points" in read["1004"]


def words(page: bytes) -> str:
    """What a person reads on a page."""
    text = re.sub(r"<(style|script).*?</\1>|<[^>]+>", " ", page.decode(), flags=re.DOTALL)
    return re.sub(r"\s+", " ", html.unescape(text))


def exported(term: Term, target: str, *words: object) -> list[dict[str, str]]:
    folder = term.folder / f"export-{target}"
    shutil.rmtree(folder, ignore_errors=True)
    term.run("export", *words, "--to", target, "-o", folder)
    (path,) = folder.iterdir()
    return list(csv.DictReader(io.StringIO(path.read_text(encoding="utf-8-sig"))))


def test_a_corrected_problem_moves_no_numbers_and_marks_only_with_consent(
    term: Term, graded: dict[str, Any]
) -> None:
    numbers = {
        each: term.run("show", "X12.5", "--student", each, "--json").document["given"] for each in NAMES
    }
    problem = term.folder / "bank" / "problems" / "impulse" / "kicking_a_ball.md"
    text = problem.read_text()
    wider = re.sub(r"(m: .*from: )[\d.]+", r"\g<1>0.36", text)
    assert wider != text
    problem.write_text(wider)
    assert numbers == {
        each: term.run("show", "X12.5", "--student", each, "--json").document["given"] for each in NAMES
    }
    before = points(term)
    quiet = term.run("grade", "week1", "--json").document
    assert (quiet["changed"], points(term)) == ([], before)
    sets = term.folder / "bank" / "problems" / "sets" / "week1.md"
    sets.write_text(sets.read_text().replace("mistaken: 0.25", "mistaken: 0.5"))
    refused = term.run("grade", "week1", fails=True)
    assert refused.status == 1
    assert "1003" in refused.out
    assert points(term) == before
    dry = term.run("grade", "week1", "--dry-run", fails=True)
    assert (dry.status, points(term)) == (0, before)
    term.run("grade", "week1", "--yes")
    mistaken = {
        each: sum(part["out_of"] for part in row["parts"].values() if part["verdict"] == "mistaken")
        for each, row in graded.items()
    }
    assert mistaken["1003"] == 1
    # A neighbour's answers may be a known mistake with one's own numbers: Finn's count as well.
    assert points(term) == before | {each: before[each] + 0.25 * worth for each, worth in mistaken.items()}


def test_an_extension_makes_nobody_late(term: Term, graded: dict[str, Any]) -> None:
    before = points(term)
    term.run("extend", "1002", "week1", "2024-03-10")
    term.run("grade", "week1", "--yes")
    assert points(term) == before | {"1002": OUT_OF - 2}
    term.run("extend", "1005", "week1", "--excuse")


def test_marks_and_feedback_go_back_to_moodle(term: Term, graded: dict[str, Any]) -> None:
    rows = exported(term, "moodle-grades", "week1")
    marks = {
        row["ID number"] if "ID number" in row else row["ID-Nummer"]: list(row.values())[-1] for row in rows
    }
    assert set(marks) == set(NAMES)
    assert marks["1005"] == "", "excused, and not 0"
    assert marks["1002"] == "10"
    folder = term.folder / "feedback-zip"
    term.run("export", "week1", "--to", "feedback-zip", "--ids", term.folder / "worksheet.csv", "-o", folder)
    (archive,) = folder.glob("*.zip")
    pages = unzipped(archive)
    assert len(pages) == 5
    for name, page in pages.items():
        person, participant = name.split("_")[:2]
        assert name.startswith(f"{person}_9{participant[1:]}_assignsubmission_file_/")
        assert person in words(page)
        assert not any(other in words(page) for other in NAMES.values() if other != person)


def points(term: Term) -> dict[str, float]:
    """The marks of all, by nbgrader's own gradebook."""
    from nbgrader.api import Gradebook

    with Gradebook(f"sqlite:///{term.course / 'gradebook.db'}") as book:
        return {each.student.id: each.score for each in book.assignment_submissions("week1")}


def query(term: Term, text: str, *values: str) -> Any:
    with sqlite3.connect(term.course / "gradebook.db") as book:
        row = book.execute(text, values).fetchone()
    return None if row is None else row[0]


def submitted_notebook(term: Term, student: str) -> str:
    return query(
        term,
        "select n.id from submitted_notebook n join submitted_assignment s on n.assignment_id = s.id where s.student_id = ?",
        student,
    )


GRADE = "from grade g join base_cell c on g.cell_id = c.id where g.notebook_id = ? and c.name = ?"


def manual_score(term: Term, student: str, cell: str) -> float | None:
    return query(term, f"select g.manual_score {GRADE}", submitted_notebook(term, student), cell)
