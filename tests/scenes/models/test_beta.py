"""One undamped contact in closed form, against the integral it closes."""

import math

import mpmath as mp
import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.scenes.models.beta import contact_time, duration_factor, largest_overlap, suggested_step

sizes = st.floats(1e-6, 1e6)


@pytest.mark.parametrize("q", [1.0, 1.25, 1.5, 2.0, 3.7, 10.0])
def test_the_factor_is_the_integral_of_the_inverse_speed(q):
    # x = 1 - y^2 takes the singularity out of the upper end.
    p = mp.mpf(q) + 1
    mp.mp.dps = 50
    integral = mp.quad(
        lambda y: 2 * y / mp.sqrt(1 - (1 - y * y) ** p) if y > 1e-12 else 2 / mp.sqrt(p), [0, 1]
    )
    assert duration_factor(q) == pytest.approx(float(2 * integral), rel=3e-15)


def test_known_values():
    assert duration_factor(1.0) == pytest.approx(math.pi, rel=1e-15)
    # Hertz: 2.94 (delta/v), and 2.87 (m^2/(R E^2 v))^(1/5) in the literature's form with k = 4/3 E sqrt(R/…).
    assert duration_factor(1.5) == pytest.approx(2.943275, abs=5e-7)
    assert duration_factor(1.5) * (15.0 / 16.0) ** 0.4 == pytest.approx(2.8683, abs=5e-5)


@given(sizes, sizes, st.floats(1.0, 10.0), sizes)
def test_dimensions(m, k, q, v):
    assert 0.5 * m * v**2 == pytest.approx(
        k * largest_overlap(m, k, q, v) ** (q + 1.0) / (q + 1.0), rel=1e-12
    )
    assert contact_time(2.0 * m, 2.0 * k, q, v) == pytest.approx(contact_time(m, k, q, v), rel=1e-12)
    assert suggested_step(m, k, q, v) == contact_time(m, k, q, v) / 100.0


@given(sizes, sizes, st.floats(1e-3, 1e3), st.floats(1e-3, 1e3))
def test_a_springs_contact_lasts_as_long_at_any_speed(m, k, v, w):
    assert contact_time(m, k, 1.0, v) == pytest.approx(contact_time(m, k, 1.0, w), rel=1e-12)
