"""An orbit round a fixed centre: its energy and angular momentum at the turning points, and closed cases."""

import math
from typing import NamedTuple

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from corollary.formula.ball import precision_of
from corollary.scenes.models import central


def orbit(pull, r, along, across):
    """In doubles, with what is not there as infinite."""
    with precision_of(256):
        found = central.orbit(pull, 1.0, (r, 0.0), (along, across))
    return found and Orbit(
        *(math.inf if x is None else float(x) for x in (found.nearest, found.farthest, found.period))
    )


class Orbit(NamedTuple):
    nearest: float
    farthest: float
    period: float


sizes, speeds = st.floats(0.1, 10.0), st.floats(-3.0, 3.0)


@given(st.one_of(sizes, sizes.map(lambda pull: -pull)), sizes, speeds, speeds)
def test_energy_and_spin_at_the_turning_points_are_those_of_the_start(pull, r, along, across):
    assume(abs(across) > 1e-3)
    found = orbit(pull, r, along, across)
    assert found is not None
    energy = 0.5 * (along**2 + across**2) - pull / r
    assert found.nearest <= r * (1.0 + 1e-12)
    for turn in (found.nearest, found.farthest):
        if math.isfinite(turn):
            speed = r * across / turn
            size = 0.5 * speed**2 + abs(pull) / turn
            assert 0.5 * speed**2 - pull / turn == pytest.approx(energy, abs=1e-9 * (size + abs(pull) / r))
    assert math.isinf(found.farthest) == math.isinf(found.period) == (energy >= 0.0)


@given(sizes, sizes)
def test_a_circle_is_a_circle(pull, r):
    found = orbit(pull, r, 0.0, math.sqrt(pull / r))
    assert found is not None
    assert (found.nearest, found.farthest) == pytest.approx((r, r), rel=1e-13)
    assert found.period == pytest.approx(2.0 * math.pi * math.sqrt(r**3 / pull), rel=1e-13)


def test_no_orbit_through_the_centre_but_a_repulsion_turns_round():
    assert orbit(1.0, 1.0, -1.0, 0.0) is None
    found = orbit(-1.0, 1.0, -1.0, 0.0)
    assert found is not None
    assert found.nearest == pytest.approx(1.0 / 1.5, rel=1e-15)
    straight = orbit(0.0, 2.0, -3.0, 4.0)
    assert straight is not None
    assert straight.nearest == pytest.approx(2.0 * 4.0 / 5.0, rel=1e-15)
