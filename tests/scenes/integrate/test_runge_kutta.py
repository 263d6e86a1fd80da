"""One step of a table: order conditions, and the counted order on a smooth oscillator."""

import math

import pytest

from corollary.grading.programs.fixed_step import RK4
from corollary.scenes.integrate.runge_kutta import DOP853, step


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
