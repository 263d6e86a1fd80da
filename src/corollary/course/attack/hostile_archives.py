"""Hostile archives: small files, each wrong in one way, as one student may hand them in."""

from __future__ import annotations

import io
import stat
import struct
import tarfile
import warnings
import zipfile
from collections.abc import Callable
from functools import cache

NOTEBOOK = "one.ipynb"


def packed(*files: tuple[str | zipfile.ZipInfo, bytes], method: int = zipfile.ZIP_STORED) -> bytes:
    content = io.BytesIO()
    with (
        warnings.catch_warnings(action="ignore"),
        zipfile.ZipFile(content, "w", method) as made,
    ):  # of a name twice
        for name, text in files:
            made.writestr(name, text, compress_type=method)
    return content.getvalue()


def patched(archive: bytes, local: dict[int, bytes], central: dict[int, bytes]) -> bytes:
    """With these bytes in the header of the first member and in its entry of the directory, by their place there."""
    raw = bytearray(archive)
    for start, changes in ((0, local), (raw.index(b"PK\x01\x02"), central)):
        for place, text in changes.items():
            raw[start + place : start + place + len(text)] = text
    return bytes(raw)


def of_method(number: int, garbage: bytes = bytes(range(256)) * 2) -> bytes:
    method = struct.pack("<H", number)
    return patched(packed((NOTEBOOK, garbage)), {8: method}, {10: method})


def far_away() -> bytes:
    """A Zip64 field by which the member begins at 2^63."""
    raw = bytearray(packed((NOTEBOOK, b"{}")))
    at = raw.index(b"PK\x01\x02")
    raw[at + 42 : at + 46] = b"\xff" * 4
    name_ends = at + 46 + len(NOTEBOOK)
    extra = struct.pack("<HHQ", 1, 8, 1 << 63)
    raw[at + 30 : at + 32] = struct.pack("<H", len(extra))
    raw[name_ends:name_ends] = extra
    end = raw.rindex(b"PK\x05\x06")
    raw[end + 12 : end + 16] = struct.pack("<I", end - at)
    return bytes(raw)


def named(name: bytes) -> bytes:
    """With a name that no program writes."""
    return packed(("x" * len(name), b"{}")).replace(b"x" * len(name), name)


def without_a_name() -> bytes:
    raw = bytearray(packed(("x", b"{}")))
    at = raw.index(b"PK\x01\x02")
    raw[at + 28 : at + 30] = b"\0\0"
    del raw[at + 46]
    raw[26:28] = b"\0\0"
    del raw[30]
    end = raw.rindex(b"PK\x05\x06")
    raw[end + 12 : end + 20] = struct.pack("<II", 46, at - 1)
    return bytes(raw)


def linked() -> bytes:
    link = zipfile.ZipInfo(NOTEBOOK)
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    return packed((link, b"/etc/passwd"))


def _special(kind: int) -> zipfile.ZipInfo:
    info = zipfile.ZipInfo(NOTEBOOK)
    info.external_attr = (kind | 0o666) << 16
    return info


def nested(depth: int) -> bytes:
    content = packed((NOTEBOOK, b"{}"))
    for _ in range(depth):
        content = packed(("inner.zip", content))
    return content


@cache
def bomb(count: int = 12) -> bytes:
    """Many members that are the same twenty megabytes of zeros."""
    zeros = bytes(20_000_000)
    return packed(*((f"{number}.ipynb", zeros) for number in range(count)), method=zipfile.ZIP_DEFLATED)


def overlapping() -> bytes:
    """Two entries of the directory for one member."""
    raw = packed((NOTEBOOK, b'{"cells": []}'))
    at, end = raw.index(b"PK\x01\x02"), raw.index(b"PK\x05\x06")
    entry = raw[at:end]
    tail = struct.pack("<4s4H2IH", b"PK\x05\x06", 0, 0, 2, 2, 2 * len(entry), at, 0)
    return raw[:at] + entry + entry + tail


def tarred() -> bytes:
    content = io.BytesIO()
    with tarfile.open(fileobj=content, mode="w:gz") as made:
        info = tarfile.TarInfo(NOTEBOOK)
        info.size = 2
        made.addfile(info, io.BytesIO(b"{}"))
    return content.getvalue()


def _fields(local: dict[int, bytes], central: dict[int, bytes]) -> bytes:
    return patched(packed((NOTEBOOK, b'{"cells": [1]}')), local, central)


