"""The origin of a problem set: its bank, and its file when it lies outside the bank.

Recorded when a set is generated, so that it can be marked later by whoever has only the course.
"""

from __future__ import annotations

import json
import os
from contextlib import suppress
from pathlib import Path

from corollary.atomic import write_whole
from corollary.messages import did_you_mean
from corollary.problem.bank import VARIABLE, Bank, UnknownCode, bank_around, chapter_bank, home, open_bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet, file_of_set, find_set, set_names
from corollary.records.files import Course, NotACourse
from corollary.records.settings import read_settings


def write_origin(course: Course, set_name: str, bank: Bank, file: Path | None = None) -> None:
    """Record the bank, and the set's file unless the bank has it by this name.

    The chapter's bank is recorded as such: it moves when the program is installed anew. A file in the course's folder is recorded
    relative to it: both may move together.
    """
    place = None if _is_chapters(bank) else bank.place
    record = {"bank": place, "set": None if file is None else _place_of(course, set_name, bank, file)}
    write_whole(_origin(course, set_name), json.dumps(record) + "\n")


def _place_of(course: Course, set_name: str, bank: Bank, file: Path) -> str | None:
    of_bank = file_of_set(bank, set_name)
    if of_bank is not None and of_bank.samefile(file):
        return None
    whole, folder = (
        Path(os.path.abspath(file)),
        Path(os.path.abspath(course.folder)),
    )  # the name of a link is the set's
    return whole.relative_to(folder).as_posix() if whole.is_relative_to(folder) else str(whole)


def set_of(course: Course, name: str, folder: Path | None = None) -> tuple[Bank, ProblemSet]:
    """The set of this name, or in the file of this path, and its bank: the one in `folder`, else the one that the set was
    generated from, else the course's, else one that other sets of the course were generated from, else the chapter's. A set that
    has a file of its own outside its bank is read from there, whatever bank its problems are from.

    Raises NotACourse when the record is damaged, UnknownCode when the bank has moved, and Malformed.
    """
    is_file = name.endswith(".md")
    set_name = Path(name).stem if is_file else name
    settings = read_settings(course.folder)
    if (
        folder is not None
        or not has_set(course, set_name)
        or (is_file and not _is_readable(course, set_name))
    ):
        named = folder or (Path(settings.bank) if settings.bank else None)
        around = None if named else bank_around(name)
        bank, file = around or open_bank(named), None
        if named is around is None and not os.environ.get(VARIABLE):
            bank = _of_other_sets(course, set_name, bank)
        if not is_file:
            file = _recorded_file(course, set_name)
        if not is_file and file is None and set_name not in (here := set_names(bank)):
            raise _unknown(course, set_name, bank, here)
    else:
        bank, file = _recorded(course, set_name)
        if not is_file:
            _check_is_there(course, set_name, bank, file)
    return bank, find_set(bank, name if is_file or file is None else file, settings.usual)


def home_in_course(course: Course, code: str) -> tuple[Bank, Problem] | None:
    """A problem and its bank, by code or name: the bank that a set was dealt from, of the set generated last that has such a problem,
    else the course's own. None where none has it. Raises NotACourse and Malformed."""
    settings = read_settings(course.folder)
    for path in _records(course):
        with suppress(NotACourse, UnknownCode):  # a bank that has moved
            return home(Path(_recorded(course, path.stem)[0].place), code)
        with suppress(NotACourse, UnknownCode, Malformed):  # a set may take problems of other banks
            bank, problem_set = set_of(course, path.stem)
            for each in problem_set.problems:
                if code == each.name or code.lower() == each.code.lower():
                    return bank, each
    with suppress(UnknownCode):
        return home(Path(settings.bank), code) if settings.bank else None
    return None


def _check_is_there(course: Course, set_name: str, bank: Bank, file: str | None) -> None:
    """Raise UnknownCode where the set is no longer where the record says."""
    if file is not None and not Path(file).is_file():
        raise UnknownCode(
            f"{set_name} was generated from {file}, which does not exist any more; {_generate_again(set_name)}"
        )
    if file is None and file_of_set(bank, set_name) is None:
        raise UnknownCode(
            f"{course.folder} has no record of the file of {set_name}, and the bank {bank.place} has no set of that name; "
            f"{_generate_again(set_name)}"
        )


