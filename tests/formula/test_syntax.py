"""Formulas as students and authors write them."""

from __future__ import annotations

import re
import tracemalloc
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.errors import ParseError
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula, parse

LETTERS = [
    "m",
    "M",
    "v",
    "v0",
    "vA0",
    "v_B0",
    "mA",
    "mB",
    "theta",
    "mu",
    "dt",
    "g",
    "h",
    "h0",
    "L",
    "k",
    "r",
    "n",
    "x",
    "y",
]


def shown(written: str, names=LETTERS, **how) -> str:
    tree = parse(written, names, **how)
    assert not isinstance(tree, ParseError), tree
    return text(tree)


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("2mv sin θ", "2*m*v*sin(theta)"),
        ("2mvsinθ", "2*m*v*sin(theta)"),
        ("2 m v sin(theta)/dt", "2*m*v*sin(theta)/dt"),
        ("m_A v_A0 + m_B*vB0", "mA*vA0 + mB*v_B0"),
        ("m_a va0 + mb v_b0", "mA*vA0 + mB*v_B0"),
        ("mAvA0+mBvB0", "mA*vA0 + mB*v_B0"),
        ("v_{A,0}", "vA0"),
        ("v_{A0} v_{B0}", "vA0*v_B0"),
        ("v₀ h₀", "v0*h0"),
        ("Δt", "dt"),
        ("Delta_t", "dt"),
        ("m v/Δ t", "m*v/dt"),
        ("Delta t v", "dt*v"),
        ("mv/Δt", "m*v/dt"),
        ("μmg", "mu*m*g"),
        ("mumg", "mu*m*g"),
        ("√(2gh)", "sqrt(2*g*h)"),
        ("√2", "sqrt(2)"),
        ("½mv²", "(1/2)*m*v^2"),
        ("1/2 m v^2", "(1/2)*m*v^2"),
        ("m v**2/2", "m*v^2/2"),
        ("v⁻¹", "v^(-1)"),
        ("-v^2", "-v^2"),
        ("2^3^2", "2^3^2"),
        ("x^y^2", "x^y^2"),
        ("2*-3*m", "2*(-3)*m"),
        ("m − M", "m - M"),
        ("m·v×g", "m*v*g"),
        ("m/M*v", "(m/M)*v"),
        ("m/M/v", "m/M/v"),
        ("[m + M](v - x)", "(m + M)*(v - x)"),
        ("|v - x|m", "abs(v - x)*m"),
        ("m|v|", "m*abs(v)"),
        ("sin²θ + cos^2 θ", "sin(theta)^2 + cos(theta)^2"),
        ("sin 2θ", "sin(2*theta)"),
        ("cosθ sinθ", "cos(theta)*sin(theta)"),
        ("sin θ * m", "sin(theta)*m"),
        ("sin(30°)", "sin(30*(pi/180))"),
        ("sin 30 deg", "sin(30*(pi/180))"),
        ("arcsin(x) + atan2(y, x)", "asin(x) + atan2(y, x)"),
        ("e^(-x)", "exp(-x)"),
        ("2e^-x", "2*exp(-x)"),
        ("e^x^2", "exp(x^2)"),
        ("πr²", "pi*r^2"),
        ("pir", "pi*r"),
        ("p = m v", "m*v"),
        ("v(t) = g x", "g*x"),
        ("0.50 m", "0.50*m"),
        ("1.2e3m", "1.2e3*m"),
        ("max(m, M)", "max(m, M)"),
        ("r^(2n)", "r^(2*n)"),
        ("10^-3 m", "10^(-3)*m"),
        ("ln(M/m)", "ln(M/m)"),
    ],
)
def test_a_formula_is_read_as_it_is_meant(written, meant):
    assert shown(written) == meant


