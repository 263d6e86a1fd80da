"""What may follow from a wrong earlier answer, and what must not: where that answer makes the rest trivial."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from corollary.answers.verdict import Follows, Right
from corollary.grading.follow_through import consequences
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
