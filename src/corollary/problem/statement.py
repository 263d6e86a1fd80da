"""A statement with a variant's numbers in its holes."""

from __future__ import annotations

import re

from corollary.messages import in_convention
from corollary.problem.variant import Variant, number, written

FORMULA = re.compile(r"\$\$.*?\$\$|\$.*?\$", re.DOTALL)
HOLE = re.compile(r"\{\{\s*([A-Za-z_]\w*)\s*(?:\|\s*(\w+)\s*)?\}\}")


def holes(text: str) -> list[tuple[str, str, int]]:
    """Every hole of a text: symbol, style, and the line it stands on (counted from 0)."""
    return [(hole[1], hole[2] or "", text.count("\n", 0, hole.start())) for hole in HOLE.finditer(text)]


def filled(text: str, variant: Variant) -> str:
    """The text with each `{{m}}` replaced by number and unit, each `{{m|number}}` by the bare number, each `{{m|svg}}` by the
    number as attributes of a drawing have it (in the given's unit, with a hyphen for minus)."""

    def fill(hole: re.Match[str]) -> str:
        symbol, style = hole[1], hole[2] or ""
        given, value = variant.problem.given(symbol), variant.values[symbol]
        bare = number(given, value) if style in ("number", "svg") else written(variant, symbol)
        if style == "svg":
            return bare.replace("−", "-")
        in_formula = text.count("$", 0, hole.start()) % 2 == 1
        return in_convention(bare, "{,}" if in_formula else ",")

    return HOLE.sub(fill, text)


def formulas_in_convention(text: str) -> str:
    """Markdown with the numbers in its formulas as readers of the spoken language write them; programs stay as they are."""
    pieces = re.split(r"(```.*?```)", text, flags=re.DOTALL)
    pieces[::2] = [FORMULA.sub(lambda found: in_convention(found[0], "{,}"), piece) for piece in pieces[::2]]
    return "".join(pieces)
