"""Bodies that gain or lose mass: the integrated laws against many small steps."""

import math

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from corollary.laws import burnt, impulse_of_growing_weight
from corollary.laws.law import sides


@given(st.floats(0.05, 0.95), st.floats(100, 5000))
def test_the_rocket_equation_is_the_sum_of_small_puffs(share, speed):
    ((_, found),) = sides(burnt(v_0=0, v_1=sympy.Symbol("v"), v_rel=speed, m_0=1, m_1=share))
    puffs = 2000
    step = (1 - share) / puffs
    summed = math.fsum(speed * step / (1 - (i + 0.5) * step) for i in range(puffs))
    assert float(found) == pytest.approx(summed, rel=1e-4)


@given(st.integers(1, 20), st.integers(1, 20), st.integers(1, 9))
def test_the_impulse_of_a_growing_weight_is_its_mean_times_the_time(m, R, t):
    m, R, t = map(sympy.Integer, (m, R, t))
    ((_, impulse),) = sides(impulse_of_growing_weight(sympy.Symbol("J"), m=m, R=R, g=sympy.Integer(10), t=t))
    assert impulse == 10 * (m + (m + R * t)) / 2 * t
