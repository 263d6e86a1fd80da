"""The text of a file of somebody else's: opened only where it is a regular file, and read up to a bound."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from corollary.problem.diagnostic import Diagnostic, Malformed

LARGEST_FILE = 20_000_000  # bytes: a bank of some thousand questions
LARGEST_PROGRAM = 1_000_000  # bytes: one question; the longest of a library of 2,467 has 24 kB
WITHOUT_WAITING = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)
KINDS = (
    (stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISSOCK, "a socket"),
    (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"),
)  # fmt: skip


def text_of(path: Path, most: int = LARGEST_FILE) -> str:
    """The text of a file. Raises Malformed where it is no regular file, cannot be read, is no text, or is larger than so many bytes."""
    try:
        content = _content(path, most)
    except OSError as error:
        raise _malformed(path, f"cannot be read: {error.strerror}") from None
    if len(content) > most:
        raise _malformed(path, f"is larger than {most // 1_000_000} MB; divide it")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise _malformed(path, "is no text in UTF-8; save it as UTF-8") from None


def _content(path: Path, most: int) -> bytes:
    """At most one byte more than allowed, whatever the size is said to be. Raises OSError, and Malformed for what is no file."""
    _refuse_other(path, path.stat().st_mode)  # before it is opened: to open a device may do something
    with os.fdopen(os.open(path, os.O_RDONLY | WITHOUT_WAITING), "rb", buffering=0) as file:
        _refuse_other(path, os.fstat(file.fileno()).st_mode)
        pieces, left = list[bytes](), most + 1
        while left and (piece := file.read(left)):
            pieces.append(piece)
            left -= len(piece)
    return b"".join(pieces)


def _refuse_other(path: Path, mode: int) -> None:
    if not stat.S_ISREG(mode):
        kind = next((name for holds, name in KINDS if holds(mode)), "no file")
        raise _malformed(path, f"is {kind}; name a file")


def _malformed(path: Path, sentence: str) -> Malformed:
    return Malformed([Diagnostic(path, 1, sentence)])
