"""Strings that jerk in turn, ever sooner: what is left is found in fractions, jerk after jerk, or by the momentum alone."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.scenes.forces.rod import String
from corollary.scenes.plan import play
from corollary.scenes.run import GuardFailed, components
from corollary.scenes.run import Observable as O
from corollary.scenes.scene import Body, Scene

LONG = 0.6


def on_strings(masses, restitutions, until=1.0):
    places, velocities = ((0.0,), (0.5,), (1.0,)), ((0.0,), (0.0,), (1.0,))
    bodies = tuple(Body(*each) for each in zip(masses, places, velocities, strict=True))
    strings = (String((k, k + 1), LONG, e) for k, e in enumerate(restitutions))
    return Scene(bodies, tuple(strings), until=until)


def jerks(masses, restitutions, until):
    """Velocities after all jerks until a time, each found in fractions; how many there were."""
    m, e = list(map(Fraction, masses)), list(map(Fraction, restitutions))
    x, v = [Fraction(0), Fraction(1, 2), Fraction(1)], [Fraction(0), Fraction(0), Fraction(1)]
    time, count, last = Fraction(0), 0, -1
    while True:
        due = [
            ((Fraction(LONG) - (x[k + 1] - x[k])) / (v[k + 1] - v[k]), k)
            for k in (0, 1)
            if k != last and v[k + 1] > v[k]
        ]
        if not due or time + min(due)[0] > until:
            return v, count
        after, last = min(due)
        time, count, x = time + after, count + 1, [a + b * after for a, b in zip(x, v, strict=True)]
        a, b, closing = m[last], m[last + 1], v[last + 1] - v[last]
        v[last] += (1 + e[last]) * closing * b / (a + b)
        v[last + 1] -= (1 + e[last]) * closing * a / (a + b)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10, 1e-12])
def test_strings_that_jerk_without_end_hold_their_bodies_together(tolerance):
    masses = (1.0, 0.05, 1.0)
    found = play(on_strings(masses, (0.3, 0.3)), {O.VELOCITIES, O.TRAJECTORY}, tolerance, times=(1.0,))
    together = masses[2] / sum(masses)
    for value, error in zip(
        components(found.observed["velocities"]), components(found.errors["velocities"]), strict=True
    ):
        assert abs(value - together) <= error <= 2e-8
    assert found.warnings == ()


@pytest.mark.parametrize("middle", [0.05, 0.2, 1.0, 5.0])
@pytest.mark.parametrize("restitutions", [(0.9, 0.9), (1.0, 0.6), (1.0, 1.0)])
def test_strings_that_jerk_in_turn_until_all_fly_together_or_apart(middle, restitutions):
    masses = (1.0, middle, 1.0)
    truth, count = jerks(masses, restitutions, 1)
    assert count > 1
    found = play(on_strings(masses, restitutions), {O.VELOCITIES})
    for value, error, true in zip(
        components(found.observed["velocities"]), components(found.errors["velocities"]), truth, strict=True
    ):
        assert abs(value - float(true)) <= error <= 1e-9


def test_jerks_that_hardly_end_are_refused():
    with pytest.raises(GuardFailed, match="in turn more than"):
        play(on_strings((13.0, 0.01, 93.0), (1.0, 0.38)), {O.VELOCITIES})
