"""`corollary generate`: a problem set for a roster."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from corollary.cli.ending import FAILS, HOLDS, MOST_LISTED, agreed, answer, refuse, say
from corollary.cli.pool_points import warn_of_pools
from corollary.cli.terminal import bar, console
from corollary.cli.told_dates import names_settled, say_corrections, say_renewals, warn_of_dates
from corollary.course.generate import Generated, generate
from corollary.course.renew import Renewals, RosterChange, renewals, roster_change, students_before
from corollary.extras import installing
from corollary.grading.solutions import Solutions
from corollary.messages import few, spoken
from corollary.nbgrader.config import check_config
from corollary.problem.bank import Bank
from corollary.problem.problem_set import ProblemSet, bank_of_set, find_set
from corollary.problem.roster import Student, ids_heading, read_roster
from corollary.problem.translation import translation
from corollary.records.assignments import open_record, sheets
from corollary.records.corrections import Correction, corrections
from corollary.records.files import Course, open_course
from corollary.records.forgotten import forgotten
from corollary.records.lms_names import LEFT_OUT, is_left_out
from corollary.records.origin import has_set, set_of
from corollary.records.settings import read_settings, write_language


def run(
    name: str,
    roster: Path | None,
    course: Path,
    bank: Path | None,
    as_json: bool,
    id_column: str | None = None,
    yes: bool = False,
    renew: bool = False,
    not_renamed: bool = False,
) -> int:
    if course.exists() and not course.is_dir():
        refuse(f"{course} is a file; name a folder for the course")
    place, problem_set = _set(name, course, bank)
    students, solutions = _students(roster, course, id_column or "", yes, as_json), Solutions(place)
    if students is None:
        return FAILS
    opened = open_course(course) if (course / ".corollary" / "key").exists() else None
    if opened is None or not has_set(opened, problem_set.name):
        warn_of_dates(problem_set)  # of a set that is new; later a past date is meant
    warn_of_pools(problem_set)
    warn_of_canvas(problem_set)
    warn_of_languages(problem_set)
    check_config(course)
    for problem in problem_set.problems:  # whatever can be refused is, before the first file is written
        solutions.of(problem)
    found, plan = list[Correction](), Renewals((), ())
    if opened is not None:
        warn_of_forgotten(opened, students)
        record = open_record(opened, problem_set)
        if not names_settled(opened, problem_set, record, yes, not_renamed):
            return FAILS
        before = sheets(opened, problem_set, record)
        found = corrections(opened, problem_set, record, before)
        say_corrections(found, students)
        plan = renewals(opened, problem_set, solutions, record, before, {each.id for each in students})
        if renew:
            say_renewals(plan, students)
            if plan.sheets and not agreed("Replace these sheets?", yes):
                return FAILS
    with bar(f"generating {problem_set.name}", 2 * len(students) + 1) as progress:
        made = generate(
            course,
            problem_set,
            students,
            solutions,
            progress,
            plan.sheets if renew else (),
            read_settings(course).jobs,
        )
    if spoken() != (read_settings(course).language or "en"):
        write_language(course, spoken())
        say(
            f'{course / "corollary.toml"} says language = "{spoken()}" from now on: students read the whole course in this language'
        )
    if not renew and (plan.sheets or plan.handed_in):
        say("all students keep their present sheets")
        say_renewals(plan, students)
    if as_json:
        answer(
            {
                "set": problem_set.name,
                "course": str(made.course.folder),
                "registered": made.registered,
                "redrawn": made.redrawn,
                "shared": made.shared,
                "corrections": [asdict(each) for each in found],
                "renewed": [each.student for each in plan.sheets] if renew else [],
                "with_renew": {} if renew else {each.student: each.other for each in plan.sheets},
                "students": {
                    student: {
                        "sheet": str(path),
                        "variants": {
                            each.problem.code: each.index for each in made.assigned[student].variants
                        },
                        "new": student in made.new,
                    }
                    for student, path in made.notebooks.items()
                },
            }
        )
        return HOLDS
    count = len(made.notebooks)
    print(
        f"{problem_set.title}: {count} notebook{'s' if count != 1 else ''} in {made.course.folder / 'release'}/STUDENT/{problem_set.name}/"
    )
    print(f"{_whose_own(made)}; numbers redrawn: {sum(made.redrawn.values())}.")
    print(
        f"Hand-ins go to {made.course.folder / 'submitted'}/STUDENT/{problem_set.name}/{problem_set.name}.ipynb; then: corollary grade {problem_set.name} --course {course}"
    )
    if not made.registered:
        say(
            f"nbgrader is not installed, so there is no gradebook.db: {installing('nbgrader')}, and generate again to have one"
        )
    return HOLDS


def warn_of_canvas(problem_set: ProblemSet) -> None:
    """The set's title is one that Canvas's import of marks leaves out."""
    if is_left_out(problem_set.title):
        say(f"warning: {LEFT_OUT}: {problem_set.title}; give the set another title if its marks go to Canvas")


def warn_of_languages(problem_set: ProblemSet) -> None:
    """Problems that nobody has translated into the language of the sheets."""
    left = [each.code for each in problem_set.problems if spoken() != "en" and translation(each) is None]
    if left:
        say(
            f"warning: not translated into {spoken()}, so that students read them in the original's language: {', '.join(left)}; "
            f"corollary new --translate {left[0]} {spoken()} begins a translation"
        )


def _whose_own(made: Generated) -> str:
    """Whether everybody has numbers of their own, and where not."""
    shared = made.shared
    if len(made.notebooks) < 2 or not shared:
        return "Each student has different numbers"
    which = ", ".join(f"{code} ({count} students)" for code, count in shared.items())
    return (
        f"Each student has different numbers, except in {which}, where some share them: "
        "finer steps of the givens give more variants"
    )


def warn_of_forgotten(course: Course, students: Sequence[Student]) -> None:
    """Students of the roster whose data was taken out of the course."""
    if again := forgotten(course, [each.id for each in students]):
        say(
            f"warning: removed with corollary forget, and on the roster: {few(again, MOST_LISTED)}; they get new sheets. "
            "Take them off the roster if they are not to be in the course"
        )


def _set(name: str, course: Path, bank: Path | None) -> tuple[Bank, ProblemSet]:
    """The set and its bank: the one named, else for a set that was generated before the one it came from."""
    if (course / ".corollary" / "key").exists():
        return set_of(open_course(course), name, bank)
    settings = read_settings(course)
    place = bank_of_set(bank, name)
    return place, find_set(place, name, settings.usual)


def _students(
    roster: Path | None, course: Path, id_column: str, yes: bool, as_json: bool
) -> tuple[Student, ...] | None:
    """Who is in the course from now on; None when somebody would no longer be, and nobody agreed to it."""
    before = students_before(course)
    if roster is None:
        if not before:
            refuse("there is no roster yet; name a CSV file of the students with --roster FILE")
        return tuple(before)
    found = read_roster(roster, id_column, {each.id for each in before}, ids_heading(before))
    for note in found.notes:
        say(note)
    change = roster_change(before, found.students)
    if change.missing:
        _show_missing(change, as_json)
        count = len(change.missing)
        question = f"Remove {'these students' if count > 1 else 'this student'} from the roster? Numbers and marks stay recorded."
        if not agreed(question, yes):
            say("to add students, give a roster with the new students only")
            return None
    if before and change.new:
        say(f"new on the roster: {few([each.name_with_id for each in change.new], MOST_LISTED)}")
    return change.roster


def _show_missing(change: RosterChange, as_json: bool) -> None:
    """Who is in the course and not in the file."""
    from rich.table import Table
    from rich.text import Text

    from corollary.messages import visible

    table = Table(
        "id",
        "name",
        "in the file as",
        title="Not in the new roster",
        title_justify="left",
        title_style="bold",
    )
    for student, other in change.missing:
        table.add_row(*(Text(visible(each)) for each in (student.id, student.name, other)))
    console(stderr=as_json).print(table)
