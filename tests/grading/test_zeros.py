"""A zero is what a calculation leaves of it, too, on the scale of what the problem is about; a small answer is none."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.verdict import Follows, Right
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.problem.variant import chosen

from .small import solved

GIVENS = """
    v: {is: speed of A, value: 5, from: 5, to: 9, step: 0.1, unit: m/s}
    w: {is: speed of B, value: 5, from: 1, to: 5, step: 0.1, unit: m/s}
    m: {is: mass, value: 2, from: 1, to: 9, step: 0.5, unit: kg}
    q: {is: charge of A, value: 3, from: 1, to: 9, step: 0.5, unit: nC}
    Q: {is: charge of B, value: 3, from: 1, to: 9, step: 0.5, unit: nC}
    theta: {is: angle, value: 90, from: 10, to: 90, step: 10, unit: deg}
    T: {is: temperature, value: 273.15, from: 200, to: 300, step: 0.05, unit: K}
    t: {is: time, value: 1, unit: s}
"""
PARTS = """\
a m/s
b kg*m/s
c J
d nC
#e .vector unit="m/s" components="x y"
#f .list unit="m/s" components="first second"
#g .table rows="A, B" columns="v, p" unit="m/s, kg m/s"
h N
i °C
j m/s"""
STEPS = """
    u, p, K, dq, G, temperature, last = unknowns("u p K dq G temperature last")
    r = unknowns("r_x r_y")
    s = unknowns("s_x s_y")
    z = unknowns("z_a z_b z_c z_d")
    return derivation(
        step(u, "Less.", law("A", "u = v - w"), answers="a"),
        step(p, "Times m.", law("B", "p = m*u"), answers="b"),
        step(K, "Of that.", law("C", "K = m*(v - w)^2/2"), answers="c"),
        step(dq, "Less.", law("D", "dq = q - Q"), answers="d"),
        step(r, "Both.", law("E", "r_x = v - w"), law("F", "r_y = w - v"), answers="e"),
        step(s, "Both.", law("G", "s_x = v - w"), law("H", "s_y = v + w"), answers="f"),
        step(z, "All.", law("I", "z_a = v - w"), law("J", "z_b = m*v - m*w"), law("K", "z_c = v + w"),
             law("L", "z_d = m*v"), answers="g"),
        step(G, "Along.", law("M", "G = m*v*cos(theta)/t"), answers="h"),
        step(temperature, "As given.", law("N", "temperature = T"), answers="i"),
        step(last, "Root.", law("O", "last = sqrt(v^2 - w^2)"), answers="j"),
    )
"""


@pytest.fixture(scope="module")
def cancelling(tmp_path_factory: pytest.TempPathFactory) -> Key:
    """Everything comes to zero but the sums."""
    solution = solved(tmp_path_factory.mktemp("zero"), GIVENS, PARTS, STEPS, "v, w, m, q, Q, theta, T, t")
    return make_key(solution, chosen(solution.problem, dict[str, Fraction]()))


def is_right(key: Key, part: str, answer: object) -> bool:
    return isinstance(judge(key, {part: from_json(answer)})[part][0][0], Right)


@pytest.mark.parametrize(
    ("part", "answer"),
    [
        ("a", "0"),
        ("a", "0 m/s"),
        ("a", "8.9e-16 m/s"),
        ("a", "-8.9e-16 m/s"),
        ("a", 8.881784197001252e-16),
        ("a", "8.9e-14 cm/s"),
        ("b", "1e-12 kg m/s"),
        ("c", "7.9e-31 J"),
        ("c", "1e-12 J"),
        ("d", "4e-25 C"),
        ("d", "-4e-16 nC"),
        ("e", "(8.9e-16, -8.9e-16) m/s"),
        ("e", [0, 8.9e-16]),
        ("f", ["10 m/s", "8.9e-16 m/s"]),
        ("f", "-8.9e-16 m/s and 10 m/s"),
        ("g", [["8.9e-16 m/s", "-1e-15 kg m/s"], ["10 m/s", "10 kg m/s"]]),
        ("h", "6.1e-16 N"),  # what the cosine of 90° leaves
        ("i", "0 °C"),
        ("i", "5.7e-14 °C"),
        ("i", "273.15 K"),
        ("j", "1.2e-7 m/s"),  # the root of what is left
    ],
)
def test_rounding_noise_is_zero(cancelling, part, answer):
    assert is_right(cancelling, part, answer)


@pytest.mark.parametrize(
    ("part", "answer"),
    [
        ("a", "1e-6 m/s"),
        ("a", "0.01 m/s"),
        ("a", "1e-12 N"),
        ("d", "1e-9 C"),
        ("d", "1e-12 C"),
        ("d", "1 nC"),
        ("d", "0.01 nC"),
        ("e", "(8.9e-16, 0.1) m/s"),
        ("f", ["9 m/s", "8.9e-16 m/s"]),
        ("g", [["8.9e-16 m/s", "-0.2 kg m/s"], ["10 m/s", "10 kg m/s"]]),
        ("h", "0.01 N"),
        ("i", "0.1 °C"),
        ("j", "0.01 m/s"),
    ],
)
def test_a_small_answer_is_no_zero(cancelling, part, answer):
    assert not is_right(cancelling, part, answer)


@given(
    st.sampled_from("ab"),
    st.floats(0.1, 8.0),
    st.sampled_from([1, -1]),
    st.sampled_from([1e-16, 1e-15, 1e-12]),
)
def test_a_few_of_the_last_bits_of_the_givens_are_zero_and_a_millionth_is_not(
    cancelling, part, times, sign, bits
):
    size = {"a": 5.0, "b": 10.0}[part]
    assert is_right(cancelling, part, sign * times * bits * size)
    assert not is_right(cancelling, part, sign * times * 1e-6 * size)


def test_from_noise_in_the_place_of_zero_nothing_wrong_follows(cancelling):
    found = judge(cancelling, {"a": from_json("8.9e-16 m/s"), "b": from_json("1.8e-15 kg m/s")})
    assert isinstance(found["b"][0][0], Right)
    assert not isinstance(found["b"][0][0], Follows)
