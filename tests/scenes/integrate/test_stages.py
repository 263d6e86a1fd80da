"""A step has an honest opinion about its error, and its controller finds the one that just keeps the tolerance."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.scenes.integrate.stages import NODES, STAGES, error_size, factor, finish, stage


@given(st.floats(-8.0, 8.0), st.floats(-6.0, 6.0))
def test_the_longest_step_that_keeps_the_tolerance_is_found_from_anywhere(start, longest):
    """The error of a method of order 8 is (h / longest)^8 tolerances; two dozen steps are enough from fourteen powers of ten away."""
    h, longest = 10.0**start, 10.0**longest
    for _ in range(24):
        h *= factor((h / longest) ** 8)
    assert 0.8 * longest < h < longest
    assert (h / longest) ** 8 < 1.0


def test_no_step_is_changed_beyond_what_an_error_can_say():
    assert factor(0.0) == factor(1e-300) <= 10.0
    assert factor(1e300) == factor(math.inf) == factor(math.nan) >= 0.1
    assert factor(1e300) < 0.5 < 2.0 < factor(0.0)


@pytest.mark.parametrize("size", [1.0, 1.01, 3.0, 1e3])
def test_a_rejected_step_is_tried_again_shorter(size):
    assert factor(size) < 1.0


def stepped(slope, y, h):
    """The state after a step, and the size of its error."""
    count = len(y)
    slopes, out = [slope(0.0, y), *([0.0] * count for _ in range(STAGES - 1))], [0.0] * count
    for i in range(1, STAGES):
        stage(i, h, y, slopes, out, 0, count)
        slopes[i] = slope(NODES[i] * h, out)
    fifth, third = finish(h, y, slopes, out, 0, count)
    return out, error_size(fifth, third, h, count)


def test_the_estimate_is_above_the_error_of_a_step_without_being_absurd():
    for h in (0.5, 1.0):
        after, size = stepped(lambda _, y: [y[1], -y[0]], [1.0, 0.0], h)
        error = math.hypot(after[0] - math.cos(h), after[1] + math.sin(h))
        assert error < size < 1e5 * error


def test_no_force_no_error():
    assert stepped(lambda _, y: [0.0], [3.0], 0.7) == ([3.0], 0.0)
