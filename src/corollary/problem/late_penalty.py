"""Penalties for late work by steps: a grace period, a share for each calendar day, a last day; and one hand-in's delay."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, date, datetime, time, timedelta, tzinfo
from fractions import Fraction
from typing import Literal

from corollary.messages import catalogue, in_convention
from corollary.problem.dates import in_words
from corollary.problem.front_matter import Reader, TableNode

_ = catalogue(__name__)

MOST_DAYS = 366
LENGTH = re.compile(r"(\d{1,4})\s*(d|days?|h|hours?|min|minutes?)$")
SHARE = re.compile(r"(\d{1,3}(?:\.\d+)?)\s*(%?)$")
HOW_TO_WRITE = "late: {grace: 12 hours, daily: 10 %, least: 50 %, last: 7 days}"
ATOM = timedelta(microseconds=1)  # what is due at midnight belongs to the day that ends


@dataclass(frozen=True, slots=True)
class Delay:
    """How late one hand-in is: seconds after the deadline (0 within the grace period), calendar days, the share of the marks that
    is left, and which rule decided."""

    seconds: float = 0.0
    days: int = 0
    share: float = 1.0
    rule: Literal["in time", "grace", "late", "last day"] = "in time"


IN_TIME = Delay()


@dataclass(frozen=True, slots=True)
class LateSteps:
    """`grace_days` end at the same time of day, `grace` is counted on a stopwatch; `daily` is taken off for each calendar day, down
    to `least`; nothing counts after the end of the day that is `last` calendar days after the deadline. `share` is left of all late
    work where nothing is taken off by the day."""

    grace_days: int = 0
    grace: timedelta = timedelta()
    daily: Fraction = Fraction(0)
    least: Fraction = Fraction(0)
    last: int | None = None
    share: float = 1.0

    def grace_end(self, due: datetime) -> datetime:
        """The moment after which work is late, in the zone of the deadline."""
        if self.grace_days:
            day = due.date() + timedelta(self.grace_days)
            due = _moment(day, due.timetz().replace(tzinfo=None), due.tzinfo)
        return (due.astimezone(UTC) + self.grace).astimezone(due.tzinfo)

    def last_moment(self, due: datetime) -> datetime | None:
        """The moment after which nothing counts; None when late work always earns something."""
        return None if self.last is None else end_of_day(due, self.last)

    def closes(self, due: datetime) -> datetime:
        """From when on a hand-in cannot earn anything, or can be no better than late."""
        return self.last_moment(due) or self.grace_end(due)

    def delay(self, due: datetime, when: datetime) -> Delay:
        """The delay of what was handed in at a moment; both with a zone. A later moment never earns more."""
        seconds = (when.astimezone(UTC) - due.astimezone(UTC)).total_seconds()
        if seconds <= 0:
            return IN_TIME
        start = self.grace_end(due)
        if when.astimezone(UTC) <= start.astimezone(UTC):
            return Delay(rule="grace")
        days = max(1, (when.astimezone(start.tzinfo).date() - _day(start)).days)
        # Where clocks are put back over midnight, a date is begun twice.
        while when.astimezone(UTC) > end_of_day(start, days).astimezone(UTC):
            days += 1
        while days > 1 and when.astimezone(UTC) <= end_of_day(start, days - 1).astimezone(UTC):
            days -= 1
        last = self.last_moment(due)
        if last is not None and when.astimezone(UTC) > last.astimezone(UTC):
            return Delay(seconds, days, 0.0, "last day")
        share = float(max(self.least, 1 - self.daily * days)) if self.daily else self.share
        return Delay(seconds, days, share, "late")


def end_of_day(when: datetime, days: int = 0) -> datetime:
    """The end of the calendar day so many days after the one of a moment, in the moment's zone."""
    return _moment(_day(when) + timedelta(days), time.max, when.tzinfo)


def _day(when: datetime) -> date:
    return (when.astimezone(UTC) - ATOM).astimezone(when.tzinfo).date()


def _moment(day: date, clock: time, zone: tzinfo | None) -> datetime:
    """The later one where clocks show it twice."""
    both = (datetime.combine(day, clock, zone).replace(fold=fold) for fold in (0, 1))
    return max(both, key=lambda each: each.astimezone(UTC))


