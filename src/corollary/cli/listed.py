"""What is listed of each problem: its record and its row of the table."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from corollary.answers.questions import checked
from corollary.problem.count import variants, written
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.units.unit import canonical, show


def listed(problems: Iterable[Problem]) -> list[tuple[dict[str, Any], list[str]]]:
    """Raises Malformed where a heading does not fit its answer type."""
    counted = [(checked(problem), *variants(problem)) for problem in problems]
    return [(_record(*each), _row(*each)) for each in counted]


def _row(problem: Problem, count: int, exact: bool) -> list[str]:
    givens = ", ".join(f"{given.symbol} [{show(given.unit) or '1'}]" for given in problem.givens)
    parts = " ".join(part.id for part in problem.parts)
    return [problem.code, problem.title, givens, parts, written(count, exact)]


def _record(problem: Problem, count: int, exact: bool) -> dict[str, Any]:
    return {
        "code": problem.code,
        "name": problem.name,
        "title": problem.title,
        "topic": problem.topic,
        "source": problem.source,
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
    }


def _part(part: Part) -> dict[str, Any]:
    return {
        "title": part.title,
        "kind": "+".join(part.answer_types),
        "unit": canonical(part.unit),
        "points": part.points,
        "components": list(part.components),
    }
