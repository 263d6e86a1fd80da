"""What an LMS or a mailbox gives put where it is marked: whose each file is, which of several counts, and since when."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime, tzinfo
from pathlib import Path

from corollary.atomic import write_whole
from corollary.course.lms_times import Times, read_times
from corollary.grading.integrity import elsewhere, notes
from corollary.messages import few
from corollary.notebook.origin import origin
from corollary.notebook.worksheet import worksheet
from corollary.problem.dates import machine_zone
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.assigned import AssignedSheet, read_assigned
from corollary.records.collected import (
    ACCEPTED,
    GUESSED,
    NOBODY,
    OLDER,
    UNCHANGED,
    UNUSABLE,
    WORKSHEET,
    Arrival,
    digest_of,
    keep,
    numbers_of,
    read_arrivals,
    remember,
    stamp,
    writable,
)
from corollary.records.deadlines import Deadlines, read_deadlines
from corollary.records.files import Course, students
from corollary.records.lms_names import Directory, LmsName, again, lms_name
from corollary.records.settings import read_settings
from corollary.records.submission import handed_in, submissions
from corollary.sandbox.archive import Member, members
from corollary.sandbox.file import Unreadable, bytes_of
from corollary.sandbox.notebook import notebook_of

COUNTED = (ACCEPTED, UNCHANGED)
ONE_GO = 300.0  # seconds in which an LMS writes an archive: times that lie closer together are those of the download


@dataclass(frozen=True, slots=True)
class Collected:
    """Every file with what became of it; sentences on what was in conflict and on the whole; who has handed in nothing yet."""

    arrivals: tuple[Arrival, ...]
    conflicts: tuple[str, ...]
    remarks: tuple[str, ...]
    missing: tuple[str, ...]

    def of(self, outcome: str) -> tuple[Arrival, ...]:
        return tuple(each for each in self.arrivals if each.outcome == outcome)


@dataclass(frozen=True, slots=True)
class Found:
    """A notebook of this set, and whose it is."""

    student: str
    member: Member
    content: bytes
    lms: LmsName | None
    when: datetime | None
    why: str = ""
    time: str = ""  # where `when` is from: WORKSHEET, GUESSED, or the file
    latest: datetime | None = None  # after which it cannot have been handed in
    named: bool = True  # by whoever handed it in, where an LMS names who did

    @property
    def order(self) -> tuple[bool, datetime, int, int]:
        """What has the student's own name counts, then the later, then what was named as a second or third."""
        attachment = int(self.lms.attachment or 0) if self.lms else 0
        stem = (self.lms.file if self.lms else self.member.parts[-1]).removesuffix(".ipynb")
        return self.named, self.when or datetime.min.replace(tzinfo=UTC), again(stem)[1], attachment


def collect(
    course: Course,
    problem_set: ProblemSet,
    sources: Sequence[Path],
    *,
    now: datetime,
    times: Path | None = None,
    dry_run: bool = False,
    progress: Callable[[str], None] = lambda name: None,
) -> Collected:
    """Puts each student's latest notebook into `submitted/`, with the moment it was handed in; what is there already and newer
    stays. Nothing is written in a dry run. `times` is Moodle's grading worksheet. Raises NotACourse, Malformed."""
    name, roster = problem_set.name, students(course)
    before = read_arrivals(course, name)
    directory = _directory(roster, before)
    assigned = read_assigned(course, problem_set)
    met, arrivals, conflicts, moved = list[Found](), list[Arrival](), list[str](), list[str]()
    zone = read_settings(course.folder).usual.zone or machine_zone() or UTC
    # A worksheet counts only where whoever collects gave it: a student could hand in one that moves everybody's times.
    moments = Times({})
    for table in (*([times] if times else []), *(each for each in sources if each.suffix.lower() == ".csv")):
        moments = moments.joined(read_times(table, zone))
    known = {each.id: each for each in roster}
    for member in (each for source in sources if source.suffix.lower() != ".csv" for each in members(source)):
        progress(writable(member.name))
        found = _identified(member, problem_set, directory, known, assigned, conflicts)
        if isinstance(found, Found):
            met.append(found)
        else:
            arrivals.append(found)
    deadlines = read_deadlines(course, problem_set)
    dated, remarks = _dated(met, moments, zone, deadlines, now)
    by_student: dict[str, list[Found]] = {}
    for each in dated:
        by_student.setdefault(each.student, []).append(each)
    there = submissions(course, name)
    for student, theirs in by_student.items():
        *others, latest = sorted(theirs, key=lambda each: each.order)
        arrivals += [_arrival(each, OLDER, "a later one was handed in") for each in reversed(others)]
        past = Past([each for each in before if each.student == student], deadlines.of(student))
        arrivals.append(_settled(course, name, latest, there.get(student), past, moved, dry_run))
        if not dry_run:
            for each in theirs:
                keep(course, name, student, each.content)
    if not dry_run:
        remember(course, name, arrivals)
    if moved:
        remarks.append(f"{len(moved)} there already get the time of the worksheet: {few(moved, 12)}")
    came = there.keys() | by_student.keys()
    missing = tuple(each.id for each in roster if each.id in assigned and each.id not in came)
    return Collected(tuple(arrivals), tuple(conflicts), tuple(remarks), missing)


