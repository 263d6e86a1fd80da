"""The uncertainty beside a value, parted from it: `8.6 ± 0.1 N`, `8.6 N ± 2 %`; in brackets, `65.0(5) N`, it is asked about."""

from __future__ import annotations

import re
from fractions import Fraction

from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.messages import catalogue

_ = catalogue(__name__)

# A wider one says that hardly a figure of the value is known: `10 ± 5 N` is no answer to be held against a tolerance.
WIDEST = Fraction(1, 10)
MARK = r"\s*(?:±|\+/-|\+-)\s*"
NUMBER = r"[0-9.,]+(?:[eE][+-]?[0-9]+)?"
IN_BRACKETS = re.compile(
    r"(?P<sign>[+-]?)\s*(?P<whole>[0-9]+)(?:(?P<point>[.,])(?P<decimals>[0-9]+))?\((?P<last>[0-9]{1,3})\)"
    r"(?:(?P<power>\s?[eE][+-]?[0-9]|\s*[*xX]\s*10\b)|(?=\s*(?:[^\W\d_]|[°%]|$)))"
)
SPREAD = re.compile(rf"{MARK}(?P<size>{NUMBER})")


def without_spread(text: str) -> tuple[str, str]:
    """The value, blanks in the place of its uncertainty, and the uncertainty with the unit behind it; "" where there is none."""
    found = SPREAD.search(text)
    if found is None:
        return text, ""
    value, unit = text[: found.start()], text[found.end() :]
    alone = value + " " * len(found[0]) + unit if re.search(r"[0-9.]$", value) else value
    return alone, found["size"] + unit.replace(")", "")


def in_brackets(text: str) -> ParseError | None:
    """What is asked about a text that begins with a number like `65.0(5)`: 65.0 ± 0.5, or 65.0*5. In `8.6(1)` both are 8.6."""
    found = IN_BRACKETS.match(text)
    if found is None or found["last"] == "1":
        return None
    decimals, last = found["decimals"] or "", found["last"]
    number = found["sign"] + found["whole"] + (found["point"] or "") + decimals
    why = _("{body} can be a number and its uncertainty, or a product", body=f"{number}({last})")
    if found["power"]:
        return refused(why, 0, _("write ± or *"))
    digits = last.rjust(len(decimals) + 1, "0")
    cut = len(digits) - len(decimals)
    size = digits[:cut] + ((found["point"] + digits[cut:]) if decimals else "")
    return ambiguous(why, 0, f"{number} ± {size}", f"{number}*{last}")
