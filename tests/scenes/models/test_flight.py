"""Between touches: the moment of the next one, in closed form."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.scenes.forces.contact import Contact
from corollary.scenes.models.flight import after_flight, first_touch, inactive
from corollary.scenes.row import RowOfBodies

SPHERE = Contact(1.0, 1.5)


@given(st.floats(1e-9, 1e9), st.floats(1e-6, 1e6))
def test_two_bodies_meet_when_the_gap_is_flown(gap, speed):
    line = RowOfBodies((1.0, 1.0), (speed, 0.0), (gap,), (SPHERE,))
    state = [0.0, -gap, speed, 0.0]
    meeting = first_touch(line, state, 0.0, bounced=False)
    assert meeting.after == pytest.approx(gap / speed, rel=1e-14)
    assert after_flight(line, state, meeting) == [meeting.after, 0.0, speed, 0.0]


@given(st.floats(1e-6, 1e3), st.floats(-30.0, 30.0), st.floats(0.1, 30.0))
def test_a_ball_over_a_floor_falls_onto_it(height, up, g):
    line = RowOfBodies((math.inf, 1.0), (0.0, up), (height,), (SPHERE,), weight=g)
    state = [0.0, -height, 0.0, up]
    meeting = first_touch(line, state, 0.0, bounced=False)
    t = meeting.after
    assert height + up * t - 0.5 * g * t * t == pytest.approx(
        0.0, abs=1e-12 * (height + abs(up) * t + g * t * t)
    )
    landed = after_flight(line, state, meeting)
    assert landed[3] ** 2 == pytest.approx(up**2 + 2 * g * height, rel=1e-9)
    assert landed[3] < 0.0


def test_after_a_bounce_falling_back_is_another_story():
    line = RowOfBodies((math.inf, 1.0), (0.0, 3.0), (0.0,), (SPHERE,), weight=9.8)
    assert first_touch(line, [0.0, -0.1, 0.0, 3.0], 1e-14, bounced=True) is None
    assert first_touch(line, [0.0, -0.1, 0.0, 3.0], 1e-14, bounced=False) is not None


def test_only_what_pushes_is_awake():
    line = RowOfBodies((1.0, 1.0), (0.0, 0.0), (0.0,), (SPHERE,))
    assert inactive(line, [0.0, 0.0, 0.0, 0.0], [True], 1e-14)
    assert inactive(line, [0.0, 0.0, 0.0, 1.0], [True], 1e-14)
    assert not inactive(line, [0.0, 0.0, 1.0, 0.0], [True], 1e-14)
    assert not inactive(line, [0.0, 0.1, 0.0, 1.0], [True], 1e-14)
