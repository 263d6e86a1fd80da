"""Certified digits, held against an independent evaluation with very many digits."""

from __future__ import annotations

import math
import threading
from fractions import Fraction

import mpmath
import pytest
from flint import arb, ctx
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.ball import RationalPi, Undefined, certified, evaluate, holds, sign
from corollary.formula.syntax import author_formula

DIGITS = 1500  # r - b at scale 1e300 needs 600


def by_many_digits(tree: Expr, values: dict[str, RationalPi]):
    """The formula by mpmath, written without a look at the evaluation under test."""

    def of(part):
        return by_many_digits(part, values)

    match tree:
        case Number(value):
            return mpmath.mpf(value.numerator) / value.denominator
        case Name("pi"):
            return +mpmath.pi
        case Name(name):
            return (
                mpmath.mpf(values[name].ratio.numerator)
                / values[name].ratio.denominator
                * mpmath.pi ** values[name].pi
            )
        case Negative(term):
            return -of(term)
        case Sum(terms):
            return mpmath.fsum(map(of, terms))
        case Product(factors):
            return mpmath.fprod(map(of, factors))
        case Quotient(top, bottom):
            return of(top) / of(bottom)
        case Power(base, exponent):
            return of(base) ** of(exponent)
        case Call(function, arguments):
            named = {"ln": mpmath.log, "abs": abs, "min": min, "max": max}
            return named.get(function, getattr(mpmath, function, None))(*map(of, arguments))
        case Relation():
            raise AssertionError


def nearest(number) -> float:
    """The double nearest to a number of very many digits."""
    mantissa, power = number.man_exp  # without the sign
    exact = Fraction(int(mantissa)) * Fraction(2) ** int(power) * (-1 if number < 0 else 1)
    try:
        return float(exact)
    except OverflowError:
        return math.inf if exact > 0 else -math.inf


FORMULAS = [
    "m*v/dt",
    "((mA - mB)*vA + 2*mB*vB)/(mA + mB)",
    "-(1/2)*mA*mB/(mA + mB)*(1 - r^2)*(vA - vB)^2",
    "(1/2)*(mA + mB)*((mA*vA + mB*vB)/(mA + mB))^2 - (1/2)*mA*vA^2 - (1/2)*mB*vB^2",
    "mA/(mA + mB) - 1",
    "((mA - mB)/(mA + mB))^2*L",
    "(mA + mB)/mA*sqrt(2*mB*L)",
    "L*(1 - cos(r))",
    "sqrt(1 - r^2)",
    "acos(1 - r)",
    "-vA*ln(mA/mB)",
    "1 - exp(-pi*r/sqrt(1 - r^2))",
    "mA*sqrt(vA^2 + vB^2 + 2*vA*vB*cos(r))",
    "sqrt(vA^2 + mA*L^2/mB) - vA",
    "(mA/mB)^0.4*vA",
    "atan(mA/mB) + asin(r) - log10(mA)",
    "gamma(7/5)*(mA/mB)^(2/5)",
    "sinh(r) - r + tanh(r)*cosh(r)",
    "max(mA, mB) - min(mA, mB)",
    "atan2(vA, -vB)",
    "2*m*v*sin(r)",
    "L/(vA - vB)",
]
TREES = [author_formula(formula) for formula in FORMULAS]


def positive(low: int, high: int):
    """Decimals from 1e`low` to 1e`high`, evenly in their logarithm."""
    return st.builds(
        lambda digits, power: RationalPi(Fraction(digits) * Fraction(10) ** (power - 6)),
        st.integers(10**6, 10**7),
        st.integers(low, high),
    )


def near(one: Fraction):
    """Numbers that differ from `one` by 1e-16 to 0.1 of it."""
    return st.integers(1, 16).map(lambda power: RationalPi(one * (1 + Fraction(1, 10**power))))


def sets_of(sizes, ratio):
    names = ("m", "v", "dt", "mA", "mB", "vA", "vB", "L")
    return st.fixed_dictionaries(dict.fromkeys(names, sizes) | {"r": ratio})


broken = st.fractions(Fraction(1, 10**6), Fraction(999_999, 10**6)).map(RationalPi)
tiny = st.integers(1, 16).map(lambda power: RationalPi(Fraction(1, 10**power)))
benign = sets_of(positive(-3, 3), broken)
unequal = sets_of(positive(-16, 16), tiny)
close = sets_of(near(Fraction(3)), tiny)
extreme = sets_of(positive(-150, 150), broken) | sets_of(positive(-300, 300), tiny)


