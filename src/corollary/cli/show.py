"""`corollary show`: one problem as a student sees it."""

from __future__ import annotations

from pathlib import Path

from corollary.cli.failure import HOLDS, refuse, say
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import exercise, worksheet
from corollary.problem.bank import Bank, home
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet, Scheme
from corollary.problem.roster import Student
from corollary.problem.variant import Variant, assigned_variant, at, chapter, size

FORMATS = ("text", "md", "html", "ipynb")


def run(
    code: str,
    bank: Path | None,
    student: str | None,
    course: Path | None,
    variant: int | None,
    solution: bool,
    format: str,
    output: Path | None,
) -> int:
    if format not in FORMATS:
        refuse(f"--format {format} is not known; choose one of {', '.join(FORMATS)}")
    if student is not None and variant is not None:
        refuse("--student and --variant both choose the numbers; give one of them")
    if course is not None and student is None:
        refuse("--course holds many students' numbers; name one with --student")
    place, problem = home(bank, code)
    chosen = _variant(place, problem, student, course, variant)
    story = Solutions(place).story(chosen) if solution else None
    text = _text(chosen, story, format, student)
    if output is not None:
        output.write_text(text, encoding="utf-8")
        say(f"written to {output}")
    else:
        print(text, end="" if text.endswith("\n") else "\n")
    return HOLDS


def _variant(
    place: Bank, problem: Problem, student: str | None, course: Path | None, variant: int | None
) -> Variant:
    if variant is not None:
        return at(problem, variant)
    if student is None:
        return chapter(problem)
    if course is None:
        return Solutions(place).assign_variant(problem, b"", student, ()).variant
    from corollary.records.assigned import assigned_anywhere
    from corollary.records.files import open_course

    row = assigned_anywhere(open_course(course), student)
    if problem.code not in row and size(problem) > 1:
        refuse(f"{student} has no numbers for {problem.code} in {course}; generate a set with it first")
    return assigned_variant(problem, row)


def _text(chosen: Variant, story: str | None, format: str, student: str | None) -> str:
    if format == "ipynb":
        from corollary.notebook.notebook import file_text, notebook

        problem = chosen.problem
        alone = ProblemSet(problem.name, problem.title, "", (problem,), (1.0,), None, Scheme(), False)
        return file_text(notebook(worksheet(alone, Student(student or "you"), [chosen])))
    from corollary.render.show import show_html, show_markdown, show_text

    shown = {"text": show_text, "md": show_markdown, "html": show_html}[format]
    return shown(exercise(chosen), story)
