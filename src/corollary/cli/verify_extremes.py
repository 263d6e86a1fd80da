"""`corollary verify --extremes`: closed forms at the ends of the range."""

from __future__ import annotations

import sys
import time
from typing import Any

from corollary.cli.ending import FAILS, HOLDS, answer
from corollary.cli.terminal import console, steps
from corollary.derive.load import NotDerivable
from corollary.derive.solve import solve
from corollary.grading.from_json import finite
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.verify.extremes import Pushed, push


def run_extremes(todo: list[tuple[Bank, Problem]], broken: list[str], *, as_json: bool) -> int:
    """Each problem's closed forms."""
    start, pushed = time.perf_counter(), list[Pushed]()
    for place, problem in steps(todo, lambda each: each[1].code, "pushing"):
        try:
            pushed.append(push(solve(place, problem)))
        except NotDerivable as error:
            broken.append(str(error))
    ok = not broken and all(each.ok for each in pushed)
    seconds = time.perf_counter() - start
    if as_json:
        found = [_problem(each) for each in pushed]
        answer({"ok": ok, "problems": found, "malformed": broken, "seconds": round(seconds, 2)})
    else:
        _table(pushed, broken, seconds)
    return HOLDS if ok else FAILS


def _problem(each: Pushed) -> dict[str, Any]:
    return {
        "code": each.code,
        "ok": each.ok,
        "certified": each.proven,
        "unproven": each.unproven,
        "refused": dict(each.refused),
        "lost": each.lost,
        "cancelled": each.cancelled,
        "worst_ulp": finite(each.worst),
        "where": each.where,
    }


def _table(pushed: list[Pushed], broken: list[str], seconds: float) -> None:
    from rich.table import Table

    out = console()
    table = Table(
        title="Closed forms, one given at a time at 1e±12 and 1e±150 of itself, an angle within 1e-12 of 0 and 90 degrees"
    )
    for heading in (
        "code",
        "certified",
        "unproven",
        "refused",
        "lost",
        "cancelled",
        "worst replay, ulp",
        "where",
    ):
        table.add_column(heading, justify="left" if heading in {"code", "where"} else "right")
    for each in pushed:
        counts = (each.proven, each.unproven, sum(each.refused.values()), each.lost, each.cancelled)
        table.add_row(each.code, *map(str, counts), f"{each.worst:.3g}", each.where)
    out.print(table)
    bad = [f"{each.code}: {each.unproven} values could not be certified" for each in pushed if not each.ok]
    for sentence in (*broken, *bad):
        print(sentence, file=sys.stderr)
    total = sum(each.proven for each in pushed)
    out.print(
        f"{total:,} values certified in {seconds:.1f} s; {'not all hold' if broken or bad else 'all hold'}"
    )
