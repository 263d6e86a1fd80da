"""Dates: the end of a day in a zone, clocks that are moved, and how a moment is written."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta, timezone
from zoneinfo import ZoneInfo

import pytest

from corollary.problem.dates import machine_zone, moment, written, zone_named

OSLO = ZoneInfo("Europe/Oslo")


@pytest.mark.parametrize(
    ("text", "in_utc"),
    [
        ("2026-12-04", "2026-12-04 22:59:59.999999"),
        ("20261204", "2026-12-04 22:59:59.999999"),
        ("2026-12-04 23:59", "2026-12-04 22:59:00"),
        (" 2026-12-04T18:00 ", "2026-12-04 17:00:00"),
        ("2026-12-04T18:00-05:00", "2026-12-04 23:00:00"),
        ("2026-12-04T18:00Z", "2026-12-04 18:00:00"),
        ("2026-07-04", "2026-07-04 21:59:59.999999"),
        ("2026-10-25", "2026-10-25 22:59:59.999999"),  # a day of 25 hours
        ("2026-10-25 02:30", "2026-10-25 01:30:00"),  # the clock shows it twice: the later one
        (
            "2026-03-29 02:30",
            "2026-03-29 01:30:00",
        ),  # and never: what a clock that was not moved on would mean
    ],
)
def test_a_date_is_a_moment_in_the_zone(text, in_utc):
    found = moment(text, OSLO)
    assert found is not None
    assert found.astimezone(UTC).replace(tzinfo=None).isoformat(" ") == datetime.fromisoformat(
        in_utc
    ).isoformat(" ")
    assert found.tzinfo is OSLO


def test_a_day_on_which_something_opens_is_its_beginning():
    assert moment("2026-12-04", OSLO, end_of_day=False) == datetime(2026, 12, 3, 23, 0, tzinfo=UTC)


@pytest.mark.parametrize(
    "text",
    ["", "tomorrow", "2026-13-01", "2026-02-30", "04.12.2026", "18:00", "0001-01-01T00:00+14:00", "9" * 50],
)
def test_what_is_no_date(text):
    assert moment(text, OSLO) is None


def test_a_moment_is_written_with_its_zone():
    assert (
        written(datetime(2026, 12, 4, 23, 59, tzinfo=OSLO)) == "Friday 4 December 2026, 23:59 (Europe/Oslo)"
    )
    assert (
        written(datetime(2026, 12, 4, 9, 5, tzinfo=ZoneInfo("Etc/UTC")))
        == "Friday 4 December 2026, 09:05 (UTC)"
    )
    offset = timezone(timedelta(hours=-5))
    assert written(datetime(2026, 12, 4, 9, 5, tzinfo=offset)) == "Friday 4 December 2026, 09:05 (UTC-05:00)"


@pytest.mark.parametrize("name", ["Berlin", "", "../../etc/passwd", "/etc/passwd", "Europe", "\ud800"])
def test_what_is_no_zone(name):
    assert zone_named(name) is None


def test_the_machines_own_zone_is_the_one_it_is_set_to(monkeypatch):
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    assert machine_zone() == ZoneInfo("Asia/Tokyo")
    assert moment("2026-12-04 09:00") == datetime(2026, 12, 4, 0, 0, tzinfo=UTC)
