"""Rows that damping brings to rest: what is said to touch for ever does, and what parts is not said to."""

import math
from random import Random

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.regularised import LaidOut, state_of
from corollary.scenes.integrate.row_motion import TOO_LONG
from corollary.scenes.integrate.row_rest import creep, lasts_at_least, stays
from corollary.scenes.line_collision import collide
from corollary.scenes.row import RowOfBodies, in_units, natural_units
from corollary.scenes.run import GuardFailed

pytestmark = pytest.mark.whole

FADED = 1e-6


def least_overlap(line, q, eta):
    """The least share of its first size that any overlap has until the largest has faded to FADED, by an implicit method."""
    inverse = np.array([1.0 / m for m in line.masses])
    count = len(line.gaps)

    def slope(_, y):
        deep, speeds = y[:count], y[count:]
        rates = speeds[:-1] - speeds[1:]
        force = np.array([0.0, *(np.maximum(deep, 0.0) ** q + eta * rates), 0.0])
        return [*rates, *((force[:-1] - force[1:]) * inverse)]

    def faded(_, y):
        return y[:count].max() - FADED * start[:count].max()

    def opened(_, y):
        return y[:count].min()

    faded.terminal = opened.terminal = True
    start = np.array([*(-gap for gap in line.gaps), *line.velocities])
    found = solve_ivp(slope, (0.0, 1e6), start, "Radau", events=(faded, opened), rtol=1e-6, atol=1e-13)
    assert found.status >= 0
    return min(found.y[:count, -1]) / max(found.y[:count, -1])


def drawn(seed):
    """Three to five bodies, alike or not, that part slowly: about as the dashpots let them, or twice as fast."""
    draw = Random(seed)
    count = draw.choice((3, 4, 5))
    q, eta = draw.choice((1.0, 1.2, 1.5, 2.0)), 10.0 ** draw.uniform(0.0, 2.0)
    masses = [10.0 ** draw.uniform(-1.0, 0.3) for _ in range(count)]
    if draw.random() < 0.3:
        masses[draw.choice((0, -1))] = math.inf
    deep = [10.0 ** draw.uniform(-1.5, 0.0) for _ in range(count - 1)]
    rates = [-(d**q) / eta * draw.uniform(1.0, 1.02) for d in deep]
    speeds = [0.0, *(-sum(rates[: i + 1]) for i in range(count - 1))]
    if masses[-1] == math.inf:
        speeds = [v - speeds[-1] for v in speeds]
    contacts = (Contact(1.0, q, eta),) * (count - 1)
    return RowOfBodies(tuple(masses), tuple(speeds), tuple(-d for d in deep), contacts), q, eta


def test_what_is_said_to_touch_for_ever_does():
    said = parts = 0
    for seed in range(40):
        line, q, eta = drawn(seed)
        y, touching, row = state_of(line)
        holds, left = creep(y, touching, row, FADED), least_overlap(line, q, eta)
        assert left > 0.0 or not holds
        said, parts = said + holds, parts + (left <= 0.0)
    assert said > 10
    assert parts > 3


@pytest.mark.parametrize("q", [1.0, 1.05, 1.5, 2.0, 5.0])
@pytest.mark.parametrize("eta", [1e3, 1e5])
def test_three_bodies_that_damping_holds_together_go_on_as_one(q, eta):
    line = RowOfBodies((1.0, 2.0, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0), (Contact(1e4, q, eta),) * 2)
    found = collide(line, 1e-10)
    assert found.result.outcome == "sticks"
    assert found.result.duration == math.inf
    assert found.result.velocities == pytest.approx((0.25,) * 3, abs=1e-9)
    assert found.spent < 200_000


def test_three_bodies_meet_one_after_the_other_and_stay():
    line = RowOfBodies((1.0, 2.0, 1.0), (1.0, 0.0, 0.0), (0.8, 0.8), (Contact(1e4, 1.5, 1e3),) * 2)
    found = collide(line, 1e-10)
    assert found.result.outcome == "sticks"
    assert found.result.velocities == pytest.approx((0.25,) * 3, abs=1e-9)


def test_who_comes_too_late_for_so_short_steps_is_told_of_soon():
    line = RowOfBodies((1.0, 2.0, 1.0), (1.0, 0.0, 0.0), (0.0, 100.0), (Contact(1e4, 1.5, 1e4),) * 2)
    with pytest.raises(GuardFailed, match=r"does not end within .* less damping"):
        collide(line, 1e-10)
    y = [0.3, 1e-3, 0.3 + 1e-9, -100.0, 0.0]
    _, _, row = state_of(line)
    assert lasts_at_least(y, [True, False], row, 1e-12) == pytest.approx(0.5 * 100.0 / 0.3)
    assert not stays(y, [True, False], row, 1e-12)
    y[-1] = 0.3
    assert stays(y, [True, False], row, 1e-8)


def test_a_wall_holds_the_far_end_of_what_creeps():
    for masses in ((math.inf, 1.0, 2.0), (2.0, 1.0, math.inf)):
        speeds = (0.0, 0.0, -1.0) if masses[0] == math.inf else (1.0, 0.0, 0.0)
        found = collide(RowOfBodies(masses, speeds, (0.0, 0.0), (Contact(1e4, 1.5, 1e3),) * 2), 1e-10)
        assert found.result.outcome == "sticks"
        assert found.result.velocities == pytest.approx((0.0,) * 3, abs=1e-9)


@pytest.mark.parametrize("q", [6.5, 9.0])
def test_what_has_flown_away_does_not_hide_that_the_rest_will_take_for_ever(q):
    """Two balls that come in together hit one 1e-11 times lighter: what is left between them squeezes them for 1e9 natural times."""
    line = RowOfBodies((36.4, 253.1, 3.8e-11), (1.0, 1.0, 0.0), (0.0, 0.0), (Contact(1e4, q),) * 2)
    laid = LaidOut(in_units(line, natural_units(line)), False)
    y = laid.start.copy()
    seen, _, _ = laid.kernel(
        y, laid.touching, laid.row, laid.deepest, laid.hardest, 1e-13, 400_000, laid.room
    )
    assert seen[0] == TOO_LONG
    assert seen[4] < 30_000