@settings(max_examples=30, deadline=None)
@given(benign | unequal | close | extreme)
@pytest.mark.parametrize("tree", TREES, ids=FORMULAS)
def test_the_double_is_the_nearest_one(tree, values):
    with mpmath.workdps(DIGITS):
        try:
            truth = by_many_digits(tree, values)
        except ZeroDivisionError:
            with pytest.raises(Undefined):
                certified(tree, values)
            return
        if isinstance(truth, mpmath.mpc):
            with pytest.raises(Undefined):
                certified(tree, values)
            return
        expected = nearest(truth)
    found = certified(tree, values)
    assert (found.value, found.proven) == (expected, True)


@settings(deadline=None)
@given(st.fractions().filter(lambda number: abs(number) < 10**300))
def test_a_fraction_is_rounded_as_python_does(number):
    assert certified(Name("x"), {"x": RationalPi(number)}).value == float(number)


@pytest.mark.parametrize(
    "tie",
    [
        Fraction(2**53 + 1),
        Fraction(2**54 + 2),
        Fraction(1) + Fraction(1, 2**53),
        Fraction(3, 2) * Fraction(1, 2**1074),
    ],
)
def test_a_tie_goes_to_the_even_double(tie):
    halves = author_formula("x/2 + y/2")
    assert certified(halves, {"x": RationalPi(tie / 3), "y": RationalPi(tie * 5 / 3)}).value == float(tie)


@pytest.mark.parametrize(
    ("number", "double"),
    [
        ("1.8e308", math.inf),
        ("-1e400", -math.inf),
        ("1e308", 1e308),
        ("5e-324", 5e-324),
        ("2e-324", 0.0),
        ("-1e-330", 0.0),
        ("0", 0.0),
    ],
)
def test_beyond_the_doubles(number, double):
    found = certified(Name("x"), {"x": RationalPi(Fraction(number))})
    assert (found.value, found.proven) == (double, True)
    assert math.copysign(1, found.value) == math.copysign(1, double)


@pytest.mark.parametrize(
    ("formula", "degrees", "double"),
    [
        ("2*m*v*cos(theta)", "90", 0.0),
        ("cos(theta)", "89.999999999999", 1.7453292519943295e-14),
        ("sin(theta)", "180", 0.0),
        ("sin(theta)", "30", 0.5),
        ("cos(theta)", "60", 0.5),
        ("cos(theta)", "240", -0.5),
        ("tan(theta)", "45", 1.0),
        ("sin(theta) + cos(theta)^2*sqrt(2)", "90", 1.0),
        ("theta", "30", 0.5235987755982989),  # math.pi/6 is the double below
        ("acos(cos(theta))/pi", "60", 1 / 3),
        ("sin(theta)", "-30", -0.5),
    ],
)
def test_degrees_are_exact(formula, degrees, double):
    values = {
        "theta": RationalPi(Fraction(degrees) / 180, 1),
        "m": RationalPi(Fraction(2)),
        "v": RationalPi(Fraction(3)),
    }
    found = certified(author_formula(formula), values)
    assert (found.value, found.proven) == (double, True)


@pytest.mark.parametrize(
    "formula", ["sqrt(2) - sqrt(2)", "exp(1)*x - x*exp(1)", "ln(x)*0", "sqrt(x)*sqrt(x) - x"]
)
def test_an_exact_zero_is_zero(formula):
    assert certified(author_formula(formula), {"x": RationalPi(Fraction(3, 7))}).value == 0.0


@pytest.mark.parametrize(
    ("formula", "double"),
    [
        ("asin(sqrt(x)^2/x)", math.pi / 2),
        ("asin(-sqrt(x)^2/x)", -math.pi / 2),
        ("acos(-sqrt(x)^2/x)", math.pi),
    ],
)
def test_an_arc_is_cut_where_rounding_leaves_it_unknown_whether_a_number_is_beyond_1(formula, double):
    assert certified(author_formula(formula), {"x": RationalPi(Fraction(3, 7))}).value == double


