"""The order of every fixed-step method, measured: not less than promised, and not more than the physics lets it have."""

import math
from itertools import pairwise

import pytest

from corollary.grading.programs.fixed_step import march
from corollary.trade.methods import METHODS


def pendulum(x, v):
    return [-math.sin(x[0])]


def pendulum_after(time):
    """The angle of x'' = -sin x, x(0) = 1, x'(0) = 0.3, by Jacobi's elliptic functions: sin(x/2) = k sn(t + t0 | k^2)."""
    import mpmath as mp

    with mp.workdps(30):
        k = mp.sqrt(mp.sin(mp.mpf("0.5")) ** 2 + mp.mpf("0.3") ** 2 / 4)
        start = mp.ellipf(mp.asin(mp.sin(mp.mpf("0.5")) / k), k**2)
        return float(2 * mp.asin(k * mp.ellipfun("sn", start + time, k=k)))


def cradle(q):
    def force(d):
        return d**q if d > 0.0 else 0.0

    def acceleration(x, v):
        left, right = force(x[0] - x[1]), force(x[1] - x[2])
        return [-left, left - right, right]

    return acceleration


def slopes(errors):
    return [math.log2(a / b) for a, b in pairwise(errors)]


@pytest.mark.parametrize(
    ("name", "order", "steps"),
    [
        ("euler_cromer", 1, (80, 160, 320)),
        ("velocity_verlet", 2, (40, 80, 160)),
        ("rk4", 4, (160, 320, 640)),
        ("yoshida4", 4, (80, 160, 320)),
        ("yoshida6", 6, (20, 40, 80)),
        ("yoshida8", 8, (40, 80, 160)),
    ],
)
def test_order_on_a_smooth_force(name, order, steps):
    exact = pendulum_after(4.0)
    errors = [
        abs(march(METHODS[name], pendulum, [1.0], [0.3], 4.0 / n, n).places[-1][0] - exact) for n in steps
    ]
    # The last halving is the asymptotic one; it may not promise more than half an order above the table.
    assert order - 0.25 < slopes(errors)[-1] < order + 0.5


def spread(method, q, steps, whole=6.0):
    """Final velocities for a handful of phases of the grid, so that the place of the kink in a step averages out."""
    runs = []
    for i in range(12):
        dt = whole / steps * (1.0 + 0.002 * i)
        runs.append(
            march(METHODS[method], cradle(q), [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], dt, steps).velocities[-1]
        )
    return runs


def root_mean_square(runs, reference):
    return math.sqrt(
        sum((a - b) ** 2 for run in runs for a, b in zip(run, reference, strict=True)) / len(runs)
    )


HERTZ = (-0.070952353651436871, 0.076403039071206993, 0.994549314580229878)
SPRING = (-0.130261695064523, 0.150229569434777, 0.980032125629746)


@pytest.mark.parametrize(("q", "reference"), [(1.0, SPRING), (1.5, HERTZ)])
def test_the_books_method_is_of_second_order_in_an_elastic_cradle(q, reference):
    """Euler-Cromer is leapfrog in disguise: read after the last opening its velocities are Verlet's."""
    errors = [root_mean_square(spread("euler_cromer", q, n), reference) for n in (200, 400, 800)]
    gain = math.log2(errors[0] / errors[2]) / 2.0
    assert 1.7 < gain < 2.3


def test_high_order_is_lost_where_the_force_is_not_smooth():
    """With q = 3/2 every method falls to order q + 1 = 5/2, whatever its table says."""
    errors = [root_mean_square(spread("yoshida6", 1.5, n), HERTZ) for n in (200, 400, 800)]
    gain = math.log2(errors[0] / errors[2]) / 2.0
    assert 2.1 < gain < 3.1


def test_evaluations_are_counted_and_a_shared_kick_is_paid_once():
    costs = [
        ("euler_cromer", 1, 0),
        ("velocity_verlet", 1, 1),
        ("rk4", 4, 0),
        ("yoshida4", 3, 1),
        ("yoshida8", 15, 1),
    ]
    for name, each, extra in costs:
        assert march(METHODS[name], pendulum, [1.0], [0.0], 0.1, 10).evaluations == 10 * each + extra


def test_a_splitting_keeps_momentum_to_the_last_digits():
    path = march(METHODS["yoshida4"], cradle(1.5), [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], 0.01, 600)
    for row in path.velocities:
        assert math.fsum(row) == pytest.approx(1.0, abs=600 * 2.3e-16)
