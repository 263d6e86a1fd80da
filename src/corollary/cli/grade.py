"""`corollary grade`: what was handed in, marked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any

import msgspec

from corollary.cli.ending import FAILS, HOLDS, MOST_LISTED, agreed, answer, say, say_each
from corollary.cli.pool_points import warn_of_pools
from corollary.cli.terminal import console, countdown
from corollary.cli.told_dates import reveal_now, warn_of_grading_early, warn_of_printed_dates
from corollary.course.grade import Outcome, grade_set
from corollary.course.workers import on_cluster
from corollary.grading.solutions import Solutions
from corollary.messages import few, visible
from corollary.records.files import one_writer, open_course, students
from corollary.records.origin import remember, set_of
from corollary.records.outside_changes import OutsideChange
from corollary.records.regrading import Change, PartChange
from corollary.records.stopped_table import stopped_record
from corollary.records.submissions import all_guessed, why_unclear
from corollary.render.marks_by_hand_tables import outside_table
from corollary.sandbox.isolation import Isolation
from corollary.sandbox.runner import Runner, probe_isolation


def run(
    name: str,
    course: Path,
    bank: Path | None,
    as_json: bool,
    regrade: bool,
    require: int,
    jobs: int | None = None,
    executor: str = "",
    dry_run: bool = False,
    reveal: bool = False,
    yes: bool = False,
    strict: bool = False,
) -> int:
    opened = open_course(course)
    place, problem_set = set_of(opened, name, bank)
    if bank is None and not dry_run and not name.endswith(".md"):
        remember(opened, problem_set.name, place, problem_set.file)  # the course has moved since
    if reveal:
        reveal_now(opened, problem_set, dry_run)
    warn_of_grading_early(opened, problem_set)
    warn_of_pools(problem_set)
    warn_of_printed_dates(opened, problem_set)
    names = {each.id: each.name_with_id for each in students(opened)}
    with one_writer(opened), countdown(f"grading {problem_set.name}") as progress:
        done = grade_set(
            opened,
            problem_set,
            Solutions(place),
            partial(Runner, require=require, packages=problem_set.packages or ()),
            regrade=regrade,
            dry_run=dry_run,
            ask=partial(ask, as_json=as_json, yes=yes, names=names),
            ask_outside=partial(ask_outside, as_json=as_json, yes=yes),
            progress=progress,
            jobs=jobs,
            execute=on_cluster(executor) if executor else None,
            # On a cluster it is the workers' machines that count, and each mark says theirs.
            begin=(lambda: None) if executor else (lambda: say_isolation(probe_isolation(require))),
        )
    say_each(
        f"{stranger} handed in but is not on the roster, so is not marked; add {stranger} to the roster and generate again"
        for stranger in done.strangers
    )
    if done.refilled:
        refilled = few([names.get(student, student) for student in done.refilled], MOST_LISTED)
        say(f"marks restored in the gradebook and autograded/, those given by hand too: {refilled}")
    say_each(
        f"{names.get(student, student)} is not graded, because this machine failed: {why} Nothing is recorded; grade again"
        for student, why in done.not_run.items()
    )
    say_each(
        f"{names.get(student, student)}: an internal error stopped the marking, so mark this by hand ({what})"
        for student, what in done.failures.items()
    )
    if done.failures:
        say(
            f"this is an error in Corollary; please report it with {done.log}, and grade again with the next version"
        )
    say_each(
        f"{names.get(student, student)} handed in {why_unclear(problem_set.name, found)}"
        for student, found in done.unclear.items()
    )
    say_each(all_guessed(problem_set.name, done.guessed))
    if done.gone:
        gone = few([names.get(student, student) for student in done.gone], MOST_LISTED)
        say(
            f"no notebook is in submitted/STUDENT/{problem_set.name} any more, and its marks are kept: {gone}; put it "
            f"back and grade again, or corollary extend STUDENT {problem_set.name} --excuse, if the marks are not to count"
        )
    say_each(
        f"{names.get(each.student, each.student)} has {each.after:g} points instead of {each.before:g}: the deadline was extended, "
        "so lateness costs less"
        for each in done.extended
    )
    if as_json:
        answer(document(problem_set.name, done))
    else:
        show(done, dry_run)
    if dry_run:
        show_changes(done.changed, as_json=as_json, names=names)
        say("nothing was written: this was a dry run")
    if done.outside:
        count = "1 score" if len(done.outside) == 1 else f"{len(done.outside)} scores"
        say(
            f"{count} changed in the gradebook, not counted; agree with corollary grade {problem_set.name}, "
            f"or decide each with corollary mark {problem_set.name}"
        )
    refused = not dry_run and (not done.written or bool(done.outside))
    broken = bool(done.failed or done.strangers or done.unclear or done.gone)
    return FAILS if refused or done.not_run or (strict and broken) else HOLDS


def ask(changed: tuple[Change, ...], *, as_json: bool, yes: bool, names: Mapping[str, str]) -> bool:
    """Shows whose marks would move, from what to what and why, and asks whether they may."""
    show_changes(changed, as_json=as_json, names=names)
    count = sum(each.moves_points for each in changed)
    return agreed(
        f"Marks that {count} {'student has' if count == 1 else 'students have'} already would change. Write them?",
        yes,
    )


def ask_outside(outside: tuple[OutsideChange, ...], *, as_json: bool, yes: bool) -> bool:
    """Shows which scores were changed in the gradebook after they counted, and asks whether they may."""
    console(stderr=as_json).print(outside_table(outside))
    count = "1 score was" if len(outside) == 1 else f"{len(outside)} scores were"
    return agreed(f"{count} changed in the gradebook. Take what stands there?", yes)


FIELDS = ("points", "out_of", "parts", "isolation", "trouble", "late", "notes", "stopped")


def say_isolation(isolation: Isolation) -> None:
    """The level, before any notebook is run, and what is missing for a better one."""
    say(f"isolation level {isolation.level}: {isolation.line}")
    for missing in isolation.missing:
        say(f"warning: isolation without {missing}")


def document(name: str, done: Outcome) -> dict[str, Any]:
    """The contract's document."""
    return {
        "set": name,
        "graded": len(done.graded),
        "held": list(done.held),
        "skipped": len(done.skipped),
        "failed": list(done.failed),
        "failures": dict(done.failures),
        "strangers": list(done.strangers),
        "gone": list(done.gone),
        "in_gradebook": done.in_gradebook,
        "report": str(done.page),
        "unclear": {student: list(names) for student, names in done.unclear.items()},
        "guessed_times": {
            student: {"taken_as": guess.moment.isoformat(), "found": guess.found}
            for student, guess in done.guessed.items()
        },
        "nobodys": [{"file": file, "why": why} for file, why in done.report.nobodys],
        "stopped": list(map(stopped_record, done.report.stopped)),
        "written": done.written,
        "outside": [msgspec.to_builtins(each) for each in done.outside],
        "changed": [asdict(each) | {"by": round(each.by, 6)} for each in done.changed],
        "students": {
            student: {each: msgspec.to_builtins(getattr(record, each)) for each in FIELDS}
            for student, record in done.records.items()
        },
    }