@pytest.mark.parametrize(
    ("written", "choices"),
    [
        ("m/2v", ("m/(2*v)", "(m/2)*v")),
        ("1/2mv^2", ("1/(2*m)", "(1/2)*m")),
        ("m/M v", ("m/(M*v)", "(m/M)*v")),
        ("m/(M + m) v", ("m/((M + m)*v)", "(m/(M + m))*v")),
        ("m/2(v + x)", ("m/(2*(v + x))", "(m/2)*(v + x)")),
        ("sin x y", ("sin(x*…)", "sin(x)*…")),
        ("sin x/2", ("sin(x/…)", "sin(x)/…")),
        ("sin x^2", ("sin(x^…)", "sin(x)^…")),
        ("√2gh", ("sqrt(2*…)", "sqrt(2)*…")),
        ("cbrt 8m", ("cbrt(8*…)", "cbrt(8)*…")),
        ("log2 8m", ("log2(8*…)", "log2(8)*…")),
        ("sin^-1 x", ("arcsin(…)", "1/sin(…)")),
        ("sin⁻¹(x)", ("arcsin(…)", "1/sin(…)")),
        ("m v 2", ("v^2", "v*2")),
    ],
)
def test_what_has_two_readings_is_asked_about(written, choices):
    found = parse(written, LETTERS)
    assert isinstance(found, ParseError)
    assert (found.status, found.choices) == ("asked", choices)
    for choice in choices:
        if "…" not in choice:
            assert shown(choice) == choice


@pytest.mark.parametrize(
    ("written", "names", "choices"),
    [
        ("ma", "m a mA", ("mA", "m*a")),
        ("asin(x)", "a x", ("arcsin(…)", "a*sin(…)")),
        ("abc", "a b c ab bc", ("a*bc", "ab*c")),
    ],
)
def test_letters_run_together_with_two_readings_are_asked_about(written, names, choices):
    found = parse(written, names.split())
    assert isinstance(found, ParseError)
    assert (found.status, found.choices) == ("asked", choices)


def test_an_exact_name_is_that_name():
    assert shown("ma mA m_a", ["mA", "ma"]) == "ma*mA*ma"
    assert shown("dt", ["d", "t", "dt"]) == "dt"
    assert shown("m_A mA", ["mA", "m_A"]) == "m_A*mA"
    assert shown("ev", ["e", "v"]) == "e*v"


@pytest.mark.parametrize(
    ("written", "at", "words"),
    [
        ("", 0, "stops too early"),
        ("m +", 3, "stops too early"),
        ("(m", 0, "never closed"),
        ("m)", 1, "closes nothing"),
        ("[m)", 2, "closes nothing"),
        ("|m", 0, "never closed"),
        ("*m", 0, "something is missing before *"),
        ("1,5*m", 1, "1.5"),
        ("q*v", 0, "q is not among the letters"),
        ("V", 0, "did you mean v?"),
        ("m v_{0A}", 2, "did you mean vA0?"),
        ("thetha", 0, "did you mean theta?"),
        ("m2", 0, "m^2"),
        ("p = m v = 3", 8, "only the right side"),
        ("m > 2", 2, "only the right side"),
        ("m == v", 2, "only the right side"),
        ("m!", 1, "does not belong"),
        ("m; v", 1, "one formula"),
        ("atan2(y)", 5, "takes 2"),
        ("sin()", 4, "closes nothing"),
        ("m.v", 1, "does not belong"),
        ("9**9**9", 1, "up to 64"),
        ("m^65", 1, "up to 64"),
        ("x = 99999999^64*m + 9^9^9", 21, "up to 64"),
        ("(9999999999999999999999999999999999999999)^64", 42, "too large a number"),
        ("1e401", 0, "up to 400"),
        ("m_v", 0, "not among"),
        ("__import__('os').getpid()", 0, "does not belong"),
        ("x.diff.__globals__", 1, "does not belong"),
        ("lambda: 1", 0, "not among"),
        ("factorial(10**7)", 0, "not among"),
        ("☃*m", 0, "does not belong"),
    ],
)
def test_an_error_has_its_place_and_what_to_do(written, at, words):
    found = parse(written, LETTERS)
    assert isinstance(found, ParseError)
    assert (found.status, found.position) == ("refused", at)
    assert words in f"{found.why}; {found.suggestion}"


