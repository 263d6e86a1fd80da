"""Courses of earlier versions, which recorded the place of each student's numbers in the grid: resolved once, on today's grid.

Where the notebook that was handed out says otherwise (the grid was changed since), what the notebook says holds.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from corollary.notebook.worksheet import exercise
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.variant import OutOfRange, Variant, at, chapter, index_of, size
from corollary.records.files import Course, NotACourse
from corollary.records.numbers import Assigned, numbers_of

HOLE = re.compile(r"\{\{\s*([A-Za-z_]\w*)\s*(?:\|\s*(\w+)\s*)?\}\}")  # all that there were then
NUMBER = r"(−?-?[0-9]+(?:\.[0-9]+)?(?:e-?[0-9]+)?)"


def indices_of(course: Course, set_name: str) -> dict[str, dict[str, int]] | None:
    """What an earlier version recorded: by student and code of the problem. Raises NotACourse when it is damaged."""
    path = course.record("dealt", f"{set_name}.json")
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        return {
            str(student): {str(code): int(index) for code, index in row.items()}
            for student, row in record.items()
        }
    except FileNotFoundError:
        return None
    except (OSError, ValueError, TypeError, AttributeError) as error:
        raise NotACourse(f"{path} is damaged ({error}); restore it from a backup") from None


def carried_over(
    course: Course, problem_set: ProblemSet, indices: Mapping[str, Mapping[str, int]]
) -> Assigned:
    """The record in today's form. A problem that the notebook handed out does not have was never asked."""
    record = Assigned([], {})
    for student, row in indices.items():
        cells = _cells(course.notebook("release", student, problem_set.name))
        agree = True
        for problem in problem_set.problems:
            if cells and f"{problem.prefix}_statement" not in cells:
                continue
            variant = _by_index(problem, row)
            if variant is None or not _stands_in(variant, cells):
                found = _read_off(problem, variant or chapter(problem), cells)
                agree = agree and variant is not None and found.values == variant.values
                variant = found
            edition = record.place(problem, problem_set.weight(problem))
            record.students.setdefault(student, {})[problem.code] = numbers_of(variant, edition)
        if agree:
            record.carried[student] = dict(row)
    return record


def _by_index(problem: Problem, row: Mapping[str, int]) -> Variant | None:
    """None when the grid has no such place any more; the chapter's numbers for a problem that has no others."""
    if problem.code not in row:
        return chapter(problem) if size(problem) == 1 else None
    try:
        return at(problem, row[problem.code])
    except OutOfRange:
        return None


def _stands_in(variant: Variant, cells: Mapping[str, str]) -> bool:
    """Whether the notebook has these very numbers, or there is none."""
    return not cells or all(text in cells.get(name, text) for name, text in _texts(variant))


def _texts(variant: Variant) -> Iterator[tuple[str, str]]:
    asked = exercise(variant)
    yield f"{asked.problem.prefix}_statement", asked.statement
    for prompt in asked.prompts:
        yield f"{prompt.key}_text", prompt.text


def _read_off(problem: Problem, otherwise: Variant, cells: Mapping[str, str]) -> Variant:
    """The numbers as the notebook has them; for what it does not print, or in other words, those of the record."""
    templates = [(f"{problem.prefix}_statement", problem.statement)]
    templates += [(f"{problem.answer_name(part)}_text", part.text) for part in problem.parts]
    found: dict[str, Fraction] = {}
    for name, text in templates:
        pieces = HOLE.split(text)  # words, symbol, style, words, …
        pattern = "".join(
            re.escape(piece)
            if place % 3 == 0
            else NUMBER
            if place % 3 == 1
            else _behind(problem, pieces, place)
            for place, piece in enumerate(pieces)
        )
        match = re.search(pattern, cells.get(name, ""))
        if match is not None:
            for symbol, number in zip(pieces[1::3], match.groups(), strict=True):
                found[symbol] = Fraction(number.replace("−", "-"))
    values = {**otherwise.values, **found}
    return Variant(problem, values, index_of(problem, values))


def _behind(problem: Problem, pieces: list[str], place: int) -> str:
    """The unit that follows a number, unless the bare number is asked for."""
    if pieces[place] == "number":
        return ""
    return r"[ \N{NO-BREAK SPACE}]?" + re.escape(_unit(problem, pieces[place - 1]))


def _unit(problem: Problem, symbol: str) -> str:
    from corollary.units.unit import show

    return show(problem.given(symbol).unit)


def _cells(path: Path) -> dict[str, str]:
    """The texts of a notebook that was handed out, by the ids of their cells; nothing when it is gone or damaged."""
    try:
        notebook: Any = json.loads(path.read_bytes())
        return {cell["id"]: "".join(cell["source"]) for cell in notebook["cells"]}
    except (OSError, ValueError, TypeError, KeyError):
        return {}
