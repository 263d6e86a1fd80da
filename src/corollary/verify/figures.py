"""Printed numbers held against derived ones as people mean them: to their own figures, or by an order of magnitude."""

from __future__ import annotations

import math
from typing import Literal

from corollary.answers.quantity import Reading
from corollary.answers.tolerance import coarse, last_place
from corollary.units.unit import Unit

ABOUT = "~"  # before an order of magnitude
HALF_AN_ORDER = 0.5  # of the decimal logarithm: 4e2 is of the order of 10^3, 3e2 of 10^2
EXACTLY = 1e-9  # relative: what is printed without figures was worked out in doubles
Agreement = Literal["agrees", "last figure", "order", "differs"]


def as_printed(
    value: float, printed: str, read: Reading, unit: Unit, figures: int | None = None
) -> Agreement:
    """How a printed text, read as `read`, agrees with a value in SI; a bare number is in `unit`.

    "order": it is of another order of magnitude, which is all that the text says. `figures` are those the number has, where
    its text leaves open whether zeros count.
    """
    ratio, pi = read.si
    measured_in = read.unit or unit
    size, zero = measured_in.si, float(measured_in.offset)
    mine, theirs = value - zero, float(ratio) * math.pi**pi - zero
    if mine == theirs:
        return "agrees"
    if printed.startswith(ABOUT):
        near = mine * theirs > 0 and abs(math.log10(mine / theirs)) <= HALF_AN_ORDER
        return "agrees" if near else "order"
    if not (read.figures or figures):  # a fraction, a square root: exact
        return "agrees" if math.isclose(mine, theirs, rel_tol=EXACTLY) else "differs"
    counts = range(max(1, read.least), max(1, read.figures) + 1) if figures is None else (figures,)
    if any(coarse((theirs,), (count,), (mine,), (size,), (0.0,)) for count in counts):  # 110 has two or three
        return "agrees"
    most = read.figures if figures is None else figures
    if most and theirs and abs(mine - theirs) <= 1.5 * last_place(theirs, most, size):
        return "last figure"
    return "differs"
