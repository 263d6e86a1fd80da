"""Regimes: rest and sliding on an incline, by a condition of which exactly one must hold."""

from __future__ import annotations

import math
import re

import pytest
import sympy
from tests.derive.conftest import problem_of

from corollary.derive import cache
from corollary.derive.put_back import put_laws_back
from corollary.derive.solve import solve, solved_derivation
from corollary.derive.worked_solution import worked_solution
from corollary.formula.ball import Undefined
from corollary.grading.key import make_key
from corollary.grading.key_record import key_record
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter
from corollary.verify.certificate.script import certificate
from corollary.verify.verify import verify

FRONT = """\
code: X1.1
title: On a slope
given:
  m: {is: mass, value: 2, from: 1, to: 4, step: 0.5, unit: kg}
  g: {is: gravity, value: 9.81, unit: m/s^2}
  alpha: {is: angle, value: 20, from: 10, to: 40, step: 1, unit: deg}
  mus: {is: static friction, value: 0.5, from: 0.3, to: 0.6, step: 0.05, unit: "1"}
  muk: {is: kinetic friction, value: 0.2, from: 0.1, to: 0.25, step: 0.05, unit: "1"}
require:
  - m > 0
  - g > 0
  - 0 < alpha < 90 deg
  - mus > 0
  - muk > 0
"""
ASKS = '## Friction {#a .value unit="N"}\n?\n\n## Acceleration {#b .value unit="m/s^2"}\n?\n'
WHOLE = """\
import sympy
from corollary.author import *
from corollary.laws import *

def derive(m, g, alpha, mus, muk):
    F, a, N = unknowns("F a N")
    slope = m*g*sympy.sin(alpha)
    return derivation(
        step(N, "Nothing moves off the slope.", law("Normal force", "N = m*g*cos(alpha)")),
        cases(
            case("the block stays at rest", REST,
                step(F, "It balances.", law("At rest", "F = m*g*sin(alpha)"), answers="a")),
            case("the block slides", SLIDES,
                step(F, "Kinetic friction.", law("Kinetic friction", "F = muk*N"), answers="a",
                     mistakes=[mistake("That is for a block at rest.", wrong("F = mus*N"))])),
        ),
        step(a, "Newton.", law("Newton's second law", "m*a = m*g*sin(alpha) - F"), answers="b", scale=g),
    )
"""
REST, SLIDES = "slope <= mus*N", "slope > mus*N"

MANY = "sympy.Or(*(k*slope < mus*N for k in range(1, 10)))"
JOINED = [
    ("sympy.Or(slope > mus*N, slope < 0)", REST),
    ("sympy.Or(alpha > sympy.pi/6, mus < muk*2)", "sympy.And(alpha <= sympy.pi/6, mus >= muk*2)"),
    ("sympy.Not(sympy.And(slope <= mus*N, mus > 2*muk))", "sympy.And(slope <= mus*N, mus > 2*muk)"),
    ("sympy.Xor(slope > mus*N, mus > 2*muk)", "sympy.Not(sympy.Xor(slope > mus*N, mus > 2*muk))"),
]


def written(rest: str = REST, slides: str = SLIDES) -> str:
    return WHOLE.replace("REST", rest).replace("SLIDES", slides)


@pytest.fixture
def bank(make):
    return make(whole=written(), asks=ASKS, front=FRONT)


def test_each_draw_has_the_answers_of_its_own_case(bank):
    problem = problem_of(bank)
    solution = solve(bank, problem)
    met = set()
    for variant in sample(problem, 40):
        m, degrees, mus, muk = (float(variant.values[name]) for name in ("m", "alpha", "mus", "muk"))
        angle = math.radians(degrees)
        key = make_key(solution, variant)
        slides = math.tan(angle) > mus
        friction = (muk * math.cos(angle) if slides else math.sin(angle)) * m * 9.81
        assert key["a"].value == pytest.approx(friction)
        assert key["b"].value == pytest.approx(9.81 * math.sin(angle) - friction / m, abs=1e-12)
        assert ("**Here the block slides.**" in told(solution, variant)) is slides
        met.add(slides)
    assert met == {True, False}


