"""Requests for regrading: what students wrote into the form, and what is still open."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import Final

import msgspec

from corollary.atomic import write_whole
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course
from corollary.records.lms_names import again
from corollary.sandbox.file import bytes_of

MOST_BYTES: Final = 20_000
LONGEST: Final = 2_000  # characters for one part
HEADING = re.compile(r"^\s{0,3}#{1,6}\s+(\S+)\s*\(([^()\s]{1,12})\)")
NAME = re.compile(r"request[ _-]+([\w. ()-]+?)(?:\.(?:md|txt|markdown))+$", re.IGNORECASE)
SECOND = re.compile(r"_\d{1,2}_$")  # "(1)", where an LMS has no brackets in a name


class RegradeRequest(msgspec.Struct, frozen=True):
    """One request about one part, named as in the notebook (X12_5_a); `at` is when it was handed in (empty: not known), `decided`
    the moment of the answer (empty: it is open)."""

    part: str
    text: str
    at: str = ""
    decided: str = ""

    @property
    def id(self) -> str:
        return sha256(f"{self.part}\n{self.text}".encode()).hexdigest()[:8]


def file_name(set_name: str) -> str:
    """What the form is called."""
    return f"request_{set_name}.md"


def is_request(name: str, set_name: str) -> bool:
    """Whether a file's own name says that it is a request about this set, as an LMS or a browser may have changed it."""
    about = set_asked_about(name)
    return set_name.casefold() in {
        each.casefold() for each in (about, again(about)[0], SECOND.sub("", about))
    }


def set_asked_about(name: str) -> str:
    """The set that a form's name says, with whatever an LMS appended; empty for another file."""
    found = NAME.search(name.rsplit("/", 1)[-1])
    return found[1] if found else ""


def requests_in(content: bytes, parts: Mapping[tuple[str, str], str], at: str) -> list[RegradeRequest]:
    """What a student wrote into a form; `parts` are the names in the notebook by code and letter. Whatever stands above the first
    heading is the form's own."""
    text = _decoded(content[:MOST_BYTES])
    found: dict[str, list[str]] = {}
    part = ""
    for line in text.splitlines():
        if heading := HEADING.match(line):
            part = parts.get((heading[1].casefold(), heading[2].casefold()), "")
            continue
        if part:
            found.setdefault(part, []).append(line)
    return [
        RegradeRequest(part, words[:LONGEST], at)
        for part, lines in found.items()
        if (words := "\n".join(lines).strip())
    ]


def part_places(problem_set: ProblemSet) -> dict[tuple[str, str], str]:
    """The parts' names in the notebook by code and letter, in small letters, as they head the parts of a form."""
    return {
        (problem.code.casefold(), letter.casefold()): problem.answer_name(part)
        for problem in problem_set.problems
        for part in problem.parts
        for letter in (part.heading_letter, part.id)
    }


def gather_requests(course: Course, problem_set: ProblemSet) -> None:
    """Records the forms that lie beside notebooks in `submitted/`, where nbgrader's exchange puts them. Whoever calls it is the only
    writer."""
    name, places = problem_set.name, part_places(problem_set)
    inside = course.folder / "submitted"
    for path in inside.glob(f"*/{name}/request_*"):
        if is_request(path.name, name):
            content = bytes_of(path, MOST_BYTES, inside)
            if isinstance(content, bytes):
                at = datetime.fromtimestamp(path.lstat().st_mtime, UTC).isoformat(timespec="seconds")
                add_requests(course, name, path.parts[-3], requests_in(content, places, at))


def read_requests(course: Course, set_name: str) -> dict[str, tuple[RegradeRequest, ...]]:
    """All requests by student, oldest first; a damaged file is none."""
    found: dict[str, tuple[RegradeRequest, ...]] = {}
    for path in sorted(_folder(course, set_name).glob("[!.]*.json")):
        if its := _read(path):
            found[path.stem] = its
    return found


def open_requests(course: Course, set_name: str) -> dict[tuple[str, str], RegradeRequest]:
    """The newest request on each part that nobody has answered, by student and part."""
    return {
        (student, each.part): each
        for student, requests in read_requests(course, set_name).items()
        for each in requests
        if not each.decided
    }


def add_requests(course: Course, set_name: str, student: str, new: Sequence[RegradeRequest]) -> int:
    """Records those that did not come before, and says how many; a newer one on the same part takes the place of an open one."""
    before = _read(_place(course, set_name, student))
    known = {each.id for each in before}
    fresh = [each for each in new if each.id not in known]
    if fresh:
        parts = {each.part for each in fresh}
        left = [each for each in before if each.decided or each.part not in parts]
        _write(course, set_name, student, [*left, *fresh])
    return len(fresh)


def decide(course: Course, set_name: str, student: str, part: str, at: str) -> None:
    """Notes that the open request on a part was answered."""
    before = _read(_place(course, set_name, student))
    now = [
        msgspec.structs.replace(each, decided=at) if each.part == part and not each.decided else each
        for each in before
    ]
    if list(before) != now:
        _write(course, set_name, student, now)


def _decoded(content: bytes) -> str:
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return content.decode("utf-16", "replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", "replace")


def _read(path: Path) -> tuple[RegradeRequest, ...]:
    try:
        return msgspec.json.decode(path.read_bytes(), type=tuple[RegradeRequest, ...])
    except (OSError, msgspec.DecodeError):
        return ()


def _write(course: Course, set_name: str, student: str, requests: Sequence[RegradeRequest]) -> None:
    write_whole(_place(course, set_name, student), msgspec.json.encode(requests))


def _folder(course: Course, set_name: str) -> Path:
    return course.record("requests", set_name)


def _place(course: Course, set_name: str, student: str) -> Path:
    return _folder(course, set_name) / f"{student}.json"
