"""A bob on a taut string, and another one whose string to it jerks tight: the taut one holds, and gives nothing back."""

import math
import random

import numpy as np
import pytest

from corollary.scenes.forces.rod import String
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.run import components
from corollary.scenes.scene import Body, Scene

integrate = pytest.importorskip("scipy.integrate")
G, AFTER = 9.8, 0.02


def drawn(seed):
    """Masses, lengths and restitutions of the strings, angle and rate of the swing, and how the second bob begins."""
    r = random.Random(seed)
    long, angle, rate = r.uniform(0.5, 1.0), r.uniform(-0.6, 0.6) - 0.5 * math.pi, r.uniform(-2.0, 2.0)
    other, way, part = r.uniform(0.4, 0.9), r.uniform(0.0, 2.0 * math.pi), r.uniform(0.3, 0.9)
    begins = np.array([math.cos(angle), math.sin(angle)]) * long
    begins = begins + part * other * np.array([math.cos(way), math.sin(way)])
    thrown = np.array([r.uniform(-2.0, 2.0), r.uniform(-2.0, 2.0)])
    masses, gives = (r.uniform(0.3, 2.0), r.uniform(0.3, 2.0)), (r.uniform(0.05, 0.8), r.uniform(0.0, 0.8))
    return masses, (long, other), gives, angle, rate, begins, thrown


def swung(angle, rate, long):
    """Place and velocity on a circle."""
    out, along = np.array([math.cos(angle), math.sin(angle)]), np.array([-math.sin(angle), math.cos(angle)])
    return long * out, long * rate * along


def swings(angle, rate, long, until, stops=None):
    return integrate.solve_ivp(
        lambda t, y: (y[1], -G / long * math.cos(y[0])),
        (0.0, until), (angle, rate), "DOP853", rtol=1e-13, atol=1e-14, events=stops,
    )  # fmt: skip


def expected(seed):
    """Until when, and the velocities then: the swing in its angle, and two linear equations for the impulses of the jerk."""
    (heavy, light), (long, other), (_, gives), angle, rate, begins, thrown = drawn(seed)

    def flies(t):
        return begins + t * thrown - (0.0, 0.5 * G * t * t), thrown - (0.0, G * t)

    def slack(t, y):
        return other - math.dist(flies(t)[0], swung(*y, long)[0])

    slack.terminal = True
    first = swings(angle, rate, long, 2.0, slack)
    at = first.t_events[0][0]
    (here, v), (there, w) = swung(*first.y_events[0][0], long), flies(at)
    out, across = here / long, (there - here) / other
    # The bob does not move along its own string afterwards; along the other one both part as that gives back.
    c, opening = out @ across, (w - v) @ across
    rows = np.array([[-1.0 / heavy, c / heavy], [c / heavy, -1.0 / heavy - 1.0 / light]])
    held, jerk = np.linalg.solve(rows, [-(v @ out), -(1.0 + gives) * opening])
    assert held > 0.0 < jerk
    v, w = v + (jerk * across - held * out) / heavy, w - jerk / light * across
    along = np.array([-out[1], out[0]])
    then = swings(math.atan2(out[1], out[0]), v @ along / long, long, AFTER).y[:, -1]
    return at + AFTER, [0.0, 0.0, *swung(*then, long)[1], *(w - (0.0, G * AFTER))]


@pytest.mark.parametrize("tolerance", [1e-6, 1e-8, 1e-12])
@pytest.mark.parametrize("seed", [20, 49, 75, 76, 144])
def test_what_holds_goes_on_holding_while_something_else_jerks(seed, tolerance):
    """Where the jerk came a little late, and its string was put right, the taut one was off its length: it was taken for one that opens, and hit."""
    masses, (long, other), gives, angle, rate, begins, thrown = drawn(seed)
    until, true = expected(seed)
    nail = Body(math.inf, (0.0, 0.0), (0.0, 0.0))
    bob = Body(masses[0], *map(tuple, swung(angle, rate, long)))
    scene = Scene(
        (nail, bob, Body(masses[1], tuple(begins), tuple(thrown))),
        (Weight(G), String((0, 1), long, gives[0]), String((1, 2), other, gives[1])),
        until=until,
    )
    found = play(scene, {O.VELOCITIES}, tolerance)
    errors = components(found.errors["velocities"])
    assert max(errors) < 1e3 * tolerance + 1e-10
    assert all(
        abs(a - b) <= e + 1e-12 for a, b, e in zip(found.observed["velocities"], true, errors, strict=True)
    )
