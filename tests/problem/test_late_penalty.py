"""Late work by steps: calendar days in the course's zone over the nights on which clocks are moved, grace, and the last day."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from fractions import Fraction
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.messages import language
from corollary.problem.bank import chapter_bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.late_penalty import LateSteps, delay_in_words, rule_in_words
from corollary.problem.problem_set import ProblemSet, Usual, read_set

BERLIN = ZoneInfo("Europe/Berlin")
TENTH = LateSteps(daily=Fraction(1, 10))


def at(text: str, zone: ZoneInfo = BERLIN) -> datetime:
    return datetime.fromisoformat(text).replace(tzinfo=zone)


@pytest.mark.parametrize(
    ("due", "when", "days"),
    [
        ("2026-12-04 23:59:59", "2026-12-05 00:00:00", 1),
        ("2026-12-04 23:59:59", "2026-12-06 23:59:59", 2),
        ("2026-12-04 23:59:59", "2026-12-07 00:00:00", 3),
        ("2026-12-04 18:00", "2026-12-04 18:01", 1),  # late on the same day
        ("2026-12-04 18:00", "2026-12-05 23:00", 1),
        ("2026-12-04 18:00", "2026-12-06 00:01", 2),
        ("2026-12-05 00:00", "2026-12-06 12:00", 2),  # midnight ends Friday
        ("2026-10-24 23:59:59", "2026-10-25 23:30", 1),  # 24.5 hours later: the day has 25
        ("2026-10-24 23:59:59", "2026-10-26 00:30", 2),
        ("2026-03-28 23:59:59", "2026-03-29 23:59", 1),  # a day of 23
        ("2026-03-28 23:59:59", "2026-03-30 00:10", 2),  # 23 hours and 10 minutes later
    ],
)
def test_days_are_those_of_the_calendar_in_the_courses_zone(due: str, when: str, days: int) -> None:
    moment = at(when).astimezone(UTC)
    assert TENTH.delay(at(due), moment).days == days
    assert TENTH.delay(at(due), moment).share == pytest.approx(1 - days / 10)


def test_grace_in_days_ends_at_the_same_time_and_in_hours_after_so_many() -> None:
    due = at("2026-10-24 18:00")
    assert LateSteps(grace_days=1).grace_end(due) == at("2026-10-25 18:00")
    assert LateSteps(grace=timedelta(hours=24)).grace_end(due) == at("2026-10-25 17:00")
    steps = LateSteps(grace_days=2, daily=Fraction(1, 10), least=Fraction(1, 2), last=7)
    found = [steps.delay(due, at(f"2026-10-{day} 17:59")) for day in range(24, 32)]
    assert [each.share for each in found] == [1, 1, 1, 0.9, 0.8, 0.7, 0.6, 0.5]
    assert [each.rule for each in found] == ["in time", "grace", "grace", *["late"] * 5]
    assert [each.seconds > 0 for each in found] == [False] * 3 + [True] * 5  # who has grace is not late
    assert steps.delay(due, at("2026-11-01 00:00")).share == 0.0


zones = st.sampled_from(
    [
        "Europe/Berlin",
        "America/Santiago",
        "Africa/Cairo",
        "Australia/Lord_Howe",
        "America/Havana",
        "Pacific/Apia",
    ]
).map(ZoneInfo)
moments = st.datetimes(datetime(2009, 1, 1), datetime(2027, 1, 1))
steps_of = st.builds(
    LateSteps,
    grace_days=st.integers(0, 3),
    grace=st.integers(0, 50).map(lambda hours: timedelta(hours=hours)),
    daily=st.integers(0, 50).map(lambda share: Fraction(share, 100)),
    least=st.integers(0, 100).map(lambda share: Fraction(share, 100)),
    last=st.none() | st.integers(4, 12),
)


@settings(max_examples=300)
@given(steps_of, zones, moments, st.integers(0, 20 * 86400), st.integers(0, 86400 * 3), st.integers(0, 20))
def test_later_never_earns_more_and_more_time_never_less(
    steps: LateSteps, zone: ZoneInfo, due: datetime, after: int, longer: int, extension: int
) -> None:
    own = due.replace(tzinfo=zone)
    when = own.astimezone(UTC) + timedelta(seconds=after)
    found = steps.delay(own, when)
    assert steps.delay(own, when + timedelta(seconds=longer)).share <= found.share
    assert 0 <= found.share <= 1
    assert (found.seconds > 0) == (when > steps.grace_end(own).astimezone(UTC))
    if found.rule == "late" and steps.daily:
        assert found.share == float(max(steps.least, 1 - steps.daily * found.days))
    extended = (own.replace(tzinfo=None) + timedelta(extension)).replace(tzinfo=zone)
    assert steps.delay(extended, when).share >= found.share


def read(folder: Path, lines: str, usual: Usual | None = None) -> ProblemSet:
    path = folder / "week.md"
    path.write_text(f"---\ntitle: Week\ndue: 2026-12-04\n{lines}problems: [X12.5]\n---\nBegin.\n")
    return read_set(chapter_bank(), path, usual or Usual(BERLIN))


def test_students_read_the_rule_and_how_it_was_reckoned(tmp_path: Path) -> None:
    week = read(tmp_path, "late: {grace: 12 hours, daily: 10 %, least: 50 %, last: 2026-12-11}\n")
    steps, due = week.late_steps, week.due
    assert steps is not None
    assert due is not None
    assert rule_in_words(steps, due) == week.late_rule == (
        "Late work loses nothing until Saturday 5 December 2026, 11:59 (Europe/Berlin). "
        "Late work loses 10 % of its points for each calendar day, but keeps at least 50 %. "
        "Nothing counts after Friday 11 December 2026, 23:59 (Europe/Berlin)."
    )  # fmt: skip
    late = week.delay(due, at("2026-12-07 09:00"))
    sentence = delay_in_words(steps, due, late)
    assert sentence.startswith("Handed in 2 calendar days late, 10 % a day: × 0.80 (counted from Saturday 5")
    with language("de"):
        assert "× 0,80" in delay_in_words(steps, due, late)
    assert "nothing counts" in delay_in_words(steps, due, week.delay(due, at("2026-12-12 09:00")))
    floor = delay_in_words(steps, due, week.delay(due, at("2026-12-11 09:00")))
    assert "6 calendar days late, 10 % a day: × 0.50 (at least 50 % is kept)" in floor
    plain = read(tmp_path, "late: {daily: 10 %}\n")
    assert delay_in_words(plain.late_steps, due, plain.delay(due, at("2026-12-06 09:00"))) == (
        "Handed in 2 calendar days late, 10 % a day: × 0.80"
    )


def test_the_courses_rule_holds_for_sets_that_say_nothing(tmp_path: Path) -> None:
    usual = Usual(BERLIN, late_steps=TENTH)
    assert read(tmp_path, "", usual).late_steps == TENTH
    assert read(tmp_path, "credit: {late: 0.8}\n", usual).late_steps is None
    own = read(tmp_path, "late: {daily: 0.2}\n", usual).late_steps
    assert own is not None
    assert own.daily == Fraction(1, 5)


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        ("late: {grace: soon}\n", "soon is no length of time"),
        ("late: {daily: 110 %}\n", "110 % is no share"),
        ("late: {daily: 10 %, last: 2026-12-01}\n", "neither a number of days nor a date after the deadline"),
        ("late: {grace: 9 days, last: 7 days}\n", "ends before the grace period does"),
        ("late: {least: 50 %}\n", "needs daily"),
        ("late: {daily: 10 %}\ncredit: {late: 0.8}\n", "keep one of them"),
        ("late: {dayly: 10 %}\n", "dayly"),
    ],
)
def test_a_rule_that_cannot_hold_is_refused_with_its_line(tmp_path: Path, lines: str, words: str) -> None:
    with pytest.raises(Malformed) as refused:
        read(tmp_path, lines)
    assert words in str(refused.value)
    assert "week.md:4" in str(refused.value)
