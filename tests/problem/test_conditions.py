"""Conditions with units: what 600 means is said, and what cannot be compared is not."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest

from corollary.formula.ball import RationalPi, holds
from corollary.problem.conditions import relations
from corollary.units.unit import unit

UNITS = {
    name: unit(text)
    for name, text in {
        "m": "g", "M": "kg", "F": "N", "v": "m/s", "vB": "m/s", "theta": "deg", "T": "°C", "r": "1", "t": "s", "k": "N/m",
    }.items()
}  # fmt: skip


def kept(text, **values):
    """Whether a condition holds for values in SI (an angle in shares of pi)."""
    at = {name: RationalPi(Fraction(value), int(name == "theta")) for name, value in values.items()}
    return all(holds(relation, at) for relation, _text in relations(text, UNITS))


@pytest.mark.parametrize(
    ("condition", "good", "bad"),
    [
        ("m <= 600 g", {"m": "0.6"}, {"m": "0.601"}),
        ("m <= 0.6 kg", {"m": "0.6"}, {"m": "0.601"}),
        ("0 < F < 2 kN", {"F": 1999}, {"F": 2000}),
        ("2 N >= F >= 1 N", {"F": 1}, {"F": "0.9"}),
        ("theta < 90 deg", {"theta": "0.49"}, {"theta": "0.5"}),
        ("theta <= 90°", {"theta": "0.5"}, {"theta": "0.51"}),
        ("theta <= pi/2", {"theta": "0.5"}, {"theta": "0.51"}),
        ("abs(vB) >= 0.4 m/s", {"vB": "-0.4"}, {"vB": "0.39"}),
        ("abs(vB) >= 1.44 km/h", {"vB": "-0.4"}, {"vB": "0.39"}),
        ("T > 20 °C", {"T": 294}, {"T": 293}),
        ("T - 20 °C > 10 K", {"T": "303.2"}, {"T": 303}),
        ("abs(T - 20 °C) < 3 Δ°C", {"T": 296}, {"T": "296.2"}),
        ("25 N/(m kg)*m < k", {"m": 1, "k": 26}, {"m": 1, "k": 25}),
        ("m*v <= 5 kN*t", {"m": 1, "v": 5000, "t": 1}, {"m": 1, "v": 5001, "t": 1}),
        ("m*v^2 <= 850 kg m^2/s^2", {"m": 1, "v": 29}, {"m": 1, "v": 30}),
        ("0 <= r <= 1", {"r": 1}, {"r": "1.01"}),
    ],
)  # fmt: skip
def test_a_number_carries_its_unit(condition, good, bad):
    assert kept(condition, **good)
    assert not kept(condition, **bad)


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("m <= 600", "write 600 kg (or in another unit)"),
        ("F > 1.5", "write 1.5 N (or in another unit)"),
        ("v > m", "v (m/s) and m (kg) cannot be compared"),
        ("v + 3 < vB", "v (m/s) and 3 (a plain number) cannot be added"),
        (
            "T - 2*r*T/r > 30 °C",
            "a number in °C is a temperature, and here a difference belongs: write it in K, or in Δ°C",
        ),
        ("30 °C < abs(T - 20 °C)", "here a difference belongs"),
        ("T + 5 °C < 40 °C", "here a difference belongs"),
        ("theta < 90", "theta is an angle; write 90 deg, or 90 rad"),
        ("abs(2*theta - 10 deg) > 5", "theta is an angle; write 5 deg, or 5 rad"),
        ("v < 3 m/t", "t may be the unit or the given: write (3 …)/t, or 3 …/(t)"),
        ("v < 3 furlongs", "furlongs is not a unit known here"),
        ("0 < F > 1 N", "a chain has all its signs one way"),
        ("0 != F != 1 N", "a chain has all its signs one way"),
        ("2*m", "it is not a comparison"),
        ("q > 3 kg", "q is not among the givens"),
        ("2 kg > 1 kg", "it contains none of the givens"),
    ],
)
def test_what_cannot_be_compared_is_said_with_the_remedy(condition, words):
    with pytest.raises(ValueError, match=re.escape(words)):
        relations(condition, UNITS)


def test_each_link_of_a_chain_has_its_own_text():
    assert [text for _relation, text in relations("0 < F < 2 kN", UNITS)] == ["0 < F", "F < 2 kN"]
