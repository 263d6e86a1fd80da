"""The origin of a problem set: its bank, and its file when it lies outside the bank.

Recorded when a set is generated, so that it can be marked later by whoever has only the course.
"""

from __future__ import annotations

import json
import os
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from corollary.atomic import write_whole
from corollary.messages import did_you_mean
from corollary.problem.bank import (
    VARIABLE,
    Bank,
    UnknownCode,
    bank_around,
    banks_below,
    chapter_bank,
    codes,
    home,
    installed_bank,
    open_bank,
)
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet, file_of_set, find_set, set_names
from corollary.records.files import Course, NotACourse
from corollary.records.settings import read_settings


@dataclass(frozen=True, slots=True)
class SetOrigin:
    """Where a set came from: its banks as names, and its file, seen from the course; `course` is where the course then lay.

    A name of a bank is that of an installed package, or a path that begins with `./` or `../`, or on another drive a whole one.
    """

    banks: tuple[str, ...] | None
    file: str | None
    course: Path

    def places_of(self, name: str, here: Path) -> list[Path]:
        """Where a path may lead: from the course as it lies now, and from where it lay."""
        return [Path(os.path.normpath(folder / name)) for folder in (here, self.course)]


def write_origin(course: Course, set_name: str, bank: Bank, file: Path | None = None) -> None:
    """Record the bank, and the set's file unless the bank has it by this name.

    The chapter's bank is recorded as such: it moves when the program is installed anew. Other places are recorded relative to the
    course, and where the course lies beside them: all may move together, or any one of them.
    """
    banks = None if _is_chapters(bank) else [_name_of(course, each.folder) for each in bank.each]
    place = None if file is None else _place_of(course, set_name, bank, file)
    _write(course, set_name, SetOrigin(None if banks is None else tuple(banks), place, course.folder))


def _write(course: Course, set_name: str, origin: SetOrigin) -> None:
    record = {"bank": origin.banks, "set": origin.file, "course": str(origin.course)}
    write_whole(_origin(course, set_name), json.dumps(record) + "\n")


def _name_of(course: Course, folder: Path) -> str:
    if installed := installed_bank(folder):
        return installed
    return _relative_name(course, folder.resolve())


def _relative_name(course: Course, folder: Path) -> str:
    relative = _seen_from(course.folder, folder)
    return relative if relative.startswith("..") or Path(relative).is_absolute() else f"./{relative}"


def _seen_from(folder: Path, path: Path) -> str:
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:  # Windows: on another drive
        return str(path)


def _place_of(course: Course, set_name: str, bank: Bank, file: Path) -> str | None:
    of_bank = file_of_set(bank, set_name)
    if of_bank is not None and of_bank.samefile(file):
        return None
    # The name of a link is the set's; the folders around it are as the system walks them.
    return _seen_from(course.folder, Path(os.path.abspath(file)).parent.resolve() / file.name)


def remember(course: Course, set_name: str, bank: Bank, file: Path | None) -> None:
    """Record anew where a set is from, where the course says otherwise; other sets from the same places move with it.

    What cannot be written is left: whoever may only read the course can still work with it.
    """
    try:
        before = _record(course, set_name) if has_set(course, set_name) else None
    except NotACourse:
        before = None
    if before is None or _is_current(course, before, bank, file, set_name):
        return
    with suppress(OSError):
        write_origin(course, set_name, bank, file)
        after = _record(course, set_name)
        for path in _records(course):
            with suppress(NotACourse, OSError):
                other = _record(course, path.stem)
                if path.stem != set_name and (moved := _moved_alike(course, other, before, after)) != other:
                    _write(course, path.stem, moved)


def _is_current(course: Course, origin: SetOrigin, bank: Bank, file: Path | None, set_name: str) -> bool:
    """True if the record leads to this bank and file, from where the course lies now."""
    if origin.course != course.folder:
        return False
    banks = None if _is_chapters(bank) else tuple(_name_of(course, each.folder) for each in bank.each)
    return origin.banks == banks and origin.file == (file and _place_of(course, set_name, bank, file))


