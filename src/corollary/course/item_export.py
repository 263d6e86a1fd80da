"""Problems as questions of an LMS: which variants a pool has, and the files with their answer table."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from corollary.grading.assign import NoVariant
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, UnknownCode, home
from corollary.problem.problem import Problem
from corollary.problem.problem_set import Scheme, bank_of_set, find_set, set_names
from corollary.problem.variant import Variant, chapter
from corollary.records.files import Course
from corollary.records.origin import has_set, set_of
from corollary.render.exports import CarriedPart, Target
from corollary.render.lms_item import LmsItem, answer_table, item


@dataclass(frozen=True, slots=True)
class Exported:
    """`files` by name, what became of each of `parts`, what is `lost` of all, and how many questions' variants there are of each problem, by code."""

    title: str
    files: dict[str, bytes]
    parts: tuple[CarriedPart, ...]
    lost: tuple[str, ...]
    variants: dict[str, int]


def export_items(
    target: Target,
    folder: Path | None,
    name: str,
    variants: int | None,
    apart: bool,
    course: Course | None = None,
) -> Exported:
    """A set, of the `course` where it has one of that name, or one problem by its code, as questions of an LMS; `variants` of each
    problem (None: the chapter's numbers).

    Raises UnknownCode, Malformed, NotDerivable, and Undefined where the chapter's numbers have no answer.
    """
    assert target.items is not None
    bank, title, short, weighed, scheme = _chosen(folder, name, course)
    solutions = Solutions(bank)
    items = [
        item(solutions, variant, number, weight, scheme)
        for problem, weight in weighed
        for number, variant in enumerate(_variants(solutions, problem, variants), 1)
    ]
    made = target.items(short, items, apart)
    files = dict(made.files) | {f"{short}-answers.json": _table(items)}
    count = {
        problem.code: sum(each.exercise.problem.code == problem.code for each in items)
        for problem, _ in weighed
    }
    return Exported(title, files, made.parts, made.lost, count)


def _chosen(
    folder: Path | None, name: str, course: Course | None
) -> tuple[Bank, str, str, Sequence[tuple[Problem, float]], Scheme]:
    """The bank, a title, a name for files, the problems with their weights, and what verdicts earn."""
    bank = bank_of_set(folder, name)
    try:
        bank, found = (
            set_of(course, name, folder)
            if course is not None and has_set(course, name)
            else (bank, find_set(bank, name))
        )
    except UnknownCode as unknown:
        try:
            bank, problem = home(folder, name)
        except UnknownCode as neither:
            raise (unknown if name in set_names(bank) else neither) from None
        return bank, f"{problem.code} {problem.title}", problem.name, [(problem, 1.0)], Scheme()
    return bank, found.title, found.name, list(zip(found.problems, found.weights, strict=True)), found.scheme


def _variants(solutions: Solutions, problem: Problem, count: int | None) -> Iterator[Variant]:
    """Distinct numbers that follow from their place alone, the same each time; fewer where there are no more."""
    if count is None:
        yield chapter(problem)
        return
    used: set[int] = set()
    for number in range(1, count + 1):
        try:
            variant = solutions.assign_variant(problem, b"", str(number), used).variant
        except NoVariant:
            if number == 1:
                raise
            return
        if number > 1 and (variant.index is None or variant.index in used):
            return
        used |= set() if variant.index is None else {variant.index}
        yield replace(variant, problem=problem)


def _table(items: Sequence[LmsItem]) -> bytes:
    """What can be typed into each question, and what share of the part's points we give."""
    rows = [
        {
            "code": each.exercise.problem.code,
            "variant": each.number,
            "part": row.part.id,
            "what": row.sort,
            "fields": list(row.fields),
            "share": round(row.share, 6),
        }
        for each in items
        for row in answer_table(each)
    ]
    return (json.dumps(rows, ensure_ascii=False, indent=1) + "\n").encode()
