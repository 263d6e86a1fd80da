"""Collecting files from an LMS or a mailbox for marking: every file taken, or named with the reason."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from functools import cache, partial
from pathlib import Path

import msgspec

from corollary.atomic import SIDE_BY_SIDE, write_whole
from corollary.course.failure_log import FailureLog
from corollary.course.hand_in_time import Times, dated, read_times
from corollary.course.lms_numbers import OwnFiles, as_they_came, known_numbers
from corollary.course.lms_places import worksheet_numbers
from corollary.course.owner import LATER, Found, directory_of, identified, not_a_notebook, numbers_before
from corollary.guard import Failure, guarded
from corollary.messages import few
from corollary.problem.dates import machine_zone
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import read_assigned
from corollary.records.deadlines import read_deadlines
from corollary.records.files import Course, students
from corollary.records.lms_names import Directory, lms_name
from corollary.records.notebook_archive import LARGE, folded, keep, read_hand_in, read_sheet, set_aside
from corollary.records.regrade_requests import (
    MOST_BYTES,
    add_requests,
    file_name,
    is_request,
    part_places,
    requests_in,
    set_asked_about,
)
from corollary.records.settings import read_settings
from corollary.records.submissions import (
    ACCEPTED,
    GUESSED,
    NOBODY,
    OLDER,
    STAMP,
    UNCHANGED,
    UNUSABLE,
    WORKSHEET,
    Arrival,
    digest_of,
    guessed_time,
    handed_in,
    own_folder,
    read_arrivals,
    remember,
    stamp,
    submissions,
    writable,
)
from corollary.sandbox.archive import Member, members

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
    course: Course,
    name: str,
    latest: Found,
    there: Path | None,
    past: Past,
    moved: list[str],
    dry_run: bool,
    large: bool,
) -> Arrival:
    """What becomes of a student's latest notebook, against what lies in `submitted/` already; `large`: with its code folded."""
    place = course.place("submitted", latest.student, name)
    if own_folder(course, name, latest.student) is None:
        return latest.arrival(
            UNUSABLE, f"{place} is a link, or lies in a linked folder; replace it by a folder"
        )
    when, why = latest.when or datetime.now(UTC), latest.why
    if there is not None:
        content = read_hand_in(course, there)
        since = handed_in(course, name, latest.student)
        if content == latest.content:
            if latest.time == WORKSHEET and since != when and past.source(since):
                moved.append(f"{latest.student} ({when:%Y-%m-%d %H:%M} UTC)")
                if not dry_run:
                    write_whole(place / STAMP, stamp(when))
            return latest.arrival(UNCHANGED, why)
        if since is not None and past.is_newer(since, latest):
            return latest.arrival(OLDER, "the file in submitted/ is newer")
        if since is not None and since > when:
            why = f"{why} taken as newer than the file in submitted/, since one of the two has no time; both are kept"
            when = since if latest.time == GUESSED else when
        if isinstance(content, bytes) and not dry_run:
            keep(course, name, latest.student, content)
    if not dry_run:
        content = folded(course, name, latest.student, latest.content) if large else latest.content
        write_whole(place / STAMP, stamp(when))
        write_whole(course.notebook("submitted", latest.student, name), content)
    return replace(latest, when=when).arrival(ACCEPTED, why.strip())


LONGEST = 30.0  # seconds of the processor for one file; the slowest that was met takes two


@dataclass(frozen=True, slots=True)
class CollectedRequest:
    """A form for regrading of one student: the parts that it asks about, and how many of these requests are new."""

    student: str
    file: str
    parts: tuple[str, ...]
    new: int


