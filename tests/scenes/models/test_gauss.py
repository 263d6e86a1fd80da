"""Gauss's quadrature: exact for polynomials, and honest about the rest."""

import math

import pytest

from corollary.scenes.models.gauss import integral, nodes


@pytest.mark.parametrize("n", [12, 18, 27, 40, 60, 90, 135])
def test_n_nodes_integrate_degree_two_n_minus_one(n):
    assert math.fsum(w for _, w in nodes(n)) == pytest.approx(2.0, abs=3e-15)
    for degree in (2, 2 * n - 2):
        assert math.fsum(w * x**degree for x, w in nodes(n)) == pytest.approx(2.0 / (degree + 1), abs=2e-15)


def test_the_error_estimate_is_of_the_order_of_the_error():
    value, error, spent = integral(math.exp, 0.0, 1.0)
    assert value == pytest.approx(math.e - 1.0, rel=1e-15)
    assert spent == 30
    rough, error, spent = integral(math.sqrt, 0.0, 1.0)
    assert abs(rough - 2.0 / 3.0) < error < 1e-5
    assert spent == sum((12, 18, 27, 40, 60, 90, 135))
