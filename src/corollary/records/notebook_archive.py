"""Archive of notebooks in a course: hand-ins by digest, and answered sheets, packed; in large courses hand-ins without the code of the checks."""

from __future__ import annotations

import hashlib
import re
import zlib
from collections.abc import Iterator
from contextlib import suppress
from functools import lru_cache
from itertools import islice
from pathlib import Path

from corollary.atomic import write_whole
from corollary.records.files import Course
from corollary.sandbox.file import Unreadable, bytes_of

SEPARATED = bytes.maketrans(b"\t\r\f\v\"'\\", b"       ")
LONG, MOST = 5_000, 32
"""Bytes of a word that is stored once in the course, and how many of a notebook are: the packed code of a sheet's checks, which all
sheets of a set carry."""
SHARED, TEXT = b"S", b"T"
LARGE = 200
"""Students of a course in which one copy of a sheet is enough: `collect` packs the sheet, and folds the code of the hand-in."""
REFERENCE = re.compile(rb"stored-in-corollary-shared-([0-9a-f]{32})")


class DamagedArchive(ValueError):
    """A file of the archive cannot be unpacked; one sentence says which."""


def archive(course: Course, place: Path, content: bytes) -> None:
    """Packs a notebook into a file of the archive. Raises OSError, and leaves nothing by this name then."""
    pieces, end = list[bytes](), 0
    for start, after in islice(_long_words(content), MOST):
        word = content[start:after]
        digest = hashlib.sha256(word).digest()
        shared = _shared(course, digest)
        if not shared.exists():
            write_whole(shared, zlib.compress(word), mode=0o600)
        pieces += [_text(content[end:start]), SHARED + digest]
        end = after
    pieces.append(_text(content[end:]))
    write_whole(place, hashlib.sha256(content).digest() + zlib.compress(b"".join(pieces)), mode=0o600)


def _long_words(content: bytes) -> Iterator[tuple[int, int]]:
    """Where the words to store once begin and end. Short lines, as notebooks have them, hold none."""
    start = 0
    for line in content.split(b"\n"):
        at = start
        for word in line.translate(SEPARATED).split(b" ") if len(line) >= LONG else ():
            if len(word) >= LONG:
                yield at, at + len(word)
            at += len(word) + 1
        start += len(line) + 1


def unarchive(course: Course, place: Path) -> bytes:
    """The notebook as it was, to the byte. Raises FileNotFoundError and DamagedArchive."""
    packed, found = place.read_bytes(), bytearray()
    try:
        pieces, at = zlib.decompress(packed[32:]), 0
        while at < len(pieces):
            kind, start = pieces[at : at + 1], at + 1
            if kind == SHARED:
                word = _word(_shared(course, pieces[start : start + 32]))
                if not word:
                    raise OSError("a part of it in .corollary/shared is missing or damaged")
                found += word
                at = start + 32
            else:
                size = int.from_bytes(pieces[start : start + 8], "big")
                found += pieces[start + 8 : start + 8 + size]
                at = start + 8 + size
    except (OSError, zlib.error) as error:
        raise DamagedArchive(
            f"{place} cannot be unpacked ({error}); restore .corollary from a backup"
        ) from None
    if hashlib.sha256(found).digest() != packed[:32]:
        raise DamagedArchive(f"{place} is damaged; restore it from a backup")
    return bytes(found)


def keep(course: Course, set_name: str, student: str, content: bytes) -> None:
    """A copy of a hand-in by its digest: whatever is taken later, it can be looked at."""
    digest = hashlib.sha256(content).hexdigest()[:16]
    place = course.record("collected", f"{set_name}/{student}/{digest}.z")
    if not place.exists() and not place.with_suffix(".ipynb").exists():
        archive(course, place, content)


def hand_ins(course: Course, set_name: str, student: str) -> dict[str, bytes]:
    """Everything that was ever collected of a student in a set, by digest, earlier versions' unpacked copies too. Raises DamagedArchive."""
    folder = course.record("collected", f"{set_name}/{student}")
    return {
        place.stem: unarchive(course, place) if place.suffix == ".z" else place.read_bytes()
        for place in sorted(folder.glob("[!.]*"))
    }