@dataclass(frozen=True, slots=True)
class Collected:
    """Every file with what became of it; sentences on what was in conflict and on the whole; who has handed in nothing yet and is
    not excused; the file with the tracebacks where this program failed over something."""

    arrivals: tuple[Arrival, ...]
    conflicts: tuple[str, ...]
    remarks: tuple[str, ...]
    missing: tuple[str, ...]
    log: Path | None = None
    requests: tuple[CollectedRequest, ...] = ()

    def of(self, outcome: str) -> tuple[Arrival, ...]:
        return tuple(each for each in self.arrivals if each.outcome == outcome)


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
    assigned = read_assigned(course, problem_set)
    met, arrivals, conflicts, moved = list[Found](), list[Arrival](), list[str](), list[str]()
    zone = read_settings(course.folder).usual.zone or machine_zone() or UTC
    # A worksheet counts only where whoever collects gave it: a student could hand in one that moves everybody's times.
    moments, numbers, by_id = Times({}), dict[str, str](), dict[str, str]()
    for table in (*([times] if times else []), *(each for each in sources if each.suffix.lower() == ".csv")):
        moments = moments.joined(read_times(table, zone))
        numbers |= worksheet_numbers(table, roster)
        by_id |= worksheet_numbers(table, roster, by_name=False)
    failures = FailureLog(course, name)
    directory = directory_of(roster, before, numbers)
    known = {each.id: each for each in roster}
    requests, forms = list[CollectedRequest](), list[Member]()
    released = partial(read_sheet, course, name)
    for member in _members(sources, directory, name):
        progress(writable(member.name))
        if is_request(member.parts[-1], name):
            forms.append(member)
            continue
        if about := set_asked_about(member.parts[-1]):
            arrivals.append(_of_another_set(member, directory, name, about))
            continue
        found = guarded(
            partial(identified, member, problem_set, directory, known, assigned, conflicts, released), LONGEST
        )
        if isinstance(found, Found):
            met.append(found)
        else:
            if isinstance(found, Failure):
                stumbled = _stumbled(member, directory, name, found)
                failures.add(stumbled.student or writable(member.name), [found])
                found = stumbled
            arrivals.append(found)
    own = OwnFiles(known_numbers(roster, numbers_before(roster, before), by_id), known)
    met = as_they_came(own.of(met), (*before, *own.refused), own.known, directory)
    arrivals += own.refused
    conflicts += own.conflicts
    strangers = own.strangers((*before, *own.refused))
    for member in forms:
        ask = partial(_request, course, problem_set, member, directory, strangers, dry_run)
        asked = guarded(ask, LONGEST)
        if isinstance(asked, CollectedRequest):
            requests.append(asked)
        elif isinstance(asked, Arrival):
            arrivals.append(asked)
    deadlines = read_deadlines(course, problem_set)
    with_times, remarks = dated(met, moments, zone, deadlines, now)
    remarks += moments.remarks
    by_student: dict[str, list[Found]] = {}
    for each in with_times:
        by_student.setdefault(each.student, []).append(each)
    there = submissions(course, name)
    begun: list[tuple[_StudentFiles, Future[list[Arrival] | Failure]]] = []
    with ThreadPoolExecutor(SIDE_BY_SIDE) as pool:  # what takes the time is waiting for the disk
        for student, theirs in by_student.items():
            earlier = [each for each in before if each.student == student]
            past = Past(earlier, deadlines.of(student), guessed_time(course, name, student) is not None)
            large = len(roster) >= LARGE
            files = _StudentFiles(
                course, problem_set, student, theirs, there.get(student), past, dry_run, large
            )
            begun.append((files, pool.submit(guarded, files.arrivals)))
    for of_student, future in begun:
        student, theirs, became = of_student.student, of_student.theirs, future.result()
        if isinstance(became, Failure):
            failures.add(student, [became])
            why = f"could not be written into submitted/ ({became.what}); the file itself is unchanged, so collect it again"
            became = [each.arrival(UNUSABLE, why) for each in theirs]
        arrivals += became
        conflicts += of_student.conflicts
        moved += of_student.moved
    failures.write()
    if not dry_run:
        remember(course, name, sorted(arrivals, key=lambda each: each.outcome == NOBODY))
    if moved:
        remarks.append(f"times corrected by the worksheet, of files already in submitted/: {few(moved, 12)}")
    arrivals = [_beside_a_notebook(each, name, {*by_student, *there}) for each in arrivals]
    came = there.keys() | by_student.keys()
    expected = [each.id for each in roster if each.id in assigned and not deadlines.excused(each.id)]
    missing = tuple(each for each in expected if each not in came)
    return Collected(
        tuple(arrivals),
        tuple(conflicts),
        tuple(remarks),
        missing,
        failures.place if failures.found else None,
        tuple(requests),
    )