def _directory(roster: Sequence[Student], before: Sequence[Arrival]) -> Directory:
    """With the numbers that came under names of the students themselves."""
    names = Directory(roster)
    own = [
        each for each in before if (lms := lms_name(each.file.split("/"))) and names.admits(lms, each.student)
    ]
    return Directory(roster, numbers_of(own))


def _identified(
    member: Member,
    problem_set: ProblemSet,
    directory: Directory,
    roster: Mapping[str, Student],
    assigned: Mapping[str, AssignedSheet],
    conflicts: list[str],
) -> Found | Arrival:
    """Whose a file is. The name that an LMS or a person gave it counts for more than what the notebook says of itself, for
    whoever has a neighbour's notebook cannot hand in as the neighbour."""
    lms = lms_name(member.parts)
    by_place = directory.of_lms(lms) if lms else directory.of_parts(member.parts, problem_set.name)
    number = f"{lms.lms} {lms.number}" if lms else ""

    def left(student: str | None, outcome: str, why: str) -> Arrival:
        return Arrival(student or "", member.name, "", outcome, why, number=number)

    if member.content is None:
        return left(
            by_place, UNUSABLE if by_place else NOBODY, f"is no notebook; ask for {problem_set.name}.ipynb"
        )
    read = notebook_of(member.content) if isinstance(member.content, bytes) else member.content
    if isinstance(read, Unreadable) or isinstance(member.content, Unreadable):
        return left(by_place, UNUSABLE, read.why if isinstance(read, Unreadable) else "")
    says = origin(read.node)
    owner = by_place or (says.student if says.student in roster else None)
    person = lms is not None and again(lms.name)[0].casefold() not in problem_set.name.casefold()
    if by_place is None and owner is not None and lms and person and not directory.admits(lms, owner):
        why = f"was handed in by {lms.name}, who is not on the roster, and was made for {owner}"
        return left(None, NOBODY, f"{why}; add who it is to the roster, or name it after the student")
    if owner is None:
        whose = (
            f"was made for {says.student}, who is not on the roster"
            if says.student
            else "says nothing of whose it is"
        )
        return left(None, NOBODY, f"{whose}; name the file after the student, and collect it again")
    if owner not in assigned:
        return left(owner, UNUSABLE, f"{owner} has no numbers in {problem_set.name}; generate it again")
    sheet = worksheet(problem_set, roster[owner], assigned[owner].variants)
    if why := elsewhere(sheet, read.node):
        return left(owner, UNUSABLE, f"is a notebook of {says.set_name}" if says.set_name else why)
    if says.student and says.student != owner:
        conflicts.append(
            f"{writable(member.name)} is {owner}'s by its name, and was made for {says.student}: taken as {owner}'s"
        )
    named = lms is None or by_place is not None
    return Found(owner, member, member.content, lms, None, " ".join(notes(sheet, read.node)), named=named)


