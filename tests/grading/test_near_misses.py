"""Near misses of reading: found by kind where an answer earned nothing, none where it is wrong, and no mark is changed by it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.value import Exact, Items, Text, Value
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.near_misses import with_near_misses
from corollary.grading.part_grades import Grade, NearMiss
from corollary.grading.points import grade
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, find
from corollary.problem.variant import chapter

BANK = chapter_bank()
SOLUTIONS = Solutions(BANK)
POWER, MARK, CASE = "power of ten lost", "decimal or thousands mark", "capital or small letter"
ONE_NUMBER, SEVERAL, BRACKET = (
    "one number in words that were not read",
    "one of several numbers",
    "bracket lost",
)
ORDER, LETTER = "components in another order", "another letter for the same quantity"


def key_of(code: str) -> Key:
    problem = find(BANK, code)
    return make_key(SOLUTIONS.of(problem), chapter(problem))


def graded(key: Key, part: str, value: Value) -> Grade:
    answers = {part: value}
    return with_near_misses(key, grade(key, judge(key, answers)), answers)


def near(code: str, part: str, answer: Any) -> NearMiss | None:
    value = answer if isinstance(answer, Items) else from_json(answer)
    return graded(key_of(code), part, value)[part].near


# The printed numbers of X12.5: 8.6 kg m/s, 8.6 N s, 86 N, 172 N.
@pytest.mark.parametrize(
    ("code", "part", "answer", "kind", "read"),
    [
        ("X12.5", "d", "1.72*102 N", POWER, "172 N"),
        ("X12.5", "a", "8;6", MARK, "8.6"),
        ("X12.5", "a", "8..6 kg m/s", MARK, "8.6 kg m/s"),
        ("X12.5", "a", Items((Exact(8), Exact(6)), (2,)), MARK, "8.6"),
        ("X12.5", "d", "I72 N", "letter typed for a digit", "172 N"),
        ("X12.5", "c", "F*dt = 86", "right side of an equation", "86"),
        ("X12.5", "a", "8.6 kg m/s downwards", "sign told in words", "8.6 kg m/s"),
        ("X12.5", "c", "86000 mn", CASE, "86000 mN"),
        ("X12.5", "c", "the ball gets about 86 of force", ONE_NUMBER, "86"),
        ("X12.5", "c", "I found 86 newton, so p = mv", ONE_NUMBER, "86 N"),
        ("X12.5", "a", "-8.6 or 8.6 kg m/s", SEVERAL, "8.6 kg m/s"),
        ("X12.5", "a", "8.6 ± 3 kg m/s", "number before an uncertainty", "8.6 kg m/s"),
        ("X12.5", "a", "m*V", LETTER, "m*v"),
        ("X12.5", "c", "m*v/dt)", BRACKET, "m*v/dt"),
        ("X12.1", "b", "2*M*v/M+m", BRACKET, "2*M*v/(M + m)"),
        ("E12.5.1", "a", "sqrt(2*g*h)*(mA+mB/mA", BRACKET, "sqrt(2*g*h)*(mA + mB)/mA"),
        ("S12.5el", "e", ["4 m/s", "0"], ORDER, "(0, 4) m/s"),
        ("X12.2", "a", "I would go for answer (b)", "one option in words that were not read", "(B)"),
    ],
)
def test_an_answer_that_another_reading_makes_right_is_found(code, part, answer, kind, read):
    found = near(code, part, answer)
    assert found is not None
    assert (found.kind, found.read) == (kind, read)


@pytest.mark.parametrize(
    ("code", "part", "answer"),
    [
        ("X12.5", "a", "8600"),  # the unit of another scale left out is no reading
        ("X12.5", "a", "0.0086"),
        ("X12.5", "d", "172000"),
        ("X12.5", "a", "85 kg m/s"),
        ("X12.5", "a", "not 8.6 kg m/s"),
        ("X12.5", "a", "8.6 kg m/s"),  # right already
        ("X12.5", "a", ""),
        ("X12.9", "e", "5.88 rpm"),  # a unit that was read
        ("X12.8", "b2", "1.57 m/s"),  # is zero: of a tiny unit anything would be
        ("S12.5el", "e", "A: 4, B: 0"),  # each number has its name
        ("X12.2", "a", "not b"),
        ("X12.2", "a", "a or b"),
        ("X12.1", "b", "2*M*v/M"),
    ],
)
def test_an_answer_that_no_other_reading_makes_right_is_not(code, part, answer):
    assert near(code, part, answer) is None


def test_plain_degrees_that_earned_nothing_are_found():
    """X12.7 d asks for an angle in radians, 90°: `90` may be a guess, so that it earns nothing by itself."""
    found = near("X12.7", "d", "90")
    assert found is not None
    assert (found.kind, found.read) == ("degrees without their sign", "90°")


def test_what_follows_from_an_earlier_answer_of_ones_own_is_right_too():
    key = key_of("X12.5")
    answers = {"a": Text("11.3 kg m/s"), "c": Text("about 113 of force")}
    found = with_near_misses(key, grade(key, judge(key, answers)), answers)
    assert found["c"].near is not None
    assert found["a"].near is None


@given(
    st.sampled_from(("X12.5", "E12.5.1", "X12.1", "S12.5el", "X12.7")),
    st.one_of(
        st.text("0123456789.,*x/()+- mvNkgs=", max_size=14),
        st.integers(-1000, 1000),
        st.lists(st.floats(-100, 100, allow_nan=False), min_size=2, max_size=4),
    ),
)
def test_no_verdict_and_no_point_depends_on_it(code, answer):
    key = key_of(code)
    for part in key.variant.problem.parts:
        answers = {part.id: from_json(answer)}
        before = grade(key, judge(key, answers))
        after = with_near_misses(key, before, answers)
        assert [(each.verdict, each.points, each.feedback) for each in after.parts] == [
            (each.verdict, each.points, each.feedback) for each in before.parts
        ]
        assert all(each.near is None for each in after.parts if each.points or each.part.id != part.id)


@given(st.sampled_from("abcd"), st.floats(1.1, 900), st.sampled_from((1e-3, 1e3, 1e6)))
def test_a_bare_number_of_another_scale_is_never_one(part, size, scale):
    key = key_of("X12.5")
    (truth,) = key.truths[part].values
    for number in (truth * scale, size):
        if not math.isclose(number, truth, rel_tol=0.05):
            assert graded(key, part, Text(f"{number:.6f}"))[part].near is None


def test_another_bank_has_them_too(key: Callable[..., Key]):
    found = graded(key("T1"), "c", Text("m*V^2/2"))["c"].near
    assert found is not None
    assert found.read == "m*v^2/2"
