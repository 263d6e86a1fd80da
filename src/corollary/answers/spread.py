"""The uncertainty beside a value, `8.6 ± 0.1 N` or `8.6 N ± 2 %`, parted from it."""

from __future__ import annotations

import re
from fractions import Fraction

# A wider one says that hardly a figure of the value is known: `10 ± 5 N` is no answer to be held against a tolerance.
WIDEST = Fraction(1, 10)
MARK = r"\s*(?:±|\+/-|\+-)\s*"
NUMBER = r"[0-9.,]+(?:[eE][+-]?[0-9]+)?"
SPREAD = re.compile(rf"{MARK}(?P<size>{NUMBER})")


def without_spread(text: str) -> tuple[str, str]:
    """The value, blanks in the place of its uncertainty, and the uncertainty with the unit behind it; "" where there is none."""
    found = SPREAD.search(text)
    if found is None:
        return text, ""
    value, unit = text[: found.start()], text[found.end() :]
    alone = value + " " * len(found[0]) + unit if re.search(r"[0-9.]$", value) else value
    return alone, found["size"] + unit.replace(")", "")
