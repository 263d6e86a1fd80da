"""A count is exact, and has its noun: what is worked out of whole numbers is not rounded."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.verdict import Right, Slip
from corollary.grading.advice import advice
from corollary.grading.assign import admitted
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.problem.diagnostic import Malformed
from corollary.problem.variant import chosen

from .small import solved

GIVENS = """
    n: {is: number of balls, value: 7, from: 2, to: 9, step: 1}
    k: {is: number of boxes, value: 3, from: 2, to: 9, step: 1}
    v: {is: speed, value: 4, from: 1, to: 9, step: 0.5, unit: m/s}
    w: {is: speed after, value: 2, from: 1, to: 9, step: 0.5, unit: m/s}
    x: {is: ratio, value: 2.5, from: 1, to: 9, step: 0.5}
"""
PARTS = """\
a 1
b 1
c 1
d 1
#e .integer
f 1
g 1"""
STEPS = """
    p, q, half, ratio, hits, scaled, large = unknowns("p q half ratio hits scaled large")
    return derivation(
        step(p, "All.", law("A", "p = n"), answers="a"),
        step(q, "Pairs.", law("B", "q = p*(p - 1)/2"), answers="b"),
        step(half, "Halves.", law("C", "half = n/2 + k/2"), answers="c"),
        step(ratio, "A ratio.", law("D", "ratio = v/w"), answers="d"),
        step(hits, "How often.", law("E", "hits = 6*v/w"), answers="e"),
        step(scaled, "Times a ratio.", law("F", "scaled = n*x*2"), answers="f"),
        step(large, "Many.", law("G", "large = n^7"), answers="g"),
    )
"""


@pytest.fixture(scope="module")
def counting(tmp_path_factory: pytest.TempPathFactory):
    return solved(tmp_path_factory.mktemp("count"), GIVENS, PARTS, STEPS, "n, k, v, w, x")


@pytest.fixture(scope="module")
def balls(counting) -> Key:
    """7 balls, 21 pairs, 5, a ratio of 2, 12 hits, 35, and 823543."""
    return make_key(counting, chosen(counting.problem, dict[str, Fraction]()))


def is_right(key: Key, part: str, answer: object) -> bool:
    return isinstance(judge(key, {part: from_json(answer)})[part][0][0], Right)


@pytest.mark.parametrize(
    ("part", "answers"),
    [
        ("a", ["7", 7, 7.0, "7.0", "7 balls", "seven", "n", "7 bounces"]),
        ("b", ["21", "21 atoms", 21.000000000001, "2.1e1"]),
        ("c", ["5", "5.01"]),  # a half for other numbers: no count
        ("d", ["2", "2.0", "2.004"]),  # whole by chance
        ("e", ["12", "12 bounces", "12 hits", "12 marbles", "12 (red marbles)", 12.000000000001]),
        ("f", ["35", "35.1"]),
        ("g", ["823543", "8.24e5", "823 543"]),
    ],
)
def test_what_is_right(balls, part, answers):
    assert [each for each in answers if not is_right(balls, part, each)] == []


@pytest.mark.parametrize(
    ("part", "answers"),
    [
        ("a", ["6.97", "7.03", "8", "8.1 balls", "6", 7.01, "7.1"]),
        ("b", ["21.1", "20.9", "22", "20", "2e1"]),
        ("e", ["12.05", "11.95", "13", "11 bounces", "12.1 bounces"]),
        ("g", ["823542", "823544", "8.2e5", "8.23e5"]),
    ],
)
def test_what_is_not(balls, part, answers):
    assert [each for each in answers if is_right(balls, part, each)] == []


def test_twice_a_count_is_a_guess(balls):
    found = judge(balls, {"a": from_json("14"), "b": from_json("42")})
    assert not any(isinstance(found[part][0][0], Right | Slip) for part in "ab")


def test_numbers_for_which_a_count_is_none_are_not_dealt(counting):
    thirds = chosen(counting.problem, {"v": Fraction(4), "w": Fraction(9)})
    assert "(e)" in admitted(counting, thirds)[1] or "part e" in admitted(counting, thirds)[1]


@pytest.mark.parametrize(
    ("typed", "right"),
    [
        ("4, 3", True),
        ("4.0, 3.0", True),
        ("(4; 3)", True),
        (["4", 3], True),
        ("4.02, 3", False),
        ("4.01,2.99", False),
        ("4, 3.004", False),
        ("3.99, 3", False),
        ("3, 4", False),
    ],
)
def test_counts_in_a_vector_are_exact(key, typed, right):
    """How many unknowns, and how many equations."""
    assert is_right(key("S12.5nc"), "e", typed) is right


@pytest.mark.parametrize(
    ("typed", "right"), [("2", True), ("2.0", True), ("2.004", True), ("2.03", False), ("1.9", False)]
)
def test_a_ratio_that_comes_out_whole_is_measured_like_another(key, typed, right):
    assert is_right(key("X12.9"), "c", typed) is right
    assert is_right(key("E12.5.2"), "f", ["0", "1", typed, "3"]) is right


def test_of_a_ratio_that_is_whole_whatever_the_numbers_it_is_said(verdicts):
    assert verdicts("X12.9", c="2.004")["c"] == Right("Right; it is exactly 2 for all numbers.")
    assert verdicts("X12.9", c="2.0")["c"] == Right()


def test_a_whole_number_has_no_tolerance(tmp_path):
    step = 'p = unknown("p")\nreturn derivation(step(p, "All.", law("A", "p = n"), answers="a"))'
    heading = '#a .integer tolerance="5 %" because="it is estimated"'
    with pytest.raises(Malformed, match="a whole number is exact"):
        solved(tmp_path, GIVENS, heading, step, "n")


@given(st.integers(2, 9), st.integers(-50, 50).filter(bool))
def test_only_the_whole_number_itself_is_right(counting, n, off):
    own = make_key(counting, chosen(counting.problem, {"n": Fraction(n)}))
    assert is_right(own, "b", n * (n - 1) // 2)
    assert not is_right(own, "b", n * (n - 1) // 2 + off)
    assert not is_right(own, "b", n * (n - 1) / 2 + off / 100)


@pytest.mark.parametrize(
    ("part", "told"), [("b", "`2*n`"), ("c", "`2*n`"), ("g", "`2*n`"), ("d", "as a formula of `v`, `w`")]
)
def test_plain_numbers_alone_are_not_checked_by_their_units(balls: Key, part: str, told: str):
    """Every sum and product of them fits: units would find no mistake there."""
    (check,) = [each for each in advice(balls, balls.variant.problem.part(part)) if "A check" in each]
    assert told in check
    assert ("units" in check) == ("formula of" in check)
