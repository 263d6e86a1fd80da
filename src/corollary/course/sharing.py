"""Rights of a course on a machine with several accounts: its owner's alone, or those of a teaching team's group."""

from __future__ import annotations

import os
import stat
import struct
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from shlex import quote
from typing import Final

from corollary.atomic import write_whole
from corollary.messages import did_you_mean, few
from corollary.problem.bank import UnknownCode
from corollary.problem.diagnostic import Finding, Malformed
from corollary.records.files import Course, NotACourse, one_writer, students
from corollary.records.origin import set_of

ACCESS_LIST: Final = "system.posix_acl_access"
OF_A_GROUP: Final = 0x08  # the tag of a group's entry in an access list (acl(5))
FOLDER, FILE = 0o2770, 0o660
OTHERS, GROUP = 0o007, 0o070
# Groups that have every account of a machine, by the usage of Linux and macOS.
EVERYBODYS: Final = {
    "users",
    "nogroup",
    "nobody",
    "everyone",
    "staff" if sys.platform == "darwin" else "users",
}
MOST_NAMED = 5
CONFIG: Final = "c.CourseDirectory.groupshared = True"


class NotShareable(Exception):
    """A course cannot be shared with this group, or not by this account; one sentence says why, and what to do."""


@dataclass(frozen=True, slots=True)
class TeamGroup:
    """A group of accounts; `members` as far as the machine lists them."""

    name: str
    number: int
    members: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SharedCourse:
    """What was done: how many files and folders have new rights, and what only somebody else can do.

    `of_others`: how many belong to another account, by its name; `barred`: folders on the way that the group cannot pass;
    `unreadable`: banks and sets that it cannot read.
    """

    group: TeamGroup
    changed: int
    of_others: dict[str, int]
    barred: tuple[Path, ...]
    unreadable: tuple[Path, ...]


def group_named(name: str) -> TeamGroup:
    """The group of this name, or number. Raises NotShareable."""
    try:
        import grp
    except ModuleNotFoundError:
        raise NotShareable(
            "this machine has no groups of Unix; a course can be shared on Linux and macOS"
        ) from None
    known = {each.gr_name: each.gr_gid for each in grp.getgrall()}
    try:
        found = grp.getgrgid(int(name)) if name.isdigit() else grp.getgrnam(name)
    except (KeyError, OverflowError):
        raise NotShareable(
            f"there is no group {name}{did_you_mean(name, known)}; make it with: sudo groupadd {quote(name)}"
        ) from None
    return _group(found.gr_gid)


def share(course: Course, group: TeamGroup) -> SharedCourse:
    """Give the group all rights in the course that its owner has, and take those of everybody else.

    Raises NotShareable, NotACourse and BeingGraded.
    """
    check_group(course, group)
    owner, me = course.folder.stat().st_uid, os.geteuid()
    if me not in (0, owner):
        raise NotShareable(
            f"{course.folder} belongs to {_account(owner)}, who alone (or root) can share it with a group"
        )
    if me != 0 and group.number not in {os.getegid(), *os.getgroups()}:
        raise NotShareable(
            f"you are not in the group {group.name}: sudo usermod -aG {quote(group.name)} {_account(me)}, then log in again"
        )
    with one_writer(course):
        _tell_nbgrader(course)
        changed, of_others = 0, Counter[str]()
        for path, found in _everything(course.folder):
            if _is_as_shared(found, group.number) and not (path == course.folder and found.st_mode & OTHERS):
                continue
            if me not in (0, found.st_uid):
                of_others[_account(found.st_uid)] += 1
                continue
            _open(path, found, group.number)
            changed += 1
    barred = tuple(each for each in course.folder.parents if not _may_enter(each, group.number))
    return SharedCourse(
        group, changed, dict(of_others), barred[::-1], tuple(_unreadable_sources(course, group))
    )


def check_group(course: Course, group: TeamGroup) -> None:
    """Raise NotShareable where the group is everybody's, or has students of the course."""
    if why := _unfit(course, group):
        raise NotShareable(f"{why}; make a group of the team alone: sudo groupadd teach")


def rights_findings(course: Course) -> Iterator[Finding]:
    """Who can enter the course and read in it, and how that is mended."""
    if os.name == "nt":
        return
    folder, found = course.folder, course.folder.stat()
    place = quote(str(folder))
    shared = bool(found.st_mode & GROUP) and _is_of_several(found)
    closing = f"chmod -R {'o' if shared else 'go'}-rwx {place}"
    if found.st_mode & OTHERS and all(each.stat().st_mode & 0o001 for each in folder.parents):
        open_to_all = list(_open_to_others(folder))
        if open_to_all:
            names = few([str(each.relative_to(folder)) for each in open_to_all], MOST_NAMED)
            yield Finding("rights", "broken", f"every account of this machine can read {names}", closing)
            return
    if not shared:
        yield Finding("rights", "good", f"only {_account(found.st_uid)} can enter {folder}")
        return
    group = _group(found.st_gid)
    if why := _unfit(course, group):
        yield Finding("rights", "broken", f"{why}, and it can read the course", f"chmod -R go-rwx {place}")
        return
    odd = [
        path.relative_to(folder)
        for path, each in _everything(folder)
        if not _is_as_shared(each, group.number)
    ]
    remedy = f"corollary share --group {quote(group.name)} --course {place}"
    who = f"the group {group.name} ({few(group.members, MOST_NAMED) or 'without members'})"
    if odd:
        names = few([str(each) for each in odd], MOST_NAMED)
        yield Finding("rights", "weak", f"{who} cannot do everything with {names}", remedy)
        return
    yield Finding("rights", "good", f"only {who} can enter {folder}")


