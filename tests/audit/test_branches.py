"""Right answers on every branch, each beside a wrong one: none is called wrong or impossible, and none of the wrong agrees."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

EXERCISES: list[dict[str, Any]] = yaml.safe_load(
    (Path(__file__).parent / "branches.yaml").read_text(encoding="utf-8")
)


def published(exercise: dict[str, Any], answer: str) -> str:
    fields = {name: value for name, value in exercise.items() if name not in ("right", "wrong")}
    return yaml.safe_dump([fields | {"published": exercise[answer]}])


@pytest.mark.parametrize("exercise", EXERCISES, ids=lambda each: each["id"])
def test_right_agrees_and_wrong_does_not(audited, exercise):
    right = audited(published(exercise, "right"))
    wrong = audited(published(exercise, "wrong"))
    assert {each.finding for each in right} == {"agrees"}, right[0].why
    assert {each.finding for each in wrong} <= {"wrong", "impossible"}, wrong[0].why


def test_there_are_enough():
    assert len(EXERCISES) >= 40


LATE = """
- id: late
  given: {{w: 3 rad/s, A: 2 m, x: 1 m}}
  laws: ["x = A*sin(w*t)"]
  where: {where}
  asked: t
  published: {published}
"""


@pytest.mark.parametrize(
    ("where", "published", "finding"),
    [
        ("[t > 1 s, t < 2.5 s]", "2.27 s", "agrees"),
        ("[t > 1 s, t < 3 s]", "2.27 s", "not unique"),  # 2.967 s as well
        ("t > 1 s", "2.27 s", "not unique"),
        ("t > 1 s", "2.37 s", "wrong"),
        ("[t > 1 s, t < 2 s]", "1.27 s", "impossible"),
        ("[t > 1 s, t < 2 s]", "2.27 s", "impossible"),
    ],
)
def test_a_crossing_that_the_conditions_admit_alone(audited, where, published, finding):
    (outcome,) = audited(LATE.format(where=where, published=published))
    assert outcome.finding == finding, outcome.why


@pytest.mark.parametrize(
    ("published", "finding"), [("45.0 deg", "agrees"), ("225.0 deg", "not unique"), ("135.0 deg", "wrong")]
)
def test_an_angle_of_which_nothing_is_said(audited, published, finding):
    text = "- {{id: a, given: {{x: 3 m, y: 3 m}}, laws: [tan(b) = y/x], asked: b, published: {}}}"
    (outcome,) = audited(text.format(published))
    assert outcome.finding == finding, outcome.why


def test_intervals_decide_where_algebra_takes_too_long(tmp_path):
    """The oblique collision, by intervals alone."""
    from corollary.audit.examine import examine
    from corollary.audit.record_file import records_in

    exercise = next(each for each in EXERCISES if each["id"] == "elastic of two masses")
    path = tmp_path / "r.yaml"
    path.write_text(published(exercise, "right"), encoding="utf-8")
    (outcome,) = examine(records_in(path)[0], by_algebra=False)
    assert outcome.finding == "agrees"


STATED_OUTRIGHT = """
- id: outright
  given: {{x: -1 m, y: {y}}}
  laws: ["b = {function}"]
  where: {where}
  asked: b
  published: {published}
"""


@pytest.mark.parametrize(
    ("y", "function", "where", "published", "finding", "words"),
    [
        ("-1 m", "atan2(y, x)", "[]", "225 deg", "ambiguous", "a whole turn further"),
        ("-1 m", "atan2(y, x)", "[]", "-135 deg", "agrees", ""),
        ("-1 m", "atan2(y, x)", "[]", "45 deg", "wrong", ""),
        ("-1 m", "atan2(y, x)", "b < 180 deg", "225 deg", "wrong", ""),
        ("1 m", "atan(y/x)", "90 deg < b < 180 deg", "135 deg", "impossible", "state tan(b) = … instead"),
        ("1 m", "tan(y/x)", "b > 0", "135 deg", "impossible", ""),
    ],
)
def test_an_angle_that_a_law_states_outright(audited, y, function, where, published, finding, words):
    text = STATED_OUTRIGHT.format(y=y, function=function, where=where, published=published)
    (outcome,) = audited(text)
    assert outcome.finding == finding, outcome.why
    assert words in outcome.why
    assert ("instead" in outcome.why) == ("instead" in words)
