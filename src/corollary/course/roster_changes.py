"""A roster that changes: who is new, who is no longer on it, and what it is afterwards."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from corollary.problem.roster import TWINS, Student
from corollary.records.files import open_course, students


class OneFolder(ValueError):
    """Two ids that many disks take for one; a sentence says which."""


@dataclass(frozen=True, slots=True)
class RosterChange:
    """The course's roster and a new file held together. `missing` are those of the course whom the file does not have, each
    with the id that somebody of the same email or name has there (or ""); `roster` is what it becomes, without them."""

    roster: tuple[Student, ...]
    new: tuple[Student, ...]
    missing: tuple[tuple[Student, str], ...]


def students_before(folder: Path) -> tuple[Student, ...]:
    """Who is on the course's roster already; nobody when there is no course yet. Raises NotACourse."""
    if not (folder / ".corollary" / "roster.csv").exists():
        return ()
    return students(open_course(folder))


def roster_change(before: Sequence[Student], file: Sequence[Student]) -> RosterChange:
    """What a file changes. One in which nobody of the course stands is a list of newcomers, and takes nobody away.

    Raises OneFolder.
    """
    old, found = {each.id: each for each in before}, {each.id: each for each in file}
    new = tuple(each for each in file if each.id not in old)
    lower = {each.lower(): each for each in old}
    for each in new:
        if twin := lower.get(each.id.lower()):
            raise OneFolder(f"id {each.id} and {twin}, who is in the course, {TWINS}")
    if not old.keys() & found.keys():
        return RosterChange((*before, *new), new, ())
    stay = [_renewed(each, found[each.id]) for each in before if each.id in found]
    missing = tuple((each, _same_person(each, new)) for each in before if each.id not in found)
    return RosterChange((*stay, *new), new, missing)


def check_folders(roster: Iterable[Student], set_name: str) -> None:
    """Raises OneFolder where a student's folder would be the set's: nbgrader has the chapter's sheet in release/SET, and
    gives all that lies there to everybody."""
    for each in roster:
        if each.id.lower() == set_name.lower():
            raise OneFolder(
                f"id {each.id} is the name of the set too, and release/{each.id}/ would hold the sheets of both; "
                "give the set's file another name, or take other ids with --id-column"
            )


def _renewed(old: Student, now: Student) -> Student:
    """What the file says, and where it says nothing what was known."""
    return replace(
        now,
        first_name=now.first_name or old.first_name,
        last_name=now.last_name or old.last_name,
        email=now.email or old.email,
        ids=tuple((dict(old.ids) | dict(now.ids)).items()),
    )


def _same_person(student: Student, new: Sequence[Student]) -> str:
    """The id of a newcomer with this student's email or name: most likely it is the id that changed."""
    for each in new:
        if (student.email and each.email.lower() == student.email.lower()) or (
            student.last_name and each.name.lower() == student.name.lower()
        ):
            return each.id
    return ""
