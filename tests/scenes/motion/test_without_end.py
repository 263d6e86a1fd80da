"""Happenings without end: those that come to rest are followed to it, those that do not are refused by name."""

import math
from collections import Counter
from random import Random

import pytest

from corollary.scenes.forces.bonds import Spring, String
from corollary.scenes.forces.contact import Contact, HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.motion.follow import Follower, follow
from corollary.scenes.plan import play
from corollary.scenes.run import GuardFailed
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole

NAIL = Body(math.inf, (0.0,), (0.0,))
G = 9.8


def hung(upper, lower, restitution, until=20.0):
    """Two balls of 2 kg and 0.7 kg on strings of 1 m and 0.8 m below each other, let go from these places."""
    strings = String((0, 1), 1.0, restitution), String((1, 2), 0.8, restitution)
    balls = Body(2.0, (upper,), (0.0,)), Body(0.7, (lower,), (0.0,))
    return Scene((NAIL, *balls), (*strings, Weight(G)), until=until)


def swings(until):
    """An oscillator of 10 rad/s."""
    return Scene((NAIL, Body(1.0, (1.3,), (0.0,))), (Spring((0, 1), 100.0, 1.0),), until=until)


def test_a_hundred_swings_are_known_as_well_as_is_stated():
    until = 20.0 * math.pi + 0.03
    found = play(swings(until), {O.VELOCITIES, O.TRAJECTORY}, times=(until,))
    x, v = 1.0 + 0.3 * math.cos(10.0 * until), -3.0 * math.sin(10.0 * until)
    for name, truth, size in (("trajectory", x, 0.3), ("velocities", v, 3.0)):
        assert abs(found.observed[name][1] - truth) <= found.errors[name][1] <= 1e-6 * size


@pytest.mark.parametrize(("until", "reached"), [(1200.0, True), (3000.0, False)])
def test_two_thousand_swings_are_within_reach(until, reached):
    """Only whether it is given up is looked at, after the first steps: to the end it is most of a minute."""
    follower = Follower(swings(until), 1e-10, share=0.65)
    advance, taken = follower.steps.advance, []

    def counted(solver, begun):
        advance(solver, begun)
        taken.append(solver.t)
        if len(taken) == 600:
            raise GuardFailed("enough")

    follower.steps.advance = counted
    with pytest.raises(GuardFailed, match="enough" if reached else "out of reach.*shorter time"):
        follower.run()


def test_a_spring_whose_ends_are_pressed_to_one_place_rests_or_is_refused_soon():
    """Which way a spring of some length pushes there nothing says: it must not change its mind without end."""
    draw, ended = Random(8), Counter[str]()
    for _ in range(12):
        light, heavy = (
            Body(m, (x,), (draw.uniform(-0.5, 0.5),)) for m, x in ((1.7, 1.58), (draw.uniform(20, 40), 3.6))
        )
        forces = Weight(215.0), HardWall((1.0,), restitution=0.0), Spring((1, 0), 500.0, 1.1)
        follower = Follower(Scene((light, heavy), forces, until=0.41), 1e-10)
        try:
            path = follower.run()
            ended["rests" if path.state[2:] == [0.0, 0.0] else "moves"] += 1
        except GuardFailed as error:
            ended["refused" if "which way it acts is not decided" in str(error) else str(error)] += 1
        assert follower.system.evaluations < 20_000
    assert set(ended) <= {"rests", "moves", "refused"}  # it may also throw the light one up
    assert ended["refused"]


@pytest.mark.parametrize("begin", [-4e-4, -1.8e-3])
def test_a_string_that_jerks_far_from_where_it_began(begin):
    """Two balls begin at nearly one place, and 37 m below it a place is known to 1e-14 m only: the string jerks there, too."""
    (a, b), length, restitution, until = (1.6, 1.9), 1.0, 0.4, 3.0
    apart = Body(a, (0.0,), (2.0,)), Body(b, (begin,), (0.0,))
    found = play(Scene(apart, (Weight(G), String((0, 1), length, restitution)), until=until), {O.VELOCITIES})
    way, speed, left = length + begin, 2.0, until
    while left > way / speed:
        left -= way / speed
        way, speed = 2.0 * length, restitution * speed
    jerks = round(math.log(speed / 2.0, restitution))
    relative = speed * (-1.0) ** jerks
    middle = 2.0 * a / (a + b) - G * until
    true = middle + b / (a + b) * relative, middle - a / (a + b) * relative
    assert found.observed["velocities"] == pytest.approx(true, abs=1e-9)


@pytest.mark.parametrize("light", [1e-2, 1e-5, 1e-9])
def test_bounces_of_what_is_heavy_die_away_beside_what_is_light(light):
    """What holds both is solved for at once: it was 1e13 times smaller for one of them, and taken for nothing."""
    slider, ball = Body(light, (0.0, 0.0), (3.72, 0.0)), Body(1e8, (200.0, 0.273), (1.224, 0.0))
    walls = HardWall((0.0, 1.0), 0.0, 0.293)
    path = follow(Scene((slider, ball), (Weight(G), walls), until=0.565), 1e-10)
    fall = math.sqrt(2.0 * 0.273 / G)
    assert path.rests == [pytest.approx(fall * (1.0 + 2.0 * 0.293 / (1.0 - 0.293)), abs=1e-6)]
    assert abs(path.state[7]) < 1e-20  # at rest, to what the solution of the linear equations rounds


@pytest.mark.parametrize("slow", [1e-33, 1e-20, 1e-13])
def test_what_is_too_slow_to_meet_is_not_asked_how_deep_it_would(slow):
    bodies = Body(1.0, (0.0,), (slow,), 0.05), Body(1.0, (1.0,), (0.0,), 0.05)
    found = play(Scene(bodies, (Contact(2e4),), until=1.0), {O.VELOCITIES})
    assert found.observed["velocities"] == (slow, 0.0)
