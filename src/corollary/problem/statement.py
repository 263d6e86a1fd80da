"""A statement with a variant's numbers in its holes."""

from __future__ import annotations

import re

from corollary.problem.variant import Variant, number, written

HOLE = re.compile(r"\{\{\s*([A-Za-z_]\w*)\s*(?:\|\s*(\w+)\s*)?\}\}")


def holes(text: str) -> list[tuple[str, str, int]]:
    """Every hole of a text: symbol, style, and the line it stands on (counted from 0)."""
    return [(hole[1], hole[2] or "", text.count("\n", 0, hole.start())) for hole in HOLE.finditer(text)]


def filled(text: str, variant: Variant) -> str:
    """The text with each `{{m}}` replaced by number and unit, each `{{m|number}}` by the bare number."""

    def fill(hole: re.Match[str]) -> str:
        symbol, style = hole[1], hole[2]
        given = variant.problem.given(symbol)
        return number(given, variant.values[symbol]) if style == "number" else written(variant, symbol)

    return HOLE.sub(fill, text)
