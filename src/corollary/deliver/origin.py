"""Where a problem set came from: recorded when it is dealt, so that it can be marked later by whoever has only the course."""

from __future__ import annotations

import json
from pathlib import Path

from corollary.deliver.course import Course, NotACourse, write_atomically
from corollary.problem.bank import Bank, Unknown, chapter_bank, open_bank
from corollary.problem.problem_set import ProblemSet, find_set


def write_origin(course: Course, set_name: str, bank: Bank, file: Path | None = None) -> None:
    """Records the bank, and the set's file when it lies outside the bank. The chapter's bank is recorded as such: it moves
    when the program is installed anew."""
    place = None if _is_chapters(bank) else str(bank.folder.resolve())
    record = {"bank": place, "set": None if file is None else str(file.resolve())}
    write_atomically(_path(course, set_name), json.dumps(record) + "\n")


def read_origin(course: Course, set_name: str) -> tuple[Bank, ProblemSet]:
    """The bank and the set. Raises NotACourse when nothing was recorded, Unknown when it has moved, and Malformed."""
    path = _path(course, set_name)
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        place, file = record["bank"], record["set"]
    except (OSError, ValueError, TypeError, KeyError):
        raise NotACourse(
            f"{course.folder} does not say which bank {set_name} comes from; generate it again (everybody keeps their numbers)"
        ) from None
    bank = open_bank(None if place is None else Path(place))
    return bank, find_set(bank, set_name if file is None else file)


def _path(course: Course, set_name: str) -> Path:
    return course.folder / ".corollary" / "origin" / f"{set_name}.json"


def _is_chapters(bank: Bank) -> bool:
    try:
        return bank.folder.resolve() == chapter_bank().folder.resolve()
    except Unknown:
        return False
