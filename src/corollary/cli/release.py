"""`corollary release`: each student the own sheet."""

from __future__ import annotations

from pathlib import Path

from corollary.atomic import write_files
from corollary.cli.ending import FAILS, HOLDS, MOST_LISTED, answer, say
from corollary.cli.told_dates import warn_of_dates
from corollary.course.release import release, sheets_of
from corollary.messages import few
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course, open_course, students
from corollary.records.origin import set_of

NEXT = {
    "moodle": "in Moodle: Assignment, View all submissions, Upload multiple feedback files in a zip (the assignment needs Feedback files)",
    "canvas": "in Canvas: the assignment, Re-Upload Submissions",
    "mail": "mail-merge.csv says which file goes to whom",
}


def run(
    name: str,
    to: str,
    course: Path,
    bank: Path | None,
    output: Path | None,
    ids: Path | None,
    force: bool,
    as_json: bool,
) -> int:
    opened = open_course(course)
    _, problem_set = set_of(opened, name, bank)
    warn_of_dates(problem_set, course=opened)
    if to == "exchange":
        return _exchange(opened, problem_set, force, as_json)
    made = release(opened, problem_set, to, ids)
    folder = output or opened.folder / "given_out" / f"{problem_set.name}-{to}"
    written = write_files(folder, made.files)
    names = {each.id: each.name_with_id for each in students(opened)}
    for why in dict.fromkeys(made.without.values()):
        who = [names.get(student, student) for student, reason in made.without.items() if reason == why]
        say(f"no file for {few(who, MOST_LISTED)}: {why}")
    if as_json:
        answer(
            {"set": problem_set.name, "to": to, "files": [str(path) for path in written],
             "students": list(made.students), "without": dict(made.without)}
        )  # fmt: skip
    else:
        count = len(made.students)
        print(f"{problem_set.title}: own sheets of {count} student{'s' * (count != 1)} in {folder}/")
        if to in NEXT:
            print(NEXT[to])
    return HOLDS


def _exchange(course: Course, problem_set: ProblemSet, force: bool, as_json: bool) -> int:
    """By nbgrader's own command, in this process."""
    from corollary.nbgrader.exchange import release_in_exchange

    sheets = sheets_of(course, problem_set)
    why = release_in_exchange(course, problem_set.name, force)
    if as_json:
        answer(
            {
                "set": problem_set.name,
                "to": "exchange",
                "files": [],
                "students": [] if why else list(sheets),
                "without": {},
            }
        )
    if why:
        say(f"corollary: {why}")
        return FAILS
    if not as_json:
        print(f"{problem_set.title}: own sheets of {len(sheets)} students in nbgrader's exchange")
    return HOLDS
