"""A picture from a file, as a data URI, without the metadata of a photograph."""

from __future__ import annotations

import base64
import binascii
import re
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from corollary.figure.svg import NotADrawing, alone, left_out, on_paper, safe_svg

EXIF = b"Exif\0\0"
ORIENTATION = 0x0112
"""How a camera was held: without it, pictures would lie on their sides."""
SHORT = 3  # a type of Exif's: two bytes
SOI, EOI, SOS, APP0, APP1, APP2, APP14, APP15, COM = (
    0xD8, 0xD9, 0xDA, 0xE0, 0xE1, 0xE2, 0xEE, 0xEF, 0xFE,
)  # fmt: skip
ALONE = frozenset({0x01, *range(0xD0, 0xD8)})  # markers without a length
COLOURS = b"ICC_PROFILE\0"
NEEDED = frozenset(b"IHDR PLTE IDAT IEND tRNS gAMA cHRM sRGB iCCP cICP sBIT bKGD pHYs acTL fcTL fdAT".split())


class Damaged(ValueError):
    """The bytes are not those of a whole picture."""


def without_metadata(kind: str, raw: bytes) -> bytes:
    """A PNG or a JPEG with what is needed to show it, and no more; which way up it is stays. Raises Damaged."""
    try:
        return _jpeg(raw) if kind == "jpeg" else _png(raw)
    except (IndexError, struct.error):
        raise Damaged("it ends too early") from None


def _jpeg(raw: bytes) -> bytes:
    pieces, turned = [raw[:2]], 1
    segments: list[bytes] = []
    for marker, segment in _segments(raw):
        if marker == APP1 and segment[4:].startswith(EXIF):
            turned = _orientation(segment[4 + len(EXIF) :]) or turned
        if not _is_remark(marker, segment):
            segments.append(segment)
    if turned != 1:
        pieces.append(_upright(turned))
    return b"".join([*pieces, *segments])


def _segments(raw: bytes) -> Iterator[tuple[int, bytes]]:
    """Each marker with what belongs to it, up to the end of the picture; what stands behind that is none of it."""
    at = 2
    while True:
        if raw[at] != 0xFF:
            raise Damaged("a marker is missing")
        while raw[at] == 0xFF:  # bytes that fill
            at += 1
        marker = raw[at]
        at += 1
        if marker == EOI or marker in ALONE:
            yield marker, raw[at - 2 : at]
            if marker == EOI:
                return
            continue
        (length,) = struct.unpack_from(">H", raw, at)
        end = at + length
        if marker == SOS:
            end = _end_of_scan(raw, end)
        if end > len(raw):
            raise Damaged("it ends too early")
        yield marker, b"\xff" + raw[at - 1 : end]
        at = end


def _end_of_scan(raw: bytes, at: int) -> int:
    """Where the next marker stands: within a scan 0xFF is followed by 0 or by a restart marker."""
    while True:
        at = raw.find(b"\xff", at)
        if at < 0:
            raise Damaged("it ends too early")
        if raw[at + 1] != 0 and raw[at + 1] not in ALONE:
            return at
        at += 2


def _is_remark(marker: int, segment: bytes) -> bool:
    if marker == APP2:
        return not segment[4:].startswith(COLOURS)
    return marker == COM or (APP0 < marker <= APP15 and marker != APP14)


def _orientation(tiff: bytes) -> int:
    """Exif's 1 to 8; 0 where it says nothing that can be read."""
    order = {b"II": "<", b"MM": ">"}.get(tiff[:2])
    if order is None:
        return 0
    try:
        (first,) = struct.unpack_from(order + "I", tiff, 4)
        (entries,) = struct.unpack_from(order + "H", tiff, first)
        for place in range(first + 2, first + 2 + 12 * entries, 12):
            tag, kind, _count, value = struct.unpack_from(order + "HHIH", tiff, place)
            if tag == ORIENTATION and kind == SHORT and 1 <= value <= 8:
                return value
    except struct.error:  # badly written, and not needed to show it
        return 0
    return 0


