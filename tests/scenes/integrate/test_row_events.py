"""Between touches: the moment of the next one, in closed form."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.regularised import state_of
from corollary.scenes.integrate.row_events import (
    TIME,
    active_part,
    first_touch,
    fly,
    inactive,
)
from corollary.scenes.row import RowOfBodies

SPHERE = Contact(1.0, 1.5)


@given(st.floats(1e-9, 1e9), st.floats(1e-6, 1e6))
def test_two_bodies_meet_when_the_gap_is_flown(gap, speed):
    line = RowOfBodies((1.0, 1.0), (speed, 0.0), (gap,), (SPHERE,))
    y, touching, (_, falls, *_) = state_of(line)
    contact, wait = first_touch(y, falls, 0.0, False)
    assert (contact, wait) == (0, pytest.approx(gap / speed, rel=1e-14))
    fly(y, touching, falls, contact, wait)
    assert (y, touching) == ([speed, 0.0, 0.0], [True])


@given(st.floats(1e-6, 1e3), st.floats(-30.0, 30.0), st.floats(0.1, 30.0))
def test_a_ball_over_a_floor_falls_onto_it(height, up, g):
    line = RowOfBodies((math.inf, 1.0), (0.0, up), (height,), (SPHERE,), weight=g)
    y, touching, (_, falls, *_) = state_of(line)
    contact, t = first_touch(y, falls, 0.0, False)
    assert height + up * t - 0.5 * g * t * t == pytest.approx(
        0.0, abs=1e-12 * (height + abs(up) * t + g * t * t)
    )
    fly(y, touching, falls, contact, t)
    assert y[2] ** 2 == pytest.approx(up**2 + 2 * g * height, rel=1e-9)
    assert y[2] < 0.0


def test_after_a_bounce_falling_back_is_another_story():
    line = RowOfBodies((math.inf, 1.0), (0.0, 3.0), (0.0,), (SPHERE,), weight=9.8)
    _, _, (_, falls, *_) = state_of(line)
    assert first_touch([0.0, -0.1, 3.0], falls, 1e-14, True) == (TIME, math.inf)
    assert first_touch([0.0, -0.1, 3.0], falls, 1e-14, False)[0] == 0


def test_after_a_bounce_what_falls_back_before_others_meet_is_met_first():
    """A ball thrown up with 1 m/s is back after 2/9.8 s; one above it comes with 3 m/s relative to it."""
    falls = [0.0, 9.8, 9.8]
    early, late = ([0.0, -0.0, 1.0, -gap, -2.0] for gap in (0.5, 1.0))
    assert first_touch(early, falls, 1e-14, True) == (1, pytest.approx(0.5 / 3.0))
    assert first_touch(late, falls, 1e-14, True) == (0, pytest.approx(2.0 / 9.8))


def test_only_what_pushes_is_awake():
    line = RowOfBodies((1.0, 1.0), (0.0, 0.0), (0.0,), (SPHERE,))
    _, _, row = state_of(line)
    for (overlap, u, v), nothing in (
        ((0.0, 0.0, 0.0), True),
        ((0.0, 0.0, 1.0), True),
        ((0.0, 1.0, 0.0), False),
        ((0.1, 0.0, 1.0), False),
    ):
        assert inactive([u, overlap, v], [True], row, 0, 1, 1e-14) is nothing


def test_what_flies_freely_is_no_part_of_what_is_followed():
    """Contacts 9 and 10 of 30 are squeezed, a ball comes in at contact 20 soon; all others are open or touch at rest."""
    line = RowOfBodies((1.0,) * 31, (0.0,) * 31, (0.0,) * 30, (SPHERE,) * 30)
    y, touching, row = state_of(line)
    y[2 * 9 + 1] = y[2 * 10 + 1] = 1e-3
    assert active_part(y, touching, row, TIME, 1.0, 3, 1e-14) == (6, 14)
    assert active_part(y, touching, row, 2, 1.0, 3, 1e-14) == (0, 14)
    touching[20], y[2 * 20 + 1], y[2 * 20] = False, -1.0, 0.1
    touching[19], y[2 * 19 + 1] = False, -1.0
    assert active_part(y, touching, row, TIME, 1.0, 3, 1e-14) == (6, 24)
    assert active_part(y, touching, row, TIME, 0.1, 3, 1e-14) == (6, 14)
