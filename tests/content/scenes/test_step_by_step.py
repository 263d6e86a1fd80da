"""The chapter's other scenes against the formulas they should lead to, each within the error it claims."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.derive.ready_scenes import run

masses, speeds = st.floats(0.1, 10.0), st.floats(0.5, 10.0)


@given(masses, masses, speeds, st.floats(-10.0, 0.4), st.floats(0.05, 0.99))
@settings(max_examples=15, deadline=None)
def test_two_blocks_leave_with_the_restitution_of_their_dashpot(ma, mb, va, vb, r):
    found = run("two_blocks", {"mA": ma, "mB": mb, "vA": va, "vB": vb, "r": r})
    a, b = found.observed["velocities"]
    assert (b - a) / (va - vb) == pytest.approx(r, abs=1e-10)
    assert ma * a + mb * b == pytest.approx(ma * va + mb * vb, abs=1e-11)
    assert found.observed["impulse"] == pytest.approx(mb * (b - vb), rel=1e-12)


def test_two_blocks_at_the_ends_of_restitution():
    stuck = run("two_blocks", {"r": 0.0})
    assert stuck.outcome == "sticks"
    assert stuck.observed["velocities"] == pytest.approx((1.4, 1.4), rel=1e-14)
    assert run("two_blocks", {"r": 1.0}).observed["energy_ratio"] == pytest.approx(1.0, rel=1e-14)


@given(masses, st.floats(0.01, 0.3))
@settings(max_examples=10, deadline=None)
def test_a_super_ball_with_a_gap_is_two_collisions(ma, part):
    mb = part * ma
    found = run("super_ball", {"mA": ma, "mB": mb})
    v = math.sqrt(2 * 9.8)
    wanted = (v * (ma - 3 * mb) / (ma + mb), v * (3 * ma - mb) / (ma + mb))
    for seen, formula in zip(found.observed["velocities"], wanted, strict=True):
        assert abs(seen - formula) < (found.relative_error("velocities") + 1e-6) * v


def test_without_a_gap_the_super_ball_is_something_else():
    with_gap, without = (run("super_ball", {"gap": gap}).observed["velocities"][1] for gap in (0.001, 0.0))
    assert abs(with_gap - without) > 0.5


@given(st.floats(0.1, 5.0), st.floats(0.1, 0.99), st.integers(1, 8))
def test_a_bouncing_ball_loses_r_squared_of_its_height_each_time(h0, r, n):
    found = run("bouncing_ball", {"h0": h0, "r": r, "n": n}).observed
    assert found["heights"] == pytest.approx([h0 * r ** (2 * i) for i in range(1, n + 1)], rel=1e-12)
    fall = math.sqrt(2 * h0 / 9.8)
    assert found["duration"] == pytest.approx(fall * (1 + 2 * sum(r**i for i in range(1, n))), rel=1e-12)
    assert found["duration"] < found["rests_after"]


def test_pendulum_and_block_of_the_exercise():
    found = run("pendulum_block", {"m": 1.0, "M": 2.0, "L": 1.0}).observed
    v = math.sqrt(2 * 9.8)
    assert found["speed_before"] == pytest.approx(v, rel=1e-14)
    assert found["velocities"] == pytest.approx((-v / 3, 2 * v / 3), rel=1e-13)
    assert found["height"] == pytest.approx(1.0 / 9.0, rel=1e-13)


def test_a_ballistic_pendulum_rises_as_high_as_its_momentum_says():
    found = run("ballistic_pendulum", {"mA": 0.01, "mB": 1.0, "v": 245.0, "dt": 1e-8}).observed
    common = 2.45 / 1.01
    assert found["height"] == pytest.approx(common**2 / 19.6, rel=1e-13)
    assert 1.0 - math.cos(found["angle"]) == pytest.approx(found["height"], rel=1e-13)
    assert found["energy_change"] == pytest.approx(0.5 * 1.01 * common**2 - 0.005 * 245**2, rel=1e-13)


@pytest.mark.parametrize("u", [-3.0, 0.0, 1.0, 4.0])
def test_a_railway_car_needs_the_force_that_brings_the_sand_to_speed(u):
    found = run("railway_car", {"ux": u}).observed
    assert found["mean_force"] == pytest.approx(50.0 * (4.0 - u), rel=1e-12, abs=1e-9)
    # Half the relative speed squared is lost for every kilogram, whoever looks.
    assert found["energy_lost"] == pytest.approx(0.5 * 1500.0 * (4.0 - u) ** 2, rel=1e-10, abs=1e-6)


def test_ions_turn_where_their_energy_is_potential():
    found = run("ions", {}).observed
    mu = 0.06
    assert 0.0012 / found["turning_points"][0] == pytest.approx(0.5 * mu + 0.0012 / 0.08, rel=1e-14)
    sideways = run("ions", {"s": 0.02}).observed["turning_points"][0]
    energy = 0.5 * mu * (0.02 / sideways) ** 2 + 0.0012 / sideways
    assert energy == pytest.approx(0.5 * mu + 0.0012 / 0.08, rel=1e-14)
    assert sideways > found["turning_points"][0]
