"""The orders of the regularised methods on one contact: as promised, damped or not, head-on or glancing."""

import math

import pytest
from trade.contact_orders import (
    ASIDE,
    DAMPINGS,
    SAMPLINGS,
    Sampling,
    chapters,
    least_order,
    order_on,
)
from trade.measures import at_the_fine_end, fitted


def test_the_classical_method_has_order_four_on_every_contact():
    least, aside, eta = least_order("regularised_rk4")
    assert least.high >= 4.0, (least, aside, eta)
    assert least.value > 3.99, (least, aside, eta)
    assert least.high - least.low < 0.05


def test_the_method_of_order_eight_has_order_eight_on_every_contact():
    least, aside, eta = least_order("regularised_dop853")
    assert least.low >= 8.0, (least, aside, eta)


def test_the_family_holds_what_is_promised_of_it():
    assert {0.0, 0.5, 1.0, 5.0} == set(DAMPINGS)
    assert min(ASIDE) == 0.0
    assert max(ASIDE) >= 0.9


def test_a_hit_that_misses_and_counts_too_coarse_have_no_order():
    with pytest.raises(ValueError, match="never meet"):
        order_on(chapters(1.01, 0.0), SAMPLINGS["regularised_rk4"])
    with pytest.raises(ValueError, match="Only"):
        order_on(chapters(0.45, 5.0), Sampling(SAMPLINGS["regularised_dop853"].table, (2, 3, 4, 5), 1.0))


@pytest.mark.parametrize("bend", [-2.0, -1.0, 2.0])
def test_a_bent_line_is_followed_to_its_fine_end(bend):
    steps = [0.1 * 2.0 ** (-i / 3.0) for i in range(12)]
    points = [(h, 3.0 * h**4 * (1.0 + bend * h)) for h in steps]
    assert abs(fitted(points).value - 4.0) > 0.03
    assert at_the_fine_end(points).value == pytest.approx(4.0, abs=0.02)


def test_scatter_is_not_taken_for_a_bend():
    points = [(2.0**-i, 8.0**-i * math.exp(0.5 * math.sin(17.0 * i))) for i in range(12)]
    assert at_the_fine_end(points) == fitted(points)