def _moved_alike(course: Course, other: SetOrigin, before: SetOrigin, after: SetOrigin) -> SetOrigin:
    """The record of another set, seen from where the course lies now: its bank, or its file's folder, may be the one that moved."""
    banks, file = other.banks, other.file
    if banks is not None:
        same = banks == before.banks and other.course == before.course
        lost = _folders(course, other) is None
        banks = after.banks if same and lost else tuple(_rebased(course, other, each) for each in banks)
    if file is not None:
        moved = PurePosixPath(after.file or "").parent / PurePosixPath(file).name
        same = PurePosixPath(file).parent == PurePosixPath(before.file or "").parent
        lost = _file(course, other) is None
        is_there = same and after.file is not None and (course.folder / moved).is_file()
        file = str(moved) if lost and is_there else _rebased(course, other, file, folder=False)
    return SetOrigin(banks, file, course.folder)


def _is_installed(name: str) -> bool:
    """True for the name of an installed bank, which no place leads to."""
    return not (name.startswith(".") or Path(name).is_absolute())


def _rebased(course: Course, origin: SetOrigin, name: str, *, folder: bool = True) -> str:
    """A recorded path, seen from where the course lies now; it stays that of the old place where it is found in neither."""
    if folder and _is_installed(name):
        return name
    here, then = origin.places_of(name, course.folder)
    place = here if here.exists() else then
    return _relative_name(course, place) if folder else _seen_from(course.folder, place)


def set_of(course: Course, name: str, folder: Path | None = None) -> tuple[Bank, ProblemSet]:
    """The set of this name, or in the file of this path, and its bank: the one in `folder`, else the one that the set was
    generated from, else the course's, else one that other sets of the course were generated from, else the chapter's. A set that
    has a file of its own outside its bank is read from there, whatever bank its problems are from.

    A place that is no longer where the record says, and that was named this time, is remembered.
    Raises NotACourse when the record is damaged, UnknownCode when the bank cannot be found, and Malformed.
    """
    bank, found, named = _set_of(course, name, folder)
    if named:
        remember(course, found.name, bank, found.file)
    return bank, found


def _set_of(course: Course, name: str, folder: Path | None) -> tuple[Bank, ProblemSet, bool]:
    """The bank and the set; and whether the request named one of them that the record no longer leads to."""
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
            file = _recorded_file(course, set_name, bank)
        if not is_file and file is None and set_name not in (here := set_names(bank)):
            raise _unknown(course, set_name, bank, here)
    else:
        bank, file = _recorded(course, set_name)
        if not is_file:
            _check_is_there(course, set_name, bank, file)
    found = find_set(bank, name if is_file or file is None else str(file), settings.usual)
    return bank, found, (folder is not None or is_file) and _is_lost(course, set_name)


def _is_lost(course: Course, set_name: str) -> bool:
    """True if a place that the record of a set names is there no more."""
    with suppress(NotACourse):
        origin = _record(course, set_name) if has_set(course, set_name) else None
        if origin is not None:
            lost_file = origin.file is not None and _file(course, origin) is None
            return lost_file or (origin.banks is not None and _folders(course, origin) is None)
    return False


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


def _check_is_there(course: Course, set_name: str, bank: Bank, file: Path | None) -> None:
    """Raise UnknownCode where the set is no longer where the record says."""
    if file is not None and not file.is_file():
        raise UnknownCode(
            f"{set_name} was generated from {file}, which is not there any more; {_give_its_file(set_name)}"
        )
    if file is None and file_of_set(bank, set_name) is None:
        raise UnknownCode(
            f"{course.folder} has no record of the file of {set_name}, and the bank {bank.place} has no set of that name; "
            f"{_generate_again(set_name)}"
        )


