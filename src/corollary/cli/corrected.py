"""What is said and asked when a set was corrected after it was handed out."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from corollary.cli.asking import agreed
from corollary.cli.ending import say
from corollary.course.renew import Renewals
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import Assigned, pending, save_record, settle
from corollary.records.corrections import Correction
from corollary.records.files import Course

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
            f"{named([each.student for each in found.sheets])}: the sheet of today in the place of the one they have"
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
