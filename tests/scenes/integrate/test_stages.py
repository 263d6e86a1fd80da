"""The step controller: it finds the step that just keeps the tolerance, with a margin, and is not thrown by what is no number."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.scenes.integrate.stages import factor


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