def _upright(turned: int) -> bytes:
    """Exif with nothing but which way up."""
    entry = struct.pack(">HHIHH", ORIENTATION, SHORT, 1, turned, 0)
    body = EXIF + b"MM\0*" + struct.pack(">IH", 8, 1) + entry + struct.pack(">I", 0)
    return struct.pack(">BBH", 0xFF, APP1, len(body) + 2) + body


def _png(raw: bytes) -> bytes:
    pieces, at, name = [raw[:8]], 8, b""
    while name != b"IEND":
        length, name = struct.unpack_from(">I4s", raw, at)
        end = at + 12 + length
        if end > len(raw):
            raise Damaged("it ends too early")
        if name in NEEDED:
            pieces.append(raw[at:end])
        at = end
    return b"".join(pieces)


KINDS: Final = {".png": "png", ".jpg": "jpeg", ".jpeg": "jpeg", ".svg": "svg+xml"}
FIRST_BYTES: Final = {"png": b"\x89PNG\r\n\x1a\n", "jpeg": b"\xff\xd8\xff"}
MOST: Final = 512 * 1024
"""Bytes: every student's notebook carries the picture, and a photograph 1 600 pixels wide has some 300 kB."""
ADDRESS = re.compile(r"data:image/(?P<kind>png|jpeg|svg\+xml);base64,(?P<data>[A-Za-z0-9+/]+={0,2})")


class NotAPicture(ValueError):
    """What was to be shown cannot be; the rest of a sentence says why."""


def address(path: Path) -> str:
    """The picture of a file as a data URI; of an SVG, what can neither run nor fetch. Raises NotAPicture."""
    kind = KINDS.get(path.suffix.lower())
    if kind is None:
        raise NotAPicture(f"is not a picture: there are {', '.join(KINDS)}")
    try:
        raw = path.read_bytes()
    except OSError as error:
        raise NotAPicture(f"cannot be read: {error.strerror}") from None
    return _address(kind, raw, sheet=True)


def checked(written: str) -> str:
    """A data URI, when it is that of a picture. Raises NotAPicture."""
    found = ADDRESS.fullmatch(written)
    if found is None:
        raise NotAPicture("is an address; a picture is a file beside the problem")
    try:
        return _address(found["kind"], base64.b64decode(found["data"], validate=True), sheet=False)
    except binascii.Error:
        raise NotAPicture("is not base64") from None


def content(written: str) -> tuple[str, bytes]:
    """The kind (`png`, `jpeg`, `svg+xml`) and the bytes of a data URI that `address` has made."""
    found = ADDRESS.fullmatch(written)
    if found is None:
        raise ValueError("no address of a picture")
    return found["kind"], base64.b64decode(found["data"])


def _address(kind: str, raw: bytes, *, sheet: bool) -> str:
    if len(raw) > MOST:
        raise NotAPicture(
            f"has {len(raw) // 1024:,} kB, and every notebook would carry them; make it smaller, {MOST // 1024} kB at most"
        )
    if kind == "svg+xml":
        safe = _drawing(raw)
        # What travels already has its sheet; it is read back as it was written.
        raw = (_drawing(on_paper(safe).encode()) if sheet else safe).encode()
    elif not raw.startswith(FIRST_BYTES[kind]):
        raise NotAPicture(f"does not hold what its name says: a {kind.upper()} begins otherwise")
    elif sheet:  # from a file
        try:
            raw = without_metadata(kind, raw)
        except Damaged as error:
            raise NotAPicture(f"is damaged: {error}") from None
    return f"data:image/{kind};base64,{base64.b64encode(raw).decode()}"


def _drawing(raw: bytes) -> str:
    try:
        text = raw.decode("utf-8")
        if lost := left_out(text):
            raise NotAPicture(
                f"has {lost}, which would not be shown; save it as a plain SVG: shapes, words and colours, nothing that runs, "
                "is fetched, or is told by classes"
            )
        safe = safe_svg(text)
    except UnicodeDecodeError:
        raise NotAPicture("is not text in UTF-8") from None
    except NotADrawing as error:
        raise NotAPicture(f"cannot be shown: {error}") from None
    return alone(safe)
