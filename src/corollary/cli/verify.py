"""`corollary verify`: problems and solutions proven right."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import Any

from corollary.cli.failure import FAILS, HOLDS, answer
from corollary.cli.progress import steps
from corollary.mark.verify.checked import Checked
from corollary.mark.verify.verify import verify
from corollary.problem.bank import Bank, doubles, files, home, open_bank
from corollary.problem.complaint import Malformed
from corollary.problem.problem import Problem
from corollary.problem.read import read_problem


def run(codes: list[str], bank: Path | None, variants: int, json: bool, extremes: bool = False) -> int:
    start = time.perf_counter()
    todo, broken = _problems(codes, bank)
    if extremes:
        from corollary.cli.verify_extremes import run_extremes

        return run_extremes(todo, broken, scenes=not codes, json=json)
    found: list[Checked] = []
    for place, problem in steps(todo, lambda each: each[1].code, "verifying"):
        found.append(verify(place, problem, variants))
    ok = not broken and all(each.ok for each in found)
    if json:
        answer(
            {
                "ok": ok,
                "problems": [_record(each) for each in found],
                "malformed": broken,
                "seconds": round(time.perf_counter() - start, 2),
            }
        )
    else:
        _table(found, broken, time.perf_counter() - start)
    return HOLDS if ok else FAILS


def _problems(codes: list[str], bank: Path | None) -> tuple[list[tuple[Bank, Problem]], list[str]]:
    """The problems asked for, all without a code, each with its bank; and what is wrong with files that cannot be read."""
    if codes:
        return [home(bank, code) for code in codes], []
    place, todo, broken = open_bank(bank), [], []
    for path in files(place):
        try:
            todo.append((place, read_problem(path)))
        except Malformed as error:
            broken += map(str, error.complaints)
    return todo, [*broken, *map(str, doubles([problem for _, problem in todo]))]


def _record(checked: Checked) -> dict[str, Any]:
    return {
        "code": checked.code, "ok": checked.ok, "variants": checked.variants, "redrawn": round(checked.redrawn, 4),
        "why_redrawn": dict(checked.why), "checks": checked.checks, "complaints": list(checked.complaints),
    }  # fmt: skip


def _table(found: list[Checked], broken: list[str], seconds: float) -> None:
    from rich.console import Console
    from rich.table import Table

    table = Table(title="Verified")
    for heading in ("code", "variants", "walked", "redrawn", "laws", "mistakes", "simulations", "complaints"):
        table.add_column(heading, justify="left" if heading == "code" else "right")
    for each in found:
        counts = each.checks
        table.add_row(
            each.code, f"{'' if each.exact_count else '≈ '}{each.variants:,}", str(counts.get("variants walked", 0)), f"{each.redrawn:.0%}",
            str(counts.get("laws put back", 0)), str(counts.get("mistakes", 0)), str(counts.get("simulations met", 0)), str(len(each.complaints) or "none"),
        )  # fmt: skip
    console = Console()
    console.print(table)
    for sentence in (*broken, *(sentence for each in found for sentence in each.complaints)):
        print(sentence, file=sys.stderr)
    total = sum(sum(each.checks.values()) for each in found)
    bad = len(broken) + sum(not each.ok for each in found)
    console.print(
        f"{len(found)} problems, {total:,} checks in {seconds:.1f} s; {'all hold' if not bad else f'{bad} with complaints'}"
    )
