"""A statement with a variant's numbers in its holes."""

from __future__ import annotations

import re

from corollary.problem.variant import Variant, number, written

HOLE = re.compile(r"\{\{\s*([A-Za-z_]\w*)\s*(?:\|\s*(\w+)\s*)?\}\}")


def holes(text: str) -> list[tuple[str, str, int]]:
    """Every hole of a text: symbol, style, and the line it stands on (counted from 0)."""
    return [(hole[1], hole[2] or "", text.count("\n", 0, hole.start())) for hole in HOLE.finditer(text)]


def filled(text: str, variant: Variant) -> str:
    """The text with each `{{m}}` replaced by number and unit, each `{{m|number}}` by the bare number, each `{{m|svg}}` by the
    number as attributes of a drawing have it (in the given's unit, with a hyphen for minus)."""

    def fill(hole: re.Match[str]) -> str:
        symbol, style = hole[1], hole[2] or ""
        given = variant.problem.given(symbol)
        bare = number(given, variant.values[symbol])
        return {"number": bare, "svg": bare.replace("−", "-")}.get(style, "") or written(variant, symbol)

    return HOLE.sub(fill, text)
