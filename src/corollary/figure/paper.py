"""A drawing on a light sheet of its own: authors draw in dark ink, and a notebook's theme may be dark."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

MARGIN: Final = 12
"""Around the drawing, in its own units."""
OPENING = re.compile(r"""<svg\b(?:[^>"']|"[^"]*"|'[^']*')*>""")
EMPTY = re.compile(r"\s*/>$")
VIEW = re.compile(r"""\sviewBox=["']([\d.-]+)[\s,]+([\d.-]+)[\s,]+([\d.]+)[\s,]+([\d.]+)["']""")
SIZE = re.compile(
    r"""(?P<name>\s(?:width|height)=)(?P<quote>["'])\s*(?P<number>[\d.]+)(?P<unit>[a-z]*)\s*(?P=quote)"""
)
SIZED = re.compile(r"\s(?:width|height)=")


def on_paper(svg: str) -> str:
    """The SVG text with a white sheet behind it, and with a size of its own: without one it would fill the page.

    A size that it has grows with the sheet, so that the drawing on it stays as large as it was. A drawing without a viewBox
    keeps its size, and one that is no SVG is left as it is.
    """
    opening = OPENING.search(svg)
    if opening is None or EMPTY.search(opening[0]):
        return svg
    tag, sheet = opening[0], '<rect width="100%" height="100%" fill="#fff"/>'
    if view := VIEW.search(tag):
        left, top, width, height = map(float, view.groups())
        x, y, wide, high = left - MARGIN, top - MARGIN, width + 2 * MARGIN, height + 2 * MARGIN
        size = "" if SIZED.search(tag) else f' width="{wide:g}" height="{high:g}"'
        grown = {"width": wide / width, "height": high / height} if width and height else {}
        tag = SIZE.sub(lambda found: _grown(found, grown), tag)
        tag = tag.replace(view[0], f' viewBox="{x:g} {y:g} {wide:g} {high:g}"{size}', 1)
        sheet = f'<rect x="{x:g}" y="{y:g}" width="{wide:g}" height="{high:g}" rx="{MARGIN}" fill="#fff"/>'
    return svg[: opening.start()] + tag + sheet + svg[opening.end() :]


def _grown(size: re.Match[str], by: Mapping[str, float]) -> str:
    """`width="420"` for a sheet that is so many times as wide. (A size in percent is another thing's.)"""
    number = float(size["number"]) * by.get(size["name"].strip(" =\n\t"), 1.0)
    return f"{size['name']}{size['quote']}{number:.6g}{size['unit']}{size['quote']}"
