"""A journal: a file of JSON lines that only grows, in which a line cut short by the power does no harm."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import msgspec


def append(path: Path, entries: Iterable[object]) -> None:
    """Adds a line for each entry, and returns when they are on the disk."""
    lines = [msgspec.json.encode(entry) + b"\n" for entry in entries]
    if not lines:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    last = last_lines(path, 1)
    # A line that was cut short has no end: the new one must not be glued to it.
    torn = b"" if not last or last[-1].endswith(b"\n") else b"\n"
    with path.open("ab", buffering=0) as file:
        file.write(torn + b"".join(lines))
        os.fsync(file.fileno())


def entries(path: Path) -> Iterator[dict[str, Any]]:
    """Every entry, oldest first, as plain data; a line that was cut short is none."""
    try:
        lines = path.read_bytes().splitlines()
    except FileNotFoundError:
        return
    for line in lines:
        try:
            entry = msgspec.json.decode(line)
        except msgspec.DecodeError:
            continue
        if isinstance(entry, dict):
            yield entry


def last_lines(path: Path, most: int) -> list[bytes]:
    """The last lines with their ends, oldest first, read from behind: a journal grows long. None where there is no file."""
    try:
        with path.open("rb") as file:
            size, block, tail = file.seek(0, os.SEEK_END), 1 << 16, b""
            while size and tail[:-1].count(b"\n") < most:
                start = max(0, size - block)
                file.seek(start)
                tail, size = file.read(size - start) + tail, start
    except FileNotFoundError:
        return []
    return tail.splitlines(keepends=True)[-most:]
