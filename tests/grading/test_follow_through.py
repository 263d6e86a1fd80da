"""What may follow from a wrong earlier answer, and what must not: where that answer makes the rest trivial."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from corollary.answers.verdict import Follows, Mistaken, Right, Wrong
from corollary.grading.follow_through import consequences, from_student
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.problem.variant import chosen

from .small import solved

GIVENS = """
    m: {is: mass, value: 2, unit: kg}
    v: {is: speed before, value: 3, unit: m/s}
    w: {is: speed after, value: 5, unit: m/s}
    t: {is: time, value: 0.5, unit: s}
"""
STEPS = """
    p, change, F = unknowns("p change F")
    return derivation(
        step(p, "Mass times speed.", law("Momentum", "p = m*v", p=p, m=m, v=v), answers="a"),
        step(change, "After less before.", law("Change", "c = m*w - p", c=change, m=m, w=w, p=p), answers="b"),
        step(F, "Per time.", law("Mean force", "F = c/t", F=F, c=change, t=t), answers="c"),
    )
"""


@pytest.fixture(scope="module")
def push(tmp_path_factory: pytest.TempPathFactory) -> Key:
    """6 kg m/s before, 10 after: a change of 4 kg m/s, and 8 N."""
    folder: Path = tmp_path_factory.mktemp("push")
    solution = solved(folder, GIVENS, "a kg*m/s\nb kg*m/s\nc N", STEPS, "m, v, w, t")
    return make_key(solution, chosen(solution.problem, dict[str, Fraction]()))


def verdicts(key: Key, **answers: float) -> dict[str, object]:
    judged = judge(key, {part: from_json(value) for part, value in answers.items()})
    return {part: judged[part][0][0] for part in answers}


def test_a_later_answer_follows_from_a_wrong_one(push):
    found = verdicts(push, a=7.0, b=3.0, c=6.0)
    assert found["b"] == Follows(("a",))
    assert found["c"] == Follows(("a",))


def test_nothing_follows_from_an_answer_that_makes_the_part_zero(push):
    """With 10 kg m/s before, nothing would change at all, and every later answer would be the same 0."""
    found = verdicts(push, a=10.0, b=0.0, c=0.0)
    assert not isinstance(found["b"], (Right, Follows))
    assert not isinstance(found["c"], (Right, Follows))


def test_a_zero_is_not_carried_on(push):
    """From no momentum before, the change would be all of 10 kg m/s: the student has not begun."""
    assert not isinstance(verdicts(push, a=0.0, b=10.0)["b"], (Right, Follows))
    assert not isinstance(verdicts(push, b=0.0, c=0.0)["c"], (Right, Follows))


def test_wrong_answers_are_combined_and_the_givens_alone_come_first(push):
    found = list(consequences(push, push.truths["c"], {"a": (7.0,), "b": (5.0,)}))
    assert [(each.values, each.earlier) for each in found] == [
        ((8.0,), ()),
        ((6.0,), ("a",)),
        ((10.0,), ("b",)),
        ((10.0,), ("a", "b")),
    ]


def test_an_answer_to_a_later_part_makes_no_earlier_one(push):
    assert [each.values for each in consequences(push, push.truths["a"], {"b": (5.0,)})] == [(6.0,)]


def test_an_absurd_answer_is_not_carried_on(push):
    """Ten times too much may be a prefix, a hundred thousand times is nothing that physics follows from."""
    assert verdicts(push, b=40.0, c=80.0)["c"] == Follows(("b",))
    assert not isinstance(verdicts(push, b=4e5, c=8e5)["c"], (Right, Follows))


COPY = """
    p, J, F = unknowns("p J F")
    return derivation(
        step(p, "Mass times speed.", law("Momentum", "p = m*v", p=p, m=m, v=v), answers="a"),
        step(J, "The impulse is the momentum.", law("Impulse", "J = p", J=J, p=p), answers="b"),
        step(F, "Per time.", law("Mean force", "F = J/t", F=F, J=J, t=t), answers="c"),
    )
