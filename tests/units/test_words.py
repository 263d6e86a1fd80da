"""Units as they are spoken and printed."""

from __future__ import annotations

import pytest

from corollary.formula.errors import ParseError
from corollary.units.unit import Unit, read_unit, unit


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("Newton seconds", "N*s"), ("newton-seconds", "N*s"), ("N-s", "N*s"), ("N.s", "N*s"), ("kg.m/s", "kg*m/s"), ("kg.m.s-1", "kg*m/s"),
        ("kilogram meters per second", "kg*m/s"), ("kg m per s", "kg*m/s"), ("Meter pro Sekunde", "m/s"), ("metres par seconde", "m/s"),
        ("[kg m/s]", "kg*m/s"), ("(kg m/s)", "kg*m/s"), ("kg(m/s)", "kg*m/s"), ("(kg m)/s", "kg*m/s"), ("J/(kg m)", "J/(kg*m)"),
        ("J / (kg m)", "J/(kg*m)"), ("kg km m / ( h s )", "kg*km*m/(h*s)"), ("J per (kg m)", "J/(kg*m)"), ("s ^ (1/2)", "s^0.5"),
        ("kmph", "km/h"), ("kilometers per hour", "km/h"), ("milliseconds", "ms"), ("Joules", "J"), ("m/(s)", "m/s"),
        ("meter per sekund", "m/s"), ("newton sekunder", "N*s"), ("millisekunder", "ms"), ("minutter", "min"), ("km per timer", "km/h"), ("radianer", "rad"),
    ],
)  # fmt: skip
def test_words_are_units(typed, meant):
    found = read_unit(typed)
    assert isinstance(found, Unit), found
    assert (found.dimension, found.factor) == (unit(meant).dimension, unit(meant).factor)


@pytest.mark.parametrize("typed", ["apples", "per", "N-", "J/kg m"])
def test_what_is_none_or_two(typed):
    assert isinstance(read_unit(typed), ParseError)
