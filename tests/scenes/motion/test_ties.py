"""Friction that can hold exactly as much as it must, but for errors: both ways are within what is stated, and it is said."""

import math

import pytest

from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

G = 9.8


def assert_announced_or_known(found, name, *truth):
    """Within the errors; and if those are large, in words, too."""
    said = any("friction" in warning and "in the errors stated" in warning for warning in found.warnings)
    for value, error, true in zip(found.observed[name], found.errors[name], truth, strict=True):
        assert abs(value - true) <= error
        assert error < 1e-3 or said


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8, 1e-10, 1e-12])
@pytest.mark.parametrize("excess", [1e-2, 1e-6, 1e-8, 1e-10, 1e-13])
def test_a_block_turns_where_the_spring_pulls_hardly_more_than_friction_holds(tolerance, excess):
    """Half swings about places that are mu g m/k off; where it turns first, 0.0294 m off, the spring pulls as much as friction can hold."""
    k, mu, shift = 100.0, 0.1, 0.1 * G / 100.0
    first = 1.049 + 0.049 * excess
    until, half = 0.6, math.pi / math.sqrt(k)
    low = 2.0 * (1.0 + shift) - first
    truth = (1.0 - shift) + (low - (1.0 - shift)) * math.cos(math.sqrt(k) * (until - half))
    nail, block = Body(math.inf, (0.0,), (0.0,)), Body(1.0, (first,), (0.0,))
    scene = Scene((nail, block), (Spring((0, 1), k, 1.0), Friction(1, mu, static=0.3)), until=until)
    found = play(scene, {O.TRAJECTORY}, tolerance, times=(until,))
    assert_announced_or_known(found, "trajectory", 0.0, truth)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("margin", [1e-4, 1e-8, 1e-11])
def test_a_sphere_on_a_spring_rolls_as_long_as_friction_holds(tolerance, margin):
    """m a (1 + 2/5) = -k x while it rolls; friction is 2/7 of k x, and its peak that much below what it can be."""
    k, m, radius, static = 20.0, 0.5, 0.1, 0.3
    wide = 3.5 * static * m * G / k * (1.0 - margin)
    rate = math.sqrt(k / (1.4 * m))
    sphere = Body(m, (0.0, radius), (wide * rate, 0.0), radius=radius, spin=-wide * rate / radius)
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=0.1, static=static, only=(1,))
    nail = Body(math.inf, (-1.0, radius), (0.0, 0.0))
    scene = Scene((nail, sphere), (Spring((0, 1), k, length=1.0), Weight(G), floor), until=0.5)
    found = play(scene, {O.VELOCITIES, O.SPINS}, tolerance)
    speed = wide * rate * math.cos(0.5 * rate)
    assert_announced_or_known(found, "velocities", 0.0, 0.0, speed, 0.0)
    assert_announced_or_known(found, "spins", 0.0, -speed / radius)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-12])
@pytest.mark.parametrize("share", [1e-3, 1e-8, 1e-11])
def test_a_pull_that_grows_past_the_stop(tolerance, share):
    """x'' = -(6 - 2 t) - mu g until it stops; the pull there is that share above what static friction holds, and then falls."""
    stop = 1.53 * (1.0 - share)
    push = ForceFunction(0, lambda t, x, v: (-(6.0 - 2.0 * t),))
    block = Body(1.0, (0.0,), (6.98 * stop - stop**2,))
    found = play(Scene((block,), (Friction(0, 0.1, static=0.3), push), until=2.0), {O.VELOCITIES}, tolerance)
    # From there on it goes back: -(6 - 2 t) + mu g.
    truth = -(6.0 - 0.98) * (2.0 - stop) + 4.0 - stop**2
    assert_announced_or_known(found, "velocities", truth)


def test_an_incline_as_steep_as_friction_holds():
    slope = math.atan(0.3)
    plane = HardWall((math.sin(slope), math.cos(slope)), restitution=0.0, mu=0.1, static=0.3)
    found = play(Scene((Body(1.0, (0.0, 0.0), (0.0, 0.0)),), (Weight(G), plane), until=1.0), {O.VELOCITIES})
    slides = G * (math.sin(slope) - 0.1 * math.cos(slope))
    assert_announced_or_known(found, "velocities", slides * math.cos(slope), -slides * math.sin(slope))


def test_what_is_held_well_is_announced_by_nobody():
    block = Body(1.0, (0.0, 0.0), (1.0, 0.0))
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=0.2, static=0.3)
    found = play(Scene((block,), (Weight(G), floor), until=1.0), {O.VELOCITIES})
    assert found.observed["velocities"] == pytest.approx((0.0, 0.0), abs=1e-10)
    assert not found.warnings
