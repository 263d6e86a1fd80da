"""The `[term]` table of a course's settings: weights of sets, dropped sets, and when a student falls behind."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, cast

from corollary.messages import did_you_mean

BY_POINTS = "points"


@dataclass(frozen=True, slots=True)
class TermRules:
    """`sets` in their order (empty: all that were generated, by their dates); each counts with its weight, 1 when left out, or as
    many as it has points. The `drop` worst are left out of each student's total, or all but the `best`. A student falls behind
    with so many `missing` sets, or with a total `below` so many per cent. `practice_site` is the address of a page to practise on."""

    sets: tuple[str, ...] = ()
    weights: Mapping[str, float] = field(default_factory=dict[str, float])
    by_points: bool = False
    drop: int = 0
    best: int | None = None
    missing: int = 2
    below: float = 50.0
    practice_site: str = ""

    def chosen(self, counted: int) -> int:
        """How many of so many sets make a total: at least one."""
        wanted = counted - self.drop if self.best is None else min(self.best, counted)
        return max(1, wanted) if counted else 0


def term_rules(table: Mapping[str, Any]) -> TermRules:
    """The rules of a table that has nothing to complain of."""
    found, weights = dict(table), cast("object", table.get("weights", {}))
    if isinstance(weights, dict):
        found["weights"] = {name: float(each) for name, each in cast("dict[str, float]", weights).items()}
    else:
        found["weights"], found["by_points"] = {}, True
    found["sets"] = tuple(found.get("sets", ()))
    return TermRules(**found)


def term_complaint(value: object) -> str:
    """What is wrong with the table, and what to write; empty when nothing is."""
    if not isinstance(value, dict):
        return "term: it is a table; write [term] on a line, and its settings below, such as drop = 1"
    table = cast("dict[str, object]", value)
    for name, each in table.items():
        if name not in CHECKS:
            return f"term: `{name}` is not known{did_you_mean(name, CHECKS)}; known are {', '.join(CHECKS)}"
        if sentence := CHECKS[name](each):
            return f"term: {name}: {each}: {sentence}"
    if table.get("drop") and "best" in table:
        return "term: drop and best say the same in two ways; give one of them"
    return ""


def _sets(value: object) -> str:
    names = cast("list[object]", value) if isinstance(value, list) else []
    right = names and all(isinstance(each, str) for each in names)
    return "" if right else 'list the names of sets, as ["week1", "week2"]'


def _weights(value: object) -> str:
    if value == BY_POINTS:
        return ""
    table = cast("dict[str, object]", value) if isinstance(value, dict) else {}
    right = table and all(
        isinstance(each, int | float) and type(each) is not bool and 0 <= each < float("inf")
        for each in table.values()
    )
    return "" if right else 'give each set a number from 0, as {project = 3}, or write "points"'


def _count(low: int) -> Callable[[object], str]:
    def complaint(value: object) -> str:
        return "" if type(value) is int and value >= low else f"give a whole number from {low}"

    return complaint


def _percent(value: object) -> str:
    right = isinstance(value, int | float) and type(value) is not bool and 0 <= value <= 100
    return "" if right else "give a number of per cent, from 0 to 100"


def _address(value: object) -> str:
    right = isinstance(value, str) and value.startswith(("http://", "https://"))
    return "" if right else 'give its address, as "https://physics.example.org/practice/"'


CHECKS: dict[str, Callable[[object], str]] = {
    "sets": _sets,
    "weights": _weights,
    "drop": _count(0),
    "best": _count(1),
    "missing": _count(1),
    "below": _percent,
    "practice_site": _address,
}
