"""Two spheres without damping: every value within its bound of the integrals it stands for in 60 digits, grazing hits included."""

import math

import mpmath as mp
import pytest

from corollary.derive.ready_scenes import run

REACH = 0.04
CASES = [
    # share of the reach by which they miss head-on, exponent, stiffness, masses, speed
    (0.5, 1.5, 2e4, 0.1, 0.1, 1.0),
    (0.5, 1.0, 2e4, 0.1, 1e9, 1.0),
    (0.999, 1.5, 2e4, 0.1, 0.1, 1.0),
    (1.0 - 1e-6, 1.5, 2e4, 0.1, 0.3, 1.0),
    (1.0 - 1e-10, 1.0, 2e4, 0.1, 0.1, 1.0),
    (0.9995, 3.0, 1e9, 1e-6, 0.1, 1.0),
    (1e-12, 1.5, 2e14, 1e20, 0.1, 1e3),
    (0.3, 2.3, 2e5, 0.1, 0.1, 1.0),
]


def integrals(share, q, k, ma, mb, v, depth):
    """Velocities, impulse, duration and largest overlap of B at rest hit by A with the speed v; the integrals are smooth in y."""
    mp.mp.dps = 60
    d, k, ma, mb, v, p = 2 * mp.mpf(0.5 * REACH), mp.mpf(k), mp.mpf(ma), mp.mpf(mb), mp.mpf(v), mp.mpf(q) + 1
    mu, spin = ma * mb / (ma + mb), v * mp.mpf(share * REACH)
    root = mp.sqrt((d * v) ** 2 - spin**2)
    inward, stiff = root / d, 2 * k / (p * mu)

    def square(x):
        return inward**2 - stiff * x**p - spin**2 * (1 / (d - x) ** 2 - 1 / d**2)

    top = mp.findroot(square, mp.mpf(depth))
    slope = stiff * p * top ** (p - 1) + 2 * spin**2 / (d - top) ** 3

    def pace(y):
        return (
            2 * top * y / mp.sqrt(square(top * (1 - y * y)))
            if y > mp.mpf(10) ** -15
            else 2 * mp.sqrt(top / slope)
        )

    pieces = [0, 0.3, 0.6, 0.8, 0.9, 0.97, 1]
    lasts = 2 * mp.quad(pace, pieces)
    turned = 2 * mp.quad(lambda y: pace(y) * spin / (d - top * (1 - y * y)) ** 2, pieces)
    # B seen from A comes with (-v, 0).
    angle = mp.atan2(spin / v, root / v) + turned
    across = spin / d
    change = (
        inward * mp.cos(angle) - across * mp.sin(angle) + v,
        inward * mp.sin(angle) + across * mp.cos(angle),
    )
    jx, jy = (mu * c for c in change)
    return {
        "velocities": (v - jx / ma, -jy / ma, jx / mb, jy / mb),
        "impulse": (jx, jy),
        "duration": (lasts,),
        "largest_overlap": (top,),
    }


@pytest.mark.parametrize(("share", "q", "k", "ma", "mb", "v"), CASES)
def test_every_value_is_within_its_bound_of_60_digits(share, q, k, ma, mb, v):
    settings = {
        "mA": ma,
        "mB": mb,
        "R": 0.5 * REACH,
        "k": k,
        "q": q,
        "eta": 0.0,
        "dx": 3 * REACH,
        "dy": share * REACH,
    }
    found = run("spheres", settings | {"vA": (v, 0.0), "vB": (0.0, 0.0)})
    assert found.outcome == "released"
    assert found.error_is == "bound"
    true = integrals(share, q, k, ma, mb, v, found.observed["largest_overlap"])
    for name, exact in true.items():
        value, error = found.observed[name], found.errors[name]
        values, errors = (x if isinstance(x, tuple) else (x,) for x in (value, error))
        for x, e, y in zip(values, errors, exact, strict=True):
            assert abs(mp.mpf(x) - y) <= e * (1 + 1e-6) + 1e-40, name
            assert e <= 2.3e-16 * abs(y), name


def test_it_is_told_exactly_whether_they_touch():
    near = {"eta": 0.0, "dx": 0.08, "vA": (1.0, 0.0)}
    assert run("spheres", near | {"dy": 0.04}).outcome == "missed"
    assert run("spheres", near | {"dy": math.nextafter(0.04, 0.0)}).outcome == "released"
    assert run("spheres", near | {"dy": math.nextafter(0.04, 1.0)}).outcome == "missed"
