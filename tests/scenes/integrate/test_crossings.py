"""Reading between samples beats counting them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.scenes.integrate.crossings import crossings, time_beyond


@given(st.floats(0.05, 0.95), st.integers(20, 200))
def test_a_sine_is_below_zero_for_half_its_period(phase, n):
    times = [2.0 * math.pi * i / n for i in range(n + 1)]
    values = [math.sin(t + phase) for t in times]
    dt = times[1]
    # A straight line instead of the sine moves a crossing by at most sin(crossing) dt^2 / 8 over the slope, twice.
    assert time_beyond(times, values) == pytest.approx(math.pi, abs=0.6 * dt**2)
    assert crossings(times, values)[0] == pytest.approx(math.pi - phase, abs=0.3 * dt**2)


def test_counting_samples_is_far_worse():
    n = 101
    times = [2.0 * math.pi * i / n for i in range(n + 1)]
    values = [math.sin(t + 0.31) for t in times]
    counted = sum(v < 0.0 for v in values) * times[1]
    assert abs(time_beyond(times, values) - math.pi) < 0.05 * abs(counted - math.pi) < 0.05 * times[1]


def test_a_sample_on_the_level_is_one_crossing():
    assert crossings([0, 1, 2], [-1.0, 0.0, 1.0]) == [1.0]
    assert crossings([0, 1], [1.0, 2.0]) == []
    assert time_beyond([0.0, 1.0, 2.0], [-1.0, -1.0, 1.0]) == 1.5
