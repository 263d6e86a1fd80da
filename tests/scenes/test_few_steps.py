"""Motions so smooth that a handful of steps is all they take: the two runs that are compared must not be off alike."""

import math
import random

import pytest

from corollary.scenes.forces.flows import Absorption, Thrust
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene


def rocket(m, burn, exhaust, caught, rate, v0, until):
    """Velocity and way: m dv/dt = -burn exhaust + rate (caught - v), with the mass as the clock."""
    k, end = burn - rate, m - (burn - rate) * until
    if not rate:
        gone = math.log(end / m)
        return v0 + exhaust * gone, v0 * until - exhaust * (until + end / k * gone)
    s, steady = rate / k, (rate * caught - burn * exhaust) / rate
    share = v0 - steady
    ways = [steady * mass + share * mass * (mass / m) ** s / (s + 1.0) for mass in (end, m)]
    return steady + share * (end / m) ** s, (ways[1] - ways[0]) / k


def off(m, burn, exhaust, caught, rate, v0, until, tolerance):
    """True over stated errors of the velocity and the way; what doubles leave of the closed form is allowed for."""
    forces = (Thrust(0, (exhaust,), burn), *([Absorption(0, (caught,), rate)] if rate else []))
    scene = Scene((Body(m, (0.0,), (v0,)),), forces, until=until)
    found = play(scene, {O.VELOCITIES, O.TRAJECTORY}, tolerance, times=(until,))
    truth = rocket(m, burn, exhaust, caught, rate, v0, until)
    for name, true in zip(("velocities", "trajectory"), truth, strict=True):
        (value,), (error,) = found.observed[name], found.errors[name]
        yield max(abs(value - true) - 3e-15 * max(abs(true), 1.0), 0.0) / error


@pytest.mark.parametrize(
    ("m", "burn", "exhaust", "caught", "rate", "v0", "until"),
    [
        (1.9654726574991446, 0.5922866730640535, -2.762018013521037, -1.5034672265582245, 0.5241854031957149, 1.490953736177854, 3.3151436939565646),
        (2.0, 0.4, -2.0, 0.0, 0.1, 2.0, 1.5),
        (2.122733561993077, 0.20939528997094842, 3.4500702066471494, 0.0, 0.0, 0.9294110787398453, 3.2545297763042793),
    ],
)  # fmt: skip
@pytest.mark.parametrize("tolerance", [2.08e-8, 1.2e-10, 1e-10, 9.36e-11])
def test_rockets_once_off_by_many_times_what_they_state(m, burn, exhaust, caught, rate, v0, until, tolerance):
    assert max(off(m, burn, exhaust, caught, rate, v0, until, tolerance)) < 1.0


def test_a_hundred_rockets_are_within_what_they_state():
    chance = random.Random(12)
    for _ in range(100):
        m, until = chance.uniform(0.5, 3.0), chance.uniform(0.5, 5.0)
        burn = m / until * chance.uniform(0.2, 0.6)
        rate = chance.choice([0.0, 0.3 * burn * chance.random()])
        given = chance.uniform(-5.0, 5.0), chance.uniform(-3.0, 3.0), rate, chance.uniform(-2.0, 2.0), until
        assert max(off(m, burn, *given, 10.0 ** chance.uniform(-11.0, -4.0))) < 0.5
