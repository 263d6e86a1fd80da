"""What is said of a set's dates before something is done that they speak against."""

from __future__ import annotations

from datetime import UTC, datetime

from corollary.cli.corrected import named
from corollary.cli.ending import refuse, say
from corollary.nbgrader.marks import with_solutions
from corollary.problem.dates import written
from corollary.problem.problem_set import ProblemSet
from corollary.records.deadlines import read_deadlines, reveal_by_hand
from corollary.records.files import Course, students


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
