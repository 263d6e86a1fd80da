"""The bytes of a file that was handed in: read without following links, waiting, or reading more than fits."""

from __future__ import annotations

import os
import stat
from dataclasses import dataclass
from pathlib import Path

MOST_BYTES = 20 << 20


@dataclass(frozen=True, slots=True)
class Unreadable:
    """A file that is no notebook; `why` is a sentence for the student."""

    why: str


def content_of(path: str | Path) -> bytes:
    """The bytes of a file that was handed in, or the words on why there are none; never raises, never waits."""
    content = bytes_of(path)
    return content if isinstance(content, bytes) else content.why.encode()


def bytes_of(path: str | Path) -> bytes | Unreadable:
    """What is in a file that was handed in; never raises, never waits."""
    try:
        # A named pipe would wait for ever, and a link leads where the student could not go.
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except (OSError, ValueError) as error:
        return Unreadable(
            f"The file cannot be opened: {error.strerror if isinstance(error, OSError) else error}."
        )
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        os.close(descriptor)
        return Unreadable("This is not a file.")
    with open(descriptor, "rb") as file:
        try:
            return file.read(MOST_BYTES + 1)
        except OSError as error:
            return Unreadable(f"The file cannot be read: {error.strerror}.")
