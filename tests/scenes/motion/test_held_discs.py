"""Discs on fixed axles, of infinite mass, that are turned where they rub; their spins from Newton's law of rotation alone."""

import math
from dataclasses import replace
from fractions import Fraction

import mpmath as mp
import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, Measurement, components
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

PRESSED = {O.SPINS, O.ENERGY, O.LARGEST_OVERLAP, O.PEAK_FORCE, O.DURATION}
A = Body(math.inf, (0.0, 0.0), (0.0, 0.0), radius=0.1, spin=20.0, inertia=0.02)
B = Body(math.inf, (0.29, 0.0), (0.0, 0.0), radius=0.2, inertia=0.05)
PUSH, MU = Fraction(10), Fraction(3, 10)
ARMS = Fraction(29, 300), Fraction(58, 300)
"""Shares of the distance, as the radii."""
INERTIAS = Fraction(1, 50), Fraction(1, 20)


def assert_true(found: Measurement, *true: float) -> None:
    for value, error, exact in zip(components(found.value), components(found.error), true, strict=True):
        assert abs(value - exact) <= error < 1e-6, (value, error, exact)


@pytest.mark.parametrize("chosen", [None, ((1, 0),)])
def test_kinetic_friction_turns_both(chosen):
    contact = Contact(1000.0, 1.0, mu=0.3, chosen=chosen)
    found = play(Scene((A, B), (contact,), until=0.5), PRESSED).measured
    spins = [s - MU * PUSH * arm / i / 2 for s, arm, i in zip((20, 0), ARMS, INERTIAS, strict=True)]
    assert_true(found["spins"], *map(float, spins))
    stored = PUSH * Fraction(1, 100) / 2
    turning = sum(i * s * s / 2 for i, s in zip(INERTIAS, spins, strict=True))
    assert_true(found["energy"], float(stored + turning))
    assert_true(found["largest_overlap"], 0.01)
    assert_true(found["peak_force"], 10.0)
    assert_true(found["duration"], 0.5)


def test_they_roll_on_each_other_in_the_end():
    """The same impulse turns both until surfaces go alike."""
    run = play(Scene((A, B), (Contact(1000.0, 1.0, mu=0.3),), until=5.0), {O.SPINS})
    (a, b), (i, j) = ARMS, INERTIAS
    impulse = 20 * a / (a * a / i + b * b / j)
    assert_true(run.measured["spins"], float(20 - impulse * a / i), float(-impulse * b / j))
    assert run.outcome == "bound"


def test_one_that_nothing_turns_brakes_the_other():
    driven = replace(B, inertia=None)
    found = play(Scene((A, driven), (Contact(1000.0, 1.0, mu=0.3),), until=0.5), {O.SPINS})
    assert_true(found.measured["spins"], float(20 - MU * PUSH * ARMS[0] / INERTIAS[0] / 2), 0.0)


def test_what_nothing_turns_is_left_alone():
    bodies = tuple(replace(body, inertia=None) for body in (A, B))
    found = play(Scene(bodies, (Contact(1000.0, 1.0, mu=0.3),), until=0.5), {O.SPINS})
    assert found.observed["spins"] == (20.0, 0.0)


@pytest.mark.parametrize("until", [2.0, 10.0])
@pytest.mark.parametrize("tolerance", [1e-8, 1e-10, 1e-12])
def test_one_that_passes_turns_the_other_while_they_touch(until, tolerance):
    k, q, mu, off = 800.0, 1.5, 0.2, mp.mpf("0.28")
    a = replace(A, place=(-2.0, 0.28), velocity=(1.0, 0.0), spin=0.0)
    b = replace(B, place=(0.0, 0.0), inertia=0.5)
    scene = Scene((a, b), (Contact(k, q, mu=mu),), until=until, passes=((0, 1),))
    found = play(scene, {O.SPINS, O.DURATION}, tolerance).measured
    half = mp.sqrt(mp.mpf("0.09") - off**2)

    def torque(x: mp.mpf) -> mp.mpf:
        r = mp.sqrt(x * x + off**2)
        return mu * k * max(mp.mpf("0.3") - r, mp.mpf(0)) ** q * r

    turned = mp.quad(torque, [-half, 0] if until == 2.0 else [-half, 0, half])
    assert_true(found["spins"], float(-turned / 3 / 0.02), float(-2 * turned / 3 / 0.5))
    assert_true(found["duration"], float(half * (1 if until == 2.0 else 2)))


def test_without_an_end_they_are_refused():
    with pytest.raises(BadSetting, match="nothing moves bodies 0 and 1"):
        Scene((A, B), (Contact(1000.0, 1.0, mu=0.3),))
