"""Every way in which a number or a condition of an author's Python reaches a key: as typed, or refused at its line."""

from __future__ import annotations

from fractions import Fraction

import pytest
from tests.derive.conftest import problem_of

from corollary.derive.load import NotDerivable
from corollary.derive.put_back import put_laws_back
from corollary.derive.solve import solve, solved_derivation
from corollary.formula.ball import RationalPi, certified
from corollary.grading.key import make_key
from corollary.problem.variant import chapter

CASES = """
N, = unknowns("N")
return derivation(
    step(N, "Weight.", law("Normal force", "N = m")),
    cases(
        case("light", {light}, step(p, "Light.", law("Light", "p = m*v"), answers="a")),
        case("heavy", {heavy}, step(p, "Heavy.", law("Heavy", "p = 2*m*v"), answers="a")),
    ),
)
"""
STEP = 'return derivation(step(p, "Newton.", law("Momentum", "p = k*m*v", k={}), answers="a"))'


@pytest.mark.parametrize(
    ("light", "heavy"),
    [
        ("t <= 1.2*v", "t > 1.2*v"), ("sympy.And(t <= 1.2*v, v < 100.5)", "t > 1.2*v"),
        ("0 < t <= 1.2*v", "t > 1.2*v"), ("t <= sympy.Rational(6, 5)*v", "v*1.2 < t"),
    ],
)  # fmt: skip
def test_a_decimal_in_the_condition_of_a_case_decides(make, light, heavy):
    """With v = 3, 1.2*v is 3.6: t = 3.5 is light, though it is more than v."""
    front = problem_front(t="value: 3.5, from: 1, to: 4, step: 0.5")
    bank = make(CASES.format(light=light, heavy=heavy).strip(), front=front, asks=PLAIN)
    solution = solve(bank, problem_of(bank))
    assert [each.text for each in solution.regimes_at(chapter(solution.problem).exact)] == ["light"]
    assert make_key(solution, chapter(solution.problem)).truths["a"].values == (1.5,)


def problem_front(**givens: str) -> str:
    return f"""\
code: X1.1
title: A cart
given:
  m: {{is: mass, value: 0.5, from: 0.1, to: 0.9, step: 0.1}}
  v: {{is: speed, value: 3, from: 1, to: 5, step: 1}}
  t: {{is: time, {givens["t"]}}}
require:
  - m > 0
  - v > 0
  - t > 0
"""


def coefficient(bank) -> Fraction:
    """Of m v in the answer, at m = v = 1."""
    (tree,) = solve(bank, problem_of(bank)).answer("a").in_givens
    value = certified(tree, {name: RationalPi(Fraction(1)) for name in "mvt"})
    assert value.proven
    return value.value


@pytest.mark.parametrize(
    ("typed", "value"),
    [
        ("1.2", 1.2), ("0.1*m/m", 0.1), ("Fraction(1, 3)", 1 / 3), ("Decimal('0.3')", 0.3), ("numpy.float64(0.3)", 0.3),
        ("numpy.float32(0.7)", 0.7), ("numpy.int64(3)", 3.0), ("10**30", 1e30), ("6.67430e-11", 6.67430e-11), ("2.5e-3", 0.0025),
    ],
)  # fmt: skip
def test_a_number_in_a_law_is_the_one_that_was_typed(make, typed, value):
    body = "import numpy\nfrom decimal import Decimal\nfrom fractions import Fraction\n" + STEP.format(typed)
    assert coefficient(make(body, front=problem_front(t="value: 2"), asks=PLAIN)) == value


PLAIN = "## Momentum {#a .value points=1}\nHow large?\n"
WHERE = 'return derivation(step(p, "Square.", law("Square", "p^2 = m^2*v^2"), answers="a", where={}))'