def _dated(
    met: Iterable[Found], times: Times, zone: tzinfo, deadlines: Deadlines, now: datetime
) -> tuple[list[Found], list[str]]:
    """When each was handed in. An archive of an LMS has the times of its download: they make nobody late."""
    met = list(met)
    spans: dict[str, list[datetime]] = {}
    for each in met:
        if each.lms and each.member.archive and (when := _own_time(each.member, zone)):
            spans.setdefault(each.member.archive, []).append(when)
    at_once = {
        archive for archive, all_ in spans.items() if (max(all_) - min(all_)).total_seconds() <= ONE_GO
    }
    dated, guessed = list[Found](), set[str]()
    for each in met:
        due = deadlines.of(each.student)
        when = times.of(each.lms) if each.lms else None
        bound, source = min(_own_time(each.member, zone) or now, now), WORKSHEET
        if when is None:
            when = bound
            says_in_time = each.lms is not None and each.lms.late is False
            unsaid = each.lms is not None and each.lms.late is None and each.member.archive in at_once
            source = GUESSED if says_in_time or unsaid or each.member.modified is None else ""
            if due is not None and when > due and source == GUESSED:
                when = due
                guessed |= {each.member.archive or each.member.name} if not says_in_time else set()
        dated.append(replace(each, when=when, time=source, latest=bound))
    remarks = [
        f"{writable(archive)} does not say when anything was handed in: all of it is taken as in time; "
        "--times FILE (Moodle's grading worksheet) says who was late"
        for archive in sorted(guessed)
    ]
    return dated, remarks


def _own_time(member: Member, zone: tzinfo) -> datetime | None:
    when = member.modified
    return when if when is None or when.tzinfo is not None else when.replace(tzinfo=zone).astimezone(UTC)


@dataclass(frozen=True, slots=True)
class Past:
    """What came of one student before, and the student's deadline."""

    arrivals: Sequence[Arrival]
    due: datetime | None

    def source(self, since: datetime | None) -> str | None:
        """Where the time of what lies in `submitted/` is from; None when it was not collected."""
        if since is None or since == self.due:
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


def _settled(
    course: Course, name: str, latest: Found, there: Path | None, past: Past, moved: list[str], dry_run: bool
) -> Arrival:
    """What becomes of a student's latest notebook, against what lies in `submitted/` already."""
    place = course.place("submitted", latest.student, name)
    if place.resolve() != (course.folder / "submitted").resolve() / latest.student / name:
        return _arrival(latest, UNUSABLE, f"{place} is a link or lies behind one; move it away")
    when, why = latest.when or datetime.now(UTC), latest.why
    if there is not None:
        content = bytes_of(there, within=course.folder / "submitted")
        since = handed_in(course, name, latest.student)
        if content == latest.content:
            if latest.time == WORKSHEET and since != when and past.source(since):
                moved.append(f"{latest.student} ({when:%Y-%m-%d %H:%M} UTC)")
                if not dry_run:
                    write_whole(place / "timestamp.txt", stamp(when))
            return _arrival(latest, UNCHANGED, why)
        if since is not None and past.is_newer(since, latest):
            return _arrival(latest, OLDER, "what lies in submitted/ is newer")
        if since is not None and since > when:
            why = f"{why} taken as newer than what lay in submitted/: one of them says no time; both are remembered"
            when = since if latest.time == GUESSED else when
        if isinstance(content, bytes) and not dry_run:
            keep(course, name, latest.student, content)
    if not dry_run:
        write_whole(place / "timestamp.txt", stamp(when))
        write_whole(course.notebook("submitted", latest.student, name), latest.content)
    return _arrival(replace(latest, when=when), ACCEPTED, why.strip())


def _arrival(found: Found, outcome: str, why: str) -> Arrival:
    number = f"{found.lms.lms} {found.lms.number}" if found.lms else ""
    when = stamp(found.when) if found.when else ""
    return Arrival(
        found.student, found.member.name, when, outcome, why, digest_of(found.content), number, found.time
    )
