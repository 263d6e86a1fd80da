"""Two formulas compared: never a false verdict, always with little work."""

from __future__ import annotations

import runpy
from fractions import Fraction
from pathlib import Path

import pytest

from corollary.answers.equality import Different, Equal, Undecided, compare, hint
from corollary.formula.ball import Undefined, evaluate
from corollary.formula.errors import ParseError
from corollary.formula.rational_pi import RationalPi
from corollary.formula.syntax import author_formula, parse

PAIRS = runpy.run_path(str(Path(__file__).with_name("pairs.py")))["pairs"]()


def read(text, letters):
    tree = parse(text, letters)
    assert not isinstance(tree, ParseError), (text, tree)
    return tree


def test_there_are_enough_pairs():
    assert len(PAIRS) >= 200
    assert sum(same for *_, same in PAIRS) >= 100


@pytest.mark.parametrize(
    ("student", "truth", "letters", "domain", "same"), PAIRS, ids=[f"{each[0]} | {each[1]}" for each in PAIRS]
)
def test_no_false_verdict(student, truth, letters, domain, same):
    verdict = compare(read(student, letters), author_formula(truth, letters), domain)
    assert isinstance(verdict, Equal if same else Different), verdict


@pytest.mark.parametrize(
    ("student", "truth", "letters", "domain", "same"), [each for each in PAIRS if not each[-1]]
)
def test_a_counterexample_is_one(student, truth, letters, domain, same):
    left, right = read(student, letters), author_formula(truth, letters)
    verdict = compare(left, right, domain)
    assert isinstance(verdict, Different)
    for name, (low, high) in domain.items():
        assert low <= verdict.point.get(name, low) <= high
    values = {name: RationalPi(Fraction(value)) for name, value in verdict.point.items()}
    answer = evaluate(right, values, 200)
    try:
        assert not evaluate(left, values, 200).overlaps(answer)
    except Undefined:
        assert answer.is_finite()


def test_the_verdict_is_the_same_every_time():
    left, right = author_formula("2*m*v"), author_formula("m*v")
    assert compare(left, right, {}) == compare(left, right, {})


@pytest.mark.parametrize(
    ("student", "truth", "words"),
    [
        ("-m*v", "m*v", "sign"),
        ("2*m*v", "m*v", "twice"),
        ("m*v/2", "m*v", "halves"),
        ("1000*m*v", "m*v", "units"),
        ("theta*pi/180", "theta", "radians"),
        ("sqrt(g*h)", "sqrt(2*g*h)", "root"),
        ("0.333*m", "m/3", "rounded"),
        ("m*v^2", "m*v", ""),
        ("0*m", "m", ""),
        ("v", "abs(v)", ""),
    ],
)
def test_the_ratio_names_a_slip(student, truth, words):
    verdict = compare(author_formula(student), author_formula(truth), {"v": (-3, 3)})
    assert isinstance(verdict, Different)
    assert words in hint(verdict)
    assert words or not hint(verdict)


def test_a_student_without_a_value_differs():
    assert isinstance(compare(author_formula("sqrt(v - 20)"), author_formula("v"), {}), Different)


def test_where_the_truth_has_no_value_nothing_is_compared():
    truth = author_formula("sqrt(v)")
    assert isinstance(compare(author_formula("sqrt(v)"), truth, {"v": (-9, 1)}), Equal)
    assert isinstance(compare(author_formula("sqrt(v)"), truth, {"v": (-9, -1)}), Undecided)


def test_zero_is_equal_to_zero_only():
    assert isinstance(compare(author_formula("m*v - v*m"), author_formula("0"), {}), Equal)
    assert isinstance(compare(author_formula("m*10^(-60)*10^(-60)"), author_formula("0"), {}), Different)


def test_a_difference_in_the_sixtieth_digit_is_found():
    assert isinstance(compare(author_formula("m*(1 + 10^(-60))"), author_formula("m"), {}), Different)


@pytest.mark.parametrize(
    "text",
    [
        "(1+sin(m)+cos(v)+tan(w)+m+M)^9",
        "(m+M+v+w+g+h)^40",
        "gamma(gamma(gamma(99)))*m",
        "exp(exp(exp(exp(9))))*m",
        "((((m^64)^64)^64)^64)^64",
        "sin(10^300*m)",
        "m^(m^(m^(m^m)))",
        "tan(tan(tan(tan(tan(m)))))",
        "(m-m)/(v-v)",
        "ln(sin(m)^2 + cos(m)^2 - 1)",
    ],
)
def test_hostile_formulas_are_decided_or_given_to_a_person_with_little_work(text, calls_of):
    student, truth = author_formula(text), author_formula("m*v")
    assert isinstance(compare(student, truth, {}), Different | Undecided)
    assert calls_of(lambda: compare(student, truth, {})) < 60_000
