"""Equal steps for many motions at once: each column is the motion it would be alone, at order 8."""

import math

import numpy as np
import pytest

from corollary.scenes.integrate.array_steps import power, stepped


@pytest.mark.parametrize("exponent", range(12))
def test_a_whole_power_is_a_power(exponent):
    values = np.array([0.0, 0.3, 1.0, 2.5])
    assert power(values, exponent) == pytest.approx(values**exponent, rel=1e-15)


def swing(pulls):
    return lambda _, state: (state[1], -pulls * state[0])


def test_each_column_is_its_own_motion_at_order_eight():
    pulls = np.array([1.0, 4.0, 9.0])
    start = np.stack([np.ones(3), np.zeros(3)])
    exact = np.cos(np.sqrt(pulls) * 3.0)
    errors = [np.abs(stepped(swing(pulls), start, 3.0, steps)[0] - exact) for steps in (6, 12)]
    gains = np.log2(errors[0] / errors[1])
    assert np.all((gains > 7.0) & (gains < 10.0))
    alone = stepped(swing(pulls[1:2]), start[:, 1:2], 3.0, 12)
    assert alone[:, 0] == pytest.approx(stepped(swing(pulls), start, 3.0, 12)[:, 1], rel=1e-14)


def test_what_goes_wrong_in_one_column_stays_there():
    def slope(x, state):
        return (np.where(np.arange(3) == 1, np.nan, state[0]),)

    found = stepped(slope, np.ones((1, 3)), 1.0, 4)[0]
    assert np.isnan(found).tolist() == [False, True, False]
    assert found[0] == pytest.approx(math.e, rel=1e-9)