def _unfit(course: Course, group: TeamGroup) -> str:
    """Why a course must not be shared with a group; empty where nothing is known against it."""
    if group.name in EVERYBODYS or group.number == 0:
        return f"the group {group.name} is not one of a team"
    ids = {
        name
        for each in students(course)
        for name in (each.id, each.email.partition("@")[0], *(other for _, other in each.ids))
        if name
    }
    if of_students := [name for name in group.members if name in ids]:
        return f"the group {group.name} has students of this course: {few(of_students, MOST_NAMED)}"
    return ""


def _group(number: int) -> TeamGroup:
    import grp
    import pwd

    try:
        found = grp.getgrgid(number)
    except KeyError:
        return TeamGroup(str(number), number, ())
    main = [each.pw_name for each in pwd.getpwall() if each.pw_gid == number]
    return TeamGroup(found.gr_name, number, tuple(sorted({*found.gr_mem, *main})))


def _account(number: int) -> str:
    import pwd

    try:
        return pwd.getpwuid(number).pw_name
    except KeyError:
        return str(number)


def _is_of_several(found: os.stat_result) -> bool:
    """Whether the group of a folder has other accounts than its owner; a group that lists none may have some elsewhere."""
    members = set(_group(found.st_gid).members)
    return bool(found.st_mode & stat.S_ISGID) or bool(members - {_account(found.st_uid)})


def _everything(folder: Path) -> Iterator[tuple[Path, os.stat_result]]:
    """All files and folders, the innermost first; links are left out: they may lead anywhere."""
    for place, _, files in os.walk(folder, topdown=False):
        for name in files:
            path = Path(place, name)
            with suppress(FileNotFoundError):  # another program's draft
                found = path.lstat()
                if stat.S_ISREG(found.st_mode):
                    yield path, found
        yield Path(place), Path(place).lstat()


def _wanted(found: os.stat_result) -> int:
    own = found.st_mode & 0o700 | 0o600
    return FOLDER if stat.S_ISDIR(found.st_mode) else own | own >> 3


def _is_as_shared(found: os.stat_result, group: int) -> bool:
    """True if the group has all rights; those of others inside do not matter, since nobody else enters the course's folder."""
    return found.st_gid == group and found.st_mode & (wanted := _wanted(found)) == wanted


def _open(path: Path, found: os.stat_result, group: int) -> None:
    if found.st_gid != group:
        os.chown(path, -1, group, follow_symlinks=False)
    path.chmod(_wanted(found))  # after it: a change of the group takes the bit by which it is inherited


def _open_to_others(folder: Path) -> Iterator[Path]:
    """Files and folders in a course that every account can read, the outermost alone."""
    with suppress(OSError):
        for each in sorted(folder.iterdir()):
            mode = 0 if each.is_symlink() else each.stat().st_mode
            if stat.S_ISDIR(mode) and mode & 0o005 == 0o001:
                yield from _open_to_others(each)
            elif mode & 0o004 and (not stat.S_ISDIR(mode) or mode & 0o001):
                yield each


def _may_enter(folder: Path, group: int) -> bool:
    found = folder.stat()
    if found.st_gid == group:
        return bool(found.st_mode & 0o010)
    return bool(found.st_mode & 0o001) or group in _let_in(folder)


def _let_in(folder: Path) -> set[int]:
    """The groups that an access list lets pass."""
    content = b""
    with suppress(OSError, AttributeError):  # it has no list, or the system knows none
        content = os.getxattr(folder, ACCESS_LIST)
    entries = struct.iter_unpack("<HHI", content[4 : 4 + (len(content) - 4) // 8 * 8]) if content else ()
    return {number for tag, rights, number in entries if tag == OF_A_GROUP and rights & 1}


def _unreadable_sources(course: Course, group: TeamGroup) -> Iterator[Path]:
    """Banks and sets' files that the group cannot read: whoever marks needs both."""
    places = set[Path]()
    for record in sorted(course.record("origin", "any").parent.glob("*.json")):
        with suppress(UnknownCode, NotACourse, Malformed):
            bank, problem_set = set_of(course, record.stem)
            places |= {each.folder for each in bank.each}
            places |= {problem_set.file} if problem_set.file else set()
    for each in sorted(places):
        found = each.stat()
        mine = 0o040 if found.st_gid == group.number else 0o004
        if not found.st_mode & mine or not all(_may_enter(place, group.number) for place in each.parents):
            yield each


def _tell_nbgrader(course: Course) -> None:
    """What nbgrader's own commands write is for the group, too."""
    path = course.folder / "nbgrader_config.py"
    if path.exists() and "groupshared" not in (text := path.read_text(encoding="utf-8", errors="replace")):
        write_whole(path, f"{text.rstrip()}\n\n# The course is shared with a group.\n{CONFIG}\n")


def left_to_do(done: SharedCourse, course: Course) -> list[str]:
    """What `share` could not do, each with what does it."""
    name, place = quote(done.group.name), quote(str(course.folder))
    again = f"corollary share --group {name} --course {place}"
    found = [
        f"{count} of the files and folders belong to {who}: run as root, sudo {again}"
        for who, count in done.of_others.items()
    ]
    found += [
        f"{each} lets nobody of {name} pass: setfacl -m g:{name}:x {quote(str(each))}, or move the course to a folder of the team"
        for each in done.barred
    ]
    found += [
        f"{each} cannot be read by {name}, who needs it to mark: move it beside the course in a folder of the team, or "
        f"chmod -R go+rX {quote(str(each))}"
        for each in done.unreadable
    ]
    return found


def names_of(members: Sequence[str]) -> str:
    return few(list(members), 10) or "no member that this machine lists"
