"""One undamped contact against the integrals it stands for, in many digits: with weight on a floor and without."""

import math

import mpmath as mp
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.derive.ready_scenes import run
from corollary.scenes.models.two_bodies import contact_time, largest_overlap

sizes = st.floats(1e-6, 1e6)


@pytest.mark.parametrize("q", [1.0, 1.25, 1.5, 2.0, 3.7, 10.0])
def test_the_time_is_the_integral_of_the_inverse_speed(q):
    # x = 1 - y^2 takes the singularity out of the upper end.
    mp.mp.dps = 50
    p = mp.mpf(q) + 1
    integral = mp.quad(
        lambda y: 2 * y / mp.sqrt(1 - (1 - y * y) ** p) if y > 1e-12 else 2 / mp.sqrt(p), [0, 1]
    )
    depth = largest_overlap(2.0, 3.0, q, 5.0)
    assert contact_time(2.0, 3.0, q, 5.0) * 5.0 / depth == pytest.approx(float(2 * integral), rel=1e-15)


def test_known_values():
    assert contact_time(1.0, 1.0, 1.0, 1.0) == pytest.approx(math.pi, rel=1e-15)
    # Hertz: 2.94 (delta/v), and 2.87 (m^2/(R E^2 v))^(1/5) in the literature's form with k = 4/3 E sqrt(R/…).
    factor = contact_time(1.0, 1.0, 1.5, 1.0) / largest_overlap(1.0, 1.0, 1.5, 1.0)
    assert factor == pytest.approx(2.943275, abs=5e-7)
    assert factor * (15.0 / 16.0) ** 0.4 == pytest.approx(2.8683, abs=5e-5)


@given(sizes, sizes, st.floats(1.0, 10.0), sizes)
def test_dimensions(m, k, q, v):
    assert 0.5 * m * v**2 == pytest.approx(
        k * largest_overlap(m, k, q, v) ** (q + 1.0) / (q + 1.0), rel=1e-12
    )
    assert contact_time(2.0 * m, 2.0 * k, q, v) == pytest.approx(contact_time(m, k, q, v), rel=1e-12)


@given(sizes, sizes, st.floats(1e-3, 1e3), st.floats(1e-3, 1e3))
def test_a_springs_contact_lasts_as_long_at_any_speed(m, k, v, w):
    assert contact_time(m, k, 1.0, v) == pytest.approx(contact_time(m, k, 1.0, w), rel=1e-12)


CASES = [
    (1e6, 1.5, 0.1, 2.8, 9.8),
    (1e6, 1.23, 0.1, 2.8, 9.8),
    (1e4, 1.0, 0.5, 0.01, 9.8),
    (1e6, 3.0, 0.1, 0.001, 9.8),
    (1e-3, 1.5, 1e6, 1e-9, 9.8),
    (1e9, 7.1, 1e-3, 1e4, 1e-6),
]


@pytest.mark.parametrize(("k", "q", "m", "v", "g"), CASES)
def test_with_weight_every_value_is_within_its_bound_of_a_quadrature_in_50_digits(k, q, m, v, g):
    mp.mp.dps = 50
    k_, q_, m_, v_, g_ = (mp.mpf(x) for x in (k, q, m, v, g))
    found = run("ball_on_floor", {"k": k, "q": q, "m": m, "v0": -v, "g": g, "R": 1.0, "y0": 1.0})
    assert found.error_is == "bound"

    def square(x):
        return v_**2 + 2 * g_ * x - 2 * k_ * x ** (q_ + 1) / ((q_ + 1) * m_)

    deepest = mp.findroot(square, mp.mpf(found.observed["largest_overlap"]))
    # x = deepest (1 - y^2) takes the singularity out of the upper end; so near to it that digits cancel, it is a square itself.
    slope = 2 * k_ * deepest**q_ / m_ - 2 * g_

    def pace(y):
        return (
            2 * deepest * y / mp.sqrt(square(deepest * (1 - y * y)))
            if y > 1e-12
            else 2 * mp.sqrt(deepest / slope)
        )

    # The bound is the integral's in arb; Gauss-Legendre with 50 digits is right to about 1e-24 of it.
    lasts = 2 * mp.quad(pace, [0, mp.mpf("0.5"), mp.mpf("0.9"), 1])
    true = {"largest_overlap": deepest, "peak_force": k_ * deepest**q_, "duration": lasts}
    true["impulse"] = 2 * m_ * v_ + m_ * g_ * lasts
    for name, value in true.items():
        assert abs(mp.mpf(found.observed[name]) - value) <= found.errors[name] * (1 + 1e-6), name
        assert found.errors[name] <= 2.3e-16 * value, name


@given(
    st.floats(1e2, 1e8), st.sampled_from([1.0, 1.5, 2.0, 3.0]), st.floats(0.01, 10.0), st.floats(0.1, 30.0)
)
@settings(max_examples=40, deadline=None)
def test_weight_makes_the_contact_deeper_and_without_it_beta_functions_hold(k, q, m, v):
    def bounce(g):
        return run("ball_on_floor", {"k": k, "q": q, "m": m, "v0": -v, "g": g, "R": 1.0, "y0": 1.0}).observed

    assert bounce(9.8)["largest_overlap"] > bounce(0.0)["largest_overlap"]
    assert bounce(1e-13 * v)["duration"] == pytest.approx(contact_time(m, k, q, v), rel=1e-9)
