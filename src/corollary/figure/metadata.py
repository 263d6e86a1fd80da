"""Metadata of a photograph (when and where it was taken, with which camera, by whom), taken out.

JPEG: ITU-T T.81, annex B, and Exif 2.3, section 4.5; PNG: its third edition (W3C), section 11.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator

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
