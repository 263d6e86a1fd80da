"""A picture from a file, as it travels: inside the text that shows it, as a data URI, which every notebook and page can show."""

from __future__ import annotations

import base64
import binascii
import re
from pathlib import Path
from typing import Final

from corollary.figure.metadata import Damaged, without_metadata
from corollary.figure.paper import on_paper
from corollary.figure.svg import NotADrawing, alone, left_out, safe_svg

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
        raise NotAPicture(f"is no picture: there are {', '.join(KINDS)}")
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
        raise NotAPicture("is no base64") from None


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
        raise NotAPicture("is no text in UTF-8") from None
    except NotADrawing as error:
        raise NotAPicture(f"cannot be shown: {error}") from None
    return alone(safe)
