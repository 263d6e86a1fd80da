"""The study's tables, as Markdown."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from .measured import FAMILIES, from_rows
from .summary import WANTED, Curves, Spread, calibration, costs, curves, failures, planned, ratios

ENDS = ("found", "silently wrong", "failed", "refused", "too dear")


def of(document: dict[str, Any]) -> str:
    """All tables, with where and when they were made."""
    runs = from_rows(document["runs"])
    found = curves(runs)
    families = [family for family in FAMILIES if any(key[0] == family for key in found)]
    opening = "# Tables of the trade\n\n**For programmers.** Here is what each method costs at each accuracy."
    head = f"{opening}\n\nMade at commit {document['commit']}; {document['machine']}; {document['draws']} draws of each family; {document['seconds']} s of the processor."
    text = [head, ""]
    for family in families:
        text += [
            f"**{family}** (evaluations, median and quartiles; time as a multiple of {planned(family)})",
            "",
            *_family(found, family),
            "",
        ]
    text += [
        "**What became of the runs at 1e-4 and finer**",
        "",
        *_failures(runs),
        "",
        "**Stated against true error**",
        "",
    ]
    return "\n".join([*text, *_calibration(runs)]) + "\n"


def _family(found: Curves, family: str) -> list[str]:
    methods = [method for name, method in found if name == family]
    rows = [
        ["method", *(f"{wanted:.0e}" for wanted in WANTED), *(f"time, {wanted:.0e}" for wanted in WANTED)]
    ]
    for method in methods:
        counted = [_cell(costs(found, family, method, wanted)) for wanted in WANTED]
        timed = [_cell(ratios(found, family, method, wanted), 2) for wanted in WANTED]
        rows.append([f"**{method}**" if method == planned(family) else method, *counted, *timed])
    return table(rows)


def _cell(spread: Spread, figures: int = 3) -> str:
    if not spread.reached:
        return ""
    numbers = [f"{float(f'{x:.{figures}g}'):,.6g}" for x in (spread.median, spread.low, spread.high)]
    few = "" if spread.reached == spread.draws else f", {spread.reached} of {spread.draws}"
    return f"{numbers[0]} ({numbers[1]} to {numbers[2]}{few})"


def _failures(runs: Any) -> list[str]:
    rows = [["method", "runs", *ENDS]]
    rows += [
        [method, str(count["runs"]), *(str(count[end]) for end in ENDS)]
        for method, count in failures(runs).items()
    ]
    return table(rows)


def _calibration(runs: Any) -> list[str]:
    rows = [["family", "route", "runs", "truth inside", "worst true/stated", "median true/stated"]]
    for (family, method), each in calibration(runs).items():
        worst = "nothing stated" if math.isinf(each.worst) else f"{each.worst:.2g}"
        rows.append(
            [family, method, str(each.runs), f"{100 * each.inside:.1f} %", worst, f"{each.median:.1g}"]
        )
    return table(rows)


def table(rows: Sequence[Sequence[str]]) -> list[str]:
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    return [lines[0], "|" + "---|" * len(rows[0]), *lines[1:]]