COMPARED = re.compile(
    r"\$\$m\\, g\\, \\sin \\alpha = (\S+?)\\,\\mathrm\{N\} (\\leq|>) \\mu_\{s\}\\, N = (\S+?)\\,\\mathrm\{N\}\$\$"
)


def test_the_comparison_that_decides_stands_there_with_its_numbers(bank):
    problem = problem_of(bank)
    solution = solve(bank, problem)
    signs = set()
    for variant in sample(problem, 20):
        m, degrees, mus = (float(variant.values[name]) for name in ("m", "alpha", "mus"))
        angle = math.radians(degrees)
        compared = COMPARED.search(told(solution, variant))
        assert compared, told(solution, variant)
        assert float(compared[1]) == pytest.approx(m * 9.81 * math.sin(angle), rel=1e-3)
        assert float(compared[3]) == pytest.approx(mus * m * 9.81 * math.cos(angle), rel=1e-3)
        assert compared[2] == (">" if math.tan(angle) > mus else r"\leq")
        signs.add(compared[2])
    assert len(signs) == 2


def told(solution, variant) -> str:
    key = make_key(solution, variant)
    return worked_solution(key.solution, variant, key.values, {}, ())


def test_the_key_as_data_is_that_of_the_case(bank):
    """`corollary key` told the force of a block at rest where it slides."""
    problem = problem_of(bank)
    solution = solve(bank, problem)
    formulas = set()
    for variant in sample(problem, 40):
        told = key_record(solution, variant)["parts"]
        key = make_key(solution, variant)
        assert [told[part]["value"] for part in "ab"] == [key[part].value for part in "ab"]
        formulas.add(told["a"]["expression"])
    assert len(formulas) == 2


def test_a_proof_script_has_the_laws_of_every_case(bank):
    steps = certificate(solve(bank, problem_of(bank)))
    assert [step.names for step in steps] == [("N",), ("F",), ("a",), ("F",), ("a",)]


def test_laws_of_both_cases_are_put_back(bank):
    assert [each.complaint for each in put_laws_back(solved_derivation(bank, problem_of(bank)).solvers)] == [
        ""
    ] * 6


