"""Pictures in a text of Markdown, which carries them as data URIs: short names in their place while the text is set."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from corollary.figure.picture import ADDRESS, content
from corollary.figure.svg import VIEW

NAME: Final = "picture:"
SOURCE = re.compile(rf'src="({NAME}[0-9a-f]{{16}})"')
ENDINGS: Final = {"png": "png", "jpeg": "jpg", "svg+xml": "svg"}
SIZE_OF_JPEG = frozenset({*range(0xC0, 0xD0)} - {0xC4, 0xC8, 0xCC})
"""The markers of a frame, which has the size (ITU T.81, table B.1)."""
UNKNOWN: Final = (400, 300)


@dataclass(frozen=True, slots=True)
class Lifted:
    """A text with `picture:` and a digest in place of each address: it can be kept and read in no time. `addresses` by name."""

    text: str
    addresses: Mapping[str, str]


def lifted(text: str) -> Lifted:
    if "data:image/" not in text:
        return Lifted(text, {})
    addresses: dict[str, str] = {}

    def named(found: re.Match[str]) -> str:
        name = NAME + hashlib.sha256(found[0].encode()).hexdigest()[:16]
        addresses[name] = found[0]
        return name

    return Lifted(ADDRESS.sub(named, text), addresses)


def put_back(html: str, addresses: Mapping[str, str]) -> str:
    """HTML with the addresses themselves."""
    return SOURCE.sub(lambda found: f'src="{addresses.get(found[1], "")}"', html) if addresses else html


def as_files(html: str, folder: str = "") -> tuple[str, dict[str, bytes]]:
    """HTML in which each picture is a file of this folder, and the files by their names."""
    files: dict[str, bytes] = {}

    def file(found: re.Match[str]) -> str:
        kind, raw = content(found[1])
        name = f"picture-{hashlib.sha256(raw).hexdigest()[:16]}.{ENDINGS[kind]}"
        files[name] = raw
        return f'src="{folder}{name}"'

    return re.sub(f'src="({ADDRESS.pattern})"', file, html), files


def as_svg(address: str) -> tuple[str, float]:
    """The picture as SVG text, and how wide it is, in pixels of 1/96 inch."""
    kind, raw = content(address)
    if kind == "svg+xml":
        text = raw.decode()
        view = VIEW.search(text)
        return text, float(view[3]) if view else float(UNKNOWN[0])
    width, height = _size(raw)
    size = f'viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" {size}>'
        f'<image width="{width}" height="{height}" xlink:href="{address}"/></svg>'
    ), float(width)


def _size(raw: bytes) -> tuple[int, int]:
    """Width and height of a PNG or JPEG in its own pixels."""
    if raw.startswith(b"\x89PNG"):
        return int.from_bytes(raw[16:20]), int.from_bytes(raw[20:24])
    at = 2
    while at + 9 < len(raw) and raw[at] == 0xFF:
        if raw[at + 1] in SIZE_OF_JPEG:
            return int.from_bytes(raw[at + 7 : at + 9]), int.from_bytes(raw[at + 5 : at + 7])
        at += 2 + int.from_bytes(raw[at + 2 : at + 4])
    return UNKNOWN
