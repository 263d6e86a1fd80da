"""When each notebook was handed in: as a worksheet says it, as its file does, or a guess that makes nobody late."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from datetime import UTC, datetime, tzinfo
from itertools import pairwise

from corollary.course.lms_times import Times
from corollary.course.owner import Found
from corollary.records.deadlines import Deadlines
from corollary.records.submissions import GUESSED, WORKSHEET, writable
from corollary.sandbox.archive import Member

ONE_GO = 300.0  # seconds from one file to the next that an LMS writes: times that lie closer together are those of a download
UNPACKED = "the folder"  # of what an LMS gave, which has the times of the archive or of unpacking it


def dated(
    met: Iterable[Found], times: Times, zone: tzinfo, deadlines: Deadlines, now: datetime
) -> tuple[list[Found], list[str]]:
    """When each was handed in. An archive of an LMS has the times of its download: they make nobody late."""
    met = list(met)
    spans: dict[str, list[datetime]] = {}
    for each in met:
        if each.lms and (when := _own_time(each.member, zone)):
            spans.setdefault(each.member.archive or UNPACKED, []).append(when)
    downloaded = {archive: max(all_) for archive, all_ in spans.items() if _in_one_go(sorted(all_))}
    found, guessed = list[Found](), set[str]()
    for each in met:
        # In UTC: an hour that a clock shows twice compares as neither of its two moments.
        due = deadlines.of(each.student)
        due = None if due is None else due.astimezone(UTC)
        when = times.of(each.lms) if each.lms else None
        archive = each.member.archive or UNPACKED
        written = downloaded.get(archive) if each.lms else None
        bound, source = min(written or _own_time(each.member, zone) or now, now), WORKSHEET
        if when is None:
            when = bound
            says_in_time = each.lms is not None and each.lms.late is False
            unsaid = each.lms is not None and each.lms.late is None and written is not None
            source = GUESSED if says_in_time or unsaid or each.member.modified is None else ""
            if due is not None and when > due and source == GUESSED:
                when = due
                guessed |= {archive} if not says_in_time else set()
        found.append(replace(each, when=when, time=source, latest=bound))
    remarks = [
        f"{writable(archive)} does not say when anything was handed in: all of it is taken as in time; "
        "--times FILE (Moodle's grading worksheet) says who was late"
        for archive in sorted(guessed)
    ]
    return found, remarks


def _in_one_go(times: Sequence[datetime]) -> bool:
    """Whether times, in their order, are those of one download; that of a large class goes on for longer."""
    return all((after - before).total_seconds() <= ONE_GO for before, after in pairwise(times))


def _own_time(member: Member, zone: tzinfo) -> datetime | None:
    when = member.modified
    return when if when is None or when.tzinfo is not None else when.replace(tzinfo=zone).astimezone(UTC)
