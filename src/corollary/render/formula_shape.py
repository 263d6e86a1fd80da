"""Formulas that differ by their numbers alone are converted once: those of a class are mostly the same with other numbers."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache, wraps
from typing import Final

HOLES: Final = "٠۰߀०০੦૦୦௦౦೦൦෦๐໐༠၀႐០᠐᥆᧐᪀᪐᭐᮰᱀᱐꘠꣐꤀꧐꧰꩐꯰"
"""A zero for each number of a formula, each of a script that no formula is written in: to every converter it is a digit."""
NUMBER = re.compile(r"(?<=[ (])(?:\d+\.\d+|\d\d+)(?![\d.])", re.ASCII)
"""A number in a row, of two digits or more; shorter ones are mostly of the formula itself."""
FILLED = re.compile(rf"([{HOLES}])\.?\1")
SET_OTHERWISE = re.compile(
    rf"[{HOLES}]|[_^]\s*\{{[^{{}}]*[{{( ]|[_^][ (]|\\(?!mathrm\b)(?:math|text|mbox|operatorname|begin)"
)
"""Where numbers may be set by their digits: an index or exponent of several words, bold letters, a text."""


def by_shape(convert: Callable[[str], str]) -> Callable[[str], str]:
    """A conversion of LaTeX that is done once for all formulas that are the same but for their numbers.

    `convert` must keep a number of a row as it stands, and look no further than whether it is whole.
    """
    remembered = lru_cache(maxsize=4096)(convert)

    @wraps(convert)
    def converted(latex: str) -> str:
        numbers = NUMBER.findall(latex)
        if not numbers or len(numbers) > len(HOLES) or SET_OTHERWISE.search(latex):
            return remembered(latex)
        holes = iter(HOLES)
        shape = NUMBER.sub(lambda number: ("." if "." in number[0] else "").join(2 * next(holes)), latex)
        return FILLED.sub(lambda hole: numbers[HOLES.index(hole[1])], remembered(shape))

    return converted
