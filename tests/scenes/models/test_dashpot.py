"""A spring with a dashpot in closed form, against the same contact in steps and against its own equation."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import regularised
from corollary.scenes.models.dashpot import damped_spring
from corollary.scenes.row import RowOfBodies

sizes = st.floats(1e-3, 1e3)


@pytest.mark.parametrize("share", [0.01, 0.2, 0.45, 0.5, 0.55, 0.8, 0.95, 1.02, 1.3, 4.0])
def test_steps_find_the_same(share):
    m, k, v = 0.1, 2000.0, 3.0
    eta = 2.0 * share * math.sqrt(k * m)
    found = damped_spring(m, k, eta, v)
    stepped = regularised.collide(
        RowOfBodies((math.inf, m), (0.0, -v), (0.0,), (Contact(k, 1.0, eta),)), 1e-13
    )
    assert found.sticks == (stepped.outcome == "sticks") == (share >= 1.0)
    assert found.restitution * v == pytest.approx(stepped.velocities[1], abs=1e-9)
    assert found.overlap == pytest.approx(stepped.overlaps[0], rel=1e-10)
    assert found.force == pytest.approx(stepped.forces[0], rel=1e-9)
    if not found.sticks:
        assert found.duration == pytest.approx(stepped.duration, rel=1e-8)


@given(sizes, sizes, st.floats(1e-3, 0.999), sizes)
def test_restitution_does_not_depend_on_size_or_speed_and_energy_only_falls(m, k, share, v):
    eta = 2.0 * share * math.sqrt(k * m)
    found, one = damped_spring(m, k, eta, v), damped_spring(1.0, 1.0, 2.0 * share, 1.0)
    # The exponent grows near critical damping, and its rounding with it.
    assert found.restitution == pytest.approx(one.restitution, rel=1e-12 / (1.0 - share))
    assert found.duration == pytest.approx(one.duration * math.sqrt(m / k), rel=1e-12 / (1.0 - share))
    assert 0.0 <= found.restitution < 1.0
    assert 0.5 * k * found.overlap**2 < 0.5 * m * v * v
    assert found.force >= eta * v


@given(sizes, sizes, st.floats(1.0, 1e12), sizes)
def test_from_critical_damping_on_it_sticks_and_more_damping_stops_it_sooner(m, k, share, v):
    eta = 2.0 * share * math.sqrt(k * m)
    found, more = damped_spring(m, k, 1.001 * eta, v), damped_spring(m, k, 1.01 * eta, v)
    assert found.sticks
    assert found.restitution == 0.0
    assert 0.0 < more.overlap < found.overlap
    # The dashpot alone would stop it within m v / eta; the spring only shortens that way.
    assert found.overlap <= m * v / (1.001 * eta) * (1.0 + 1e-9)


def test_the_closed_form_passes_through_critical_damping_without_a_jump():
    below, at, above = (
        damped_spring(1.0, 1.0, 2.0 * share, 1.0) for share in (1.0 - 1e-12, 1.0, 1.0 + 1e-12)
    )
    assert at.overlap == pytest.approx(math.exp(-1.0), rel=1e-15)
    assert below.overlap == pytest.approx(at.overlap, rel=1e-10)
    assert above.overlap == pytest.approx(at.overlap, rel=1e-10)
