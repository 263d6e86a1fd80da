"""`corollary show`: one problem as a student sees it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from corollary.cli.ending import HOLDS, refuse, say
from corollary.notebook.worksheet import Exercise, exercise
from corollary.problem.bank import Bank, home
from corollary.problem.problem import Problem
from corollary.problem.roster import Student
from corollary.problem.variant import Variant, at, chapter, size
from corollary.render.exports import UnknownTarget, names_for_exercises, target


def run(
    code: str,
    bank: Path | None,
    student: str | None,
    course: Path | None,
    variant: int | None,
    solution: bool,
    fmt: str,
    output: Path | None,
) -> int:
    write = _writer(fmt)
    if student is not None and variant is not None:
        refuse("--student and --variant both choose the numbers; give one of them")
    if course is not None and student is None:
        refuse("--course holds many students' numbers; name one with --student")
    place, problem = home(bank, code)
    chosen = _variant(place, problem, student, course, variant)
    worked = ""
    if solution:
        from corollary.grading.solutions import Solutions  # needed for the answers only

        worked = Solutions(place).worked_solution(chosen)
    text = write(exercise(chosen), Student(student or "you"), worked)
    if output is not None:
        output.write_text(text, encoding="utf-8")
        say(f"written to {output}")
    else:
        print(text, end="" if text.endswith("\n") else "\n")
    return HOLDS


def _writer(fmt: str) -> Callable[[Exercise, Student, str], str]:
    """What writes one exercise in this format."""
    try:
        write = target(fmt).exercise
    except UnknownTarget:
        write = None
    if write is None:
        refuse(f"--format {fmt} is not known; choose one of {', '.join(names_for_exercises())}")
    return write


def _variant(
    place: Bank, problem: Problem, student: str | None, course: Path | None, variant: int | None
) -> Variant:
    if variant is not None:
        return at(problem, variant)
    if student is None:
        return chapter(problem)
    if course is None:
        from corollary.grading.solutions import Solutions  # needed for the answers only

        return Solutions(place).assign_variant(problem, b"", student, ()).variant
    from corollary.records.assigned import variant_anywhere
    from corollary.records.files import open_course

    found = variant_anywhere(open_course(course), problem, student)
    if found is None and size(problem) > 1:
        refuse(f"{student} has no numbers for {problem.code} in {course}; generate a set with it first")
    return found or chapter(problem)
