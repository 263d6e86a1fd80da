"""Dates and corrections of a set that a command is told of before it does what they speak against."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from datetime import UTC, datetime

from corollary.cli.ending import agreed, refuse, say
from corollary.course.renew import Renewals
from corollary.nbgrader.written_marks import with_solutions
from corollary.problem.dates import written
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import Assigned, pending, save_record, settle
from corollary.records.corrections import Correction
from corollary.records.deadlines import read_deadlines, reveal_by_hand
from corollary.records.files import Course, students

MOST_NAMED = 5


def names_settled(
    course: Course, problem_set: ProblemSet, record: Assigned, yes: bool, no: bool = False
) -> bool:
    """Asks about every name that looks changed, and records the answer, which is known where `no` or `yes`; False when there is nobody
    to answer."""
    for renames in pending(course, problem_set, record):
        for each in renames:
            say(each.sentence)
        take = not no and agreed("Is it the same under another name?", yes)
        if not no and not take and not (sys.stdin.isatty() and sys.stderr.isatty()):
            say("where it is not the same, say --not-renamed")
            return False
        settle(record, renames, agreed=take)
        save_record(course, problem_set, record)
    return True


def say_corrections(found: Sequence[Correction]) -> None:
    """Each with who has it so."""
    for each in found:
        say(f"{each.code} {each.sentence} ({named(each.students)})")


def say_renewals(found: Renewals) -> None:
    """For whom a new sheet would be another one, and who keeps theirs in any case."""
    if found.sheets:
        say(
            f"{named([each.student for each in found.sheets])}: the corrected sheet in place of the one they have"
        )
    for each in found.sheets:
        if each.other:
            say(f"  {each.student}: other numbers in {', '.join(each.other)}")
    if found.handed_in:
        say(f"{named(found.handed_in)}: handed in, and keep the sheet they have answered")


def named(students: Sequence[str]) -> str:
    """`3 students: ada, ben, cyd`."""
    more = len(students) - MOST_NAMED
    names = ", ".join(students[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")
    return f"{len(students)} student{'' if len(students) == 1 else 's'}: {names}"


def now() -> datetime:
    """This moment."""
    return datetime.now(UTC)


def warn_of_dates(problem_set: ProblemSet, at: datetime | None = None) -> None:
    """Before sheets are made or given out: the date is over already, or the set is not open yet."""
    at = at or now()
    if problem_set.due is not None and problem_set.due < at:
        say(
            f"warning: {problem_set.name} was due {written(problem_set.due)}, which is past; whatever comes in is late "
            "(correct due: in the set's file)"
        )
    if problem_set.opens is not None and at < problem_set.opens:
        say(f"warning: {problem_set.name} opens {written(problem_set.opens)}; give nothing out before")


def warn_of_grading_early(course: Course, problem_set: ProblemSet, at: datetime | None = None) -> None:
    """Before marking: who may still hand in, and that nothing is given away to them."""
    deadlines, at = read_deadlines(course, problem_set), at or now()
    if deadlines.due is None:
        return
    if at <= deadlines.due:
        say(
            f"warning: {problem_set.name} is due {written(deadlines.due)}, which is not yet past: what comes in until then is "
            "marked by the next run, and feedback gives no right values before"
        )
        return
    more = [each.id for each in students(course) if deadlines.early(each.id, at)]
    if more:
        last = deadlines.last
        assert last is not None
        say(
            f"{', '.join(more)} {'has' if len(more) == 1 else 'have'} more time in {problem_set.name}, until {written(last)} at the "
            "latest, and may still hand in"
        )
        if deadlines.reveal == "after extensions":
            out = with_solutions(course, problem_set.name)
            addition = f", and taken out of the {len(out)} that have them" if out else ""
            say(
                f"worked solutions are held back from all feedback pages until then{addition} (reveal: after extensions)"
            )


def warn_of_printed_dates(course: Course, problem_set: ProblemSet) -> None:
    """Before marking: whose sheet prints a later moment than the set has by now, which holds for them."""
    deadlines = read_deadlines(course, problem_set)
    if deadlines.due is not None and (whose := deadlines.by_sheet):
        say(
            f"warning: {problem_set.name} is due {written(deadlines.due)} now, and a later moment stands on the sheets of "
            f"{named(whose)}; they are late from that moment on. corollary generate {problem_set.name} says which it is, and "
            "with --renew gives a new sheet to who has not handed in"
        )


def reveal_now(course: Course, problem_set: ProblemSet, dry_run: bool) -> None:
    """Records that right values may be seen. Raises Refusal where the set leaves that to a date, or forbids it."""
    if problem_set.reveal != "by hand":
        refuse(
            f"--reveal is for sets that say reveal: by hand; {problem_set.name} says reveal: {problem_set.reveal}"
        )
    if dry_run:
        refuse(
            "--reveal shows students what they must not see yet, and --dry-run writes nothing; give one of them"
        )
    reveal_by_hand(course, problem_set.name)