@dataclass(slots=True)
class _StudentFiles:
    """One student's notebooks on their way to `submitted/`, where `there` lies what was taken before."""

    course: Course
    problem_set: ProblemSet
    student: str
    theirs: Sequence[Found]
    there: Path | None
    past: Past
    dry_run: bool
    large: bool
    conflicts: list[str] = field(default_factory=list[str])
    moved: list[str] = field(default_factory=list[str])

    def arrivals(self) -> list[Arrival]:
        """What became of each; the latest that counts is taken."""
        name, tries = self.problem_set.name, self.problem_set.tries
        in_order = sorted(self.theirs, key=lambda each: each.order)
        count, beyond = counting(in_order, self.past.arrivals, tries)
        why = f"exceeds the {tries} tries that the set allows; the earlier hand-ins count"
        found = [each.arrival(UNUSABLE, why) for each in beyond]
        if not count:
            return found
        *others, latest = count
        for each in reversed(others):
            why = each.why_before(latest)
            if each.content != latest.content and why != LATER:
                self.conflicts.append(
                    f"{self.student}: {writable(each.member.name)} {why}; that one is taken"
                )
            found.append(each.arrival(OLDER, why))
        if not self.dry_run:
            for each in self.theirs:
                keep(self.course, name, self.student, each.content)
        found.append(
            settled(self.course, name, latest, self.there, self.past, self.moved, self.dry_run, self.large)
        )
        if self.large and not self.dry_run:
            set_aside(self.course, name, self.student)
        return found


def _beside_a_notebook(each: Arrival, name: str, students: Collection[str]) -> Arrival:
    """A file of another kind from a student whose notebook came, too, or lies in the course: nobody need ask for one."""
    if each.outcome == UNUSABLE and each.student in students and each.why == not_a_notebook(name):
        return msgspec.structs.replace(each, why=_came_too(name))
    return each


def _came_too(name: str) -> str:
    return f"is not a notebook; nothing to do, since {name}.ipynb came, too"


def nothing_to_do(each: Arrival, name: str) -> bool:
    """True for a text or another file beside a student's notebook, as Moodle's online texts are."""
    return each.outcome == UNUSABLE and each.why == _came_too(name)


def _members(sources: Sequence[Path], directory: Directory, set_name: str) -> Iterator[Member]:
    """Every file that came, each student's within bounds of their own."""

    @cache
    def named(part: str) -> str | None:
        return directory.of_parts((part,), set_name)

    def whose(parts: Sequence[str]) -> str:
        if lms := lms_name(parts):
            return directory.of_lms(lms) or f"{lms.name} ({lms.key})"
        return next(filter(None, map(named, parts)), "")

    for source in sources:
        if source.suffix.lower() != ".csv":
            yield from members(source, whose)


def _request(
    course: Course,
    problem_set: ProblemSet,
    member: Member,
    directory: Directory,
    strangers: Collection[str],
    dry_run: bool,
) -> CollectedRequest | Arrival:
    """A form for regrading: whose it is only its place says, never the form. `strangers` are the numbers of files that were refused."""
    name = problem_set.name
    student, lms = directory.of_file(member.parts, name), lms_name(member.parts)
    if student and lms and lms.key in strangers:
        why = (
            f"is a request for regrading under a number whose notebook was not taken as that of {student}; "
            f"if it is theirs, rename it to {student}_{file_name(name)}"
        )
        return Arrival("", member.name, "", NOBODY, why, "", lms.key)
    if student is None:
        why = f"is a request for regrading, and its name tells no student; rename it to STUDENT_{file_name(name)}"
        return Arrival("", member.name, "", NOBODY, why)
    if not isinstance(member.content, bytes) or len(member.content) > MOST_BYTES:
        why = f"is a request for regrading larger than {MOST_BYTES // 1000} kB; ask for a shorter one"
        return Arrival(student, member.name, "", UNUSABLE, why)
    at = "" if member.modified is None else member.modified.isoformat(timespec="seconds")
    found = requests_in(member.content, part_places(problem_set), at)
    if not found:
        why = f"is a request for regrading with nothing below the heading of a part, as in {file_name(name)}; read it yourself"
        return Arrival(student, member.name, "", UNUSABLE, why)
    new = 0 if dry_run else add_requests(course, name, student, found)
    return CollectedRequest(student, writable(member.name), tuple(each.part for each in found), new)


def _of_another_set(member: Member, directory: Directory, set_name: str, about: str) -> Arrival:
    """A form for regrading that is about another set."""
    why = f"is a request for regrading of {about}; collect it with corollary collect {about}"
    return _left(member, directory, set_name, why)


def _stumbled(member: Member, directory: Directory, set_name: str, failure: Failure) -> Arrival:
    """A file over which this program stumbled: it stays where it is, and a person looks at it."""
    why = f"made corollary fail ({failure.what}); please report it, and look at the file yourself"
    return _left(member, directory, set_name, why)


def _left(member: Member, directory: Directory, set_name: str, why: str) -> Arrival:
    """A file that is not taken, with its student where its place says whose it is."""
    student = directory.of_file(member.parts, set_name)
    return Arrival(student or "", member.name, "", UNUSABLE if student else NOBODY, why)