"""


def test_a_wrong_answer_written_down_again_earns_nothing(tmp_path):
    solution = solved(tmp_path, GIVENS, "a kg*m/s\nb kg*m/s\nc N", COPY, "m, v, w, t")
    key = make_key(solution, chosen(solution.problem, dict[str, Fraction]()))
    found = verdicts(key, a=7.0, b=7.0, c=14.0)
    assert found["b"] == Follows(("a",), nothing=True)
    assert found["c"] == Follows(("a",))  # per time is more than a copy


TURNED = """
    V, v_0, h = unknowns("V v_0 h")
    return derivation(
        step(V, "Halved.", law("Half", "2*V = v + w", V=V, v=v, w=w), answers="b"),
        step(v_0, "From the mean velocity.", law("Start", "v_0 = 3*V*m", v_0=v_0, V=V, m=m), answers="a"),
        step(h, "From it, too.", law("Later", "h = V*t", h=h, V=V, t=t), answers="c",
             mistakes=[mistake("That is the whole way.", law("Later", "h = 2*V*t", h=h, V=V, t=t))]),
    )
"""


def test_an_answer_follows_whatever_order_the_author_took(tmp_path):
    """The author finds (b) first and makes (a) and (c) of it; students meet (a) first."""
    solution = solved(tmp_path, GIVENS, "a kg*m/s\nb m/s\nc m", TURNED, "m, v, w, t")
    key = make_key(solution, chosen(solution.problem, dict[str, Fraction]()))
    assert verdicts(key, a=24.0, b=4.0, c=2.0) == {"a": Right(), "b": Right(), "c": Right()}
    assert verdicts(key, a=30.0, b=5.0)["b"] == Follows(("a",))
    assert verdicts(key, a=30.0, c=2.5)["c"] == Follows(("a",))
    assert verdicts(key, a=30.0, b=4.0, c=2.5)["c"] == Follows(("a",))


def test_what_follows_is_not_punished_again_for_a_known_mistake(tmp_path):
    """Twice the velocity, and the way that follows from it is what a mistake of its own would give."""
    solution = solved(tmp_path, GIVENS, "a kg*m/s\nb m/s\nc m", TURNED, "m, v, w, t")
    key = make_key(solution, chosen(solution.problem, dict[str, Fraction]()))
    assert isinstance(verdicts(key, c=4.0)["c"], Mistaken)
    assert verdicts(key, a=48.0, c=4.0)["c"] == Follows(("a",))


def test_answers_to_no_part_and_with_too_many_numbers_are_left_out(push):
    found = from_student(push, {"a": (6.0,), "b": (3.0,), "z": (1.0,), "c": (6.0, 1.0)})
    assert (found.right, found.wrong) == ({"a": (6.0,)}, {"b": (3.0,)})


@pytest.mark.parametrize(
    ("b", "c", "follows"),
    [
        ("2000 N", "1998.04 N", False),  # less the weight
        ("2000 N", "2001.96 N", True),
        ("2000 N", "2002 N", True),
        ("2000 N", "2000 N", True),
        ("1500 N", "1498 N", False),
        ("200 N", "198 N", False),
        ("200 N", "201 N", True),
    ],
)
def test_a_term_with_the_wrong_sign_does_not_follow(tmp_path, b, c, follows):
    """Though it is so small that what was not written down of the answer before would explain it."""
    givens = """
        m: {is: mass, value: 0.2, from: 0.1, to: 0.9, step: 0.1, unit: kg}
        p: {is: momentum, value: 0.61, from: 0.1, to: 3, step: 0.01, unit: kg*m/s}
        t: {is: time, value: 4, from: 1, to: 9, step: 1, unit: ms}
        g: {is: acceleration of gravity, value: 9.8, unit: m/s^2}
    """
    steps = """
        F, N = unknowns("F N")
        return derivation(
            step(F, "Per time.", law("F", "F = p/t"), answers="b"),
            step(N, "And the weight.", law("N", "N - m*g = F"), answers="c"),
        )
    """
    solution = solved(tmp_path, givens, "b N\nc N", steps, "m, p, t, g")
    key = make_key(solution, chosen(solution.problem, dict[str, Fraction]()))
    found = judge(key, {"b": from_json(b), "c": from_json(c)})["c"][0][0]
    assert isinstance(found, Follows) is follows, found
    if not follows:
        assert isinstance(found, Wrong)


def test_the_sign_of_a_term_is_told(key):
    of = key("E12.3.1")
    found = verdicts(of, a="0.56", b="200 N", c="199.02 N")["c"]
    assert isinstance(found, Wrong)
    assert "one term has the wrong sign" in found.why
    assert verdicts(of, a="0.56", b="200 N", c="200.98 N")["c"] == Follows(("b",))
