"""Laws of the judge, for whatever numbers and whatever answers."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Wrong
from corollary.formula.value import Complex, Exact, Items, Measured, Nothing, Real, Refused, Text, Value
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.grading.points import grade
from corollary.problem.variant import at, first_broken, size

QUICK = settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
PREFIXES = {"": 1.0, "k": 1e3, "m": 1e-3, "M": 1e6, "µ": 1e-6}
VERDICTS = (Right, Follows, Mistaken, Slip, Wrong, Unread, Unmarked)

indices = st.integers(0, 2**60)
floats = st.floats(allow_nan=True, allow_infinity=True)
odd_texts = st.text(max_size=40) | st.text(alphabet="0123456789.,eE+-*/^() kmgsNJxyijθ=", max_size=30)
texts = odd_texts | st.sampled_from(
    [
        "8.6 kg m/s",
        "(3, 4) m/s",
        "5 m/s at 30 deg",
        "m*v",
        "p = m*v",
        "1,234 N",
        "9**9**9",
        "b",
        "0",
        "-0",
        "x to the left",
        "3 m/s, x to the left",
    ]
)
leaves: st.SearchStrategy[Value] = st.one_of(
    st.just(Nothing()),
    st.builds(Real, floats),
    st.builds(Exact, st.fractions()),
    st.builds(Exact, st.sampled_from([Fraction(10) ** 500, Fraction(1, 10**500)])),
    st.builds(Complex, floats, floats),
    st.builds(Text, texts),
    st.builds(Measured, floats, st.sampled_from(["newton", "N", "kg*m/s", "parsec", ""])),
    st.builds(Refused, st.text(max_size=10), st.text(max_size=10)),
)
plains = st.recursive(
    leaves,
    lambda inner: st.lists(inner, max_size=4).map(lambda items: Items(tuple(items), (len(items),))),
    max_leaves=6,
)


def variant_of(solved, index):
    """A variant of the grid on which the problem's conditions hold."""
    variant = at(solved.problem, index % size(solved.problem))
    assume(first_broken(variant) is None)
    return variant


def single(key, part, answer: Value):
    return judge(key, {part: answer})[part][0][0]


@pytest.mark.parametrize(
    ("code", "part", "unit"), [("X12.5", "c", "N"), ("X12.8", "b", "m/s"), ("X12.10", "b", "J")]
)
@QUICK
@given(index=indices, prefix=st.sampled_from(sorted(PREFIXES)))
def test_a_right_answer_stays_right_in_another_unit(solution, code, part, unit, index, prefix):
    assume(unit != "m/s" or prefix in ("", "k", "m", "µ"))
    key = make_key(solution(code), variant_of(solution(code), index))
    value = key.truths[part].values[0] / PREFIXES[prefix]
    assert isinstance(single(key, part, Text(f"{value!r} {prefix}{unit}")), Right)


@pytest.mark.parametrize(("code", "part"), [("X12.5", "d"), ("X12.10", "a"), ("X12.10", "b")])
@QUICK
@given(index=indices, figures=st.integers(3, 15))
def test_three_figures_are_always_enough(solution, code, part, index, figures):
    solved = solution(code)
    key = make_key(solved, variant_of(solved, index))
    value = key.truths[part].values[0]
    assume(value != 0)
    unit = solved.problem.part(part).unit.text
    assert isinstance(single(key, part, Text(f"{value:.{figures - 1}e} {unit}")), Right)


@pytest.mark.parametrize(
    ("code", "part"), [("X12.5", "d"), ("X12.10", "a"), ("X12.10", "b"), ("X12.8", "a"), ("X12.7", "c")]
)
@QUICK
@given(index=indices, off=st.floats(1.01, 400), below=st.booleans())
def test_beyond_the_tolerance_nothing_is_right(solution, code, part, index, off, below):
    solved = solution(code)
    key = make_key(solved, variant_of(solved, index))
    truth = key.truths[part]
    assume(truth.scale > 0)
    factor = 1 + truth.tolerance * off * (-1 if below else 1)
    size_of = float(solved.problem.part(part).unit.factor)
    values = tuple(Real(value * factor / size_of + 0.0) for value in truth.values)
    assume(
        all(len(repr(each.value)) > 8 or each.value == 0 for each in values)
    )  # as calculated, not as rounded by hand
    verdict = single(key, part, values[0] if len(values) == 1 else Items(values, (len(values),)))
    assert not isinstance(verdict, (Right, Follows)), verdict


@pytest.mark.whole
@pytest.mark.parametrize("code", ["T1", "X12.7", "X12.10", "P12.14"])
@settings(max_examples=80, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(answers=st.lists(plains, min_size=6, max_size=6))
def test_a_verdict_never_raises_whatever_comes_in(key, code, answers):
    own = KEYS.setdefault(code, key(code))
    parts = own.variant.problem.parts
    judged = judge(own, {part.id: answers[place % 6] for place, part in enumerate(parts)})
    assert set(judged) == {part.id for part in parts}
    assert all(isinstance(verdict, VERDICTS) for verdicts, _ in judged.values() for verdict in verdicts)
    marked = grade(own, judged)
    assert 0 <= marked.points <= marked.out_of
    assert all(math.isfinite(part.points) for part in marked.parts)


KEYS: dict = {}


@QUICK
@given(index=indices, ratio=st.floats(0.2, 5))
def test_a_consistent_student_always_gets_the_later_points(solution, index, ratio):
    """Whatever was found in (a), who goes on with it rightly earns the points of (b) and (c)."""
    solved = solution("X12.5")
    key = make_key(solved, variant_of(solved, index))
    a, dt = key.truths["a"].values[0] * ratio, float(key.variant.values["dt"])
    judged = judge(key, {"a": Real(a), "b": Real(a), "c": Real(a / dt)})
    for part in "bc":
        assert isinstance(judged[part][0][0], (Right, Follows)), judged[part]


@QUICK
@given(index=indices, turn=st.floats(0, 2 * math.pi))
@example(index=0, turn=0.0078125)  # 4.8 kg m/s at 12.4476°: a length of two figures, and half a degree off
def test_a_vector_by_its_length_and_direction_is_the_same_vector(solution, index, turn):
    solved = solution("X12.8")
    key = make_key(solved, variant_of(solved, index))
    x, y = key.truths["a"].values
    length, angle = math.hypot(x, y), math.degrees(math.atan2(y, x))
    assert isinstance(single(key, "a", Text(f"{length!r} kg m/s at {angle!r} deg")), Right)
    other = Text(f"{length!r} kg m/s at {angle + math.degrees(turn)!r} deg")
    apart = math.dist((1, 0), (math.cos(turn), math.sin(turn)))
    assume(apart > 1.001 * key.truths["a"].tolerance)
    assert not isinstance(single(key, "a", other), Right)
