"""A sign is a slip only of what has one: a direction, or a negative value for some numbers that can be dealt."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary import api
from corollary.answers.verdict import Mistaken, Right, Slip, Wrong
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.problem.variant import chosen

from .small import solved

GIVENS = """
    m: {is: mass, value: 2.3, from: 1, to: 9, step: 0.1, unit: kg}
    v: {is: velocity, value: 3.7, from: 1, to: 9, step: 0.1, unit: m/s}
    u: {is: velocity across, value: 1.7, from: 1, to: 9, step: 0.1, unit: m/s}
    w: {is: velocity of the other, value: 1.9, from: 1, to: 9, step: 0.1, unit: m/s}
    t: {is: time, value: 1.3, from: 1, to: 9, step: 0.1, unit: s}
"""
PARTS = """\
#mass .value unit="kg"
#way .value unit="m"
#energy .value unit="J"
#time .value unit="s"
#ratio .value unit="1"
#turn .value unit="deg"
#velocity .value unit="m/s"
#momentum .value unit="kg*m/s"
#gain .value unit="J"
#part .value unit="m"
#size .value unit="m/s"
#formula .expression unit="J"
#both .vector unit="m" components="A B"
#place .vector unit="m" components="x y"
#loss .value unit="J\""""
STEPS = """
    a, b, c, d, e, f, g, h, i, j, k, l, o = unknowns("a b c d e f g h i j k l o")
    both, place = vector("q", "A B"), vector("r")
    return derivation(
        step(a, "A.", law("A", "a = m*v/w"), answers="mass"),
        step(b, "B.", law("B", "b = v*t"), answers="way"),
        step(c, "C.", law("C", "c = m*v^2/2"), answers="energy"),
        step(d, "D.", law("D", "d = t*v/w"), answers="time"),
        step(e, "E.", law("E", "e = v/(v + w)*1.37"), answers="ratio"),
        step(f, "F.", law("F", "f = atan(u/v)"), answers="turn"),
        step(g, "G.", law("G", "g = v + u/3"), answers="velocity"),
        step(h, "H.", law("H", "h = m*v"), answers="momentum"),
        step(i, "I.", law("I", "i = m*(v^2 - w^2)/2"), answers="gain"),
        step(j, "J.", law("J", "j = (v - w)*t"), answers="part"),
        step(k, "K.", law("K", "k = sqrt(v^2 + u^2)"), answers="size"),
        step(l, "L.", law("L", "l = m*u^2/2"), answers="formula"),
        step(both, "M.", law("M", "q_A = v*t*1.1", q_A=both[0]), law("M", "q_B = u*t", q_B=both[1]), answers="both"),
        step(place, "N.", law("N", "r_x = v*t*1.3", r_x=place[0]), law("N", "r_y = u*t*1.2", r_y=place[1]), answers="place"),
        step(o, "O.", law("O", "o = -m*w^2/3"), answers="loss"),
    )
"""


@pytest.fixture(scope="module")
def solution(tmp_path_factory: pytest.TempPathFactory):
    return solved(tmp_path_factory.mktemp("signs"), GIVENS, PARTS, STEPS, "m, v, u, w, t")


@pytest.fixture(scope="module")
def key(solution) -> Key:
    return make_key(solution, chosen(solution.problem, dict[str, Fraction]()))


def turned(key: Key, part: str):
    """The verdict on the right answer with its sign turned."""
    values = [-value / key.variant.problem.part(part).unit.si for value in key.truths[part].values]
    typed = [f"{value:.6g}" for value in values]
    return judge(key, {part: from_json(typed if len(typed) > 1 else typed[0])})[part][0][0]


@pytest.mark.parametrize("part", ["mass", "way", "energy", "time", "ratio", "turn", "size", "both"])
def test_what_is_never_negative_has_no_sign_to_get_wrong(key, part):
    found = turned(key, part)
    assert isinstance(found, Wrong)
    assert "cannot be negative" in found.why
    assert "direction is positive" not in found.why


@pytest.mark.parametrize("part", ["velocity", "momentum", "gain", "part", "place", "loss"])
def test_what_has_a_direction_or_is_negative_for_some_numbers_has_one(key, part):
    found = turned(key, part)
    assert isinstance(found, Slip)
    assert not found.nothing


def test_one_component_of_sizes_has_no_sign_either(key):
    first, second = key.truths["both"].values
    found = judge(key, {"both": from_json([f"{first:.6g}", f"{-second:.6g}"])})["both"][0][0]
    assert isinstance(found, Wrong)
    assert "cannot be negative" in found.why


@pytest.mark.parametrize("typed", ["-m*u^2/2", "-m*u^2", "-m*u^2/4"])
def test_a_formula_of_what_is_never_negative_has_no_sign_to_get_wrong(key, typed):
    assert not isinstance(judge(key, {"formula": from_json(typed)})["formula"][0][0], Slip)


def test_a_factor_of_such_a_formula_is_a_slip(key):
    assert isinstance(judge(key, {"formula": from_json("m*u^2")})["formula"][0][0], Slip)


@pytest.fixture(scope="module")
def key_of():
    return lambda code: api.key(api.load_bank()[code])


@pytest.mark.parametrize(
    ("code", "part", "question"),
    [
        ("T12.3", "a", "a speed"),
        ("X12.4", "a", "a speed"),
        ("P12.14", "h1", "a time"),
        ("E12.7.2", "b", "a mass"),
        ("S12.5r", "c", "a height"),
        ("P12.15", "i2", "the largest speed"),
        ("S12.2", "b", "a magnitude"),
        ("X12.3", "c", "a kinetic energy"),
        ("S12.4", "b", "a ratio of magnitudes"),
        ("S12.5nc", "a", "speeds"),
        ("E12.5.1", "c", "a common speed"),
        ("E12.5.2", "a", "a *speed*"),
        ("P12.15", "e", "how large it must be"),
        ("E12.3.2", "d2", "give its magnitude"),
    ],
)
def test_the_chapter_gives_no_half_for_the_sign_of(key_of, code, part, question):
    assert isinstance(turned(key_of(code), part), Wrong), question


@pytest.mark.parametrize(
    ("code", "part"),
    [("X12.5", "a"), ("X12.5", "c"), ("S12.1", "c"), ("S12.2", "a"), ("T12.3", "b"), ("X12.3", "b"), ("X12.8", "c2"), ("S12.7", "c")],
)  # fmt: skip
def test_the_chapter_gives_half_for_the_sign_of(key_of, code, part):
    assert isinstance(turned(key_of(code), part), Slip | Mistaken)


@given(st.data())
def test_whatever_is_dealt_the_marks_of_a_sign_are_the_same(solution, data):
    numbers = {
        given.symbol: data.draw(st.integers(10, 90).map(lambda tenths: Fraction(tenths, 10)))
        for given in solution.problem.givens
    }
    own = make_key(solution, chosen(solution.problem, numbers))
    for part in ("mass", "way", "energy", "time"):
        found = turned(own, part)
        assert not isinstance(found, Slip | Right)
    if abs(own.truths["gain"].values[0]) > 1:
        assert isinstance(turned(own, "gain"), Slip)
