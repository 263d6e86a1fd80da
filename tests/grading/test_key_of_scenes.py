"""Answers that come from a scene: their errors are absolute, in SI, and hold against quadratures in 50 digits of the exact numbers."""

import mpmath as mp
import pytest

import corollary
from corollary.api import variant
from corollary.grading.key_record import key_record

CASES = [
    {},
    {"k": "1e300", "v0": "-1e-100"},
    {"k": "1e-300", "v0": "-1e100"},
    {"m": "3e-7", "k": "1.7e3", "v0": "-0.3"},
    {"k": "1e30", "v0": "0", "y0": "0.02000000000001"},
    {
        "m": "0.125",
        "k": "1e6",
        "v0": "-2.5",
        "y0": "0.03125",
        "R": "0.015625",
        "g": "9.5",
    },  # doubles, all of them
]


def contact(m, k, v, g):
    """Largest overlap, its force and the duration of a contact with k overlap^1.5 and weight, entered at v."""
    p = mp.mpf("2.5")

    def square(x):
        return v**2 + 2 * g * x - 2 * k * x**p / (p * m)

    # Newton's method from above, where the energy falls ever faster.
    top = 2 * max((p * m * v**2 / (2 * k)) ** (1 / p), (p * m * g / k) ** (mp.mpf(2) / 3))
    for _ in range(300):
        top -= square(top) / (2 * g - 2 * k * top ** (p - 1) / m)
    slope = 2 * k * top ** (p - 1) / m - 2 * g

    def pace(y):  # in units of top / v: mpmath's quadrature takes what is small for nothing
        return (
            v
            / top
            * (2 * top * y / mp.sqrt(square(top * (1 - y * y))) if y > 1e-12 else 2 * mp.sqrt(top / slope))
        )

    return top, k * top ** mp.mpf("1.5"), 2 * top / v * mp.quad(pace, [0, 0.01, 0.3, 0.6, 0.9, 0.99, 1])


@pytest.mark.parametrize("given", CASES)
def test_the_ball_on_the_floor_is_within_the_error_of_its_key(given):
    mp.mp.dps = 60
    solution = corollary.solve(corollary.load_bank()["E12.3.1s"])
    chosen = variant(solution.problem, given)
    numbers = {name: mp.mpf(x.ratio.numerator) / x.ratio.denominator for name, x in chosen.exact.items()}
    m, k, g, r, y0, v0 = (numbers[name] for name in ("m", "k", "g", "R", "y0", "v0"))
    top, force, lasts = contact(m, k, mp.sqrt(v0**2 + 2 * g * (y0 - r)), g)
    parts = key_record(solution, chosen)["parts"]
    for part, true in (("c", top), ("d", force - m * g), ("e", lasts)):
        entry = parts[part]
        assert not entry["certified"]
        assert abs(entry["value"] - true) <= 1.2 * entry["error"], part
        assert entry["error"] <= 1e-13 * abs(true), part
