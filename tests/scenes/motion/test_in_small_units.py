"""The same scene in other units is the same motion, however fast or slowly bodies of another size turn."""

from __future__ import annotations

import math

import pytest

from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import InverseSquare, Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

MASS, MU, G = 2.0, 0.36, 9.8


@pytest.mark.parametrize("length", [0, 20, 32, 34, 60, -60])
@pytest.mark.parametrize("time", [0, 34, -34])
def test_a_falling_ball_is_slowed_by_a_rough_upright_wall(length, time):
    """For 1e-10 m and seconds friction had driven the slip: speeds of turning in rad/s are large beside m/s, and slips were rounding to them."""
    unit, second = 2.0**-length, 2.0**-time
    speed, gravity = unit / second, G * unit / second**2
    radius, gap, into, down, until = 0.1 * unit, 0.3 * unit, 1.4 * speed, -2.2 * speed, 0.5 * second
    scene = Scene(
        (Body(MASS, (-radius - gap, 0.0), (into, down), radius),),
        (HardWall((-1.0, 0.0), 0.0, restitution=0.0, mu=MU), Weight(gravity)),
        until=until,
    )
    # It slips through the whole hit, and nothing presses it after: friction turns the ball by 5/2 of that over its radius.
    pushed = MU * into
    true = (0.0, down - gravity * until + pushed), (2.5 * pushed / radius,)
    found = play(scene, {O.VELOCITIES, O.SPINS}, 1e-10)
    for name, values in zip(("velocities", "spins"), true, strict=True):
        for value, error, wanted in zip(found.observed[name], found.errors[name], values, strict=True):
            assert abs(value - wanted) <= error <= 1e-8 * (abs(wanted) or into)


@pytest.mark.parametrize("until", [1e-12, 1e-9, 1e-3])
@pytest.mark.parametrize("speed", [0.0, 1e5])
def test_ions_that_fly_apart_are_as_far_apart_as_they_begin(until, speed):
    """Ten million times as far as that they get within a millisecond; what repels them knows the 1e-10 m between them all the same."""
    strength, mass, places = 2.3e-28, 1e-26, ((0.0, 0.0), (1e-10, 1e-11))
    ions = tuple(
        Body(mass, place, (way * speed, 0.0)) for place, way in zip(places, (1.0, -1.0), strict=True)
    )
    scene = Scene(ions, (InverseSquare((0, 1), -strength),), until=until)
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, times=(until,))
    fast, (a, b, c, d) = found.observed["velocities"], found.observed["trajectory"]
    had = mass * speed**2 + strength / math.dist(*places)
    has = 0.5 * mass * sum(v * v for v in fast) + strength / math.dist((a, b), (c, d))
    assert has == pytest.approx(had, rel=1e-8)
    assert max(found.errors["velocities"]) < 1e-9 * math.sqrt(had / mass)
