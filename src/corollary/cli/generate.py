"""`corollary generate`: a problem set for a roster."""

from __future__ import annotations

from pathlib import Path

from corollary.cli.ending import HOLDS, answer, refuse, say
from corollary.cli.progress import bar
from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.nbgrader.config import check_config
from corollary.problem.bank import open_bank
from corollary.problem.problem_set import find_set
from corollary.problem.roster import read_roster


def run(name: str, roster: Path, course: Path, bank: Path | None, as_json: bool) -> int:
    place = open_bank(bank)
    problem_set = find_set(place, name)
    students, solutions = read_roster(roster), Solutions(place)
    if course.exists() and not course.is_dir():
        refuse(f"{course} is a file; name a folder for the course")
    check_config(course)
    for problem in problem_set.problems:  # whatever can be refused is, before the first file is written
        solutions.of(problem)
    with bar(f"generating {problem_set.name}", len(students) + len(problem_set.problems) + 1) as progress:
        made = generate(
            course, problem_set, students, solutions, progress, Path(name) if name.endswith(".md") else None
        )
    if as_json:
        answer(
            {
                "set": problem_set.name,
                "course": str(made.course.folder),
                "registered": made.registered,
                "passed_over": made.redrawn,
                "students": {
                    student: {"sheet": str(path), "variants": made.assigned[student]}
                    for student, path in made.notebooks.items()
                },
            }
        )
        return HOLDS
    count = len(made.notebooks)
    print(
        f"{problem_set.title}: {count} notebook{'s' if count != 1 else ''} in {made.course.folder / 'release'}/STUDENT/{problem_set.name}/"
    )
    print(f"Each student has numbers of their own; {sum(made.redrawn.values())} draws were rejected.")
    print(
        f"Hand-ins go to {made.course.folder / 'submitted'}/STUDENT/{problem_set.name}/{problem_set.name}.ipynb; then: corollary grade {problem_set.name} --course {course}"
    )
    if not made.registered:
        say(
            "nbgrader is not installed, so there is no gradebook.db: pip install 'corollary[nbgrader]' and generate again to have one"
        )
    return HOLDS
