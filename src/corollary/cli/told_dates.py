"""Dates and corrections of a set that a command is told of before it does what they speak against."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime

from corollary.cli.ending import MOST_LISTED, agreed, counted, refuse, say, say_each
from corollary.course.renew import Renewals
from corollary.messages import few
from corollary.nbgrader.written_marks import with_solutions
from corollary.problem.dates import written
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.assignments import Assigned, pending, save_record, settle
from corollary.records.corrections import Correction
from corollary.records.deadlines import read_deadlines, reveal_by_hand
from corollary.records.files import Course, students
from corollary.records.submissions import submissions


def names_settled(
    course: Course, problem_set: ProblemSet, record: Assigned, yes: bool, no: bool = False
) -> bool:
    """Asks about every name that looks changed, and records the answer, which is known where `no` or `yes`; False when there is nobody
    to answer."""
    for renames in pending(course, problem_set, record):
        for each in renames:
            say(each.sentence)
        take = not no and agreed("Was it only renamed?", yes)
        if not no and not take and not (sys.stdin.isatty() and sys.stderr.isatty()):
            say("--not-renamed treats it as removed and added")
            return False
        settle(record, renames, agreed=take)
        save_record(course, problem_set, record)
    return True


def say_corrections(found: Sequence[Correction], roster: Iterable[Student]) -> None:
    """Each with who has it so."""
    for each in found:
        say(f"{each.code} {each.sentence} ({named(each.students, roster)})")


def say_renewals(found: Renewals, roster: Iterable[Student]) -> None:
    """For whom a new sheet would be another one, and who keeps theirs in any case."""
    if found.sheets:
        whose = named([each.student for each in found.sheets], roster)
        say(f"--renew replaces the sheet of {whose} by the corrected one")
    names = {each.id: each.name_with_id for each in roster}
    say_each(
        f"  {names.get(each.student, each.student)} gets new numbers in {', '.join(each.other)}"
        for each in found.sheets
        if each.other
    )
    if found.handed_in:
        say(
            f"no new sheet, with or without --renew, since they have handed in: {named(found.handed_in, roster)}"
        )


def named(students: Sequence[str], roster: Iterable[Student]) -> str:
    """`3 students: Ada Lovelace (0101014), ben, cyd`; ten at most."""
    names = {each.id: each.name_with_id for each in roster}
    return f"{counted(len(students), 'student')}: {few([names.get(each, each) for each in students], MOST_LISTED)}"


def now() -> datetime:
    """This moment."""
    return datetime.now(UTC)


def warn_of_dates(problem_set: ProblemSet, at: datetime | None = None, course: Course | None = None) -> None:
    """Before sheets are made or given out: the date is past, or the set is not open yet. Once hand-ins lie in the course, a past
    date is no mistake."""
    at = at or now()
    handed_in = course is not None and bool(submissions(course, problem_set.name))
    due = problem_set.due
    if due is not None and (delay := problem_set.delay(due, at)).seconds > 0 and not handed_in:
        so = "nothing counts any more" if delay.rule == "last day" else "every hand-in counts as late"
        say(
            f"warning: {problem_set.name} was due {written(due)}, so {so}; "
            "correct due: in the set's file if that is not meant"
        )
    if problem_set.opens is not None and at < problem_set.opens:
        say(f"warning: {problem_set.name} opens {written(problem_set.opens)}; do not give sheets out before")


def warn_of_grading_early(course: Course, problem_set: ProblemSet, at: datetime | None = None) -> None:
    """Before marking: who may still hand in, and that nothing is given away to them."""
    deadlines, at = read_deadlines(course, problem_set), at or now()
    if deadlines.due is None:
        return
    if at <= deadlines.due:
        say(
            f"warning: {problem_set.name} is not due before {written(deadlines.due)}: run grade again then; "
            "until then feedback shows no right values"
        )
        return
    more = [each.name_with_id for each in students(course) if deadlines.early(each.id, at)]
    if more:
        last = deadlines.last
        assert last is not None
        say(
            f"{few(more, MOST_LISTED)} can still hand in {problem_set.name}, at the latest until {written(last)} "
            f"(corollary extend --list {problem_set.name} shows each date)"
        )
        if deadlines.reveal == "after extensions":
            out = with_solutions(course, problem_set.name)
            addition = f" and removed from {len(out)} pages that show them" if out else ""
            say(
                f"reveal: after extensions keeps worked solutions off all feedback pages until then{addition}"
            )


def warn_of_printed_dates(course: Course, problem_set: ProblemSet) -> None:
    """Before marking: whose sheet prints a later moment than the set has by now, which holds for them."""
    deadlines = read_deadlines(course, problem_set)
    if deadlines.due is not None and (whose := deadlines.by_sheet):
        printed = _moments(deadlines.printed[each] for each in whose)
        say(
            f"warning: {problem_set.name} is due {written(deadlines.due)} now, but the sheets of {named(whose, students(course))} "
            f"print {printed}, which counts for them. corollary generate {problem_set.name} --renew gives a new sheet to "
            "students who have not handed in"
        )


def _moments(printed: Iterable[datetime]) -> str:
    """`27 November 2026, 23:59`; of several the first and the last."""
    several = sorted({when.astimezone(UTC): when for when in printed}.items())
    first, last = written(several[0][1]), written(several[-1][1])
    return first if len(several) == 1 else f"dates from {first} to {last}"


def reveal_now(course: Course, problem_set: ProblemSet, dry_run: bool) -> None:
    """Records that right values may be seen. Raises Refusal where the set leaves that to a date, or forbids it."""
    if problem_set.reveal != "by hand":
        refuse(
            f"--reveal needs reveal: by hand in the set's file; {problem_set.name} has reveal: {problem_set.reveal}"
        )
    if dry_run:
        refuse("--reveal changes feedback pages, and --dry-run writes nothing; give one of them")
    reveal_by_hand(course, problem_set.name)
