"""What is slow is followed as well as it is known, however fast it was or something else is."""

import math

import pytest

from corollary.scenes.forces.contact import Friction
from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole

MU, G = 0.3, 9.8
BOTH = {O.VELOCITIES, O.TRAJECTORY}


def assert_within(found, name, *truth):
    for value, error, true in zip(found.observed[name], found.errors[name], truth, strict=False):
        assert abs(value - true) <= error, (name, value, true, error)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10, 1e-12])
@pytest.mark.parametrize("fast", [1e2, 1e4, 1e6])
@pytest.mark.parametrize("until", [0.3367, 1.0])
def test_a_block_stops_where_it_does_whatever_flies_by(tolerance, fast, until):
    blocks = Body(1.0, (0.0,), (1.0,)), Body(1.0, (5.0,), (fast,))
    found = play(Scene(blocks, (Friction(0, MU),), until=until), BOTH, tolerance, times=(until,))
    slowed = min(until, 1.0 / (MU * G))
    way, speed = slowed - 0.5 * MU * G * slowed**2, 1.0 - MU * G * slowed
    assert_within(found, "trajectory", way)
    assert_within(found, "velocities", speed)
    if tolerance < 1e-6:
        assert found.errors["trajectory"][0] <= max(1e-9, 1e-11 * fast) * 1e3


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10, 1e-12])
@pytest.mark.parametrize(
    ("drag", "thrown", "times", "at"),
    [
        (1e8, 1.0, 1.7, 0.0),
        (1e4, 1e3, 1.7, 0.0),
        (1e5, 1.0, 3.0, 0.0),
        (0.098, 1e4, 1.3, 1e6),
        (0.098, 1e3, 1.3, 1e6),
    ],
)
def test_what_a_fluid_stops_at_once_falls_at_its_own_pace(drag, thrown, times, at, tolerance):
    last = math.sqrt(G / drag)
    up = last / G * math.atan(thrown / last)
    until = times * up
    falls = G * (until - up) / last
    high = last**2 / G * (math.log(math.hypot(1.0, thrown / last)) - math.log(math.cosh(falls)))
    scene = Scene((Body(1.0, (at,), (thrown,)),), (Weight(G), Drag(0, quadratic=drag)), until=until)
    found = play(scene, BOTH, tolerance, times=(until,))
    assert_within(found, "velocities", -last * math.tanh(falls))
    assert_within(found, "trajectory", at + high)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
def test_what_a_fluid_stops_without_end_never_turns(tolerance):
    drag = 1e8
    scene = Scene((Body(1.0, (0.0,), (10.0,)),), (Drag(0, quadratic=drag),), until=1.3)
    found = play(scene, BOTH, tolerance, times=(1.3,))
    assert_within(found, "velocities", 10.0 / (1.0 + 13.0 * drag))
    assert_within(found, "trajectory", math.log1p(13.0 * drag) / drag)
