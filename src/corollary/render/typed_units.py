"""Units as they are typed, for an LMS that knows only those it is told of: names without blanks, and their sizes."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import combinations

from corollary.answers.unit_meant import unit_meant
from corollary.formula.errors import ParseError
from corollary.units.table import ENGLISH, UNITS
from corollary.units.unit import ONE, Unit, canonical, read_unit, show

COMMON = ("N kN mN J kJ mJ W kW kg g t C V A K m cm mm km s ms min h").split()  # fmt: skip  # noqa: SIM905
"""What products and quotients are made of, products in this order."""
TIMES = ("", "*", "·")
RAISED = (("^2", "²", "2"), ("^3", "³", "3"))
MANY = 60
LEAST, MOST = 1e-9, 1e9
"""Moodle keeps 19 decimals of a size."""


@cache
def typed_units(unit: Unit) -> list[tuple[str, float]]:
    """Each name with how many of it make one of the unit; the unit itself first. None for a plain number and a temperature.

    Only what our own reader reads as this quantity where the unit is asked for: no Hz for rad/s.
    """
    if not show(unit) or unit.offset:
        return []
    found: dict[str, float] = {}
    for text in _candidates(unit):
        name = text.replace(" ", "")
        meant = read_unit(text)
        if isinstance(meant, ParseError) or isinstance(unit_meant(name, unit), ParseError) or name in found:
            continue
        size = unit.si / meant.si
        if meant.dimension == unit.dimension and not meant.offset and LEAST <= size <= MOST:
            found[name] = size
    return list(found.items())[:MANY]


def _candidates(unit: Unit) -> Iterator[str]:
    for text in (show(unit), canonical(unit)):
        yield from _spelled(text)
    for name, each in UNITS.items():
        if each.dimension == unit.dimension and (name == each.text or name in ENGLISH):
            yield name
    if unit.dimension == ONE:
        return
    for one, other in combinations(COMMON, 2):
        a, b = UNITS[one].dimension, UNITS[other].dimension
        if a * b == unit.dimension:
            yield from _spelled(f"{one}*{other}")
        if a / b == unit.dimension:
            yield from _spelled(f"{one}/{other}")


def _spelled(text: str) -> Iterator[str]:
    """The ways to write a product or a power."""
    texts = [text.replace(" ", "*").replace("*", times) for times in TIMES]
    for power in RAISED:
        texts += [
            each.replace(sign, other)
            for each in texts
            for sign in power[:2]
            for other in power
            if sign in each
        ]
    yield from dict.fromkeys(texts)
