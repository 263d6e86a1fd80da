"""`corollary list`: every problem of a bank."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from corollary.answers.questions import checked
from corollary.cli.ending import HOLDS, answer
from corollary.problem.bank import load, open_bank
from corollary.problem.count import variants, written
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.units.unit import canonical, show


def run(bank: Path | None, as_json: bool) -> int:
    problems = [checked(problem) for problem in load(open_bank(bank))]
    counted = {problem.code: variants(problem) for problem in problems}
    if as_json:
        answer([_record(problem, *counted[problem.code]) for problem in problems])
        return HOLDS
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table(title=f"{len(problems)} problems, {sum(len(problem.parts) for problem in problems)} parts")
    for heading in ("code", "title", "givens", "parts"):
        table.add_column(heading, no_wrap=heading == "code")
    table.add_column("variants", justify="right", no_wrap=True)
    for problem in problems:
        givens = ", ".join(f"{given.symbol} [{show(given.unit) or '1'}]" for given in problem.givens)
        table.add_row(
            problem.code,
            problem.title,
            escape(givens),
            " ".join(part.id for part in problem.parts),
            written(*counted[problem.code]),
        )
    Console().print(table)
    return HOLDS


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
