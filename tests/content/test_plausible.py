"""Numbers that could be: what a student's variant implies, held against the world, over 500 variants of each problem concerned."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import pytest

from corollary.problem.bank import chapter_bank, find
from corollary.problem.sampling import draws

BANK = chapter_bank()
OSMIUM = 22_590.0  # kg/m^3, the densest element
Numbers = Mapping[str, float]


def density(mass: str, radius: str, share: float = 1.0) -> Callable[[Numbers], float]:
    return lambda n: n[mass] / (4 / 3 * math.pi * (share * n[radius]) ** 3)


def fall(n: Numbers) -> float:
    return math.sqrt(2 * n["g"] * n["h"])


# The problem, what is looked at, and between what it must lie; each formula is the textbook's.
WORLD: tuple[tuple[str, str, Callable[[Numbers], float], float, float], ...] = (
    ("E12.3.1s", "density of the ball", density("m", "R"), 30, 0.6 * OSMIUM),
    ("S12.6", "density of A", density("mA", "R"), 30, 0.6 * OSMIUM),
    ("S12.6", "density of B", density("mB", "R"), 30, 0.6 * OSMIUM),
    ("S12.5nc", "density of A", density("mA", "D", 0.5), 30, 0.6 * OSMIUM),
    ("S12.5nc", "density of B", density("mB", "D", 0.5), 30, 0.6 * OSMIUM),
    ("X12.4", "speed of the bike", lambda n: n["M"] * n["V"] / n["mb"], 5, 170),
    ("S12.5r", "height of the last bounce", lambda n: n["h0"] * n["r"] ** (2 * n["n"]), 0.01, 5),
    (
        "E12.5.1",
        "speed of the bullet",
        lambda n: (n["mA"] + n["mB"]) / n["mA"] * math.sqrt(2 * n["g"] * n["h"]),
        40,
        1200,
    ),
    (
        "X12.10",
        "speed of the bullet",
        lambda n: (n["m"] + n["M"]) / n["m"] * math.sqrt(2 * n["mu"] * n["g"] * n["d"]),
        10,
        1200,
    ),
    ("E12.3.2", "mass of the tennis ball", lambda n: n["m"], 0.03, 0.1),
    ("E12.3.2", "force on the racket", lambda n: n["m"] * (n["v0"] + n["v1"]) / n["dt"], 50, 6000),
    ("T12.3", "weights on the legs", lambda n: fall(n) / n["dt"] / n["g"], 0.5, 25),
    ("T12.3", "weights over the distance", lambda n: n["h"] / n["s"], 0.5, 25),
    ("X12.8", "energy of the throw", lambda n: n["m"] * n["v"] ** 2 / 2, 5, 450),
    ("X12.9", "height of the book", lambda n: math.sqrt(3 * n["I"] / n["M"]), 0.1, 0.6),
    ("X12.9", "height hit, of that", lambda n: n["h"] / math.sqrt(3 * n["I"] / n["M"]), 0, 1),
    (
        "X12.12",
        "height of the sphere",
        lambda n: ((n["M"] - n["m"]) / (n["M"] + n["m"])) ** 2 * n["L"],
        0.005,
        3,
    ),
    (
        "P12.15",
        "excess over the circle",
        lambda n: 2 * n["m"] * n["v1"] ** 2 / (n["k"] * n["b"]),
        0.004,
        0.33,
    ),
    ("P12.14", "lowest height", lambda n: n["h0"] / 4, 0.005, 1),
)


@pytest.mark.parametrize(
    ("code", "what", "formula", "least", "most"), WORLD, ids=[f"{c} {w}" for c, w, *_ in WORLD]
)
def test_the_numbers_of_students_could_be(code, what, formula, least, most):
    problem = find(BANK, code)
    found = [formula(next(draws(problem, b"plausible", f"student {n}")).si) for n in range(500)]
    assert least <= min(found)
    assert max(found) <= most