@pytest.mark.parametrize(
    ("body", "words"),
    [
        (STEP.format("1/3"), "write Rational(1, 3)"),
        (STEP.format("2**0.5"), "write sqrt(2)"),
        (STEP.format("3.141592653589793"), "write 1*pi"),
        (STEP.format("float('nan')"), "what is not a number"),
        (STEP.format("1e400"), "oo cannot be written as a formula"),
        (STEP.format("2j"), "is complex"),
        (STEP.format("True"), "a truth or a condition"),
        (STEP.format("'1.2'"), "without quotation marks"),
        (STEP.format("None"), "neither a number nor a formula"),
        (STEP.format("m > v"), "a truth or a condition"),
        (STEP.format("__import__('math').sqrt(m)"), "take sqrt, sin, exp, pi and the like from sympy"),
        (STEP.format("__import__('numpy').sqrt(m)"), "take sqrt, sin, exp, pi and the like from sympy"),
        (STEP.format("max(m, v)"), "write Max and Min for max and min"),
        (STEP.format("m % v"), "cannot be written as a formula"),
        (CASES.format(light="t/1.2 <= v", heavy="t/1.2 > v").strip(), "write Rational(5, 6)"),
        (WHERE.format("p > 0.1/3"), "write Rational(1, 30)"),
        (WHERE.format("p == 3"), "write Eq(p, 3)"),
        (WHERE.format("p != -m*v"), "write Ne(p, -m*v)"),
        (WHERE.format("0 < p and p < 9"), "write And(a < b, b < c)"),
        (WHERE.format("-1 < p < 9"), "write And(a < b, b < c)"),
        (WHERE.format("not p < 0"), "Not(…) of sympy"),
        (WHERE.format("p < 0 or p > 1"), "Or(…)"),
        (WHERE.format("'p > 0'"), "is not a condition; write a relation"),
        (WHERE.format("p"), "is not a condition; write a relation"),
        (WHERE.format("1"), "is not a condition; write a relation"),
        (CASES.format(light="t == v", heavy="t != v").strip(), "write Eq(t, v)"),
        (CASES.format(light="t < v/3.0*0.1", heavy="t >= v").strip(), "write Rational(1, 30)"),
        (CASES.format(light="t*1j < v", heavy="t >= v").strip(), "Invalid comparison"),
        ('same = t == v\nreturn derivation(choice("a", "So.", a=same, b=True))', "write Eq(t, v)"),
        ('if m == v:\n    pass', "write Eq(m, v)"),
        ('return derivation(step(p, "N.", law("M", "p = m*v"), answers="a", scale=1/3*m))', "write Rational(1, 3)"),
        ('return derivation(step(p, "N.", law("M", "p = m*v"), answers="a"), limit(p, v, 0, 1/3))', "write Rational(1, 3)"),
        ('return derivation(step(p, "N.", law("M", "p = m*v"), answers="a"), at(v=1/3, p=0))', "write Rational(1, 3)"),
        ('return derivation(step(p, "N.", law("M", "p = m*v"), answers="a"), always("so", p > 1/3))', "write Rational(1, 3)"),
        ('return derivation(optimum(p, "N.", of=m*v*q/3.0*0.1, over=q, between=(0, 1), answers="a"))', "write Rational(1, 30)"),
        ('return derivation(optimum(p, "N.", of=m*q, over=q, between=(0, 2**0.5), answers="a"))', "write sqrt(2)"),
        ('return derivation(step(p, "N.", law("M", "p = m*v"), answers="a", mistakes=[mistake("x", wrong("p = k*v", k=2/3*m))]))', "write Rational(2, 3)"),
        ('return derivation(step(p, "N.", law("M", "p = m*v"), answers="a", routes=[route("x", law("R", "p = k*v", k=2/3*m))]))', "write Rational(2, 3)"),
    ],
)  # fmt: skip
def test_what_is_not_as_typed_is_refused_at_its_line(refused, body, words):
    line, sentence = refused(body, front=problem_front(t="value: 2"), asks=PLAIN)
    assert words in sentence
    assert line >= 8


def test_a_comparison_in_a_module_beside_the_solution_is_refused_where_it_stands(make, tmp_path):
    make("pass")
    (tmp_path / "solutions" / "carts" / "shared.py").write_text(
        "def alike(one, other):\n    return one == other\n"
    )
    bank = make("from shared import alike\nalike(m, v)")
    with pytest.raises(NotDerivable, match=r"^shared\.py:2: derive fails: .*write Eq\(m, v\)"):
        solve(bank, problem_of(bank))


def test_comparisons_of_what_is_no_formula_are_python_s_own(make):
    """Numbers, texts, lists, arrays, and letters among other things."""
    body = """
    import numpy
    assert 1 == 1.0 and "a" != "b" and [1] == [1] and (numpy.array([1, 2]) == numpy.array([1, 3])).tolist() == [True, False]
    assert m != None and not m == "m" and 1 < 2 == 2 < 3 and m in (v, m)
    return derivation(step(p, "Newton.", law("Momentum", "p = m*v"), answers="a"))
    """
    assert coefficient(make(body)) == 1.0


def test_a_decimal_in_where_tells_the_root(make):
    bank = make(
        'return derivation(step(p, "Two.", law("Two", "p^2 - 3*m*v*p + 2*m^2*v^2 = 0"), answers="a", where=p > 1.5*m*v))'
    )
    assert [each.complaint for each in put_laws_back(solved_derivation(bank, problem_of(bank)).solvers)] == [
        ""
    ] * 1
    assert coefficient(bank) == 2.0
