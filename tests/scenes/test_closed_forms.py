"""Scenes that a closed form answers are refused where following them would be: bodies that overlap with no contact between them."""

import math

import pytest

from corollary.scenes.forces.inverse_square import InverseSquare
from corollary.scenes.plan import play
from corollary.scenes.run import GuardFailed
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene


def planet(velocity, radius=0.3, until=None, passes=(), strength=1.0):
    sun = Body(math.inf, (0.0, 0.0), (0.0, 0.0), 0.3)
    return Scene(
        (Body(1.0, (1.0, 0.0), velocity, radius), sun),
        (InverseSquare((0, 1), strength),),
        until=until,
        passes=passes,
    )


INTO_THE_SUN = [
    (planet((0.0, 0.8), until=10.0), {O.PERIOD}),
    (planet((0.0, 0.8), until=10.0), {O.TURNING_POINTS}),
    (planet((0.0, 0.8)), {O.PERIOD}),
    (planet((0.0, 0.8), until=10.0), {O.PERIOD, O.ENERGY}),
    (planet((0.0, 0.8), until=10.0), {O.VELOCITIES}),
    (planet((-1.5, 0.5)), {O.TURNING_POINTS}),
    (planet((0.0, 1.1), 0.8), {O.PERIOD}),
]


@pytest.mark.parametrize(("scene", "asked"), INTO_THE_SUN)
def test_a_planet_that_runs_into_its_sun_has_no_orbit(scene, asked):
    with pytest.raises(GuardFailed, match=r"overlap.* no contact acts between them"):
        play(scene, asked)


def test_one_that_keeps_off_or_may_pass_has_its_orbit():
    """Its nearest distance is 0.8 squared / (2 - 0.8 squared), by energy and angular momentum."""
    nearest = 0.64 / 1.36
    for scene in (
        planet((0.0, 0.8), radius=0.0, until=10.0),
        planet((0.0, 0.8), radius=0.17),
        planet((0.0, 0.8), until=10.0, passes=((1, 0),)),
    ):
        found = play(scene, {O.TURNING_POINTS})
        assert found.observed["turning_points"] == pytest.approx((nearest, 1.0), rel=1e-14)
    # Away from the sun it does not come to the nearest point of its way.
    assert play(planet((1.5, 0.2)), {O.TURNING_POINTS}).observed["turning_points"] == ()
    # Nor in so short a time.
    assert play(planet((-0.1, 0.8), until=0.1), {O.TURNING_POINTS}).observed["turning_points"] == ()
