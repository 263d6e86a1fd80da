"""The problem that a command is about, and its numbers: typed, read from a file of cases, a student's, or those of a variant."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

from corollary.cli.ending import refuse
from corollary.problem.bank import Bank, home
from corollary.problem.problem import Problem
from corollary.problem.variant import Variant, at, chapter, size


def from_options(sets: list[str], form: str = 'name=value, such as m=0.43 or v="72 km/h"') -> dict[str, str]:
    """Givens as `m=0.43` (SI) or `v=72 km/h`, by symbol; `form` is how they are written. Refuses one that is given twice."""
    values: dict[str, str] = {}
    for option in sets:
        name, mark, text = option.partition("=")
        if not mark or not name.strip():
            refuse(f"--set {option}: write it as {form}")
        if name.strip() in values:
            refuse(f"--set {option}: {name.strip()} is set twice; give it once")
        values[name.strip()] = text
    return values


def read_cases(path: Path) -> list[Any]:
    """A JSON list; its numbers are kept as exact decimals."""
    try:
        found: Any = json.loads(
            path.read_text(encoding="utf-8"), parse_float=_decimal, parse_constant=_no_number
        )
    except OSError as error:
        refuse(f"{path} cannot be read: {error.strerror}")
    except (ValueError, RecursionError) as error:
        refuse(f"{path} is not JSON: {error}")
    if not isinstance(found, list):
        refuse(f"{path} must hold a JSON list")
    return _listed(found)


def _listed(cases: Any) -> list[Any]:
    return list(cases)


def _decimal(text: str) -> Fraction | str:
    from corollary.problem.front_matter import exact  # with YAML

    number = exact(text)
    return number if number is not None else text


def _no_number(text: str) -> str:
    return text


def chosen_problem(bank: Path | None, course: Path | None, code: str) -> tuple[Bank, Problem]:
    """The problem and its bank: the one named, else one that sets of the course were dealt from, else as without a course.

    Raises UnknownCode, Malformed and NotACourse.
    """
    if course is not None and bank is None:
        from corollary.records.files import open_course
        from corollary.records.origin import home_in_course

        if (found := home_in_course(open_course(course), code)) is not None:
            return found
    return home(bank, code)


def chosen_variant(
    place: Bank, problem: Problem, student: str | None, course: Path | None, variant: int | None = None
) -> Variant:
    """Those of a student in a course are the ones dealt there. Ends the command where a course has none for a student."""
    if variant is not None:
        return at(problem, variant)
    if student is None:
        return chapter(problem)
    if course is None:
        from corollary.grading.solutions import Solutions  # needed for the answers only

        return Solutions(place).assign_variant(problem, b"", student, ()).variant
    from corollary.records.assignments import variant_anywhere
    from corollary.records.files import find_student, open_course

    opened = open_course(course)
    found = variant_anywhere(opened, problem, find_student(opened, student).id)
    if found is None and size(problem) > 1:
        refuse(f"{student} has no numbers for {problem.code} in {course}; generate a set with it first")
    return found or chapter(problem)
