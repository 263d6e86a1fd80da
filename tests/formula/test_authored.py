"""What an author types in Python is the number, the formula and the condition that is taken: nothing is dropped, nothing guessed."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from corollary.formula.authored import NotTyped, as_condition, as_expression
from corollary.formula.ball import RationalPi, Undefined, evaluate, holds
from corollary.formula.from_sympy import NoTree, relation, tree

a, b, c = letters = sympy.symbols("a b c", positive=True)
WITHOUT_FORM = (
    sympy.I,
    sympy.nan,
    sympy.zoo,
    sympy.oo,
    -sympy.oo,
    sympy.Piecewise,
    sympy.frac,
    sympy.sign,
    sympy.EulerGamma,
)
POINTS = [
    dict(zip("abc", map(Fraction, each), strict=True))
    for each in (("3/7", "8/5", "11/3"), ("2", "5/4", "1/9"))
]

numbers = st.one_of(
    st.integers(-9, 9).map(sympy.Integer),
    st.fractions(-9, 9, max_denominator=12).map(
        lambda each: sympy.Rational(each.numerator, each.denominator)
    ),
    st.decimals(-9, 9, places=2).filter(bool).map(lambda each: sympy.Float(float(each))),
    st.sampled_from([sympy.pi, sympy.E]),
)
strange = st.sampled_from([sympy.I, sympy.oo, sympy.nan, sympy.zoo, sympy.frac(a), sympy.sign(a - b), sympy.EulerGamma,
                           sympy.Piecewise((a, a > b), (b, True))])  # fmt: skip
functions = st.sampled_from(
    [sympy.sin, sympy.cos, sympy.tan, sympy.exp, sympy.atan, sympy.sinh, sympy.tanh, sympy.Abs, sympy.sqrt, sympy.log, sympy.cot, sympy.sec, sympy.asin]
)  # fmt: skip
exponents = st.sampled_from(
    [2, -1, sympy.Rational(1, 2), sympy.Rational(-3, 2), 0.5, -1.5, sympy.Float(2.0), sympy.pi, a]
)


def grown(inner):
    return st.one_of(
        st.lists(inner, min_size=2, max_size=3).map(lambda each: sympy.Add(*each)),
        st.lists(inner, min_size=2, max_size=3).map(lambda each: sympy.Mul(*each)),
        st.tuples(inner, inner)
        .filter(lambda each: each[1] != 0 and each[1] != sympy.Float(0.0))
        .map(lambda each: each[0] / each[1]),
        st.tuples(inner, exponents).map(lambda each: each[0] ** each[1]),
        st.tuples(functions, inner).map(lambda each: each[0](each[1])),
        st.tuples(inner, inner).map(lambda each: sympy.atan2(*each)),
    )


def expressions(leaves):
    return st.recursive(st.one_of(st.sampled_from(letters), leaves), grown, max_leaves=6)


def as_typed(number):
    """The shortest decimal of a double; of sums such as 0.1 + 0.2, whose last figures are rounding, fourteen figures."""
    shortest = repr(number)
    figures = shortest.partition("e")[0].lstrip("-0.").replace(".", "")
    return shortest if len(figures) <= 15 else f"{number:.14g}"


def by_sympy(expression, point):
    """Worked out by sympy alone, with the decimals as they were typed."""
    typed = {each: sympy.Rational(as_typed(float(each))) for each in expression.atoms(sympy.Float)}
    at = {
        letter: sympy.Rational(point[letter.name].numerator, point[letter.name].denominator)
        for letter in letters
    }
    return expression.xreplace(typed).subs(at).evalf(25)


def ours(formula, point):
    return evaluate(formula, {name: RationalPi(value) for name, value in point.items()}, 200)


@given(expressions(numbers))
def test_an_expression_and_its_formula_have_the_same_value(expression):
    try:
        formula = tree(as_expression(expression))
    except (NotTyped, NoTree):
        # only what has no form, a function of a decimal that sympy has rounded already, or a complex number
        rounded = any(
            len(repr(float(each)).strip("-0.").replace(".", "")) > 14
            for each in expression.atoms(sympy.Float)
        )
        assert (
            rounded
            or expression.has(*WITHOUT_FORM)
            or not all(by_sympy(expression, each).is_real for each in POINTS)
        )
        return
    compared = 0
    for point in POINTS:
        try:
            ball = ours(formula, point)
        except Undefined:
            continue
        expected = by_sympy(expression, point)
        if ball.is_finite() and expected.is_real and expected.is_finite:
            difference = abs(sympy.Float(ball.str(30, radius=False), 30) - expected)
            assert difference <= 1e-15 * max(1, abs(expected)), (expression, formula)
            compared += 1
    assume(compared)


@given(
    expressions(numbers),
    strange,
    st.sampled_from(
        [sympy.Add, sympy.Mul, lambda x, y: x**y, lambda x, y: y**x, lambda x, y: sympy.sin(x) / y]
    ),
)
def test_what_has_no_form_is_refused_wherever_it_stands(expression, without, put):
    whole = put(expression, without)
    assume(whole.has(*WITHOUT_FORM))
    with pytest.raises((NotTyped, NoTree)):
        tree(as_expression(whole))


@given(
    expressions(numbers),
    expressions(numbers),
    st.sampled_from([sympy.Lt, sympy.Le, sympy.Gt, sympy.Ge, sympy.Eq, sympy.Ne]),
)
def test_a_relation_and_its_formula_are_true_together(left, right, sign):
    assume(not left.has(*WITHOUT_FORM) and not right.has(*WITHOUT_FORM))
    try:
        stated = as_condition(sign(left, right))
        found = relation(stated)
    except (NotTyped, NoTree, TypeError):
        return  # the sides are tried above; here those that have a form
    for point in POINTS:
        both = [by_sympy(side, point) for side in (left, right)]
        if not all(each.is_real and each.is_finite for each in both) or abs(both[0] - both[1]) < 1e-12:
            continue
        try:
            held = holds(found, {name: RationalPi(value) for name, value in point.items()})
        except Undefined:
            continue
        assert held is bool(sign(*both)), (stated, found)


@given(
    st.decimals(allow_nan=False, allow_infinity=False, min_value=Decimal("1e-30"), max_value=Decimal("1e30"))
)
def test_a_decimal_of_fifteen_figures_is_the_number_that_was_typed(number):
    text = f"{number:.14e}"
    assert as_expression(float(text)) == sympy.Rational(text)
    assert as_expression(float(text) * a) == sympy.Rational(text) * a
    assert as_expression(Decimal(text)) == sympy.Rational(text)


@pytest.mark.parametrize(
    ("typed", "exact"),
    [
        (1.2, "6/5"), (0.1, "1/10"), (6.67430e-11, "6.67430e-11"), (2.0, "2"), (10**300, str(10**300)),
        (Fraction(1, 3), "1/3"), (Decimal("0.12345678901234567890"), "0.12345678901234567890"), (np.float64(0.3), "3/10"),
        (np.float32(0.1), "1/10"), (np.int64(7), "7"), (9007199254740991.0, "9007199254740991"), (1 / 8, "1/8"), (0.1 * 3, "3/10"), (sympy.Float("0.1", 30), "1/10"),
    ],
)  # fmt: skip
def test_every_kind_of_number_is_read_as_typed(typed, exact):
    assert as_expression(typed) == sympy.Rational(exact)


@pytest.mark.parametrize(
    ("made", "remedy"),
    [
        (1 / 3, "Rational(1, 3)"), (2**0.5, "sqrt(2)"), (math.pi, "1*pi"), (math.pi / 180 * 1.0, "Rational(1, 180)*pi"),
        (math.sqrt(0.3), "sqrt(Rational(3, 10))"), (math.exp(0.1), "exact formula"), (math.nan, "a number"), (1j, "complex"),
        (1 / 3 * a, "Rational(1, 3)"), (a**0.5 * 2**0.5, "sqrt(2)"), (sympy.sin(0.3) * a, "exact formula"), (a * 1j, "complex"),
        (a / sympy.Integer(0), "a number"), (sympy.zoo * a, "a number"), (sympy.sqrt(-2) * a, "complex"),
        ("1.2*a", "without quotation marks"), (True, "a truth"), (a > b, "a condition"), (None, "a number"), ([1.2], "a number"),
        (np.array([0.1, 0.2]), "a number"), (np.True_, "a number"), (sympy.Matrix([1]), "a number"), (a & b, "a condition"),
    ],
)  # fmt: skip
def test_what_is_no_number_that_was_typed_is_refused(made, remedy):
    with pytest.raises((NotTyped, TypeError)) as raised:
        as_expression(made)
    assert remedy in str(raised.value)


@pytest.mark.parametrize("made", [a, 1.2, "a > b", None, 1, (a > b, b > c), [a > b]])
def test_what_is_no_condition_is_refused(made):
    with pytest.raises(TypeError) as raised:
        as_condition(made)
    assert "is not a condition; write a relation" in str(raised.value)


def test_the_decimals_of_joined_conditions_are_exact():
    stated = as_condition(sympy.And(a > 1.2 * b, sympy.Or(a**0.5 < 0.1, sympy.Eq(c, 2.5))))
    half, tenth = sympy.Rational(1, 2), sympy.Rational(1, 10)
    assert stated == sympy.And(
        a > sympy.Rational(6, 5) * b, sympy.Or(a**half < tenth, sympy.Eq(c, sympy.Rational(5, 2)))
    )
