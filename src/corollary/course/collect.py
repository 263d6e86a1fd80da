"""What an LMS or a mailbox gives put where it is marked: every file taken, or named with the reason."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from corollary.course.hand_in_time import dated
from corollary.course.latest import Past, counting, settled
from corollary.course.lms_places import worksheet_numbers
from corollary.course.lms_times import Times, read_times
from corollary.course.owner import LATER, Found, directory_of, identified
from corollary.messages import few
from corollary.problem.dates import machine_zone
from corollary.problem.problem_set import ProblemSet
from corollary.records.assigned import read_assigned
from corollary.records.collected import (
    NOBODY,
    OLDER,
    UNUSABLE,
    Arrival,
    keep,
    read_arrivals,
    remember,
    writable,
)
from corollary.records.deadlines import read_deadlines
from corollary.records.files import Course, students
from corollary.records.hand_in_time import guessed_time
from corollary.records.settings import read_settings
from corollary.records.submission import submissions
from corollary.sandbox.archive import members


@dataclass(frozen=True, slots=True)
class Collected:
    """Every file with what became of it; sentences on what was in conflict and on the whole; who has handed in nothing yet and is
    not excused."""

    arrivals: tuple[Arrival, ...]
    conflicts: tuple[str, ...]
    remarks: tuple[str, ...]
    missing: tuple[str, ...]

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
    moments, numbers = Times({}), dict[str, str]()
    for table in (*([times] if times else []), *(each for each in sources if each.suffix.lower() == ".csv")):
        moments = moments.joined(read_times(table, zone))
        numbers |= worksheet_numbers(table, roster)
    directory = directory_of(roster, before, numbers)
    known = {each.id: each for each in roster}
    for member in (each for source in sources if source.suffix.lower() != ".csv" for each in members(source)):
        progress(writable(member.name))
        found = identified(member, problem_set, directory, known, assigned, conflicts)
        if isinstance(found, Found):
            met.append(found)
        else:
            arrivals.append(found)
    deadlines = read_deadlines(course, problem_set)
    with_times, remarks = dated(met, moments, zone, deadlines, now)
    remarks += moments.remarks
    by_student: dict[str, list[Found]] = {}
    for each in with_times:
        by_student.setdefault(each.student, []).append(each)
    there = submissions(course, name)
    for student, theirs in by_student.items():
        earlier = [each for each in before if each.student == student]
        count, beyond = counting(sorted(theirs, key=lambda each: each.order), earlier, problem_set.tries)
        why = f"is one more than the {problem_set.tries} tries that the set allows; what came before counts"
        arrivals += [each.arrival(UNUSABLE, why) for each in beyond]
        if not count:
            continue
        *others, latest = count
        for each in reversed(others):
            why = each.why_before(latest)
            if each.content != latest.content and why != LATER:
                conflicts.append(f"{student}: {writable(each.member.name)} {why}; the latter is taken")
            arrivals.append(each.arrival(OLDER, why))
        guessed = guessed_time(course, name, student) is not None
        past = Past(earlier, deadlines.of(student), guessed)
        arrivals.append(settled(course, name, latest, there.get(student), past, moved, dry_run))
        if not dry_run:
            for each in theirs:
                keep(course, name, student, each.content)
    if not dry_run:
        remember(course, name, sorted(arrivals, key=lambda each: each.outcome == NOBODY))
    if moved:
        remarks.append(f"{len(moved)} there already get the time of the worksheet: {few(moved, 12)}")
    came = there.keys() | by_student.keys()
    expected = [each.id for each in roster if each.id in assigned and not deadlines.excused(each.id)]
    missing = tuple(each for each in expected if each not in came)
    return Collected(tuple(arrivals), tuple(conflicts), tuple(remarks), missing)
