"""Records and table rows of listed problems."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

from corollary.answers.registry import answer_type
from corollary.problem.count import variants, written
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.units.unit import canonical


def listed(problems: Iterable[Problem]) -> list[tuple[dict[str, Any], list[str]]]:
    """Of problems that can be asked."""
    counted = [(problem, *variants(problem)) for problem in problems]
    return [(_record(*each), _row(*each)) for each in counted]


def _row(problem: Problem, count: int, exact: bool) -> list[str]:
    givens = ", ".join(given.symbol for given in problem.givens)
    parts = " ".join(part.id + "*" * waits_for_a_person(part) for part in problem.parts)
    answers = ", ".join(dict.fromkeys(name for part in problem.parts for name in part.answer_types))
    return [problem.code, problem.title, problem.topic, givens, parts, answers, written(count, exact)]


def waits_for_a_person(part: Part) -> bool:
    """Whether an answer to it is read by a person, whatever it says: it is written into a cell of its own."""
    return any(answer_type(name).found_in == "cell" for name in part.answer_types)


def _record(problem: Problem, count: int, exact: bool) -> dict[str, Any]:
    return {
        "code": problem.code,
        "name": problem.name,
        "title": problem.title,
        "topic": problem.topic,
        "source": problem.source,
        **asdict(problem.description),
        "given": {given.symbol: _given(given) for given in problem.givens},
        "parts": {part.id: _part(part) for part in problem.parts},
        "variants": count,
        "exact": exact,
    }


def _given(given: Given) -> dict[str, Any]:
    return {
        "is": given.meaning,
        "unit": canonical(given.unit),
        "value": float(given.value),
        "from": float(given.grid.first),
        "to": float(given.grid.last),
        "step": float(given.grid.step),
        **(
            {"in": list(given.words or map(float, given.grid.values))}
            if given.words or given.grid.values
            else {}
        ),
        **({"rows": given.table} if given.table else {}),
    }


def _part(part: Part) -> dict[str, Any]:
    return {
        "title": part.title,
        "kind": "+".join(part.answer_types),
        "unit": canonical(part.unit),
        "points": part.points,
        "components": list(part.components),
        **({"rows": list(part.rows), "columns": list(part.columns)} if part.rows else {}),
        **({"units": [canonical(each) for each in part.units]} if part.column_units else {}),
        "person": waits_for_a_person(part),
    }
