"""Rough walls that face each other: they press nothing together that nothing pushes, however well they could hold it."""

import math
import random

import pytest
from scipy.integrate import quad, solve_ivp

from corollary.scenes.forces.function import ForceFunction
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


@pytest.mark.parametrize("draw", range(12))
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
