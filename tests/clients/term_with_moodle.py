"""A set's way through a course of Moodle's: roster, sheets given out, notebooks collected, marks and feedback; Moodle's part is
played by Moodle itself, or by what it gave when it was last asked."""

from __future__ import annotations

import hashlib
import io
import json
import os
import subprocess
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from tests import forked

from corollary.course.demo.players import right_sources
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in
from corollary.notebook.worksheet import worksheet
from corollary.problem.bank import chapter_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.assignments import read_assigned
from corollary.records.files import open_course, students

DRIVER = Path(__file__).with_name("moodle_course.php")
TITLE = "Week 1, impulse"
SET = f"""---
title: {TITLE}
due: 2026-01-05T23:59:59+00:00
reveal: after due
credit: {{late: 0.777}}
problems:
  - X12.5
---
One exercise.
"""
DUE = 1767657599  # 2026-01-05 23:59:59 UTC
IN_TIME, LATE = DUE - 86400 * 3, DUE + 86400 * 2
HYPERLINK = '=HYPERLINK("https://example.org";"click")'


@dataclass(frozen=True, slots=True)
class Person:
    """A student of Moodle's; `hands_in` is right, wrong in the first part, or "" for nothing."""

    username: str
    first: str
    last: str
    number: str
    hands_in: str = "right"
    late: bool = False
    file: str = "week_1.ipynb"

    @property
    def email(self) -> str:
        return f"{self.username}@example.org"


CLASS = (
    Person("corollary-ada", "Ada", "Lovelace", "007", late=True),
    Person("corollary-jo", 'Jo "Lucky"', "O'Neil; Müller, Jr.", "0100", file="Müllers Übung (1).ipynb"),
    Person("corollary-eve", HYPERLINK, "Under_Score", "12,5", hands_in="wrong"),
    Person("corollary-cyd", "Cyd", "Missing", "1e3", hands_in=""),
    Person("corollary-dag", "Dag", "Excused", "0102"),
    Person("corollary-anna1", "Anna", "Li", "Ä-1"),
    Person("corollary-anna2", "Anna", "Li", "b-2", hands_in="wrong"),
    Person("corollary-wang", "小明", "王", "x y", late=True),
    Person("corollary-zoe", "Zoë-Ann", "d'Été / Ø.", "0,7"),
)
EXCUSED = "corollary-dag"


class Lms(Protocol):
    """What a course asks of Moodle."""

    def gradebook(self) -> str: ...
    def worksheet(self) -> str: ...
    def submissions(self, handed_in: Mapping[str, Path], *, folders: bool) -> bytes: ...


@dataclass(frozen=True, slots=True)
class Moodle:
    """An installed Moodle with a course of its own, in which the class is and one assignment."""

    folder: str
    scratch: Path
    assignment: int
    version: str
    decimal: str = "."

    @classmethod
    def opened(cls, folder: str, scratch: Path, *, out_of: int = 100, decimal: str = ".") -> Moodle:
        new = cls(folder, scratch, 0, "", decimal)
        people = [
            {"username": each.username, "firstname": each.first, "lastname": each.last,
             "idnumber": each.number, "email": each.email}
            for each in CLASS
        ]  # fmt: skip
        found = new.told("open", title=TITLE, out_of=out_of, due=DUE, students=people)
        return cls(folder, scratch, found["assignment"], found["version"], decimal)

    def ask(self, action: str, **given: object) -> bytes:
        arguments = self.scratch / "arguments.json"
        arguments.write_text(
            json.dumps({"assignment": self.assignment, "decimal": self.decimal, **given}), encoding="utf-8"
        )
        line = [
            "php", "-d", "memory_limit=2G", "-d", "max_input_vars=5000", "-d", "display_errors=stderr",
            DRIVER, self.folder, action, arguments,
        ]  # fmt: skip
        run = subprocess.run(line, capture_output=True, check=False)
        assert run.returncode == 0, f"{action}: {(run.stdout + run.stderr)[-2000:].decode(errors='replace')}"
        return run.stdout

    def told(self, action: str, **given: object) -> dict[str, Any]:
        # Where a page was made, Moodle closes it when it ends.
        return json.JSONDecoder().raw_decode(self.ask(action, **given).decode())[0]

    def gradebook(self) -> str:
        return self.ask("gradebook").decode()

    def worksheet(self) -> str:
        return self.ask("worksheet").decode()

    def submissions(self, handed_in: Mapping[str, Path], *, folders: bool) -> bytes:
        files = [
            {"username": each.username, "when": LATE if each.late else IN_TIME,
             "files": {each.file: str(handed_in[each.username])}}
            for each in CLASS if each.username in handed_in
        ]  # fmt: skip
        self.told("submit", handed_in=files)
        return self.ask("submissions", folders=folders)

    def read(self) -> dict[str, dict[str, Any]]:
        return self.told("read")["students"]


