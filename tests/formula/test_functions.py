"""One row a function: every reader, evaluator and writer knows each of them, and a new one by its row alone."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

import mpmath
import numpy as np
import pytest
import sympy
from flint import arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from corollary.answers.equality import Equal, compare
from corollary.formula.arithmetics import DOUBLES, arrays, exactly, ready
from corollary.formula.ast import Call, Name
from corollary.formula.ball import RationalPi, certified
from corollary.formula.errors import ParseError
from corollary.formula.from_sympy import tree
from corollary.formula.functions import FUNCTIONS, SPELLINGS, Function, register
from corollary.formula.latex import latex
from corollary.formula.plain_text import text
from corollary.formula.symbols import letters
from corollary.formula.syntax import author_formula, parse
from corollary.formula.to_sympy import expression
from corollary.problem.interval_filter import INTERVALS, Interval
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, unit

# What each function is, said once more by other people's libraries.
BY_MPMATH = {
    "abs": mpmath.fabs, "ln": mpmath.log, "min": min, "max": max, "sqrt": mpmath.sqrt, "sin": mpmath.sin, "cos": mpmath.cos,
    "tan": mpmath.tan, "asin": mpmath.asin, "acos": mpmath.acos, "atan": mpmath.atan, "atan2": mpmath.atan2, "exp": mpmath.exp,
    "log10": mpmath.log10, "sinh": mpmath.sinh, "cosh": mpmath.cosh, "tanh": mpmath.tanh, "gamma": mpmath.gamma,
    "floor": mpmath.floor, "ceil": mpmath.ceil, "round": lambda x: mpmath.floor(x + mpmath.mpf(1) / 2),
}  # fmt: skip
HALVES = (Fraction(1, 2), Fraction(3, 4))  # where every one of them has a value


def called(name: str) -> Call:
    return Call(name, tuple(map(Name, "xy"[: FUNCTIONS[name].arity])))


def test_the_list_is_the_one_in_the_documentation():
    assert set(FUNCTIONS) == set(BY_MPMATH)


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_every_function_is_known_to_every_visitor(name):
    row, written = FUNCTIONS[name], called(name)
    values = dict(zip("xy", HALVES, strict=True))
    with mpmath.workdps(40):
        true = float(BY_MPMATH[name](*(mpmath.mpf(float(half)) for half in HALVES[: row.arity])))
    exact = {letter: RationalPi(half) for letter, half in values.items()}
    assert certified(written, exact).value == true
    assert ready(written, DOUBLES)({"x": 0.5, "y": 0.75}) == pytest.approx(true, rel=1e-14)
    known = exactly(written, exact)
    assert known is None or float(known.ratio) * math.pi**known.pi == pytest.approx(true, rel=1e-14)
    assert dimension_of(written, dict.fromkeys("xy", ONE)) == ONE
    assert author_formula(text(written)) == written
    for spelling in (name, *row.spellings):
        assert parse(f"{spelling}({', '.join('xy'[: row.arity])})", ["x", "y"]) == written
    assert "x" in latex(written)
    in_sympy = expression(written, {letter: sympy.Rational(half) for letter, half in values.items()})
    assert float(in_sympy) == pytest.approx(true, rel=1e-14)
    assert isinstance(compare(written, written, {"x": (0.1, 0.9)}), Equal)


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_sympy_and_back_is_the_same_function(name):
    x, y = sympy.Symbol("x", positive=True), sympy.Symbol("y", positive=True)
    written = called(name)
    back = tree(expression(written, {"x": x, "y": y}))
    values = {letter: RationalPi(half) for letter, half in zip("xy", HALVES, strict=True)}
    assert isinstance(compare(back, written, {"x": (0.1, 0.9)}), Equal), text(back)
    assert certified(back, values).value == certified(written, values).value


@pytest.mark.parametrize("name", sorted(name for name, row in FUNCTIONS.items() if row.derivatives))
@settings(max_examples=25, deadline=None)
@given(x=st.floats(0.05, 0.95), y=st.floats(0.05, 0.95))
def test_the_derivatives_are_those_of_the_function(name, x, y):
    row = FUNCTIONS[name]
    assert len(row.derivatives) == row.arity
    with mpmath.workdps(30):
        at = [mpmath.mpf(x), mpmath.mpf(y)][: row.arity]
        for place, derivative in enumerate(row.derivatives):
            orders = tuple(int(other == place) for other in range(row.arity))
            true = mpmath.diff(BY_MPMATH[name], tuple(at), orders)
            found = ready(author_formula(derivative), DOUBLES)({"x": x, "y": y})
            assert found == pytest.approx(float(true), rel=1e-9)
            assert row.slope is None or abs(found) <= row.slope


def test_the_functions_of_angles_and_the_like_have_bounds_in_doubles():
    bounded = {name for name, row in FUNCTIONS.items() if INTERVALS.column(row) is not None}
    steps = {"ceil", "floor", "round"}
    assert bounded == steps | {
        "abs",
        "acos",
        "asin",
        "atan",
        "cos",
        "ln",
        "max",
        "min",
        "sin",
        "sqrt",
        "tan",
        "tanh",
    }


@pytest.mark.parametrize(
    "name", sorted(n for n, row in FUNCTIONS.items() if INTERVALS.column(row) is not None)
)
@settings(max_examples=40, deadline=None)
@given(st.fractions(-3, 3), st.fractions(-3, 3))
def test_a_bound_in_doubles_holds_the_true_value(name, x, y):
    row = FUNCTIONS[name]
    numbers = dict(zip("xy"[: row.arity], (x, y), strict=False))
    with np.errstate(all="ignore"):
        found = ready(called(name), INTERVALS)(
            {letter: Interval.of(number) for letter, number in numbers.items()}
        )
    with mpmath.workdps(40):
        try:
            true = BY_MPMATH[name](
                *(mpmath.mpf(each.numerator) / each.denominator for each in numbers.values())
            )
        except ValueError:  # ln(0)
            return
    assume(not isinstance(true, mpmath.mpc))
    assert not abs(float(found.value) - float(true)) > float(found.radius) + 1e-300


@pytest.fixture
def ash():
    """A function nobody has thought of, for the time of one test."""
    row = register(
        Function(
            "ash",
            math.asinh,
            lambda x: x.asinh(),
            spellings=("arsh",),
            exact=lambda x: x if x.ratio == 0 else None,
            derivatives=("1/sqrt(1 + x^2)",),
            slope=1,
            tex=r"\operatorname{arsinh}",
            array="arcsinh",
            sympy="asinh",
        )
    )
    yield row
    del FUNCTIONS["ash"]
    for spelling in ("ash", "arsh"):
        del SPELLINGS[spelling]


def test_a_new_function_is_one_row(ash):
    x = sympy.Symbol("x")
    written = Call("ash", (Name("x"),))
    assert parse("arsh x", ["x"]) == parse("ash(x)", ["x"]) == author_formula("ash(x)") == written
    assert letters(frozenset("x")).exact["arsh"] == ("function", "ash")
    assert ready(written, DOUBLES)({"x": 2.0}) == math.asinh(2)
    assert ready(written, arrays())({"x": np.array([2.0])})[0] == pytest.approx(math.asinh(2))
    assert certified(written, {"x": RationalPi(Fraction(2))}).value == float(mpmath.asinh(2))
    assert exactly(written, {"x": RationalPi(Fraction(0))}) == RationalPi(Fraction(0))
    assert exactly(written, {"x": RationalPi(Fraction(1))}) is None
    assert dimension_of(written, {"x": unit("rad").dimension}) == unit("1").dimension
    wrong = dimension_of(written, {"x": unit("m").dimension})
    assert isinstance(wrong, ParseError)
    assert wrong.why == "x (m) cannot be inside ash"
    assert text(written) == "ash(x)"
    assert latex(written) == r"\operatorname{arsinh} x"
    assert expression(written, {"x": x}) == sympy.asinh(x)
    assert tree(sympy.asinh(x)) == written
    bound = ready(written, INTERVALS)({"x": Interval.of(2)})
    assert abs(float(bound.value) - math.asinh(2)) <= float(bound.radius) < 1e-14


def test_without_its_row_nobody_knows_it():
    assert isinstance(parse("ash(x)", ["x"]), ParseError)


def test_a_name_in_use_is_refused():
    with pytest.raises(ValueError, match="the function mine: lg means log10 already"):
        register(Function("mine", math.sin, lambda x: x.sin(), spellings=("lg",)))
    assert "mine" not in FUNCTIONS


ABBREVIATED = {
    "cot": (0.7, 1 / math.tan(0.7)), "sec": (0.7, 1 / math.cos(0.7)), "csc": (0.7, 1 / math.sin(0.7)),
    "coth": (0.7, 1 / math.tanh(0.7)), "sech": (0.7, 1 / math.cosh(0.7)), "csch": (0.7, 1 / math.sinh(0.7)),
    "asinh": (0.7, math.asinh(0.7)), "arcsinh": (-0.7, math.asinh(-0.7)), "acosh": (1.7, math.acosh(1.7)),
    "arccosh": (1.7, math.acosh(1.7)), "atanh": (0.7, math.atanh(0.7)), "arctanh": (-0.7, math.atanh(-0.7)),
    "cbrt": (0.7, 0.7 ** (1 / 3)), "square": (0.7, 0.49), "log2": (0.7, math.log2(0.7)), "log1p": (0.7, math.log1p(0.7)),
    "expm1": (0.7, math.expm1(0.7)), "exp2": (0.7, 2**0.7), "sign": (-0.7, -1.0), "radians": (30.0, math.pi / 6),
    "deg2rad": (30.0, math.pi / 6), "rad2deg": (0.5, math.degrees(0.5)),
    "sind": (30.0, 0.5), "cosd": (60.0, 0.5), "tand": (45.0, 1.0), "log": (0.7, math.log(0.7)), "Abs": (-0.7, 0.7),
    "np.sqrt": (0.7, math.sqrt(0.7)), "sympy.log": (0.7, math.log(0.7)), "math.fabs": (-0.7, 0.7),
}  # fmt: skip


@pytest.mark.parametrize("name", sorted(ABBREVIATED))
def test_what_numpy_and_sympy_have_is_read_as_what_it_stands_for(name):
    x, true = ABBREVIATED[name]
    found = parse(f"{name}(x)", ["x"])
    assert not isinstance(found, ParseError), found
    assert ready(found, DOUBLES)({"x": x}) == pytest.approx(true, rel=1e-12)


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("hypot(x, y)", "sqrt(x^2 + y^2)"),
        ("pow(x, 3)", "x^3"),
        ("np.power(x, 2)", "x^2"),
        ("log(x, 10)", "ln(x)/ln(10)"),
        ("log x", "ln(x)"),
        ("Max(x, y)", "max(x, y)"),
    ],
)
def test_functions_of_two_numbers(written, meant):
    found = parse(written, ["x", "y"])
    assert not isinstance(found, ParseError), found
    assert text(found) == meant


@pytest.mark.parametrize(
    "bomb", ["pow(9, pow(9, 9))", "exp2(exp2(exp2(99)))", "square(" * 30 + "9" + ")" * 30]
)
def test_towers_by_another_name_are_refused(bomb):
    assert isinstance(parse(bomb, ["x"]), ParseError)


@pytest.mark.parametrize(
    "name", sorted(name for name, row in FUNCTIONS.items() if row.slope and row.arity == 1)
)
def test_no_values_are_further_apart_than_the_slope_says_and_some_are_nearly_as_far(name):
    """The slope is the least whole number that bounds how steep the function is anywhere."""
    row = FUNCTIONS[name]
    places = [place / 64 for place in range(-640, 641)]
    steepest = max(
        abs(row.double(right) - row.double(left)) / (right - left) for left, right in pairwise(places)
    )
    assert row.slope - 1 < steepest <= row.slope * (1 + 1e-12)
    ends = [row.ball(arb(place) / 8) for place in (-1, 0, 1, 3)]
    assert all(abs(right - left) <= row.slope * arb("0.2501") for left, right in pairwise(ends))
