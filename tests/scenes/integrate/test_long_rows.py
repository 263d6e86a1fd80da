"""Rows of up to 200 balls: against another method that knows nothing of contacts, conservation, and ends in bounded time."""

import math
from itertools import pairwise

import numpy as np
import pytest

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate.regularised import collide
from corollary.scenes.row import RowOfBodies

pytestmark = pytest.mark.whole

integrate = pytest.importorskip("scipy.integrate")


def cradle(count, q, tail=0.0):
    velocities = (1.0, *(0.0,) * (count - 1))
    return RowOfBodies((1.0,) * count, velocities, (tail,) * (count - 1), (Contact(1.0, q),) * (count - 1))


def in_plain_time(line, until, tolerance):
    """Newton's second law for places and velocities, by scipy; no contact is located."""
    count, q, k = len(line.masses), line.contacts[0].q, line.contacts[0].k
    apart = np.array(line.gaps)

    def law(_, y):
        overlap = np.maximum(y[: count - 1] - y[1:count] - apart, 0.0)
        push = k * overlap**q
        gained = np.zeros(count)
        gained[:-1] -= push
        gained[1:] += push
        return np.concatenate([y[count:], gained])

    start = np.concatenate([np.zeros(count), line.velocities])
    found = integrate.solve_ivp(
        law, (0.0, until), start, "DOP853", rtol=tolerance, atol=tolerance, max_step=0.5
    )
    return found.y[count:, -1]


@pytest.mark.parametrize("q", [1.0, 1.5, 3.0])
@pytest.mark.parametrize("count", [50, pytest.param(200, marks=pytest.mark.whole)])
def test_long_cradles_agree_with_plain_time(count, q):
    found = collide(cradle(count, q), 1e-11)
    assert found.outcome == "released"
    other = in_plain_time(cradle(count, q), 1.02 * found.duration, 1e-10)
    # scipy's tolerance is not its error, which is up to several thousand times as large here (found by tightening it).
    assert np.abs(np.array(found.velocities) - other).max() < 1e-6
    assert math.fsum(found.velocities) == pytest.approx(1.0, abs=1e-13)
    assert math.fsum(v * v for v in found.velocities) == pytest.approx(1.0, abs=1e-9)
    assert all(a <= b + 1e-10 for a, b in pairwise(found.velocities))


def test_a_finer_step_only_changes_what_the_coarser_one_left_open():
    """Also where an overlap nearly ends within a step in time: its own variable takes over before."""
    coarse, fine = (collide(cradle(20, 1.5), tolerance) for tolerance in (1e-12, 1e-15))
    assert max(abs(a - b) for a, b in zip(coarse.velocities, fine.velocities, strict=True)) < 5e-12
    assert coarse.duration == pytest.approx(fine.duration, rel=1e-11)
    assert coarse.overlaps == pytest.approx(fine.overlaps, abs=1e-11)


def test_wide_gaps_hand_the_speed_on_ball_by_ball():
    found = collide(cradle(60, 1.5, tail=1e3), 1e-12)
    assert found.openings == 59
    assert found.velocities[-1] == pytest.approx(1.0, abs=1e-10)


@pytest.mark.parametrize("q", [1.001, 1.37, 9.999])
def test_broken_exponents_in_a_long_row(q):
    found = collide(cradle(60, q), 1e-10)
    assert math.fsum(v * v for v in found.velocities) == pytest.approx(1.0, abs=3e-9)
    assert all(a <= b + 1e-9 for a, b in pairwise(found.velocities))
