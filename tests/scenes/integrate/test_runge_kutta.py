"""One step of a table: order conditions, the counted order on a smooth oscillator, and an honest opinion about the error."""

import math

import pytest

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.fixed_step import RK4
from corollary.scenes.integrate.runge_kutta import error_estimate, step


def oscillator(_, y):
    return [y[1], -y[0]]


def error_after(table, steps):
    y, h = [1.0, 0.0], 2.0 / steps
    for i in range(steps):
        y, _ = step(table, oscillator, i * h, y, h, oscillator(0.0, y))
    return math.hypot(y[0] - math.cos(2.0), y[1] + math.sin(2.0))


@pytest.mark.parametrize("table", [DOP853, RK4])
def test_every_row_adds_up_to_its_node_and_the_result_to_one(table):
    for node, row in zip(table.nodes, table.rows, strict=True):
        # The larger the weights, the more of their sum is rounding.
        assert sum(row.weights) == pytest.approx(node, abs=4e-16 * (1.0 + sum(map(abs, row.weights))))
    assert sum(table.result.weights) == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("table", [DOP853, RK4])
def test_powers_of_time_are_integrated_exactly_up_to_the_order(table):
    for power in range(table.order):
        (end,), _ = step(table, lambda x, _, n=power: [x**n], 0.0, [0.0], 1.0, [0.0**power])
        assert end == pytest.approx(1.0 / (power + 1), abs=3e-15)
    (end,), _ = step(table, lambda x, _: [x**table.order], 0.0, [0.0], 1.0, [0.0])
    assert abs(end - 1.0 / (table.order + 1)) > 1e-12


@pytest.mark.parametrize(("table", "coarse"), [(DOP853, 4), (RK4, 32)])
def test_halving_the_step_gains_two_to_the_order(table, coarse):
    gain = math.log2(error_after(table, coarse) / error_after(table, 2 * coarse))
    assert table.order - 0.4 < gain < table.order + 0.8


def test_the_estimate_is_above_the_error_of_a_step_without_being_absurd():
    y = [1.0, 0.0]
    for h in (0.5, 1.0):
        after, slopes = step(DOP853, oscillator, 0.0, y, h, oscillator(0.0, y))
        error = math.hypot(after[0] - math.cos(h), after[1] + math.sin(h))
        size = error_estimate(DOP853, slopes, h, [1.0, 1.0])
        assert error < size < 1e5 * error


def test_no_force_no_error():
    after, slopes = step(DOP853, lambda _, y: [0.0], 0.0, [3.0], 0.7, [0.0])
    assert after == [3.0]
    assert error_estimate(DOP853, slopes, 0.7, [1.0]) == 0.0
