"""Exact motion under simple forces: each obeys its own equation of motion."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.scenes.models.flow import Mover, faded_time, stopping, under_dashpot, under_force, under_spring

sizes = st.floats(0.1, 10.0)
velocities = st.floats(-10.0, 10.0)


@given(velocities, velocities, sizes, sizes, sizes, sizes)
def test_two_times_in_turn_are_one(x, v, m, k, t, s):
    start = Mover(x, v)
    twice, once = under_spring(under_spring(start, m, k, t), m, k, s), under_spring(start, m, k, t + s)
    scale = abs(x) + abs(v) * math.sqrt(m / k) + 1e-12
    # The angle w t is up to 200; its rounding is that many ulps.
    assert twice.x == pytest.approx(once.x, abs=1e-13 * scale)
    twice, once = under_force(under_force(start, m, k, t), m, k, s), under_force(start, m, k, t + s)
    assert twice.x == pytest.approx(once.x, rel=1e-12, abs=1e-9)


@given(velocities, velocities, sizes, sizes, sizes, sizes)
def test_a_dashpot_keeps_momentum_and_only_takes_energy(u, v, ma, mb, c, t):
    a, b = under_dashpot(Mover(0.0, u), Mover(1.0, v), ma, mb, c, t)
    assert ma * a.v + mb * b.v == pytest.approx(ma * u + mb * v, abs=1e-12)
    assert ma * a.v**2 + mb * b.v**2 <= ma * u**2 + mb * v**2 + 1e-10
    assert ma * (a.x - 0.0) + mb * (b.x - 1.0) == pytest.approx((ma * u + mb * v) * t, abs=1e-10)


def test_after_the_faded_time_nothing_is_left():
    a, b = under_dashpot(Mover(0.0, 5.0), Mover(0.0, 0.0), 1.0, 3.0, 2.0, faded_time(1.0, 3.0, 2.0))
    assert abs(a.v - b.v) < 1e-15
    assert a.x - b.x == pytest.approx(5.0 * 0.75 / 2.0, rel=1e-14)


@given(st.floats(0.1, 100.0), sizes, sizes)
def test_stopping_takes_the_energy_as_work(v, m, force):
    end, t = stopping(Mover(0.0, v), m, force)
    assert force * end.x == pytest.approx(0.5 * m * v * v, rel=1e-12)
    assert t == pytest.approx(m * v / force)