def test_the_cache_keeps_the_cases(bank, monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    problem = problem_of(bank)
    first = cache.solution_of(bank, problem)
    monkeypatch.setattr(cache, "_solved", None)
    again = cache.solution_of(bank, problem)
    assert again == first
    assert [each.text for each in again.regimes] == ["the block stays at rest", "the block slides"]


def test_verify_says_where_none_or_two_hold(make):
    for slides, said in (
        ("slope > 2*mus*N", "no case holds for"),
        ("slope > mus*N/2", "'the block stays at rest' and 'the block slides' holds for"),
    ):
        bank = make(whole=written(slides=slides), asks=ASKS, front=FRONT)
        complaints = [each for each in verify(bank, problem_of(bank), 2).complaints if said in each]
        assert len(complaints) == 1
        assert complaints[0].startswith("cart.py:11: ")


def test_numbers_at_which_no_case_holds_have_no_answer(make):
    bank = make(whole=written(slides="slope > 2*mus*N"), asks=ASKS, front=FRONT)
    problem = problem_of(bank)
    solution = solve(bank, problem)
    between = next(each for each in sample(problem, 60) if not solution.regimes_at(each.exact))
    with pytest.raises(Undefined, match="none of the cases hold; exactly one must"):
        make_key(solution, between)
    told = key_record(solution, between)["parts"]
    assert told["a"] == {"why": "no value for these numbers: none of the cases hold; exactly one must"}
    assert make_key(solution, chapter(problem)).solution.case == "the block stays at rest"


@pytest.mark.whole
@pytest.mark.parametrize(("slides", "rest"), JOINED)
def test_a_condition_joins_relations_by_and_or_and_not(make, slides, rest):
    """Each draw has the answers of the case whose condition is true by Python's own and, or, not."""
    problem = problem_of(bank := make(whole=written(rest, slides), asks=ASKS, front=FRONT))
    solution, cases = solve(bank, problem), set()
    for variant in sample(problem, 60):
        m, degrees, mus, muk = (float(variant.values[name]) for name in ("m", "alpha", "mus", "muk"))
        angle = math.radians(degrees)
        N = m * 9.81 * math.cos(angle)
        letters = {"slope": m * 9.81 * math.sin(angle), "N": N, "mus": mus, "muk": muk, "alpha": angle}
        truth = bool(eval(slides, {"sympy": sympy}, letters))
        friction = muk * N if truth else letters["slope"]
        assert make_key(solution, variant)["a"].value == pytest.approx(friction)
        cases.add(truth)
    assert cases == {True, False}
    checked = verify(bank, problem, 20)
    assert checked.ok, checked.complaints
    assert [each.outcome for each in checked.obligations if each.kind == "one case"] == ["proven"]


def test_a_joined_condition_that_leaves_numbers_out_is_no_case_for_them(make):
    bank = make(
        whole=written("sympy.And(slope <= mus*N, mus > 2*muk)", SLIDES),
        asks=ASKS,
        front=FRONT.replace("from: 0.1", "from: 0.2"),
    )
    assert any("no case holds for" in each for each in verify(bank, problem_of(bank), 2).complaints)


def test_the_dimensions_of_a_joined_condition_are_complained_of_once(make):
    bank = make(whole=written(REST, "sympy.Or(slope > mus*N, m > 3)"), asks=ASKS, front=FRONT)
    found = [each for each in verify(bank, problem_of(bank), 2).complaints if "cannot be compared" in each]
    assert len(found) == 1


@pytest.mark.parametrize(
    "place",
    [
        'law("Kinetic friction", "F = f", f=WHICH)',
        'law("Kinetic friction", "F = muk*N"), where=F >= WHICH',
        'law("Kinetic friction", "F = muk*N"), scale=WHICH',
    ],
)
def test_a_piecewise_is_pointed_to_cases(refused, place):
    which = "sympy.Piecewise((slope, slope <= mus*N), (muk*N, True))"
    opening, _, rest = WHOLE.partition("        cases(")
    one = f'        step(F, "Friction.", {place.replace("WHICH", which)}, answers="a"),\n'
    line, sentence = refused(
        whole=opening + one + rest[rest.index("        step(a") :], asks=ASKS, front=FRONT
    )
    assert line == 10
    assert "state each of its pieces as a case" in sentence


@pytest.mark.parametrize(
    ("rest", "slides", "said"),
    [
        (REST, "slope > 200*mus*N", "the case 'the block slides': it holds for none of"),
        (REST, "True", "is not a condition of a case; write relations"),
        (REST, "sympy.Or(m > 0, slope > mus*N)", "True is not a condition of a case; write relations"),
        (REST, MANY, "can hold in more than 8 ways; state cases with conditions that are shorter"),
    ],
)
def test_faults_are_said_at_the_case(refused, rest, slides, said):
    line, sentence = refused(whole=written(rest, slides), asks=ASKS, front=FRONT)
    assert line == 13
    assert said in sentence


def test_a_fault_before_the_cases_is_said_of_its_step(refused):
    line, sentence = refused(
        whole=written().replace("N = m*g*cos(alpha)", "N = m*cos(alpha) + g"), asks=ASKS, front=FRONT
    )
    assert (line, sentence.partition(":")[0]) == (9, "N")


def test_one_case_is_none(refused):
    one = written().replace(
        '            case("the block slides"', '            ) or cases(case("the block slides"'
    )
    _line, sentence = refused(
        whole=one.replace("cases(\n", "(cases(\n").replace(
            'wrong("F = mus*N"))])),\n        )', 'wrong("F = mus*N"))]))))'
        ),
        asks=ASKS,
        front=FRONT,
    )
    assert "cases(…) needs two cases or more" in sentence
