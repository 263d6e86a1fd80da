"""Whatever is edited in a problem after it was handed out: nobody's numbers move, and right answers stay right."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from corollary.answers.verdict import Right
from corollary.formula.value import Text as Written
from corollary.grading.judge import judge
from corollary.grading.solutions import Solutions
from corollary.problem.variant import Variant, chapter
from corollary.records.assignments import AssignedSheet, open_record, pending, settle, sheets
from corollary.records.files import Course, open_course

from .changing_bank import PARTS, ChangingBank, Text

USED = {
    "m": [
        "value: 0.43, from: 0.3, to: 0.6, step: 0.01, unit: kg",
        "value: 0.43, from: 0.36, to: 0.6, step: 0.02, unit: kg",
        "value: 430, from: 100, to: 200, step: 10, unit: g",
        "value: 5, unit: kg",
    ],
    "v": [
        "value: 20, from: 8, to: 35, step: 0.5, unit: m/s",
        "value: 20, from: 30, to: 50, step: 2.5, unit: m/s",
        "value: 72, from: 36, to: 108, step: 3.6, unit: km/h",
    ],
    "dt": [
        "value: 0.1, from: 0.02, to: 0.15, step: 0.01, unit: s",
        "value: 100, from: 20, to: 40, step: 1, unit: ms",
    ],
}
# Printed in the statement, and of no use to the solution: it may go, or be called otherwise.
IDLE = "value: 3, from: 1, to: 9, step: 1, unit: m"
FIRST = {symbol: rows[0] for symbol, rows in USED.items()} | {"h": IDLE}
WORDS = "At {{h}} a ball of {{m}} moves at {{v}} for {{dt}}."


@st.composite
def texts(draw: st.DrawFn) -> Text:
    """The problem after an afternoon of somebody's."""
    givens = {symbol: draw(st.sampled_from(rows)) for symbol, rows in USED.items()}
    idle = draw(st.sampled_from(["h", "height", ""]))
    givens |= {idle: IDLE} if idle else {}
    givens |= {"q": "value: 0.8, from: 0.5, to: 0.9, step: 0.1"} if draw(st.booleans()) else {}
    order = draw(st.permutations(sorted(givens)))
    parts = draw(st.permutations(sorted(PARTS)))[: draw(st.integers(1, len(PARTS)))]
    return Text(
        givens={symbol: givens[symbol] for symbol in order},
        parts=tuple(parts),
        conditions=tuple(
            draw(st.sets(st.sampled_from(["m > 0", "v > 25 m/s", "m > 0.5 kg", "v*dt > 1000 m"]), min_size=1))
        ),
        words=draw(
            st.sampled_from(
                ["A ball of {{m}} moves at {{v}} for {{dt}}.", "Something moves at {{v|number}}."]
            )
        ),
        points=draw(st.sampled_from([1, 2.5])),
        ids={"a": "p"} if draw(st.booleans()) else {},
    )


@dataclass(frozen=True, slots=True)
class HandedOut:
    """What was handed out, and what is right for it, as typed."""

    ball: ChangingBank
    course: Course
    record: bytes
    exact: dict[str, dict[str, object]]
    right: dict[str, dict[str, str]]


@pytest.fixture(scope="module")
def handed_out(tmp_path_factory: pytest.TempPathFactory) -> HandedOut:
    ball = ChangingBank(tmp_path_factory.mktemp("ball"))
    ball.write(Text(givens=FIRST, words=WORDS, parts=("a", "b", "c")))
    made = ball.generate("ada", "ben", "cyd")
    solutions = Solutions(ball.bank)
    keys = {student: solutions.key(sheet.variants[0]) for student, sheet in made.assigned.items()}
    return HandedOut(
        ball,
        open_course(ball.course),
        (ball.course / ".corollary" / "assigned" / "week.json").read_bytes(),
        {student: dict(sheet.variants[0].exact) for student, sheet in made.assigned.items()},
        {
            student: {
                PARTS[part][0]: f"{key.truths[part].values[0]!r} {PARTS[part][1]}" for part in ("a", "b", "c")
            }
            for student, key in keys.items()
        },
    )


def opened(handed_out: HandedOut) -> Mapping[str, AssignedSheet]:
    """Everybody's sheet today, all that is asked agreed to."""
    course, problem_set = handed_out.course, handed_out.ball.problem_set
    (course.folder / ".corollary" / "assigned" / "week.json").write_bytes(handed_out.record)
    record = open_record(course, problem_set)
    while found := pending(course, problem_set, record):
        settle(record, found[0], agreed=True)
    return sheets(course, problem_set, record)


@settings(
    max_examples=12,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
@given(text=texts())
@example(text=Text(givens=FIRST, words=WORDS, parts=("c", "d", "a"), ids={"a": "p"}))
@example(
    text=Text(givens={symbol: USED[symbol][-1] for symbol in ("dt", "v", "m")}, conditions=("m > 100 kg",))
)
def test_nobodys_numbers_move_and_right_stays_right(handed_out: HandedOut, text: Text) -> None:
    handed_out.ball.write(text)
    solutions = Solutions(handed_out.ball.bank)
    for student, sheet in opened(handed_out).items():
        (variant,) = sheet.variants
        assert_unmoved(variant, handed_out.exact[student])
        asked = {part.title: part.id for part in variant.problem.parts}
        assert asked.keys() == {PARTS[part][0] for part in text.parts if part != "d"}
        right = handed_out.right[student]
        answers = {part: Written(right[title]) for title, part in asked.items()}
        judged = judge(solutions.key(variant), answers)
        assert all(isinstance(verdict, Right) for verdicts, _ in judged.values() for verdict in verdicts)


def assert_unmoved(variant: Variant, before: Mapping[str, object]) -> None:
    todays = variant.problem.as_written
    printed = chapter(todays).exact
    for symbol, value in variant.exact.items():
        name = "h" if symbol == "height" else symbol
        assert value == before.get(name, printed.get(symbol)), symbol


def test_numbers_are_recorded_exactly(handed_out: HandedOut) -> None:
    for sheet in opened(handed_out).values():
        assert all(isinstance(value, Fraction) for value in sheet.variants[0].values.values())
