"""The dates of a problem set: moments in the course's time zone, and when right values may be seen."""

from __future__ import annotations

import os
from datetime import UTC, date, datetime, time, tzinfo
from pathlib import Path
from typing import Literal
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from corollary.messages import N_, catalogue, language

_ = catalogue(__name__)
WEEKDAYS = (
    N_("Monday"),
    N_("Tuesday"),
    N_("Wednesday"),
    N_("Thursday"),
    N_("Friday"),
    N_("Saturday"),
    N_("Sunday"),
)
MONTHS = (
    N_("January"),
    N_("February"),
    N_("March"),
    N_("April"),
    N_("May"),
    N_("June"),
    N_("July"),
    N_("August"),
    N_("September"),
    N_("October"),
    N_("November"),
    N_("December"),
)
Reveal = Literal["no", "after due", "after extensions", "by hand"]
# What a set's `reveal:` may say; `yes` is the word of old.
REVEAL: dict[str, Reveal] = {
    "no": "no",
    "yes": "after due",
    "after due": "after due",
    "after extensions": "after extensions",
    "by hand": "by hand",
}
HOW_TO_WRITE = (
    "write it as 2026-12-04 (the end of that day), 2026-12-04 18:00, or with a zone, 2026-12-04T18:00+01:00"
)
_UTC_BY_NAME = {"UTC", "Etc/UTC", "Etc/UCT", "Etc/Universal", "Etc/Zulu", "GMT", "Etc/GMT"}


def moment(text: str, zone: tzinfo | None = None, *, end_of_day: bool = True) -> datetime | None:
    """The moment a date stands for, in the zone (None: the machine's own); None when it is no date.

    A day alone is its end, or its beginning; a clock that shows this time twice, or never, means the later moment.
    """
    text, edge = text.strip(), time.max if end_of_day else time.min
    try:
        day = _day(text)
        found = datetime.fromisoformat(text) if day is None else datetime.combine(day, edge)
        zone = zone or machine_zone()
        if found.tzinfo is not None:
            return found.astimezone(zone)
        if zone is None:
            return found.astimezone()
        return max((found.replace(tzinfo=zone, fold=fold) for fold in (0, 1)), key=_in_utc)
    except (ValueError, OverflowError):
        return None


def _day(text: str) -> date | None:
    try:
        return date.fromisoformat(text)
    except ValueError:
        return None


def written(when: datetime) -> str:
    """A moment for those who run commands: `Friday 4 December 2026, 23:59 (Europe/Berlin)`."""
    with language("en"):
        return in_words(when)


def in_words(when: datetime) -> str:
    """The same in the language spoken: `Freitag, 4. Dezember 2026, 23:59 Uhr (Europe/Berlin)`."""
    name = getattr(when.tzinfo, "key", None) or when.tzname() or ""
    return _(
        "{weekday} {day} {month} {year}, {time} ({zone})",
        weekday=_(WEEKDAYS[when.weekday()]),
        day=when.day,
        month=_(MONTHS[when.month - 1]),
        year=when.year,
        time=f"{when:%H:%M}",
        zone="UTC" if name in _UTC_BY_NAME else name,
    )


def zone_named(name: str) -> ZoneInfo | None:
    """The time zone of this name; None when there is none."""
    try:
        return ZoneInfo(name)
    except (ZoneInfoNotFoundError, ValueError, OSError):
        return None


def machine_zone() -> ZoneInfo | None:
    """The time zone this machine is set to, by its name; None where the system does not say one."""
    named = os.environ.get("TZ", "").removeprefix(":")
    if not named:
        _, found, named = os.path.realpath(Path("/etc/localtime")).replace("\\", "/").partition("zoneinfo/")
        if not found:
            return None
    return zone_named(named)


def _in_utc(when: datetime) -> datetime:
    return when.astimezone(UTC)
