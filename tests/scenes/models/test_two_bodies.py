"""Two bodies on a line: a spring with a dashpot against the same contact in steps, exact ratios, and both ends of the damping."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.derive.ready_scenes import run
from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import regularised
from corollary.scenes.models.certain import found
from corollary.scenes.models.two_bodies import collision
from corollary.scenes.row import RowOfBodies

sizes = st.floats(1e-3, 1e3)


def ball_on_wall(m, k, eta, v):
    return found(lambda: collision((math.inf, m), (0.0, -v), Contact(k, 1.0, eta)))


@pytest.mark.parametrize("share", [0.01, 0.2, 0.45, 0.5, 0.55, 0.8, 0.95, 1.02, 1.3, 4.0])
def test_steps_find_the_same(share):
    m, k, v = 0.1, 2000.0, 3.0
    eta = 2.0 * share * math.sqrt(k * m)
    closed = ball_on_wall(m, k, eta, v)
    stepped = regularised.collide(
        RowOfBodies((math.inf, m), (0.0, -v), (0.0,), (Contact(k, 1.0, eta),)), 1e-13
    )
    assert (closed.outcome == "sticks") == (stepped.outcome == "sticks") == (share >= 1.0)
    assert closed.observed["velocities"][1] == pytest.approx(stepped.velocities[1], abs=1e-9)
    assert closed.observed["largest_overlap"] == pytest.approx(stepped.overlaps[0], rel=1e-10)
    assert closed.observed["peak_force"] == pytest.approx(stepped.forces[0], rel=1e-9)
    assert ("duration" in closed.observed) == (share < 1.0)
    if share < 1.0:
        assert closed.observed["duration"] == pytest.approx(stepped.duration, rel=1e-8)


@given(sizes, sizes, st.floats(1e-3, 0.999), sizes)
def test_restitution_does_not_depend_on_size_or_speed_and_energy_only_falls(m, k, share, v):
    hit, one = (
        ball_on_wall(*at).observed
        for at in ((m, k, 2.0 * share * math.sqrt(k * m), v), (1.0, 1.0, 2.0 * share, 1.0))
    )
    # The exponent grows near critical damping, and what rounding makes of eta with it.
    assert hit["velocities"][1] / v == pytest.approx(one["velocities"][1], rel=1e-12 / (1.0 - share))
    assert hit["duration"] == pytest.approx(one["duration"] * math.sqrt(m / k), rel=1e-12 / (1.0 - share))
    assert 0.5 * k * hit["largest_overlap"] ** 2 < 0.5 * m * v * v


@pytest.mark.parametrize(("m", "k", "eta"), [(1.0, 1.0, 2.0), (3.0, 12.0, 12.0), (0.25, 1e4, 100.0)])
def test_critical_damping_is_told_exactly(m, k, eta):
    at = ball_on_wall(m, k, eta, 1.0)
    assert at.outcome == "sticks"
    assert at.observed["largest_overlap"] == pytest.approx(math.exp(-1.0) * math.sqrt(m / k), rel=1e-15)
    below = ball_on_wall(m, k, math.nextafter(eta, 0.0), 1.0)
    assert below.outcome == "released"
    assert below.observed["duration"] > 1e7 * math.sqrt(m / k)


@given(*[st.floats(1e-9, 1e25)] * 2, st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(0.0, 1.0))
def test_two_blocks_of_any_masses_against_exact_fractions(ma, mb, va, vb, r):
    seen = run("two_blocks", {"mA": ma, "mB": mb, "vA": va, "vB": vb, "r": r})
    a, b, u, v, back = map(Fraction, (ma, mb, va, vb, r))
    impulse = (1 + back) * max(u - v, 0) * a * b / (a + b)
    before = a * u * u + b * v * v
    true = {
        "velocities": (u - impulse / a, v + impulse / b),
        "impulse": impulse,
        "energy_ratio": (a * (u - impulse / a) ** 2 + b * (v + impulse / b) ** 2) / before if before else 1,
    }
    for name, value in true.items():
        each = seen.measured[name]
        assert each.error_is == "bound"
        for x, error, exact in zip(
            *(y if isinstance(y, tuple) else (y,) for y in (each.value, each.error, value)), strict=True
        ):
            assert abs(Fraction(x) - exact) <= Fraction(error), name
            assert error <= 2.3e-16 * abs(x) + 5e-324, name


def test_a_light_block_against_the_earth():
    """Impulse mA (1 + r) (vA - vB): to a body of 6e24 kg the difference of velocities would have lost it."""
    seen = run("two_blocks", {"mA": 0.05, "mB": 6e24})
    exact = Fraction(0.05) * Fraction(6e24) / (Fraction(0.05) + Fraction(6e24)) * (1 + Fraction(0.6)) * 6
    assert seen.observed["impulse"] == pytest.approx(0.48, rel=1e-15)
    assert abs(Fraction(seen.observed["impulse"]) - exact) <= Fraction(seen.errors["impulse"])


@given(st.floats(1e-12, 1e12), st.floats(1e-12, 1e12), st.floats(1e-6, 1e6))
def test_a_bullet_in_a_block_of_any_mass_against_exact_fractions(m, block, v):
    seen = run("bullet_block", {"m": m, "M": block, "v": v})
    a, b, u, mu, g = map(Fraction, (m, block, v, 0.5, 9.8))
    true = {
        "energy_change": -a * b * u * u / (2 * (a + b)),
        "distance": (a * u / (a + b)) ** 2 / (2 * mu * g),
        "duration": a * u / (a + b) / (mu * g),
    }
    for name, exact in true.items():
        assert (
            abs(Fraction(seen.observed[name]) - exact)
            <= Fraction(seen.errors[name])
            <= abs(exact) * Fraction(1, 4 * 10**15)
        )
