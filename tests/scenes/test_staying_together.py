"""Bodies that a damped contact keeps together for as long as they are watched, or until something hits or pulls them."""

import math

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

pytestmark = pytest.mark.whole

R = 0.2
ASKED = {O.VELOCITIES, O.TRAJECTORY}


def rates(masses, k, eta, third=None):
    """The matrix of (overlap of 0 and 1, overlap of 2 and 0, velocities) while 0 and 1 touch; with the stiffness of a `third` that pushes."""
    push, drag = np.array([k, 0.0, eta, -eta, 0.0]), np.array([0.0, third or 0.0, 0.0, 0.0, 0.0])
    pair, behind = np.array([0.0, 0.0, 1.0, -1.0, 0.0]), np.array([0.0, 0.0, -1.0, 0.0, 1.0])
    forces = drag - push, push, -drag
    return np.vstack([pair, behind, *(f / m for f, m in zip(forces, masses, strict=True))])


def within(found, name, truth, most):
    errors = found.errors[name]
    assert all(abs(x - t) <= e + 1e-11 for x, t, e in zip(found.observed[name], truth, errors, strict=True))
    assert max(errors) < most


@pytest.mark.parametrize("damping", [1.2, 3.0, 30.0])
@pytest.mark.parametrize("lasts", [3.0, 30.0, 300.0])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
def test_a_pair_relaxes_and_goes_on_as_one(damping, lasts, tolerance):
    """`damping` is a part of the critical one, `lasts` counts the times eta/k in which the overlap fades."""
    (a, b), k, v = (1.0, 3.0), 1e4, 0.8
    eta = damping * 2.0 * math.sqrt(k * a * b / (a + b))
    until = 0.5 + lasts * eta / k
    bodies = Body(a, (-2.0 * R - 0.5 * v,), (v,), R), Body(b, (0.0,), (0.0,), R)
    found = play(Scene(bodies, (Contact(k, 1.0, eta),), until=until), ASKED, tolerance, times=(until,))
    z = expm(rates((a, b, 1.0), k, eta) * (until - 0.5)) @ [0.0, 0.0, v, 0.0, 0.0]
    middle = v * a / (a + b) * (until - 0.5) - 2.0 * R * a / (a + b)
    apart = 2.0 * R - z[0]
    within(found, "velocities", z[2:4], 1e3 * tolerance)
    within(found, "trajectory", (middle - apart * b / (a + b), middle + apart * a / (a + b)), 1e3 * tolerance)
    assert found.warnings == ()
    if lasts != 30.0:  # by then some steps have seen it come to rest
        assert found.outcome == ("bound" if lasts == 3.0 else "sticks")


@pytest.mark.parametrize(("damping", "lasts"), [(1.5, 20.0), (1.5, 100.0), (10.0, 40.0), (30.0, 15.0)])
@pytest.mark.parametrize("third", [0.3, 4.0])
def test_a_third_body_hits_the_pair_as_one(damping, lasts, third):
    masses, k, stiff, v = (1.0, 0.4, third), 2e4, 3e4, 1.1
    mu = masses[0] * masses[1] / (masses[0] + masses[1])
    eta = damping * 2.0 * math.sqrt(k * mu)
    alone, pushed = rates(masses, k, eta), rates(masses, k, eta, stiff)
    fast, gap = 3.0, (3.0 - v * masses[0] / (masses[0] + masses[1])) * lasts * eta / k
    bodies = (
        Body(masses[0], (0.0,), (v,), R),
        Body(masses[1], (2.0 * R,), (0.0,), R),
        Body(masses[2], (-2.0 * R - gap,), (fast,), R),
    )
    z = np.array([0.0, -gap, v, 0.0, fast])
    hit = brentq(lambda t: (expm(alone * t) @ z)[1], 0.0, 3.0 * lasts * eta / k, xtol=1e-15)
    z = expm(alone * hit) @ z
    longest = 4.0 * math.pi * math.sqrt(sum(masses) / stiff)
    ahead = np.linspace(0.02, 1.0, 400) * longest
    opens = next(t for t in ahead if (expm(pushed * t) @ z)[1] < 0.0)
    opens = brentq(lambda t: (expm(pushed * t) @ z)[1], opens - ahead[0] / 4.0, opens, xtol=1e-16)
    z = expm(pushed * opens) @ z
    z = expm(alone * 0.1) @ z
    contacts = Contact(k, 1.0, eta, chosen=((0, 1),)), Contact(stiff, 1.0, chosen=((0, 2), (1, 2)))
    found = play(Scene(bodies, contacts, until=hit + opens + 0.1), {O.VELOCITIES})
    within(found, "velocities", z[2:], 1e-7)
    assert not any("coincide" in each or "grazes" in each for each in found.warnings)


@pytest.mark.parametrize("newtons", [1e-3, 1e-6])
def test_a_weak_pull_parts_what_has_come_to_rest(newtons):
    """No dashpot holds: the overlap falls through zero, and from then on the pulled body goes by itself."""
    (a, b), k, eta, v, until = (1.0, 1.0), 1e4, 600.0, 1.0, 20.0
    mu = 0.5
    bodies = Body(a, (0.0,), (v,), R), Body(b, (2.0 * R,), (0.0,), R)
    pull = ForceFunction(1, lambda t, x, v: (newtons,))
    found = play(Scene(bodies, (Contact(k, 1.0, eta), pull), until=until), {O.VELOCITIES})
    half, rest = eta / (2.0 * mu), -mu * newtons / b / k
    root = math.sqrt(half * half - k / mu)
    slow, quick = root - half, -root - half
    first = (v + rest * quick) / (slow - quick)
    second = -rest - first
    ends = brentq(lambda t: rest + first * math.exp(slow * t) + second * math.exp(quick * t), 0.01, until)
    parting = -(first * slow * math.exp(slow * ends) + second * quick * math.exp(quick * ends))
    apart = parting + newtons / b * (until - ends)
    middle = 0.5 * v + newtons / (a + b) * until
    within(found, "velocities", (middle - 0.5 * apart, middle + 0.5 * apart), 1e-6)
    assert found.outcome == "bound"


@pytest.mark.parametrize("eta", [0.0, 3.0, 1e3])
@pytest.mark.parametrize("aside", [1e-12, -1e-12])
def test_a_true_graze_is_still_said(eta, aside):
    bodies = Body(1.0, (-1.0, 0.0), (1.0, 0.0), R), Body(1.0, (0.0, 2.0 * R - aside), (0.0, 0.0), R)
    found = play(Scene(bodies, (Contact(1e4, 1.5, eta),), until=2.0), {O.VELOCITIES})
    assert any("grazes" in each for each in found.warnings)
