"""A drop that takes up vapour: its momentum is that of the start, of the vapour, and the impulse of a growing weight."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.derive.ready_scenes import run
from corollary.scenes.run import components


@given(
    st.floats(0.1, 10.0), st.floats(0.0, 12.0), st.floats(0.0, 5.0), st.floats(-3.0, 3.0), st.floats(0.1, 5.0)
)
@settings(max_examples=25, deadline=None)
def test_its_momentum_is_what_it_had_and_what_came(m, v, rate, u, t):
    found = run("growing_drop", {"m": m, "v": v, "R": rate, "u": u, "t": t}).observed
    momentum = m * v + rate * t * u + 9.8 * (m * t + 0.5 * rate * t * t)
    assert found["mass"] * found["velocities"][0] == pytest.approx(momentum, rel=1e-11, abs=1e-11)


def test_a_drop_that_does_not_grow_falls_freely_and_one_from_next_to_nothing_half_as_fast():
    assert run("growing_drop", {"R": 0.0}).observed["velocities"][0] == pytest.approx(
        6.0 + 9.8 * 1.5, rel=1e-14
    )
    mist = run("growing_drop", {"m": 1e-9, "v": 0.0, "R": 1.0, "t": 2.0})
    assert mist.observed["velocities"][0] == pytest.approx(9.8, rel=1e-8)
    assert mist.observed["way"] == pytest.approx(9.8, rel=1e-8)


def test_its_way_is_the_integral_of_its_velocity():
    """Without weight v = m v0/(m + R t), and the way is (m v0/R) ln(1 + R t/m)."""
    found = run("growing_drop", {"g": 0.0, "R": 1.3, "t": 4.0}).observed
    assert found["velocities"][0] == pytest.approx(2.0 * 6.0 / 7.2, rel=1e-13)
    assert found["way"] == pytest.approx(12.0 / 1.3 * math.log(1.0 + 1.3 * 4.0 / 2.0), rel=1e-12)


@pytest.mark.parametrize("t", [1e3, 1e6, 1e9, 1e12])
def test_a_drop_that_falls_for_ages_is_known_to_a_part_of_what_it_has_become(t):
    """It ends far faster than it began: half as fast as in free fall, and the start is soon forgotten."""
    found = run("growing_drop", {"t": t})
    momentum = 2.0 * 6.0 + 9.8 * (2.0 * t + 0.5 * 0.4 * t * t)
    assert found.observed["velocities"][0] == pytest.approx(
        momentum / (2.0 + 0.4 * t), rel=1e-12 + found.error
    )
    assert found.evaluations < 10_000


@pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-12])
def test_in_steps_it_is_as_far_off_as_it_says_where_it_comes_back_to_its_start(tolerance):
    """Blown up by the vapour until its way is a tenth of a thousandth of what it went."""
    there = {"m": 0.0248358, "t": 0.0691914, "v": 24.35, "u": -0.927888, "R": 64.4414, "g": 9.8}
    known, found = run("growing_drop", there), run("growing_drop", there, tolerance, second_way=True)
    for name in ("velocities", "way"):
        (true,), (value,), (error,) = (
            components(x) for x in (known.observed[name], found.observed[name], found.measured[name].error)
        )
        assert abs(value - true) <= error
