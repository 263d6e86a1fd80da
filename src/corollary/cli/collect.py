"""`corollary collect`: what an LMS, a mailbox or a folder has, put where it is marked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path

from msgspec import to_builtins

from corollary.atomic import write_files
from corollary.cli.ending import FAILS, HOLDS, MOST_LISTED, answer, counted, refuse, say
from corollary.cli.terminal import bar, console
from corollary.course.collect import Collected, collect, nothing_to_do
from corollary.records.assignments import is_assigned
from corollary.records.files import Course, one_writer, open_course, students
from corollary.records.notebook_archive import hand_ins, set_aside
from corollary.records.origin import set_of
from corollary.records.submissions import (
    ACCEPTED,
    GUESSED,
    NOBODY,
    OLDER,
    UNCHANGED,
    UNUSABLE,
    Arrival,
    submissions,
)

HEADINGS = {
    ACCEPTED: "Taken",
    OLDER: "Not taken, since another file was",
    UNUSABLE: "Cannot be marked",
    NOBODY: "Owner unknown",
}


def run(
    name: str,
    files: list[Path],
    course: Path,
    bank: Path | None,
    times: Path | None,
    dry_run: bool,
    copies: Path | None,
    pack: bool,
    as_json: bool,
) -> int:
    opened = open_course(course)
    _, problem_set = set_of(opened, name, bank)
    if copies is not None or pack:
        if files or times or dry_run:
            refuse("--copies and --pack work on what was collected; give no files with them")
        return _of_archive(opened, problem_set.name, copies, pack, as_json)
    if not files:
        refuse("say what to collect: the LMS's archive, a folder, or notebooks")
    if not is_assigned(opened, problem_set.name):
        refuse(
            f"{problem_set.name} was never generated in {opened.folder}; run corollary generate {problem_set.name} first"
        )
    for file in (*files, *([times] if times else [])):
        if not file.exists():
            refuse(f"{file} does not exist; give the LMS's archive, or a folder")
    with one_writer(opened), bar(f"collecting {problem_set.name}", None) as progress:
        found = collect(
            opened, problem_set, files, now=datetime.now(UTC), times=times, dry_run=dry_run, progress=progress
        )
    for each in (*found.conflicts, *found.remarks):
        say(each)
    if found.log is not None:
        say(f"an internal error occurred while a file was read; please report it with {found.log}")
    if as_json:
        outcomes = {
            outcome: [to_builtins(each) for each in found.of(outcome)]
            for outcome in (ACCEPTED, UNCHANGED, OLDER, UNUSABLE)
        }
        answer(
            {"set": problem_set.name, "dry_run": dry_run, **outcomes, "nobodys": [to_builtins(each) for each in found.of(NOBODY)],
             "requests": [asdict(each) for each in found.requests], "conflicts": list(found.conflicts), "remarks": list(found.remarks), "missing": list(found.missing)}
        )  # fmt: skip
    else:
        show(found, problem_set.name, dry_run, {each.id: each.name_with_id for each in students(opened)})
    return HOLDS if found.of(ACCEPTED) or found.of(UNCHANGED) or found.requests else FAILS


def _of_archive(course: Course, name: str, copies: Path | None, pack: bool, as_json: bool) -> int:
    """What lies in the course already: hand-ins written out, answered sheets packed."""
    written, packed = list[Path](), list[str]()
    if copies is not None:
        found = {
            f"{student.id}/{digest}.ipynb": content
            for student in students(course)
            for digest, content in hand_ins(course, name, student.id).items()
        }
        written = write_files(copies, found)
    if pack:
        with one_writer(course):
            for student in submissions(course, name):
                if set_aside(course, name, student):
                    packed.append(student)
    if as_json:
        answer({"set": name, "copies": [str(each) for each in written], "packed": packed})
        return HOLDS
    if copies is not None:
        print(f"{counted(len(written), 'notebook')} in {copies}/STUDENT/")
    if pack:
        print(f"{counted(len(packed), 'sheet')} packed; corollary release gives them out as before")
    return HOLDS


def handed_in(arrival: Arrival) -> str:
    """When, as far as anybody said it: the time of a download, or of the deadline in its place, is nobody's."""
    if arrival.time == GUESSED:
        return "not said"
    return arrival.when.partition(".")[0] + " UTC" * bool(arrival.when)


def show(found: Collected, name: str, dry_run: bool, names: Mapping[str, str]) -> None:
    """What was not taken, and with a dry run what would be; then how many. `names`: of the students, by id."""
    from rich.table import Table
    from rich.text import Text

    from corollary.messages import few, visible

    out = console()
    for outcome, title in HEADINGS.items():
        arrivals = [
            each
            for each in found.of(outcome)
            if (outcome != ACCEPTED or dry_run or each.why) and not nothing_to_do(each, name)
        ]
        if not arrivals:
            continue
        if outcome == ACCEPTED:
            title = "Would be taken" if dry_run else "Taken, with a remark"
            title += ", which the student reads, too" if any(each.why for each in arrivals) else ""
        headings = ("student", "file", "handed in", *(("why",) if any(each.why for each in arrivals) else ()))
        table = Table(*headings, title=title, title_justify="left", title_style="bold")
        for each in arrivals[:MOST_LISTED]:
            who = names.get(each.student, each.student) or "?"
            cells = (who, each.file, handed_in(each), each.why)
            table.add_row(*(Text(visible(cell)) for cell in cells[: len(headings)]))
        out.print(table)
        if len(arrivals) > MOST_LISTED:
            out.print(f"and {len(arrivals) - MOST_LISTED} more; --json lists all", highlight=False)
    accepted, same, older = (len(found.of(outcome)) for outcome in (ACCEPTED, UNCHANGED, OLDER))
    unusable = [*found.of(UNUSABLE), *found.of(NOBODY)]
    left = sum(not nothing_to_do(each, name) for each in unusable)
    beside = f", {len(unusable) - left} texts or other files beside a notebook" * (left < len(unusable))
    verb = "would be taken" if dry_run else "taken"
    out.print(
        f"{name}: {accepted} {verb}, {same} already there, {older} older, {left} not usable{beside}",
        soft_wrap=True,
    )
    if found.requests:
        who = few([names.get(each.student, each.student) for each in found.requests], MOST_LISTED)
        out.print(f"requests for regrading from {who}; corollary mark {name} shows them", soft_wrap=True)
    if found.missing:
        who = few([names.get(student, student) for student in found.missing], MOST_LISTED)
        out.print(f"not handed in by {counted(len(found.missing), 'student')}: {who}", soft_wrap=True)
    if dry_run:
        out.print("nothing was written: this was a dry run")
