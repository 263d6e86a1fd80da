"""The two files of a problem as texts to edit, written only where they are still as they were read."""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from corollary.atomic import write_whole
from corollary.problem.bank import Bank, files

Side = Literal["problem", "solution"]
SIDES: tuple[Side, Side] = ("problem", "solution")
LARGEST = 400_000  # bytes of a text that a page is given
INSTALLED = {"site-packages", "dist-packages"}


class NotWritable(ValueError):
    """A text that is not written; the sentence says why, and what to do."""


class ChangedOnDisk(Exception):
    """Something else has written to files since they were read; `files` are these as they are now."""

    def __init__(self, files: Mapping[Side, AuthorFile]):
        self.files = files
        super().__init__(", ".join(each.path.name for each in files.values()))


@dataclass(frozen=True, slots=True)
class AuthorFile:
    """A text with LF between its lines. `fingerprint` tells the bytes of the file apart from others, and is "" where there is
    none; `locked` says why it cannot be written, and is "" where it can."""

    path: Path
    text: str
    fingerprint: str
    locked: str


@dataclass(frozen=True, slots=True)
class Edited:
    """A text to write, and the fingerprint of the file that it was made from."""

    text: str
    fingerprint: str


def problem_names(bank: Bank) -> dict[str, Path]:
    """The problem files of a bank by topic and name: `mechanics/sliding_box`."""
    found: dict[str, Path] = {}
    for path in files(bank):
        home = bank.home_of(path)
        found.setdefault(path.relative_to(home.problems).with_suffix("").as_posix(), path)
    return found


def pair(bank: Bank, path: Path) -> dict[Side, Path]:
    """The files of the problem at `path`."""
    return {"problem": path, "solution": bank.solution_beside(path)}


def read_author_file(home: Bank, path: Path) -> AuthorFile:
    """The file of a bank with one folder, as it is now; one that cannot be read has no text and is locked."""
    try:
        raw = path.read_bytes() if path.is_file() else None
    except OSError as error:
        return AuthorFile(path, "", "", f"{path.name} cannot be read: {error.strerror}")
    if raw is None:
        return AuthorFile(path, "", "", f"{path.name} is missing; write it in an editor, or put it back")
    fingerprint = hashlib.sha256(raw).hexdigest()
    if len(raw) > LARGEST:
        return AuthorFile(path, "", fingerprint, f"{path.name} is larger than {LARGEST // 1000} kB")
    try:
        text = raw.decode("utf-8")
    except UnicodeDecodeError:
        return AuthorFile(path, "", fingerprint, f"{path.name} is not UTF-8; save it so in an editor")
    return AuthorFile(path, _with_lf(text), fingerprint, _locked(home, path))


def write_author_files(bank: Bank, path: Path, edited: Mapping[Side, Edited]) -> dict[Side, AuthorFile]:
    """Write the edited texts of the problem at `path`, all or none, and return the files as they are then.

    Raises ChangedOnDisk where a file is no longer what its text was made from, and NotWritable.
    """
    home, paths = bank.home_of(path), pair(bank, path)
    found: dict[Side, AuthorFile] = {side: read_author_file(home, paths[side]) for side in edited}
    for each in found.values():
        if each.locked:
            raise NotWritable(each.locked)
    changed: dict[Side, AuthorFile] = {
        side: each for side, each in found.items() if each.fingerprint != edited[side].fingerprint
    }
    if changed:
        raise ChangedOnDisk(changed)
    written: dict[Side, bytes] = {side: _encoded(paths[side], each.text) for side, each in edited.items()}
    for side, content in written.items():
        write_whole(paths[side], content, mode=stat.S_IMODE(paths[side].stat().st_mode))
    return {side: read_author_file(home, paths[side]) for side in edited}


def locked_place(home: Bank, path: Path) -> str:
    """Why nothing can be written at `path` of a bank with one folder; "" where it can, also where there is no file yet."""
    inside = home.folder.resolve() / path.relative_to(home.folder)
    if inside.is_symlink() or inside.resolve() != inside:
        return f"{path.name} is a link, or lies behind one; open the bank that it leads to"
    if INSTALLED & set(inside.parts):
        return (
            "this bank belongs to an installed package and is read only; copy the problem into a bank of your own: "
            "corollary new CODE NAME --like CODE --bank FOLDER"
        )
    above = next(each for each in inside.parents if each.is_dir())
    if not os.access(above, os.W_OK) or (inside.exists() and not os.access(inside, os.W_OK)):
        return (
            f"{path.name} is read only for you; ask for the right to write in {above.name}/, or copy the bank"
        )
    return ""


def _locked(home: Bank, path: Path) -> str:
    if path.suffix != ".md":
        return f"{path.name} is a program: change it in an editor, and this page follows what you save there"
    return locked_place(home, path)


def _with_lf(text: str) -> str:
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _encoded(path: Path, text: str) -> bytes:
    """The bytes to write, with the ends of lines that the file has. Raises NotWritable."""
    try:
        content = _with_lf(text).encode("utf-8")
    except UnicodeEncodeError:
        raise NotWritable("the text holds half of a sign; delete it") from None
    if len(content) > LARGEST:
        raise NotWritable(f"the text is larger than {LARGEST // 1000} kB")
    if b"\0" in content:
        raise NotWritable("the text holds a sign that no text has (NUL); delete it")
    before = path.read_bytes()
    windows = b"\r\n" in before and before.count(b"\r\n") == before.count(b"\n")
    return content.replace(b"\n", b"\r\n") if windows else content
