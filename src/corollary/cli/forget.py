"""`corollary forget`: one student's data taken out of a course."""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict
from pathlib import Path

from corollary.cli.ending import FAILS, HOLDS, agreed, answer, counted, say, say_each
from corollary.cli.terminal import console, countdown
from corollary.course.personal_data import PersonalData, find_data, take_out
from corollary.messages import visible
from corollary.problem.roster import Student
from corollary.records.files import Course, UnknownStudent, one_writer, open_course
from corollary.records.forgotten import forgotten
from corollary.records.person import Person, find_person, person_of


def run(student: str, course: Path, dry_run: bool, yes: bool, as_json: bool) -> int:
    opened = open_course(course)
    person = _person(opened, student)
    found = find_data(opened, person)
    who = f"{person.id} ({person.student.name})" if person.student.name != person.id else person.id
    if dry_run:
        _show(found, as_json, person.id, done=False)
        say("nothing was changed: this was a dry run")
        return HOLDS
    if not yes:
        _show(found, False, person.id, done=False, stderr=True)
    question = f"Take the data of {who} out of the course {opened.folder}? It cannot be brought back."
    if not agreed(question, yes):
        if as_json:
            answer(_document(found, person.id, done=False))
        return FAILS
    with one_writer(opened), countdown(f"taking out {person.id}") as progress:
        done = take_out(opened, person, lambda name: progress(name, 0))
    _show(done, as_json, person.id, done=True)
    return FAILS if done.left else HOLDS


def _person(course: Course, name: str) -> Person:
    """The student; also one whom an earlier run, cut short, has taken off the roster already."""
    try:
        return find_person(course, name)
    except UnknownStudent:
        if not forgotten(course, [name]):
            raise
        return person_of(course, Student(name))


def _document(found: PersonalData, student: str, *, done: bool) -> dict[str, object]:
    return {
        "student": student,
        "done": done,
        "places": [asdict(each) for each in found.places],
        "left": found.left,
    }


def _show(found: PersonalData, as_json: bool, student: str, *, done: bool, stderr: bool = False) -> None:
    if as_json:
        answer(_document(found, student, done=done))
        return
    from rich.table import Table  # only where a table is printed

    groups = Counter[tuple[str, str]]()
    rows = Counter[tuple[str, str]]()
    for each in found.places:
        group = _group(each.path, each.action), each.action
        groups[group] += 1
        rows[group] += each.entries
    table = Table(
        "place", "files", "entries", "what happened" if done else "what happens", box=None, pad_edge=False
    )
    words = {
        "delete": "deleted",
        "change": "the entries taken out",
        "write again": "written again without them",
    }
    for group, count in groups.items():
        table.add_row(visible(group[0]), str(count), str(rows[group]), words[group[1]])
    out = console(stderr=stderr)
    if found.places:
        out.print(table)
    else:
        out.print(f"nothing of {student} is in this course", highlight=False)
    say_each((f"{visible(place)}: {why}" for place, why in found.left.items()), "--json lists all")
    if done:
        deleted, changed = found.count("delete"), found.count("change", "write again")
        out.print(f"{counted(deleted, 'file')} deleted, {changed} changed", highlight=False)


def _group(path: str, action: str) -> str:
    """The folder that a person knows a file by."""
    if path.startswith("/"):
        return "the exchange"
    parts = path.split("/")
    if parts[0] == ".corollary":
        return "/".join(parts[:2]) + ("/" if len(parts) > 2 else "")
    return f"{parts[0]}/" if len(parts) > 1 else parts[0]