def test_the_left_side_is_the_one_asked_for():
    assert shown("v_B1 = g x", left="vB1") == "g*x"
    found = parse("F = m g", LETTERS, left="p")
    assert isinstance(found, ParseError)
    assert found.why == "F stands on the left, but p is asked for"


def test_degrees_where_the_problem_says_so():
    assert shown("sin(30)", degrees=True) == "sin(30*(pi/180))"
    assert shown("cos(90 - θ)", degrees=True) == "cos(90*(pi/180) - theta)"
    assert shown("sin(2θ) + cos(theta/2)", degrees=True) == "sin(2*theta) + cos(theta/2)"
    assert shown("tan((180 - θ)/2)", degrees=True) == "tan((180*(pi/180) - theta)/2)"
    assert shown("sin(30°)", degrees=True) == "sin(30*(pi/180))"
    assert shown("sin(30)") == "sin(30)"


@pytest.mark.parametrize(
    "written",
    [
        "abs(v - w) > 1.5",
        "m_A*v_A0 + m_B*v_B0 = (m_A + m_B)*v",
        "sqrt(xp^2 + yp^2) < b + d",
        "theta <= 1.5707963267948966",
        "0 != x",
    ],
)
def test_authors_write_laws_and_conditions(written):
    tree = author_formula(written)
    assert isinstance(tree, Relation)
    assert text(tree) == written


@pytest.mark.parametrize(
    ("written", "names", "words"),
    [
        ("2 m", None, "write \\* for every product"),
        ("sin x", None, "write sin"),
        ("0 <= r <= 1", None, "write two conditions"),
        ("m*q", ["m"], "q is not among the letters here \\(m\\)"),
        ("mA", ["m_A"], "mA is not among"),
        ("m +", None, "formula 'm \\+', at character 4"),
    ],
)
def test_authors_are_told_in_a_sentence(written, names, words):
    with pytest.raises(ValueError, match=words):
        author_formula(written, names)


def test_a_derived_formula_may_be_long():
    long = " + ".join(f"a{number}*b{number}" for number in range(300))
    assert text(author_formula(long)) == long
    found = parse(long, [])
    assert isinstance(found, ParseError)
    assert found.why == "this is longer than 400 characters"


letters = st.sampled_from(["m", "v_A0", "theta", "dt", "x"]).map(Name)
wholes = st.integers(0, 999).map(lambda value: Number(Fraction(value)))
decimals = st.builds(
    lambda digits, power: Number(Fraction(digits) * Fraction(10) ** power, len(str(digits))),
    st.integers(1, 9999),
    st.integers(-9, 9),
)
trees: st.SearchStrategy[Expr] = st.recursive(
    letters | wholes | decimals,
    lambda inner: st.one_of(
        inner.map(Negative),
        st.lists(inner, min_size=2, max_size=3).map(lambda each: Sum(tuple(each))),
        st.lists(inner, min_size=2, max_size=3).map(lambda each: Product(tuple(each))),
        st.builds(Quotient, inner, inner),
        st.builds(Power, inner, st.integers(0, 4).map(lambda value: Number(Fraction(value))) | letters),
        st.builds(
            lambda name, part: Call(name, (part,)), st.sampled_from(["sqrt", "sin", "ln", "abs"]), inner
        ),
        st.builds(lambda left, right: Call("max", (left, right)), inner, inner),
    ),
    max_leaves=12,
)


@given(trees)
def test_the_text_of_a_formula_reads_back(tree):
    assert author_formula(text(tree)) == tree


@given(trees)
def test_students_may_write_what_authors_write(tree):
    assert parse(text(tree), ["m", "v_A0", "theta", "dt", "x"]) == tree