def _generate_again(set_name: str) -> str:
    return (
        f"run corollary generate again with the file in the place of its name (such as path/{set_name}.md): "
        "that records where it is, and all students keep their numbers"
    )


def has_set(course: Course, name: str) -> bool:
    """Whether a set of this name was generated here, and it is known from where."""
    return _origin(course, name).exists()


def _is_readable(course: Course, set_name: str) -> bool:
    try:
        _record(course, set_name)
    except NotACourse:
        return False
    return True


def _recorded_file(course: Course, set_name: str) -> str | None:
    """The set's own file, where it lies outside its bank and is still there."""
    with suppress(NotACourse):  # a damaged record: the bank named may have the set
        file = _record(course, set_name)[1] if has_set(course, set_name) else None
        return file if file is not None and Path(file).is_file() else None
    return None


def _of_other_sets(course: Course, set_name: str, otherwise: Bank) -> Bank:
    """The bank of the set generated last of those whose bank has this one too; else that of the very last."""
    banks = list[Bank]()
    for path in _records(course):
        with suppress(NotACourse, UnknownCode):  # it has moved: another one may have the set
            banks.append(_recorded(course, path.stem)[0])
    return next((bank for bank in banks if set_name in set_names(bank)), next(iter(banks), otherwise))


def _records(course: Course) -> list[Path]:
    """Of every set, that of the one generated last first."""
    return sorted(_origin(course, "any").parent.glob("*.json"), key=_age, reverse=True)


def _age(path: Path) -> float:
    return path.stat().st_mtime


def _unknown(course: Course, set_name: str, bank: Bank, here: list[str]) -> UnknownCode:
    assigned = course.record("assigned", f"{set_name}.json")
    if has_set(course, set_name):
        return UnknownCode(
            f"the bank {bank.place} has no set {set_name}, and the file that it was generated from is gone or lies in another "
            f"bank; give the path of {set_name}.md in the place of {set_name}"
        )
    if assigned.exists():
        return UnknownCode(
            f"{course.folder} has numbers of {set_name}, but no longer says where that set is: {_origin(course, set_name)} "
            f"is lost, and the bank {bank.place} has no set of that name; restore the file from a backup, or run corollary "
            f"generate again with --bank, or with the path of {set_name}.md (all students keep their numbers)"
        )
    generated = sorted(
        {
            path.stem
            for kind in ("origin", "assigned")
            for path in course.record(kind, "any").parent.glob("*.json")
        }
    )
    near = did_you_mean(set_name, {*generated, *here} - {set_name})
    return UnknownCode(
        f"there is no problem set {set_name}{near}; {course.folder} has: "
        f"{', '.join(generated) or 'none yet'}; the bank {bank.place} has: {', '.join(here) or 'none'}"
    )


def _record(course: Course, set_name: str) -> tuple[str | None, str | None]:
    """The places of the bank (None: the chapter's) and of the set's file. Raises NotACourse."""
    try:
        record = json.loads(_origin(course, set_name).read_text(encoding="utf-8"))
        file = record["set"]
        return record["bank"], None if file is None else str(course.folder / file)
    except (OSError, ValueError, TypeError, KeyError):
        raise NotACourse(
            f"{course.folder} does not say which bank {set_name} comes from; {_generate_again(set_name)}"
        ) from None


def _recorded(course: Course, set_name: str) -> tuple[Bank, str | None]:
    place, file = _record(course, set_name)
    if place is None:
        return chapter_bank(), file
    try:
        return open_bank(Path(place)), file
    except UnknownCode:
        raise UnknownCode(
            f"{set_name} was generated from the bank {place}, which is not there any more; run "
            f"corollary generate {set_name} --course {course.folder} --roster FILE --bank DIR with its new folder (all students keep "
            "their numbers)"
        ) from None


def _is_chapters(bank: Bank) -> bool:
    try:
        return bank.place == chapter_bank().place
    except UnknownCode:
        return False


def _origin(course: Course, set_name: str) -> Path:
    return course.record("origin", f"{set_name}.json")
