import math
import random

import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import outlook, regularised
from corollary.scenes.integrate.outlook import rough_steps
from corollary.scenes.row import RowOfBodies, caught_between, in_units, natural_units
from corollary.scenes.run import GuardFailed

pytestmark = pytest.mark.whole


def followed(line, tolerance):
    return regularised.LaidOut(line, compiled=False).follow(tolerance)


def row_of(masses, gaps=None, q=1.5):
    count = len(masses)
    line = RowOfBodies(
        tuple(masses),
        (1.0,) + (0.0,) * (count - 1),
        gaps or (0.0,) * (count - 1),
        (Contact(1.0, q),) * (count - 1),
    )
    return in_units(line, natural_units(line))


@pytest.mark.parametrize(("seed", "q"), [(1, 1.5), (2, 1.5), (3, 3.0), (4, 2.0)])
def test_rough_steps_are_a_tenth_to_a_half_of_those_that_are_followed(seed, q):
    rng = random.Random(seed)
    masses = [10.0 ** rng.uniform(-3.0, 0.0) for _ in range(5)]
    masses[2] = 1e-5
    line = row_of(masses, q=q)
    steps = followed(line, 1e-13).evaluations / 11
    assert 0.1 * steps < rough_steps(line, 40_000) < 0.5 * steps


def test_a_ball_thrown_between_a_wall_and_a_heavy_one_meets_them_as_often_as_hard_ones():
    """Elastic collisions of the two turn their state in a plane by twice the angle that tan = sqrt(m/M): pi over that angle in all."""
    for mass in (1e-4, 1e-6):
        contacts = (Contact(1e9, 1.5),) * 2
        line = RowOfBodies((math.inf, mass, 1.0), (0.0, 0.0, -1.0), (1.0, 1.0), contacts)
        hits = math.pi / math.atan(math.sqrt(mass))
        assert 5 * hits < rough_steps(in_units(line, natural_units(line)), 400_000) < 20 * hits


def test_what_flies_apart_takes_none():
    line = RowOfBodies((1.0, 1e-9, 1.0), (-1.0, 0.0, 1.0), (0.0, 0.0), (Contact(1.0, 1.5),) * 2)
    assert rough_steps(line, 10) == 0


def test_a_row_that_would_take_too_long_is_refused_after_few_steps_and_one_that_would_not_is_followed(
    monkeypatch,
):
    asked = []

    def follow(laid, tolerance, most):
        asked.append(most)
        return steps(laid, tolerance, most)

    steps = regularised.LaidOut._steps
    monkeypatch.setattr(regularised.LaidOut, "_steps", follow)
    with pytest.raises(GuardFailed, match="does not end"):
        followed(row_of((1.0, 1e-12) * 8), 1e-13)
    assert max(asked) <= regularised.FIRST_STEPS
    asked.clear()
    assert followed(row_of((1.0, 1e-4, 1.0)), 1e-13).outcome == "released"
    assert asked == [regularised.FIRST_STEPS, regularised.MOST_STEPS]


def test_rows_whose_balls_are_alike_damped_or_weighed_are_never_asked(monkeypatch):
    monkeypatch.setattr(outlook, "rough_steps", None)
    alike = row_of((1.0,) * 30)
    assert caught_between(alike.masses) == 1.0
    assert followed(alike, 1e-10).outcome == "released"
    damped = RowOfBodies((1.0, 1e-6, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1.0, 1.5, 5.0),) * 2)
    assert not regularised._may_throw(damped)