def set_aside(course: Course, set_name: str, student: str) -> bool:
    """Packs a sheet in `release/`; `release` and `generate` find it as before. False when there is none. Raises OSError."""
    path = course.notebook("release", student, set_name)
    if path.is_symlink() or not path.is_file():
        return False
    content, place = path.read_bytes(), _sheet(course, set_name, student)
    archive(course, place, content)
    if unarchive(course, place) != content:
        return False
    path.unlink()
    with suppress(OSError):  # something else lies there
        path.parent.rmdir()
        path.parent.parent.rmdir()
    return True


def folded(course: Course, set_name: str, student: str, content: bytes) -> bytes:
    """A hand-in in which the code of the checks, as the sheet has it, is a reference to `shared/`; `read_hand_in` has it whole."""
    sheet = read_sheet(course, set_name, student) or b""
    of_sheet = {sheet[start:end] for start, end in _long_words(sheet)}
    pieces, before = list[bytes](), 0
    for start, end in _long_words(content):
        word = content[start:end]
        if word in of_sheet and (place := _shared(course, hashlib.sha256(word).digest())).exists():
            of_sheet.remove(word)
            pieces += [content[before:start], b"stored-in-corollary-shared-" + place.stem.encode()]
            before = end
    short = b"".join([*pieces, content[before:]])
    return short if unfolded(course, short) == content else content


def read_hand_in(course: Course, path: Path) -> bytes | Unreadable:
    """What was handed in, to the byte, from its file in `submitted/`, which is a stranger's; never raises for what is in it."""
    content = bytes_of(path, within=course.folder / "submitted")
    return unfolded(course, content) if isinstance(content, bytes) else content


def unfolded(course: Course, content: bytes) -> bytes:
    """Each reference counts once, as `folded` writes it: a hundred thousand, which a student may write, make no file of a gigabyte."""
    seen = set[bytes]()

    def word(found: re.Match[bytes]) -> bytes:
        whole = b"" if found[1] in seen else _word(course.record("shared", f"{found[1].decode()}.z"))
        seen.add(found[1])
        return whole or found[0]

    return REFERENCE.sub(word, content)


@lru_cache(maxsize=64)
def _word(place: Path) -> bytes:
    """A word of `shared/`; empty where there is none, or it is damaged."""
    try:
        return zlib.decompress(place.read_bytes())
    except (OSError, zlib.error):
        return b""


def has_sheet(course: Course, set_name: str, student: str) -> bool:
    """True if a sheet was written for this student, be it packed by now."""
    return (
        course.notebook("release", student, set_name).exists() or _sheet(course, set_name, student).exists()
    )


def read_sheet(course: Course, set_name: str, student: str) -> bytes | None:
    """The sheet as it was handed out; None when there is none. Raises DamagedArchive."""
    path = course.notebook("release", student, set_name)
    if path.is_file():
        return path.read_bytes()
    try:
        return unarchive(course, _sheet(course, set_name, student))
    except FileNotFoundError:
        return None


def restore_sheet(course: Course, set_name: str, student: str) -> None:
    """Writes a packed sheet into `release/` again, for programs that look there. Raises DamagedArchive."""
    path = course.notebook("release", student, set_name)
    if not path.exists() and (content := read_sheet(course, set_name, student)) is not None:
        write_whole(path, content)


def drop_sheet(course: Course, set_name: str, student: str) -> None:
    """Removes a sheet that a new one replaces."""
    course.notebook("release", student, set_name).unlink(missing_ok=True)
    _sheet(course, set_name, student).unlink(missing_ok=True)


def _sheet(course: Course, set_name: str, student: str) -> Path:
    return course.record("released", f"{set_name}/{student}.z")


def _text(content: bytes) -> bytes:
    return TEXT + len(content).to_bytes(8, "big") + content


def _shared(course: Course, digest: bytes) -> Path:
    return course.record("shared", f"{digest.hex()[:32]}.z")
