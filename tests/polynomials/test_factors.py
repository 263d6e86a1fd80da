"""Factors of polynomials, of coefficients and exponents of any size."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.formula.syntax import author_formula
from corollary.polynomials.polynomial import context, factored
from corollary.polynomials.polynomial_signs import Signs
from corollary.polynomials.translate import Translation, sign_by_factors

LETTERS = context(("a", "b"))
POSITIVE = (Fraction(0), None)


@st.composite
def polynomials(draw: st.DrawFn):
    bits = draw(st.sampled_from([2, 30, 62, 64, 70, 300]))
    terms = st.dictionaries(
        st.tuples(st.integers(0, 3), st.integers(0, 2)), st.integers(-(2**bits), 2**bits), max_size=3
    )
    return LETTERS.from_dict(draw(terms))


@settings(max_examples=150, deadline=None)
@given(polynomials(), polynomials(), st.integers(1, 2))
def test_the_product_of_the_factors_is_the_polynomial(one, other, exponent):
    whole = one * other**exponent
    content, factors = factored(whole)
    made = LETTERS.constant(content)
    for factor, power in factors:
        made *= factor**power
    assert made == whole


@pytest.mark.parametrize("size", [2**31, 2**63, 10**40, 10**400])
def test_the_sign_is_told_by_factors_of_any_size(size):
    a, b = LETTERS.gen(0), LETTERS.gen(1)
    whole = -((a + LETTERS.constant(size) * b) ** 3) * (LETTERS.constant(size + 1) * a + b)
    whole *= LETTERS.constant(size - 1) * a + LETTERS.constant(size) * b
    assert sign_by_factors(whole, Signs({"a": POSITIVE, "b": POSITIVE})) == -1
    assert sign_by_factors(whole, Signs({"a": POSITIVE})) == 0


def test_roots_with_large_constants_are_translated():
    tree = author_formula(
        "x = sqrt((12345678901234567890*a + b)*(a + 98765432109876543210123*b)*(3*a + 98765432109876543210121*b))"
    )
    translation = Translation([tree], {"a": POSITIVE, "b": POSITIVE})
    translation.equation(tree)
    assert translation.known["#0"] == POSITIVE
