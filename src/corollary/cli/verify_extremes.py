"""`corollary verify --extremes`: closed forms and scenes at the ends of the range."""

from __future__ import annotations

import sys
import time
from typing import Any

from corollary.cli.console import console
from corollary.cli.ending import FAILS, HOLDS, answer
from corollary.cli.progress import steps
from corollary.derive.load import NotDerivable
from corollary.derive.solve import solve
from corollary.grading.from_json import finite
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.verify.extreme_scenes import extremes
from corollary.verify.extremes import Pushed, push
from corollary.verify.scene_extremes import ExtremeRun, play


def run_extremes(todo: list[tuple[Bank, Problem]], broken: list[str], *, scenes: bool, as_json: bool) -> int:
    """Each problem's closed forms and, when asked for, the scenes."""
    start, pushed = time.perf_counter(), list[Pushed]()
    for place, problem in steps(todo, lambda each: each[1].code, "pushing"):
        try:
            pushed.append(push(solve(place, problem)))
        except NotDerivable as error:
            broken.append(str(error))
    met = (
        [play(extreme) for extreme in steps(extremes(), lambda each: each.what, "playing")]
        if scenes
        else list[ExtremeRun]()
    )
    ok = not broken and all(each.ok for each in (*pushed, *met))
    seconds = time.perf_counter() - start
    if as_json:
        found = {"problems": [_problem(each) for each in pushed], "scenes": [_scene(each) for each in met]}
        answer({"ok": ok, **found, "malformed": broken, "seconds": round(seconds, 2)})
    else:
        _tables(pushed, met, broken, seconds)
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


def _scene(each: ExtremeRun) -> dict[str, Any]:
    return {
        "what": each.what,
        "scene": each.scene,
        "ok": each.ok,
        "outcome": each.outcome,
        "said": each.why,
        "off": finite(each.off),
        "stated": each.stated,
        "seconds": each.seconds,
    }


def _tables(pushed: list[Pushed], met: list[ExtremeRun], broken: list[str], seconds: float) -> None:
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
    if met:
        table = Table(title="Scenes: off from a law that holds there, and the error the run states")
        for heading in ("scene", "what", "outcome", "off", "stated", "ms"):
            table.add_column(heading, justify="left" if heading in {"scene", "what", "outcome"} else "right")
        for one in met:
            table.add_row(
                one.scene,
                one.what,
                one.outcome,
                f"{one.off:.1e}",
                f"{one.stated:.1e}",
                f"{1e3 * one.seconds:.0f}",
            )
        out.print(table)
    bad = [
        f"{one.what} ({one.scene}): off by {one.off:.1e}, stated {one.stated:.1e}"
        for one in met
        if not one.ok
    ]
    bad += [f"{each.code}: {each.unproven} values could not be certified" for each in pushed if not each.ok]
    for sentence in (*broken, *bad):
        print(sentence, file=sys.stderr)
    total = sum(each.proven for each in pushed)
    out.print(
        f"{total:,} values certified, {len(met)} scenes in {seconds:.1f} s; {'all hold' if not broken + bad else 'not all hold'}"
    )
