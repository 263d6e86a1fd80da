"""What could be held in several ways: rough walls that face each other squeeze nothing, and what moves next decides who lets go."""

import math
import random

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from tests.shares import share

from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.rod import Rod, String
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene


def walls(mu, *normals, only=()):
    return tuple(HardWall(n, restitution=0.0, mu=mu, only=only) for n in normals)


def wire(mu, only=()):
    return walls(mu, (0.0, 1.0), (0.0, -1.0), only=only)


def pull(x, y):
    return ForceFunction(0, lambda t, place, velocity: (x, y))


SLANT = math.radians(20.0)
GROOVE = (math.cos(SLANT), math.sin(SLANT)), (-math.cos(SLANT), math.sin(SLANT))
CASES = {
    "a bead on a wire": (wire(0.3), (5.0, 0.0), 1.0, (5.0 - 0.3 * 9.8, 0.0)),
    "a block drawn away from a wall": (
        walls(1.1, (0.0, 1.0), (1.0, 0.0)),
        (30.0, 0.0),
        0.5,
        (0.5 * (30.0 - 1.1 * 9.8), 0.0),
    ),
    "lifted from a groove": (walls(0.5, *GROOVE), (0.0, 20.0), 0.5, (0.0, 0.5 * (20.0 - 9.8))),
    "in a shaft": (walls(0.5, (1.0, 0.0), (-1.0, 0.0)), (0.0, 0.0), 1.0, (0.0, -9.8)),
    "pressed into a corner": (walls(1.1, (0.0, 1.0), (1.0, 0.0)), (-30.0, 0.0), 0.5, (0.0, 0.0)),
}


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("tolerance", [1e-6, 1e-12])
def test_from_rest_nothing_is_squeezed(name, tolerance):
    surfaces, force, until, truth = CASES[name]
    body = Body(1.0, (0.0, 0.0), (0.0, 0.0))
    found = play(
        Scene((body,), (Weight(9.8), *surfaces, pull(*force)), until=until), {O.VELOCITIES}, tolerance
    )
    for value, error, true in zip(
        found.observed["velocities"], found.errors["velocities"], truth, strict=True
    ):
        assert abs(value - true) <= error < 1e-4


@pytest.mark.parametrize("draw", share(range(12), 4))
def test_a_bead_slides_from_side_to_side(draw):
    """What presses a bead swings: friction takes mu |N| t of its momentum."""
    rng = random.Random(draw)
    strength, weight, rate, mu = (
        rng.uniform(5.0, 20.0),
        rng.choice([3.0, 9.8]),
        rng.choice([3.0, 7.3, 10.0]),
        rng.choice([0.1, 0.3]),
    )
    until, forward = 0.6, rng.uniform(-5.0, 5.0)

    def across(t):
        return strength * math.sin(rate * t) - weight

    lost = quad(lambda t: abs(across(t)), 0.0, until, epsabs=1e-12, epsrel=1e-12, limit=500)[0]
    truth = 12.0 + forward * until - mu * lost
    force = ForceFunction(0, lambda t, x, v: (forward, strength * math.sin(rate * t)))
    bead = Body(1.0, (0.0, 0.0), (12.0, 0.0))
    found = play(Scene((bead,), (Weight(weight), *wire(mu), force), until=until), {O.VELOCITIES})
    assert abs(found.observed["velocities"][0] - truth) <= found.errors["velocities"][0] + 1e-11
    assert found.errors["velocities"][0] < 1e-8


def test_a_spring_presses_a_bead_now_to_one_side_now_to_the_other():
    k, m, mu, free, beside = 100.0, 0.5, 0.1, 0.6, 0.2

    def rates(t, y):
        long = math.hypot(y[0], beside)
        push = k * (long - free) / long
        return [y[1], (-push * y[0] - math.copysign(mu * push * beside, y[1])) / m]

    truth = solve_ivp(
        rates, (0.0, 0.8), [-1.0, 0.5], method="DOP853", rtol=1e-12, atol=1e-14, max_step=1e-3
    ).y[:, -1]
    bead, nail = Body(m, (-1.0, 0.0), (0.5, 0.0)), Body(math.inf, (0.0, beside), (0.0, 0.0))
    scene = Scene((bead, nail), (*wire(mu, (0,)), Spring((0, 1), k, length=free)), until=0.8)
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, times=(0.8,))
    for name, true in (("trajectory", truth[0]), ("velocities", truth[1])):
        assert abs(found.observed[name][0] - true) <= found.errors[name][0] + 1e-7
        assert found.errors[name][0] < 1e-6