@pytest.mark.parametrize(
    ("formula", "why"),
    [
        ("sqrt(x - 4)", "root of a negative"),
        ("1/(x - 3)", "division by zero"),
        ("ln(3 - x)", "logarithm"),
        ("asin(x)", "beyond 1"),
        ("(x - 3)^(-2)", "division by zero"),
        ("(-x)^0.5", "root of a negative"),
        ("(-x)^x2", "negative number"),
        ("gamma(3 - x)", "gamma"),
        ("atan2(x - 3, 0)", "no direction"),
        ("1/(sqrt(x) - sqrt(x))", "could not|no value"),
        ("gamma(gamma(gamma(99)))", "no value"),
        ("atan2(sin(x)^2 + cos(x)^2 - 1, -1)", "no value"),
    ],
)
def test_where_there_is_no_value_it_says_so(formula, why):
    with pytest.raises(Undefined, match=why):
        certified(author_formula(formula), {"x": RationalPi(Fraction(3)), "x2": RationalPi(Fraction(1, 3))})


@pytest.mark.parametrize(
    ("formula", "found"),
    [
        ("x - 3", 0),
        ("x - 4", -1),
        ("x", 1),
        ("sqrt(x^2) - x", 0),
        ("x*10^(-300) - 10^(-301)", 1),
        ("sqrt(2) - sqrt(2)", None),
    ],
)
def test_the_sign_of_a_formula(formula, found):
    assert sign(author_formula(formula), {"x": RationalPi(Fraction(3))}) == found


@pytest.mark.parametrize(
    ("condition", "true"),
    [
        ("x > 2.9", True),
        ("x > 3", False),
        ("x >= 3", True),
        ("x <= 3", True),
        ("x < 3", False),
        ("x = 3", True),
        ("x != 3", False),
        ("abs(x - 5) > 1.5", True),
        ("sqrt(2) < sqrt(2)", None),
    ],
)
def test_conditions(condition, true):
    tree = author_formula(condition)
    assert isinstance(tree, Relation)
    assert holds(tree, {"x": RationalPi(Fraction(3))}) is true


def test_a_letter_without_a_value_is_an_error_of_the_caller():
    with pytest.raises(KeyError):
        evaluate(author_formula("x*y"), {"x": RationalPi(Fraction(1))}, 64)


def test_a_tie_that_cannot_be_proven_says_so():
    tie = author_formula("x + (sqrt(2) - 1)*(sqrt(2) + 1)")  # exactly 2^53 + 1, but no ball can show it
    found = certified(tie, {"x": RationalPi(Fraction(2**53))})
    assert not found.proven
    assert isinstance(found.bits, int)
    assert found.value in (2.0**53, 2.0**53 + 2)


def test_a_ball_given_stays_a_ball():
    found = certified(author_formula("2*x"), {"x": arb(1, 1e-10)})
    assert not found.proven
    assert found.value == pytest.approx(2, abs=1e-9)


def test_the_precision_is_put_back_even_beside_other_threads():
    before = ctx.prec
    results: list[float] = []

    def work():
        for _ in range(200):
            results.append(
                certified(
                    TREES[3], {name: RationalPi(Fraction(1, 3)) for name in ("mA", "mB", "vA", "vB")}
                ).value
            )

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert ctx.prec == before
    assert set(results) == {0.0}
    assert len(results) == 800


def test_a_typical_formula_is_settled_at_the_first_precision():
    """Its cost: one pass at 64 bits. (benchmarks/arithmetic.py has the microseconds.)"""
    tree = author_formula("2*m*v*sin(theta)/dt")
    values = {
        "m": RationalPi(Fraction("0.43")),
        "v": RationalPi(Fraction(20)),
        "theta": RationalPi(Fraction(1, 5), 1),
        "dt": RationalPi(Fraction("0.1")),
    }
    found = certified(tree, values)
    assert (found.bits, found.proven) == (64, True)


def test_the_hardest_of_the_bank_needs_no_more_than_its_digits():
    """r - b at scale 1e300 cancels 600 digits, about 2000 bits, and is found with the next doubling of 64."""
    tree = author_formula("sqrt(x^2 + y^2) - x")
    found = certified(tree, {"x": RationalPi(Fraction(10) ** 300), "y": RationalPi(Fraction(1))})
    assert found.value == pytest.approx(5e-301, rel=1e-15)
    assert 2000 < found.bits <= 4096
