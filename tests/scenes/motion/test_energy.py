"""Momentum and energy of a start: sums whose terms cancel are as far off as stated, and a disc on a nail has the energy of its spin."""

import math
from fractions import Fraction

import mpmath
import pytest
from tests.ready_scene_files import names_in

from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.fields import InverseSquare, Weight
from corollary.scenes.plan import play
from corollary.scenes.run import Observable as O
from corollary.scenes.run import components
from corollary.scenes.scene import Body, Scene

Well = names_in("atom")["Well"]

SUN = Body(math.inf, (0.0, 0.0), (0.0, 0.0))
DRIFTING = (Body(3.0, (0.0,), (0.1,)), Body(0.3, (1.0,), (-1.0,)))


def square(*numbers):
    return mpmath.fsum(mpmath.mpf(x) ** 2 for x in numbers)


def flies_off():
    """A planet with next to no energy: its speed is all but that at which it leaves for ever."""
    speed, place = 1e3, (3.1, 0.7)
    strength = 0.35 * speed**2 * math.hypot(*place) * (1.0 - 1e-9)
    with mpmath.workdps(40):
        truth = mpmath.mpf(0.7) / 2 * square(speed) - mpmath.mpf(strength) / mpmath.sqrt(square(*place))
    return Scene((SUN, Body(0.7, place, (0.0, speed))), (InverseSquare((0, 1), strength),), until=1e-4), truth


def thrown_up():
    truth = Fraction(1.4) ** 2 / 2 - Fraction(9.8) * Fraction(0.1)
    return Scene((Body(1.0, (-0.1,), (1.4,)),), (Weight(9.8),), until=1.0), truth


def all_but_at_length():
    """A stiff spring in a plane, as long as it is but for rounding."""
    with mpmath.workdps(40):
        longer = mpmath.sqrt(square(300.0, 400.1)) - mpmath.mpf(math.hypot(300.0, 400.1))
        truth = mpmath.mpf(1e9) / 2 * longer**2
    length = math.hypot(300.0, 400.1)
    bodies = SUN, Body(2.0, (300.0, 400.1), (0.0, 0.0))
    return Scene(bodies, (Spring((0, 1), 1e9, length),), until=1e-3), truth


def squeezed():
    bodies = Body(1.0, (0.1,), (0.0,), 0.1), Body(1.0, (0.3 - 1e-16,), (0.0,), 0.1)
    deep = Fraction(0.1) + Fraction(0.1) - (Fraction(0.3 - 1e-16) - Fraction(0.1))
    return Scene(bodies, (Contact(1e20, 1.0),), until=1e-12), Fraction(1e20) * max(deep, 0) ** 2 / 2


def at_the_bottom():
    with mpmath.workdps(40):
        truth = mpmath.mpf(1e8) / 2 * (mpmath.sqrt(square(0.6, 0.8)) - 1) ** 2
    return Scene((Body(1.0, (0.6, 0.8), (0.0, 0.0)),), (Well(1e8, 1.0, 0.4),), until=1e-3), truth


@pytest.mark.parametrize("made", [flies_off, thrown_up, all_but_at_length, squeezed, at_the_bottom])
def test_an_energy_whose_terms_cancel_is_as_far_off_as_stated(made):
    scene, truth = made()
    found = play(scene, {O.ENERGY}).measured["energy"]
    assert found.model == "conservation"
    with mpmath.workdps(40):
        off = (
            abs(mpmath.mpf(found.value) - mpmath.mpf(truth.numerator) / truth.denominator)
            if isinstance(truth, Fraction)
            else abs(mpmath.mpf(found.value) - truth)
        )
    assert off <= found.error <= 1e-11 * max(found.size, 1.0)


def test_momenta_that_cancel_are_rounded_once():
    scene = Scene(DRIFTING, (Spring((0, 1), 1.0, 0.5),), until=1.0)
    exact = 3 * Fraction(0.1) - Fraction(0.3)
    alone = play(scene, {O.MOMENTUM})
    assert alone.observed["momentum"] == (float(exact),)
    (value,), (error,) = (components(x["momentum"]) for x in (alone.observed, alone.errors))
    assert abs(Fraction(value) - exact) <= Fraction(error) < Fraction(1e-30)
    assert play(scene, {O.MOMENTUM, O.VELOCITIES}).observed["momentum"] == alone.observed["momentum"]


def test_the_momentum_of_two_spheres_is_one_number_whatever_else_is_asked():
    a, b = Body(0.3, (0.0, 0.0), (0.7, 0.1), 0.02), Body(0.7, (0.05, 0.01), (-0.3, -0.3 / 7.0), 0.03)
    scene = Scene((a, b), (Contact(2e4, 1.5),))
    exact = [sum(Fraction(c.mass) * Fraction(c.velocity[i]) for c in (a, b)) for i in (0, 1)]
    for asked in ({O.MOMENTUM}, {O.MOMENTUM, O.VELOCITIES}):
        found = play(scene, asked).measured["momentum"]
        for value, error, truth in zip(components(found.value), components(found.error), exact, strict=True):
            assert abs(Fraction(value) - truth) <= Fraction(error)


def on_a_nail(mass, start):
    """A disc that turns, and a ball."""
    disc = Body(mass, (0.0, 0.0), (0.0, 0.0), 0.1, spin=20.0, inertia=0.02)
    return Scene((disc, Body(1.0, start, (-1.0, 0.0), 0.1)), (Contact(1e5, 1.5, mu=0.3),))