@given(st.text(max_size=60) | st.text(alphabet="mvθ2^*/()+-. sin√²,=|e", max_size=40))
def test_any_text_is_read_or_answered(written):
    found = parse(written, LETTERS)
    if isinstance(found, ParseError):
        assert found.why
        assert found.position is None or 0 <= found.position <= len(written)
    else:
        assert parse(text(found), LETTERS) == found


MOST_CALLS = 100000

HOSTILE = [
    "9**9**9",
    "(" * 3000,
    "-" * 100_000,
    "(" * 190,
    "-" * 190,
    "a" * 24 + "z",
    "m" * 400,
    "m" * 60,
    "mv" * 30,
    "√" * 150,
    "sin" * 130,
    "|" * 150,
    "m^" * 100 + "m",
    "2^" * 60 + "2",
    "(((((2^64)^64)^64)^64)^64)",
    "1e400^64",
    "99^64*" * 40 + "1",
    "(99/98)^64+" * 30 + "1",
    "factorial(10**7)",
    "exp(exp(exp(exp(9))))",
    "x=" * 200,
    "m_" * 200,
    "θ" * 400,
    "½" * 100,
    "²" * 100,
    "m²²²²²²²²",
    "((((m+1)^64+1)^64+1)^64+1)^64",
    "\x00" * 399,
    "𝐦" * 90,
    "m_{" + "A" * 300,
    "mA" * 30 + "q",
    "0." + "0" * 390 + "1",
    "1e-400",
    "(1/3)^(1/3)^(1/3)",
    "2^(1/3)^64^(1/2)",
    "dt" * 30,
    "m" + "_a" * 150,
]


@pytest.mark.parametrize("written", HOSTILE, ids=[repr(written[:20]) for written in HOSTILE])
def test_hostile_text_is_read_or_refused_with_little_work_and_memory(written, calls_of):
    assert calls_of(lambda: parse(written, [*LETTERS, "a", "aa", "aaa"])) < MOST_CALLS
    tracemalloc.start()
    parse(written, [*LETTERS, "a", "aa", "aaa"])
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 50e6


def test_a_formula_may_have_as_many_signs_as_the_refusal_says():
    refused = parse("-" * 390 + "x", ["x"])
    assert isinstance(refused, ParseError)
    signs = [parse("x" + "+x" * count, ["x"]) for count in range(200)]
    told = next(each for each in signs if isinstance(each, ParseError))
    most = int(re.search(r"more than (\d+) signs", told.why)[1])
    assert signs.index(told) == (most + 1) // 2  # count additions are 2 count + 1 signs
    assert isinstance(parse("-x" + "+x" * ((most - 2) // 2), ["x"]), Expr)
    assert isinstance(parse("-x" + "+x" * (most // 2), ["x"]), ParseError)


def test_brackets_may_lie_in_each_other_as_deep_as_the_refusal_says():
    nested = [parse("(" * depth + "x" + ")" * depth, ["x"]) for depth in range(1, 80)]
    told = next(each for each in nested if isinstance(each, ParseError))
    most = int(re.search(r"nested more than (\d+) deep", told.why)[1])
    assert nested.index(told) + 1 in (most - 1, most, most + 1)  # the letter within is one more
    assert all(isinstance(each, ParseError) for each in nested[most + 1 :])


@pytest.mark.parametrize("typed", ["2*lam*d", "2 λ d", "2lambda d", "2*lam d"])
def test_a_wavelength_is_called_by_its_letter(typed):
    """`lambda` is a word of Python, so that authors write lam."""
    assert text(parse(typed, {"lam", "d"})) == "2*lam*d"


def test_a_lamp_is_no_wavelength():
    assert text(parse("lamp*d", {"lamp", "d"})) == "lamp*d"
    assert isinstance(parse("lambda*d", {"lamp", "d"}), ParseError)