def _give_its_file(set_name: str) -> str:
    return (
        f"give its file once in the place of its name (such as path/{set_name}.md): the course remembers it, "
        "and all students keep their numbers"
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


def _recorded_file(course: Course, set_name: str, bank: Bank) -> Path | None:
    """The set's own file, where it lies outside its bank and is still there, or lies to this bank as it lay to its own."""
    with suppress(NotACourse):  # a damaged record: the bank named may have the set
        if has_set(course, set_name):
            origin = _record(course, set_name)
            return _file(course, origin) or _beside_bank(origin, bank)
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


def _record(course: Course, set_name: str) -> SetOrigin:
    """The record of a set; banks None: the chapter's. Raises NotACourse."""
    try:
        record = json.loads(_origin(course, set_name).read_text(encoding="utf-8"))
        banks, file = record["bank"], record["set"]
        if isinstance(banks, str):  # one text, before places were relative
            banks = banks.split(os.pathsep)
        then = Path(record.get("course") or course.folder)
        return SetOrigin(None if banks is None else tuple(map(str, banks)), file and str(file), then)
    except (OSError, ValueError, TypeError, KeyError, AttributeError):
        raise NotACourse(
            f"{course.folder} does not say which bank {set_name} comes from; {_generate_again(set_name)}"
        ) from None


def _file(course: Course, origin: SetOrigin) -> Path | None:
    """The set's own file, where it is found."""
    places = [] if origin.file is None else origin.places_of(origin.file, course.folder)
    return next((place for place in places if place.is_file()), None)


def _folders(course: Course, origin: SetOrigin) -> Path | None:
    """The recorded banks as `open_bank` takes them; None where one of them is not found."""
    found: list[str] = []
    for name in origin.banks or ():
        if _is_installed(name):
            found.append(name)
            continue
        places = origin.places_of(name, course.folder)
        there = next((place for place in places if (place / "problems").is_dir()), None)
        if there is None:
            return None
        found.append(str(there))
    return Path(os.pathsep.join(found))


def _beside_bank(origin: SetOrigin, bank: Bank) -> Path | None:
    """The set's file where it lies to this bank as it lay to its own: both have moved together."""
    if origin.file is None or not origin.banks or not origin.banks[0].startswith("."):
        return None
    place = Path(os.path.normpath(bank.folder / os.path.relpath(origin.file, origin.banks[0])))
    return place if place.is_file() else None


def _recorded(course: Course, set_name: str) -> tuple[Bank, Path | None]:
    """The bank and the set's own file, by the record or, where the bank has moved, by the course's setting."""
    origin = _record(course, set_name)
    file = _file(course, origin)
    if origin.banks is None:
        bank = chapter_bank()
    else:
        place, setting = _folders(course, origin), read_settings(course.folder).bank
        try:
            if place is None and not setting:
                raise UnknownCode
            bank = open_bank(place or Path(setting))
        except UnknownCode:
            raise UnknownCode(_bank_has_moved(course, set_name, origin)) from None
        file = file or _beside_bank(origin, bank)
    if file is None and origin.file is not None:  # as it is looked for
        file = origin.places_of(origin.file, course.folder)[1]
    return bank, file


def _bank_has_moved(course: Course, set_name: str, origin: SetOrigin) -> str:
    places = [
        each if not each.startswith(".") else str(origin.places_of(each, course.folder)[1])
        for each in origin.banks or ()
    ]
    near = bank_near(course, set_name)
    hint = f"is it {near}? Then give --bank {near} once" if near else "give its folder once with --bank DIR"
    return (
        f"{set_name} was generated from the bank {os.pathsep.join(places)}, which is not there any more; {hint}: "
        "the course remembers it, and all students keep their numbers"
    )


def is_file_gone(course: Course, set_name: str) -> bool:
    """True if a set's bank is found, and the file that it was generated from is not."""
    with suppress(NotACourse, UnknownCode):
        file = _recorded(course, set_name)[1]
        return file is not None and not file.is_file()
    return False


def bank_near(course: Course, set_name: str) -> Path | None:
    """The one bank near the course, the nearest first, that has every problem of a set; None where there is none, or several."""
    from corollary.records.assignments import read_numbers  # only where a bank is lost

    with suppress(NotACourse, OSError):
        record = read_numbers(course, set_name)
        wanted = {edition.code_now.lower() for edition in record.editions} if record else set[str]()
        for place in (course.folder, *course.folder.parents[:2]) if wanted else ():
            banks = banks_below(place)
            having = [bank for bank in banks if wanted <= {code.lower() for code in codes(bank).values()}]
            if having:
                return having[0].folder if len(having) == 1 else None
    return None


def _is_chapters(bank: Bank) -> bool:
    try:
        return bank.place == chapter_bank().place
    except UnknownCode:
        return False


def _origin(course: Course, set_name: str) -> Path:
    return course.record("origin", f"{set_name}.json")
