"""A ball on the floor, weight included, against an integral in 25 digits."""

import mpmath as mp
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.scenes.forces.contact import Contact
from corollary.scenes.models.beta import contact_time
from corollary.scenes.models.bounce import bounce

CASES = [
    (1e6, 1.5, 0.1, 2.8, 9.8),
    (1e6, 1.23, 0.1, 2.8, 9.8),
    (1e4, 1.0, 0.5, 0.01, 9.8),
    (1e6, 3.0, 0.1, 0.001, 9.8),
]


@pytest.mark.parametrize(("k", "q", "m", "v", "g"), CASES)
def test_against_mpmath(k, q, m, v, g):
    mp.mp.dps = 50
    k_, q_, m_, v_, g_ = (mp.mpf(x) for x in (k, q, m, v, g))
    found = bounce(Contact(k, q), m, v, g)

    def square(x):
        return v_**2 + 2 * g_ * x - 2 * k_ * x ** (q_ + 1) / ((q_ + 1) * m_)

    deepest = mp.findroot(square, mp.mpf(found.overlap))
    # x = deepest (1 - y^2) takes the singularity out of the upper end; so near to it that digits cancel, it is a square itself.
    slope = 2 * k_ * deepest**q_ / m_ - 2 * g_

    def pace(y):
        return (
            2 * deepest * y / mp.sqrt(square(deepest * (1 - y * y)))
            if y > 1e-10
            else 2 * mp.sqrt(deepest / slope)
        )

    half = mp.quad(pace, [0, 0.5, 1])
    assert found.overlap == pytest.approx(float(deepest), rel=1e-14)
    assert found.force == pytest.approx(float(k_ * deepest**q_), rel=1e-13)
    assert found.duration == pytest.approx(float(2 * half), rel=max(2e-14, 10 * found.doubt))


@given(st.floats(1e2, 1e8), st.floats(1.0, 6.0), st.floats(0.01, 10.0), st.floats(0.1, 30.0))
@settings(max_examples=40, deadline=None)
def test_weight_makes_the_contact_deeper_and_without_it_beta_functions_hold(k, q, m, v):
    heavy, light = bounce(Contact(k, q), m, v, 9.8), bounce(Contact(k, q), m, v, 0.0)
    assert heavy.overlap > light.overlap * (1.0 - 1e-14)
    faint = bounce(Contact(k, q), m, v, 1e-13 * v)
    assert faint.duration == pytest.approx(contact_time(m, k, q, v), rel=1e-9)
