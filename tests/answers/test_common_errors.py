"""The slips that everybody makes: each is found in numbers, and in formulas, under words that name it."""

from __future__ import annotations

import math

import pytest

from corollary.answers.common_errors import ratio_of_formulas, slips
from corollary.units.unit import unit


def told(values: tuple[float, ...], wrong: tuple[float, ...], of: str) -> list[str]:
    """What is said of wrong values where others are right."""
    return [sentence for slip, sentence in slips(values, unit(of)) if slip == pytest.approx(wrong, rel=1e-12)]


@pytest.mark.parametrize(
    ("right", "wrong", "of", "words"),
    [
        ((8.6,), (-8.6,), "N", "sign"),
        ((3.0, 4.0), (-3.0, -4.0), "N", "Every component"),
        ((3.0, 4.0), (3.0, -4.0), "N", "sign of one component"),
        ((3.0, 4.0), (4.0, 3.0), "N", "interchanged"),
        ((8.6,), (17.2,), "N", "constant factor"),
        ((8.6,), (4.3,), "N", "constant factor"),
        ((8.6,), (8600.0,), "N", "power of ten is off"),
        ((8.6,), (0.86,), "N", "power of ten is off"),
        ((20.0,), (72.0,), "m/s", "km/h and m/s"),
        ((math.pi / 2,), (90.0,), "1", "degrees where radians"),
    ],
)
def test_a_slip_in_numbers_is_named(right, wrong, of, words):
    (sentence,) = told(right, wrong, of)
    assert words in sentence


def test_what_measures_something_has_no_radians():
    assert not told((1.0,), (math.degrees(1.0),), "N")


def test_zero_slips_to_nothing():
    assert not [slip for slip, _sentence in slips((0.0,), unit("N"))]


@pytest.mark.parametrize(
    ("ratio", "words"),
    [
        (-1.0, "sign"),
        (2.0, "twice"),
        (-0.5, "sign and a constant factor"),
        (1000.0, "units"),
        (3.6, "km/h"),
        (180 / math.pi, "degrees"),
        (math.sqrt(2), "root"),
        (1.004, "rounded"),
        (1.7, ""),
        (10.0, ""),  # a formula has no power of ten to lose
    ],
)
def test_a_constant_ratio_of_formulas_is_named(ratio, words):
    found = ratio_of_formulas(ratio)
    assert words in found
    assert bool(words) == bool(found)


@pytest.mark.parametrize(
    ("of", "title", "directed"),
    [
        ("m/s", "Velocity of B", True),
        ("m/s", "", True),
        ("N", "Force on the car", True),
        ("kg*m/s", "Impulse", True),
        ("m/s^2", "Acceleration", True),
        ("N*m", "Torque", True),
        ("rad", "Angle", True),
        ("J", "Change of energy", False),
        ("kJ", "Work", False),
        ("kg", "Mass", False),
        ("s", "Time", False),
        ("1", "Ratio", False),
        ("%", "Share", False),
        ("W", "Power", False),
        ("K", "Temperature", False),
        ("Pa", "Pressure", False),
        ("C", "Charge", False),
        ("m/s", "Speed of B", False),
        ("m/s", "How fast?", False),
        ("N", "Magnitude of the force", False),
        ("m", "Distance", False),
        ("km/h", "Tempo nachher", False),
    ],
)
def test_a_sign_says_a_direction_only_of_what_has_one(of, title, directed):
    sentence = next(text for values, text in slips((8.6,), unit(of), title) if values == (-8.6,))
    assert ("direction" in sentence) == directed
    assert "sign is wrong" in sentence
