"""One row a function: every reader, evaluator and writer knows each of them, and a new one by its row alone."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from corollary.answers.equality import Equal, compare
from corollary.formula.arithmetics import DOUBLES, arrays, ready
from corollary.formula.ast import Call, Name
from corollary.formula.ball import RationalPi, certified
from corollary.formula.errors import ParseError
from corollary.formula.exact import exactly
from corollary.formula.from_sympy import tree
from corollary.formula.functions import FUNCTIONS, SPELLINGS, Function, register
from corollary.formula.latex import latex
from corollary.formula.symbols import letters
from corollary.formula.syntax import author_formula, parse
from corollary.formula.text import text
from corollary.formula.to_sympy import expression
from corollary.problem.interval_filter import INTERVALS, Interval
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, unit

# What each function is, said once more by other people's libraries.
BY_MPMATH = {
    "abs": mpmath.fabs, "ln": mpmath.log, "min": min, "max": max, "sqrt": mpmath.sqrt, "sin": mpmath.sin, "cos": mpmath.cos,
    "tan": mpmath.tan, "asin": mpmath.asin, "acos": mpmath.acos, "atan": mpmath.atan, "atan2": mpmath.atan2, "exp": mpmath.exp,
    "log10": mpmath.log10, "sinh": mpmath.sinh, "cosh": mpmath.cosh, "tanh": mpmath.tanh, "gamma": mpmath.gamma,
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
    assert bounded == {"abs", "acos", "asin", "atan", "cos", "ln", "max", "min", "sin", "sqrt", "tan", "tanh"}


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
def asinh():
    """A function nobody has thought of, for the time of one test."""
    row = register(
        Function(
            "asinh",
            math.asinh,
            lambda x: x.asinh(),
            spellings=("arsinh",),
            exact=lambda x: x if x.ratio == 0 else None,
            derivatives=("1/sqrt(1 + x^2)",),
            slope=1,
            tex=r"\operatorname{arsinh}",
            array="arcsinh",
        )
    )
    yield row
    del FUNCTIONS["asinh"]
    for spelling in ("asinh", "arsinh"):
        del SPELLINGS[spelling]


def test_a_new_function_is_one_row(asinh):
    x = sympy.Symbol("x")
    written = Call("asinh", (Name("x"),))
    assert parse("arsinh x", ["x"]) == parse("asinh(x)", ["x"]) == author_formula("asinh(x)") == written
    assert letters(frozenset("x")).exact["arsinh"] == ("function", "asinh")
    assert ready(written, DOUBLES)({"x": 2.0}) == math.asinh(2)
    assert ready(written, arrays())({"x": np.array([2.0])})[0] == pytest.approx(math.asinh(2))
    assert certified(written, {"x": RationalPi(Fraction(2))}).value == float(mpmath.asinh(2))
    assert exactly(written, {"x": RationalPi(Fraction(0))}) == RationalPi(Fraction(0))
    assert exactly(written, {"x": RationalPi(Fraction(1))}) is None
    assert dimension_of(written, {"x": unit("rad").dimension}) == unit("1").dimension
    wrong = dimension_of(written, {"x": unit("m").dimension})
    assert isinstance(wrong, ParseError)
    assert wrong.why == "x (m) cannot be inside asinh"
    assert text(written) == "asinh(x)"
    assert latex(written) == r"\operatorname{arsinh} x"
    assert expression(written, {"x": x}) == sympy.asinh(x)
    assert tree(sympy.asinh(x)) == written
    bound = ready(written, INTERVALS)({"x": Interval.of(2)})
    assert abs(float(bound.value) - math.asinh(2)) <= float(bound.radius) < 1e-14


def test_without_its_row_nobody_knows_it():
    assert isinstance(parse("asinh(x)", ["x"]), ParseError)


def test_a_name_in_use_is_refused():
    with pytest.raises(ValueError, match="the function mine: lg means log10 already"):
        register(Function("mine", math.sin, lambda x: x.sin(), spellings=("lg",)))
    assert "mine" not in FUNCTIONS