@dataclass(frozen=True, slots=True)
class Remembered:
    """What Moodle gave: its two tables, and by the names in its archive whose notebook it was."""

    gradebook_table: str
    worksheet_table: str
    names: Mapping[str, str] = field(default_factory=dict[str, str])

    def gradebook(self) -> str:
        return self.gradebook_table

    def worksheet(self) -> str:
        return self.worksheet_table

    def submissions(self, handed_in: Mapping[str, Path], *, folders: bool) -> bytes:
        made = io.BytesIO()
        with zipfile.ZipFile(made, "w") as archive:
            for name, username in self.names.items():
                archive.writestr(name, handed_in[username].read_bytes())
        return made.getvalue()


@dataclass(frozen=True, slots=True)
class Term:
    """The folder in which a term is played; `course` is in it."""

    folder: Path

    def run(self, *words: str) -> dict[str, Any]:
        """What a command of ours printed as JSON, with what it said besides as `said`."""
        line = [forked.COMMAND, *words, "--course", "course", "--json"]
        done = forked.run(line, cwd=self.folder, env={**os.environ, "TZ": "UTC"})
        assert done.returncode == 0, done.stderr
        return {**json.loads(done.stdout), "said": done.stderr}

    def begin(self, roster: str) -> None:
        """The sheets, for a list of the class."""
        (self.folder / "week_1.md").write_text(SET, encoding="utf-8")
        self.save("roster.csv", roster)
        self.run("generate", "week_1.md", "--roster", "roster.csv", "--yes")

    def give_out(self, lms: Lms) -> Path:
        """The archive with everybody's sheet."""
        self.save("before.csv", lms.worksheet())
        self.run("release", "week_1", "--to", "moodle", "--ids", "before.csv", "-o", "given_out")
        return self.folder / "given_out" / "week_1-moodle.zip"

    def collect(self, lms: Lms, *, folders: bool) -> dict[str, Any]:
        """What Moodle's archive of all submissions and its worksheet brought."""
        archive = self.folder / "submissions.zip"
        archive.write_bytes(lms.submissions(self.handed_in(), folders=folders))
        self.save("after.csv", lms.worksheet())
        return self.run("collect", "week_1", "submissions.zip", "--times", "after.csv")

    def grade(self) -> None:
        self.run("extend", self.ids[EXCUSED], "week_1", "--excuse")
        self.run("grade", "week_1", "--jobs", "1")

    def export(self, *words: str) -> Path:
        (name,) = self.run("export", "week_1", *words)["files"]
        return self.folder / name

    def save(self, name: str, text: str) -> Path:
        (self.folder / name).write_text(text, encoding="utf-8", newline="")
        return self.folder / name

    @property
    def ids(self) -> dict[str, str]:
        """What the course calls each, by username: whoever has the email address, which may be the login."""
        roster = students(open_course(self.folder / "course"))
        known = {value: each.id for each in roster for value in (each.email, *dict(each.ids).values())}
        return {each.username: known[each.email] for each in CLASS}

    @property
    def marks(self) -> dict[str, float | None]:
        """By username, what the report says; nothing for who has handed in nothing or is excused."""
        found = self.run("report", "week_1")["students"]
        points = {who: found[own]["points"] if own in found else None for who, own in self.ids.items()}
        return points | {EXCUSED: None}

    def handed_in(self) -> dict[str, Path]:
        """A notebook of everybody who hands one in, as a file outside of the course."""
        bank = chapter_bank()
        problem_set, solutions = find_set(bank, str(self.folder / "week_1.md")), Solutions(bank)
        course = open_course(self.folder / "course")
        assigned, ids = read_assigned(course, problem_set), self.ids
        roster: dict[str, Student] = {each.id: each for each in students(course)}
        found: dict[str, Path] = {}
        for each in CLASS:
            if not each.hands_in:
                continue
            student = roster[ids[each.username]]
            sheet = worksheet(problem_set, student, assigned[student.id].variants)
            keys = {one.problem.code: solutions.key(one.variant) for one in sheet.exercises}
            sources = right_sources(sheet, keys)
            if each.hands_in == "wrong":
                sources["X12_5_a_answer"] = f"{sheet.prompts[0].name} = 1e9"
            found[each.username] = self.save(f"{each.username}.ipynb", filled_in(sheet, sources))
        return found


def names_in(archive: Path | bytes) -> list[str]:
    with zipfile.ZipFile(archive if isinstance(archive, Path) else io.BytesIO(archive)) as opened:
        return sorted(opened.namelist())


def fingerprint(file: Path) -> str:
    """Of a table its bytes; of an archive the names in it, for what is in it follows from the course's key."""
    if file.suffix == ".zip":
        return _hash("\n".join(names_in(file)).encode())
    return _hash(file.read_bytes())


def sha1(path: Path) -> str:
    """What Moodle knows the content of a file by."""
    return hashlib.sha1(path.read_bytes()).hexdigest()


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:16]