HOSTILE: dict[str, Callable[[], bytes]] = {
    "LZMA garbage": lambda: of_method(14),
    "bzip2 garbage": lambda: of_method(12),
    "deflate garbage": lambda: of_method(8),
    "Deflate64": lambda: of_method(9),
    "Zstandard": lambda: of_method(93),
    "a method that nobody knows": lambda: of_method(31_337),
    "an offset of 2^63": far_away,
    "a member without a name": without_a_name,
    "a name that is NUL": lambda: named(b"\0.ipynb"),
    "a name in no encoding": lambda: named(b"\xff\xfe\x80.ipynb"),
    "a name that leads out": lambda: packed(("../../one.ipynb", b"{}")),
    "an absolute name": lambda: packed(("/etc/one.ipynb", b"{}")),
    "a drive": lambda: packed(("C:\\one.ipynb", b"{}")),
    "a name that Windows forbids": lambda: packed(("con./aux .ipynb", b"{}")),
    "a name of 60 000 letters": lambda: packed(("_" * 60_000 + ".ipynb", b"{}")),
    "a thousand folders": lambda: packed(("a/" * 1_000 + NOTEBOOK, b"{}")),
    "a number of 5 000 digits in its name": lambda: packed((f"one-{'9' * 5_000}.ipynb", b"{}")),
    "a link": linked,
    "a password": lambda: _fields({6: b"\x01\0"}, {8: b"\x01\0"}),
    "month 0": lambda: _fields({10: b"\0\0\0\0"}, {12: b"\0\0\0\0"}),
    "the year 2107": lambda: _fields({10: b"\xff\xff\xff\xff"}, {12: b"\xff\xff\xff\xff"}),
    "a wrong checksum": lambda: _fields({14: b"\1\2\3\4"}, {16: b"\1\2\3\4"}),
    "a size of 4 GB": lambda: _fields({22: b"\xfe\xff\xff\xff"}, {24: b"\xfe\xff\xff\xff"}),
    "sizes that differ": lambda: _fields({18: b"\x01\0\0\0"}, {20: b"\xff\xff\0\0"}),
    "a version of the future": lambda: _fields({4: b"\xff\xff"}, {6: b"\xff\xff"}),
    "an extra field of 60 000 bytes": lambda: _fields({28: b"\x60\xea"}, {30: b"\x60\xea"}),
    "a torn directory": lambda: packed((NOTEBOOK, b"{}"))[:-30],
    "half a file": lambda: packed((NOTEBOOK, b"{}" * 500))[:600],
    "a comment that goes on": lambda: packed((NOTEBOOK, b"{}"))[:-2] + b"\xff\xff" + b"PK\x05\x06" * 9,
    "the same name twice": overlapping,
    "four archives in one another": lambda: nested(4),
    "a tar with the wrong name": tarred,
    "a 7z with the wrong name": lambda: b"7z\xbc\xaf\x27\x1c\0\x04" + bytes(200),
    "a rar with the wrong name": lambda: b"Rar!\x1a\x07\x01\0" + bytes(200),
    "nothing": lambda: b"",
    "one byte": lambda: b"P",
    "only an end": lambda: b"PK\x05\x06" + bytes(18),
    "twelve padded notebooks": bomb,
    "a directory that begins before the file": lambda: (
        packed((NOTEBOOK, b"{}"))[:-6] + b"\xff\xff\xff\x7f\0\0"
    ),
    "65 535 members in its end": lambda: packed((NOTEBOOK, b"{}"))[:-12] + b"\xff" * 8 + bytes(4),
    "fifty thousand empty notebooks": lambda: packed(*((f"{n}.ipynb", b"") for n in range(50_000))),
    "one name in capitals and not": lambda: packed((NOTEBOOK, b"{}"), (NOTEBOOK.upper(), b"{}")),
    "a name that turns the line around": lambda: packed(("\u202egnp.ipynb", b"{}")),
    "a name that clears the screen": lambda: named(b"\x1b[2J\x1b]0;x\x07.ipynb"),
    "a name that a spreadsheet calculates": lambda: packed(("=HYPERLINK(0).ipynb", b"{}")),
    "a name that a page runs": lambda: packed(("<img src=x onerror=alert(1)>.ipynb", b"{}")),
    "the course's key by name": lambda: packed(
        ("../../.corollary/key", b"0" * 32), (".corollary/key", b"0" * 32)
    ),
    "a device": lambda: packed((_special(stat.S_IFCHR), b""), (_special(stat.S_IFIFO), b"")),
    "a program that unpacks itself": lambda: b"MZ" + bytes(500) + packed((NOTEBOOK, b"{}")),
}