def show_changes(changed: tuple[Change, ...], *, as_json: bool, names: Mapping[str, str]) -> None:
    """Who changes, from what to what, and why; on standard output, unless a document goes there. `names`: by id."""
    from rich.table import Table
    from rich.text import Text

    out = console(stderr=as_json)
    if not changed:
        out.print("no marks change")
        return
    table = Table(title="Changed marks", title_justify="left", title_style="bold")
    for heading in ("student", "had", "gets", "by", "parts", "why"):
        table.add_column(
            heading, justify="left" if heading in {"student", "parts", "why"} else "right", overflow="fold"
        )
    for each in changed:
        parts, who = "; ".join(map(_part, each.parts)), names.get(each.student, each.student)
        out_of = each.out_of_before != each.out_of
        had, gets = (
            f"{points:g} of {most:g}" if out_of else f"{points:g}"
            for points, most in ((each.before, each.out_of_before), (each.after, each.out_of))
        )
        share = (
            f" ({_share(each.before, each.out_of_before)} to {_share(each.after, each.out_of)})"
            if out_of
            else ""
        )
        numbers = (had, gets, f"{each.by:+g}{share}")
        table.add_row(*(Text(visible(word)) for word in (who, *numbers, parts, each.why)))
    out.print(table)


def _share(points: float, out_of: float) -> str:
    return f"{points / out_of:.0%}" if out_of else "0%"


def _part(part: PartChange) -> str:
    """`X12_5_a: wrong to right (+1)`, `X12_5_b: right (+0, out of 3 instead of 2)`, `X12_5_c: by hand, 1 of 1 to 3 of 3`."""
    if part.by_hand:
        before, after = f"{part.before:g} of {part.out_of_before:g}", f"{part.after:g} of {part.out_of:g}"
        look = "; mark it again" if part.out_of != part.out_of_before else ""
        return f"{part.part}: by hand, {before} to {after} ({part.after - part.before:+g}{look})"
    before, after = part.verdict_before or "nothing", part.verdict or "nothing"
    verdict = before if before == after else f"{before} to {after}"
    out_of = (
        f", out of {part.out_of:g} instead of {part.out_of_before:g}"
        if part.out_of != part.out_of_before
        else ""
    )
    return f"{part.part}: {verdict} ({part.after - part.before:+g}{out_of})"


def show(done: Outcome, dry_run: bool) -> None:
    """The report on the terminal, and where to look."""

    from corollary.render.report_page import terminal

    out = console()
    recorded = {one.student for one in done.report.handed_in}
    out.print(terminal(done.report, [one for one in done.held if one not in recorded]))
    out.print(f"{what_was_done(done, dry_run)}; report: {done.page}", soft_wrap=True, highlight=False)
    if not done.in_gradebook and not dry_run:
        say(
            "nbgrader is not installed: the marks are in the report and the feedback pages, and not in a gradebook.db"
        )


def what_was_done(done: Outcome, dry_run: bool) -> str:
    """How many were graded, and how many were left as they are, and why."""
    unchanged = f"unchanged {len(done.skipped)}"
    if dry_run:
        return f"would grade {len(done.held)}, {unchanged}"
    refused = f"held back {len(done.held)} (not confirmed), " if done.held else ""
    return f"graded {len(done.graded)}, {refused}{unchanged}"
