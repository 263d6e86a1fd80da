"""A student's latest notebook against the one that lies in `submitted/` already."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

from corollary.atomic import write_whole
from corollary.course.owner import Found
from corollary.records.files import Course
from corollary.records.submissions import (
    ACCEPTED,
    GUESSED,
    OLDER,
    UNCHANGED,
    UNUSABLE,
    WORKSHEET,
    Arrival,
    digest_of,
    handed_in,
    keep,
    stamp,
)
from corollary.sandbox.file import bytes_of

COUNTED = (ACCEPTED, UNCHANGED)


@dataclass(frozen=True, slots=True)
class Past:
    """What came of one student before, the student's deadline, and whether grading guessed the time of what lies there."""

    arrivals: Sequence[Arrival]
    due: datetime | None
    guessed: bool

    def source(self, since: datetime | None) -> str | None:
        """Where the time of what lies in `submitted/` is from; None when it was not collected."""
        if since is None or self.guessed or (self.due is not None and since == self.due.astimezone(UTC)):
            return GUESSED
        ours = [each for each in self.arrivals if each.when == stamp(since) and each.outcome in COUNTED]
        return (
            (ours[-1].time or (WORKSHEET if ours[-1].number.startswith("moodle ") else "")) if ours else None
        )

    def is_newer(self, since: datetime, found: Found) -> bool:
        """Whether what lies there is newer. A guessed time is not compared with others: what is new counts, and what was
        taken before and replaced does not come back."""
        when, guessed = found.when or since, self.source(since) == GUESSED
        earlier = [each.outcome for each in self.arrivals if each.digest == digest_of(found.content)]
        if any(each in COUNTED for each in earlier) and found.time:
            return when <= since or guessed or found.time == GUESSED
        if found.time == GUESSED and not earlier:
            return found.latest is not None and since > found.latest
        return since > when and not (guessed and not earlier)


def counting(
    theirs: Sequence[Found], before: Sequence[Arrival], tries: int | None
) -> tuple[list[Found], list[Found]]:
    """A student's notebooks, the earliest first, parted into those that count and those beyond the tries that a set allows;
    the same notebook once more is no other try. `before` is what was collected of the student earlier."""
    tried = {each.digest for each in before if each.outcome in (*COUNTED, OLDER)}
    count, beyond = list[Found](), list[Found]()
    for each in theirs:
        digest = digest_of(each.content)
        within = tries is None or digest in tried or len(tried) < tries
        if within:
            tried.add(digest)
        (count if within else beyond).append(each)
    return count, beyond


def settled(
    course: Course, name: str, latest: Found, there: Path | None, past: Past, moved: list[str], dry_run: bool
) -> Arrival:
    """What becomes of a student's latest notebook, against what lies in `submitted/` already."""
    place = course.place("submitted", latest.student, name)
    if place.resolve() != (course.folder / "submitted").resolve() / latest.student / name:
        return latest.arrival(UNUSABLE, f"{place} is a link or lies behind one; move it away")
    when, why = latest.when or datetime.now(UTC), latest.why
    if there is not None:
        content = bytes_of(there, within=course.folder / "submitted")
        since = handed_in(course, name, latest.student)
        if content == latest.content:
            if latest.time == WORKSHEET and since != when and past.source(since):
                moved.append(f"{latest.student} ({when:%Y-%m-%d %H:%M} UTC)")
                if not dry_run:
                    write_whole(place / "timestamp.txt", stamp(when))
            return latest.arrival(UNCHANGED, why)
        if since is not None and past.is_newer(since, latest):
            return latest.arrival(OLDER, "what lies in submitted/ is newer")
        if since is not None and since > when:
            why = f"{why} taken as newer than what lay in submitted/: one of them says no time; both are remembered"
            when = since if latest.time == GUESSED else when
        if isinstance(content, bytes) and not dry_run:
            keep(course, name, latest.student, content)
    if not dry_run:
        write_whole(place / "timestamp.txt", stamp(when))
        write_whole(course.notebook("submitted", latest.student, name), latest.content)
    return replace(latest, when=when).arrival(ACCEPTED, why.strip())
