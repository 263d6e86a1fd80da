"""A drawing on a light sheet of its own: authors draw in dark ink, and a notebook's theme may be dark."""

from __future__ import annotations

import re
from typing import Final

MARGIN: Final = 12
"""Around the drawing, in its own units."""
OPENING = re.compile(r"""<svg\b(?:[^>"']|"[^"]*"|'[^']*')*>""")
EMPTY = re.compile(r"\s*/>$")
VIEW = re.compile(r"""\sviewBox=["']([\d.-]+)[\s,]+([\d.-]+)[\s,]+([\d.]+)[\s,]+([\d.]+)["']""")
SIZED = re.compile(r"\s(?:width|height)=")


def on_paper(svg: str) -> str:
    """The SVG text with a white sheet behind it, and with a size of its own: without one it would fill the page.

    A drawing without a viewBox keeps its size, and one that is no SVG is left as it is.
    """
    opening = OPENING.search(svg)
    if opening is None or EMPTY.search(opening[0]):
        return svg
    tag, sheet = opening[0], '<rect width="100%" height="100%" fill="#fff"/>'
    if view := VIEW.search(tag):
        left, top, width, height = map(float, view.groups())
        x, y, wide, high = left - MARGIN, top - MARGIN, width + 2 * MARGIN, height + 2 * MARGIN
        size = "" if SIZED.search(tag) else f' width="{wide:g}" height="{high:g}"'
        tag = tag.replace(view[0], f' viewBox="{x:g} {y:g} {wide:g} {high:g}"{size}', 1)
        sheet = f'<rect x="{x:g}" y="{y:g}" width="{wide:g}" height="{high:g}" rx="{MARGIN}" fill="#fff"/>'
    return svg[: opening.start()] + tag + sheet + svg[opening.end() :]
