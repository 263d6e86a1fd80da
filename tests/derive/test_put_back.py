"""Right derivations are not refused because an identity is hard to see, wrong ones are shown by numbers."""

from __future__ import annotations

import re

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.derive.conftest import problem_of

from corollary.derive.assumptions import Known
from corollary.derive.put_back import put_laws_back
from corollary.derive.sampled import compared
from corollary.derive.solve import solved_derivation
from corollary.problem.bank import chapter_bank, find
from corollary.verify.verify import verify

FRONT = """\
code: X1.1
title: Identities
given:
  a: {is: a, value: 1.5, from: 1.1, to: 2.5, step: 0.1}
  b: {is: b, value: 0.7, from: 0.4, to: 0.9, step: 0.1}
  c: {is: c, value: 0.3, from: 0.1, to: 0.6, step: 0.1}
require: [a > 0, b > 0, c > 0]
"""
ASKS = "## Number {#a .value points=1}\nHow large?\n"
WHOLE = """\
from sympy import *
from corollary.author import *
from corollary.laws import law, wrong
def derive(a, b, c):
    x, y = unknowns("x y")
    return derivation(
        step(x, "First.", law("First", "{law}"), answers="a"{where}),
        confirm("Besides.", law("Second", "{besides}")),
    )
"""
RIGHT = [
    ("x = sin(3*a)", "x = 3*sin(a) - 4*sin(a)^3", ""),
    ("x = sqrt(a^2 + sqrt(b))", "x = sqrt((a^2 + sqrt(a^4 - b))/2) + sqrt((a^2 - sqrt(a^4 - b))/2)", ""),
    ("x = atan(a) + atan(1/a)", "x = pi/2", ""),
    ("sin(x) = b", "x = atan(b/sqrt(1 - b^2))", ", where=x < pi/2"),
    ("x = log10(a*b^2)", "10^x = a*b^2", ""),
    ("x = tanh(a + b)", "x = (tanh(a) + tanh(b))/(1 + tanh(a)*tanh(b))", ""),
    ("x^a = b", "ln(x) = ln(b)/a", ""),
    ("sinh(x) = a", "x = ln(a + sqrt(a^2 + 1))", ""),
    ("cosh(x) = a", "tanh(x) = sqrt(a^2 - 1)/a", ", where=x > 0"),
    ("x = tan(b/2)", "x = sin(b)/(1 + cos(b))", ""),
    ("x = 2^(-a/b)", "x = exp(-ln(2)*a/b)", ""),
    ("b*exp(-b*x) = c*exp(-c*x)", "x*(b - c) = ln(b) - ln(c)", ""),
    ("x = 4*atan(1/5) - atan(1/239) + 0*a", "x = pi/4", ""),
    ("x = (a^b)^c", "x = exp(b*c*ln(a))", ""),
    ("x = acos(c) + asin(c)", "cos(x) = 0", ""),
    ("x = sqrt(5 + 2*sqrt(6))*a", "x = (sqrt(2) + sqrt(3))*a", ""),
    ("x = atan2(b, c)", "tan(x) = b/c", ""),
]  # fmt: skip


def put_back(make, law, besides, where=""):
    bank = make(whole=WHOLE.format(law=law, besides=besides, where=where), front=FRONT, asks=ASKS)
    return bank, [
        each for each in put_laws_back(solved_derivation(bank, problem_of(bank)).solvers) if each.complaint
    ]


@pytest.mark.parametrize(("law", "besides", "where"), RIGHT)
def test_no_right_derivation_is_refused(make, law, besides, where):
    assert put_back(make, law, besides, where)[1] == []


@pytest.mark.parametrize(("law", "besides", "where"), [each for each in RIGHT if each[1] != "cos(x) = 0"])
@pytest.mark.parametrize("bend", ["({right})*(1 + 1e-12)", "({right}) + c/10^9"])
def test_every_wrong_one_is_shown_by_numbers(make, law, besides, where, bend):
    left, right = besides.split(" = ")
    _bank, (wrong,) = put_back(make, law, f"{left} = {bend.format(right=right)}", where)
    shown = re.search(r"the left side is (\S+) and the right side (\S+) \(SI\)", wrong.complaint)
    assert shown is not None, wrong.complaint
    assert "at a = " in wrong.complaint
    left, right = map(sympy.Rational, shown.groups())
    assert left != right
    assert abs(left - right) < sympy.Rational(3, 10**8)  # both are values of this law, and no others


def test_what_algebra_does_not_see_is_told_as_sampled(make):
    """The time at which a daughter decays as fast as its mother: k = ln(2)/T in the exponents."""
    whole = """\
from corollary.author import *
from corollary.laws import law
def derive(a, b, c):
    k1, k2, t = unknowns("k1 k2 t")
    return derivation(
        step(k1, "Mother.", law("Mother", "k1 = ln(2)/a")),
        step(k2, "Daughter.", law("Daughter", "k2 = ln(2)/b")),
        step(t, "Equal.", law("Equal", "k1*exp(-k1*t) = k2*exp(-k2*t)"), answers="a"),
    )
"""
    bank = make(whole=whole, front=FRONT, asks=ASKS)
    checked = verify(bank, problem_of(bank), 3)
    assert checked.complaints == ()
    held = {each.claim: (each.outcome, each.by) for each in checked.obligations if each.kind == "laws hold"}
    assert held["the laws of k1 hold for what is found"] == ("proven", "algebra")
    assert held["the laws of t hold for what is found"][0] == "sampled"