@pytest.mark.parametrize("tie", [String, Rod])
@pytest.mark.parametrize(("pull_by", "mu"), [(10.0, 0.1), (-10.0, 0.1), (3.0, 0.3), (1.0, 0.1)])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
def test_a_bob_that_just_touches_the_floor_is_off_it_as_soon_as_it_moves(tie, pull_by, mu, tolerance):
    """String and floor hold the same motion, so neither is known to carry the weight; but the way of a bob bends upward."""

    def swings(t, y):
        return [y[1], pull_by * math.cos(y[0]) - 9.8 * math.sin(y[0])]

    angle, rate = solve_ivp(swings, (0.0, 0.3), [0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-15).y[:, -1]
    bob, nail = Body(1.0, (0.0, 0.0), (0.0, 0.0)), Body(math.inf, (0.0, 1.0), (0.0, 0.0))
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=mu, only=(0,))
    scene = Scene((bob, nail), (tie((0, 1)), Weight(9.8), floor, pull(pull_by, 0.0)), until=0.3)
    found = play(scene, {O.VELOCITIES}, tolerance)
    for value, error, true in zip(
        found.observed["velocities"],
        found.errors["velocities"],
        (rate * math.cos(angle), rate * math.sin(angle)),
        strict=False,
    ):
        assert abs(value - true) <= error + 1e-12
        assert error < 1e-6


def test_a_foot_that_stops_sliding_stands():
    """Two balls on a rod, 1 kg each, the lower one on a floor so rough that it would be pressed the harder the more it slid back."""
    mu, g, long = 4.0, 9.8, math.hypot(0.5, 1.0)

    def slides(t, y):
        _, angle, speed, turn = y
        sine, cosine = long * math.sin(angle), long * math.cos(angle)
        # Both along the floor, both upward, and the upper one about the lower: the acceleration, that of the angle, what presses.
        matrix = [[2.0, -sine, mu], [0.0, cosine, -1.0], [-sine, long**2, 0.0]]
        gained, bends, _ = np.linalg.solve(matrix, [cosine * turn**2, sine * turn**2 - 2.0 * g, -g * cosine])
        return [speed, turn, gained, bends]

    def stops(t, y):
        return y[2]

    stops.terminal = True
    exact = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-15}
    slid = solve_ivp(slides, (0.0, 0.3), [0.0, math.atan2(1.0, 0.5), 3.0, 0.0], events=stops, **exact)
    _, angle, _, turn = slid.y[:, -1]
    tipped = solve_ivp(
        lambda t, y: [y[1], -g * math.cos(y[0]) / long], (slid.t[-1], 0.3), [angle, turn], **exact
    )
    angle, turn = tipped.y[:, -1]
    truth = 0.0, 0.0, -long * math.sin(angle) * turn, long * math.cos(angle) * turn
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=mu)
    bodies = Body(1.0, (0.0, 0.0), (3.0, 0.0)), Body(1.0, (0.5, 1.0), (3.0, 0.0))
    found = play(Scene(bodies, (Rod((0, 1)), Weight(g), floor), until=0.3), {O.VELOCITIES})
    for value, error, true in zip(
        found.observed["velocities"], found.errors["velocities"], truth, strict=True
    ):
        assert abs(value - true) <= error + 1e-12
        assert error < 1e-9


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
@pytest.mark.parametrize("pull_by", [1.0, -2.0, 3.0, 4.8])
def test_whether_string_or_floor_carries_a_bob_is_said_to_be_open(pull_by, tolerance):
    """Carried by the floor, with 4.9 N of friction, it rests; carried by the string it swings: both obey the laws of rigid bodies."""

    def swings(t, y):
        return [y[1], pull_by * math.cos(y[0]) - 9.8 * math.sin(y[0])]

    angle, rate = solve_ivp(swings, (0.0, 0.3), [0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-15).y[:, -1]
    bob, nail = Body(1.0, (0.0, 0.0), (0.0, 0.0)), Body(math.inf, (0.0, 1.0), (0.0, 0.0))
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=0.5, only=(0,))
    scene = Scene((bob, nail), (String((0, 1)), Weight(9.8), floor, pull(pull_by, 0.0)), until=0.3)
    found = play(scene, {O.VELOCITIES}, tolerance)
    assert any("leave it open" in warning for warning in found.warnings)
    for value, error, swung in zip(
        found.observed["velocities"],
        found.errors["velocities"],
        (rate * math.cos(angle), rate * math.sin(angle)),
        strict=False,
    ):
        assert abs(value) <= error
        assert abs(value - swung) <= error


def test_a_bob_that_floor_and_string_leave_no_choice_is_not_said_to_be_open():
    """Pulled by more than friction could hold it is off the floor as soon as it moves."""
    bob, nail = Body(1.0, (0.0, 0.0), (0.0, 0.0)), Body(math.inf, (0.0, 1.0), (0.0, 0.0))
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=0.5, only=(0,))
    scene = Scene((bob, nail), (String((0, 1)), Weight(9.8), floor, pull(5.0, 0.0)), until=0.3)
    assert play(scene, {O.VELOCITIES}).warnings == ()