def rule_in_words(steps: LateSteps, due: datetime) -> str:
    """What students read below the deadline of their sheet."""
    sentences: list[str] = []
    if (start := steps.grace_end(due)) != due:
        sentences.append(_("Late work loses nothing until {moment}.", moment=in_words(start)))
    if steps.daily:
        loss = _("Late work loses {share} of its points for each calendar day.", share=percent(steps.daily))
        if steps.least:
            loss = _(
                "Late work loses {share} of its points for each calendar day, but keeps at least {least}.",
                share=percent(steps.daily),
                least=percent(steps.least),
            )
        sentences.append(loss)
    elif steps.share < 1:
        sentences.append(
            _("Late work keeps {share} of its points.", share=percent(Fraction(str(steps.share))))
        )
    if (last := steps.last_moment(due)) is not None:
        sentences.append(_("Nothing counts after {moment}.", moment=in_words(last)))
    return " ".join(sentences)


def delay_in_words(steps: LateSteps, due: datetime, delay: Delay) -> str:
    """What a student reads of the own delay, as it was reckoned; empty for work in time."""
    if delay.rule == "grace":
        return _(
            "Handed in after the deadline, by {moment}: no points were lost.",
            moment=in_words(steps.grace_end(due)),
        )
    last = steps.last_moment(due)
    if delay.rule == "last day" and last is not None:
        return _("Handed in after {moment}, the last day: nothing counts.", moment=in_words(last))
    if delay.rule != "late":
        return ""
    share = in_convention(f"{delay.share:.2f}")
    if not steps.daily:
        return _("Handed in late: × {share}", share=share)
    counted = _.plural(
        "Handed in {count} calendar day late, {daily} a day: × {share}",
        "Handed in {count} calendar days late, {daily} a day: × {share}",
        delay.days,
        daily=percent(steps.daily),
        share=share,
    )
    if steps.daily * delay.days > 1 - steps.least:
        counted = _("{counted} (at least {least} is kept)", counted=counted, least=percent(steps.least))
    if (start := steps.grace_end(due)) != due:
        return _("{counted} (counted from {moment})", counted=counted, moment=in_words(start))
    return counted


def percent(share: Fraction) -> str:
    """`12.5 %`"""
    return in_convention(f"{float(100 * share):g} %")


def read_late_steps(front: Reader, table: TableNode, due: datetime | None, share: float) -> LateSteps:
    """What stands under `late:` of a set or in a course's settings; what is wrong with it is complained of."""
    row = Reader(front.path, table, "`late`", front.complaints)

    def complain(name: str, words: str) -> None:
        row.complain(row.line_of(name, "")[1], f"late: {name}: {words}; write it as {HOW_TO_WRITE}")

    days, grace = 0, timedelta()
    if text := row.text("grace", ""):
        found = LENGTH.match(text.strip())
        if found is None:
            complain("grace", f"{text} is no length of time")
        elif found[2].startswith("d"):
            days = int(found[1])
        else:
            grace = timedelta(**{"hours" if found[2].startswith("h") else "minutes": int(found[1])})
    shares = dict[str, Fraction]()
    for name in ("daily", "least"):
        if text := row.text(name, ""):
            found = SHARE.match(text.strip())
            number = Fraction(found[1]) / (100 if found[2] else 1) if found else Fraction(2)
            if number > 1:
                complain(name, f"{text} is no share; give per cent, or a number from 0 to 1")
            shares[name] = min(number, Fraction(1))
    last: int | None = None
    if text := row.text("last", ""):
        last = _last(text.strip(), due)
        if last is None:
            complain("last", f"{text} is neither a number of days nor a date after the deadline")
    row.finish()
    if max(days, last or 0) > MOST_DAYS:
        complain("last" if last and last > MOST_DAYS else "grace", f"is more than {MOST_DAYS} days")
        days, last = min(days, MOST_DAYS), None
    if shares.get("daily") and share < 1:
        complain("daily", "stands beside late: in the set's credit; keep one of them")
    if shares.get("least") and not shares.get("daily"):
        complain("least", "needs daily:")
    steps = LateSteps(
        days, grace, shares.get("daily", Fraction(0)), shares.get("least", Fraction(0)), last, share
    )
    if due is not None and (end := steps.last_moment(due)) is not None and end < steps.grace_end(due):
        complain("last", "ends before the grace period does")
    return steps


def _last(text: str, due: datetime | None) -> int | None:
    if (found := LENGTH.match(text)) is not None and found[2].startswith("d"):
        return int(found[1])
    try:
        days = None if due is None else (date.fromisoformat(text) - _day(due)).days
    except ValueError:
        return None
    return days if days is not None and days >= 0 else None