def test_a_counter_example_has_its_numbers(make):
    whole = WHOLE.replace(
        'answers="a"{where}', 'answers="a", routes=[route("By another way.", law("Way", "x = a*b"))]'
    )
    bank = make(whole=whole.format(law="x = a + b", besides="x - a = b"), front=FRONT, asks=ASKS)
    checked = verify(bank, problem_of(bank), 3)
    (held,) = [each for each in checked.obligations if each.kind == "laws hold"]
    assert (held.outcome, dict(held.numbers)) == ("counter-example", {"a": "1.5", "b": "0.7", "c": "0.3"})
    assert (
        "Way does not hold for the answers: x = a*b; at a = 1.5, b = 0.7, c = 0.3 the left side is 2.2"
        in checked.complaints[0]
    )


def test_limits_and_special_cases_hold_at_numbers_too(make):
    whole = WHOLE.replace('confirm("Besides.", law("Second", "{besides}")),', "{besides}")
    for besides, fault in (
        ("at(b=a, x=4*sin(a)*cos(a)*cos(2*a)),", ""),
        ("at(b=a, x=4*sin(a)*cos(a)*cos(2*a) + a/10**9),", "at b = a: x is sin(4*a), not"),
        ("limit(x, b, a, 2*sin(2*a)*cos(2*a)),", ""),
        ("limit(x, b, a, 2*sin(2*a)*cos(2*a) + a/10**9),", "the limit of x for b to a is sin(4*a), not"),
    ):
        bank = make(
            whole=whole.format(law="x = sin(3*a + b)", besides=besides, where=""), front=FRONT, asks=ASKS
        )
        found = [
            each.complaint
            for each in put_laws_back(solved_derivation(bank, problem_of(bank)).solvers)
            if each.complaint
        ]
        assert [fault in each and "the claim" in each for each in found] == [True] * bool(fault)


X12_5 = Known(find(chapter_bank(), "X12.5"))
LETTERS = sorted(X12_5.givens, key=str)


@settings(deadline=None, max_examples=40)
@given(
    st.recursive(
        st.sampled_from([*LETTERS, sympy.Integer(2), sympy.Rational(1, 3)]),
        lambda inner: st.one_of(
            st.tuples(inner, inner).map(lambda each: each[0] + each[1]),
            st.tuples(inner, inner).map(lambda each: each[0] * each[1]),
            inner.map(lambda each: sympy.exp(-each)),
            inner.map(lambda each: sympy.log(1 + each**2)),
            inner.map(lambda each: sympy.sqrt(1 + each**2)),
            inner.map(sympy.sin),
        ),
        max_leaves=4,
    ),
    st.sampled_from([1, 0, sympy.Rational(1, 10**30)]),
)  # fmt: skip
def test_a_difference_is_seen_however_small_and_none_is_seen_where_there_is_none(formula, more):
    """The same formula with its functions written otherwise, and a little more of it."""
    otherwise = formula.rewrite(sympy.tan).rewrite(sympy.cosh) + more * LETTERS[0]
    found = compared(formula, otherwise, X12_5)
    assert found.how in (("algebra", "points") if more == 0 else ("differ",))


MOVING = """\
from sympy import *
from corollary.author import *
from corollary.laws import law
def derive(a, b, c):
    T, w, t = unknowns("T w t")
    x = function("x", t)
    return derivation(
        step(w, "Rate.", law("Rate", "w = ln(2)/a")),
        step(T, "Fades.", law("Fades", "dx/dt = -w*x", x=x), law("Begins", "x(0) = b", x=x),
             law("Ends", "x(T) = c*b", x=x), answers="a", routes=[route("Otherwise.", law("Way", "{way}"))]),
        confirm("Besides.", law("Second", "{besides}", x=x)),
    )
"""


@pytest.mark.parametrize(
    ("way", "besides"),
    [
        ("T = -ln(c)/w", "d2x/dt2 = w^2*x"),
        ("2^(-T/a) = c", "dx/dt = -w*b*exp(-w*t)"),
        ("T = -ln(c)/w", "d2x/dt2 = w^2*x*(1 + 1e-9)"),
        ("T = -ln(c)/w", "dx/dt = -w*b*exp(-w*t)*cos(w*t)"),
    ],
)
def test_a_law_with_derivatives_is_refuted_by_numbers(make, way, besides):
    bank = make(whole=MOVING.format(way=way, besides=besides), front=FRONT, asks=ASKS)
    found = [
        each for each in put_laws_back(solved_derivation(bank, problem_of(bank)).solvers) if each.complaint
    ]
    if "1e-9" not in besides and "cos" not in besides:
        assert found == []
        return
    (wrong,) = found
    shown = re.search(r"t = (\S+) the left side is (\S+) and the right side (\S+) \(SI\)", wrong.complaint)
    assert shown is not None, wrong.complaint
    t, left, right = map(sympy.Rational, shown.groups())
    rate = sympy.log(2) / sympy.Rational(3, 2)
    slope = -rate * sympy.Rational(7, 10) * sympy.exp(-rate * t)
    truth = -rate * slope if besides.startswith("d2") else slope
    assert abs(truth - left) < sympy.Rational(1, 10**5)
    assert left != right


def test_what_is_not_decided_is_called_so(make, monkeypatch):
    """Neither proven nor refuted: a complaint of its own, and no counter-example."""
    monkeypatch.setattr("corollary.derive.sampled._at_point", lambda trees, point: False)
    monkeypatch.setattr("corollary.derive.sampled.vanishes", lambda residual: False)
    bank = make(
        whole=WHOLE.format(law="sinh(x) = a", besides="x = ln(a + sqrt(a^2 + 1))", where=""),
        front=FRONT,
        asks=ASKS,
    )
    checked = verify(bank, problem_of(bank), 3)
    (held,) = [each for each in checked.obligations if each.kind == "laws hold"]
    assert (held.outcome, held.by) == ("undecided", "neither algebra nor numbers decide it")
    (complaint,) = checked.complaints
    assert "whether sinh(x) = a holds for the answers was not decided" in complaint
