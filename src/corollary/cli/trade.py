"""`corollary trade`: every method raced on every scene; the table and the pictures."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from corollary.cli.ending import HOLDS, answer, refuse, say
from corollary.cli.terminal import steps
from corollary.trade.methods import METHODS
from corollary.trade.race import (
    WANTED,
    Timing,
    WorkPrecision,
    cases,
    label,
    lies_beyond,
    orders,
    race,
    reaching,
    record,
)
from corollary.trade.raced_scene import RacedScene

NAMESPACE = '<svg xmlns="http://www.w3.org/2000/svg" '
"""A drawing in a page needs none; one in a file of its own does."""

COSTS: dict[str, tuple[str, Callable[[Timing], float]]] = {
    "evaluations": ("evaluations of the force", lambda timing: float(max(timing.evaluations, 1))),
    "seconds": ("processor time, s", lambda timing: timing.seconds),
}


def run(scenes: list[str], output: Path | None, as_json: bool, quick: bool) -> int:
    begin = time.perf_counter()
    todo = _chosen(scenes)
    raced = [race(case, quick) for case in steps(todo, lambda case: case.name, "racing")]
    from corollary.trade.arithmetic_costs import (
        measured,  # after the races: it brings the bank's formulas and their solver
    )

    found: dict[str, Any] = {
        "scenes": [record(each) for each in raced],
        "closed_forms": [] if scenes else measured(quick),
    }
    found["seconds"] = round(time.perf_counter() - begin, 2)
    folder = output or (None if as_json else Path("trade"))
    if folder is not None:
        _write(folder, raced, found, ("evaluations",) if quick else ("evaluations", "seconds"))
        say(f"written to {folder}/: trade.json, trade.md, and pictures of each scene")
    if as_json:
        answer(found)
    else:
        print(table(raced, found))
    return HOLDS


def _chosen(scenes: Sequence[str]) -> list[RacedScene]:
    """Scenes by their own name or by that of the ready-made scene (all of that name); every one when none is named."""
    known = cases()
    for name in scenes:
        if not any(name in (case.name, case.ready) for case in known):
            names = dict.fromkeys([case.ready for case in known] + [case.name for case in known])
            refuse(f"no trade is measured for a scene called {name!r}; choose one of {', '.join(names)}")
    return [case for case in known if not scenes or case.name in scenes or case.ready in scenes]


def table(raced: Sequence[WorkPrecision], found: dict[str, Any]) -> str:
    """What was measured, as Markdown that also reads well on a terminal."""
    heads = ["scene", *(label(wanted) for wanted in WANTED), "planned"]
    best = [heads]
    for each in raced:
        row = [each.case.name]
        for wanted in WANTED:
            ways = sorted(reaching(each, wanted).values(), key=lambda timing: timing.seconds)
            row.append(
                f"{ways[0].method}: {ways[0].evaluations}; {1e3 * ways[0].seconds:.2f} ms" if ways else "none"
            )
        best.append([*row, each.planned])
    text = [
        "The cheapest method for a wanted accuracy (evaluations; processor time), and what the planner takes",
        "",
        *_rows(best),
        "",
    ]
    text += [
        "Observed orders, with two standard errors; the step, in contact times, beyond which Euler-Cromer is off by 1 %",
        "",
    ]
    text += [*_rows(_slopes(raced)), ""]
    if found["closed_forms"]:
        text += [
            "Closed forms of the bank (of four problems when quick), many variants of each: speed against error",
            "",
        ]
        text += [*_rows(_formula_rows(found["closed_forms"])), ""]
    return "\n".join([*text, *_left_out(raced)])


def _left_out(raced: Sequence[WorkPrecision]) -> list[str]:
    """One line for each method that could not run, and each reason."""
    scenes: dict[tuple[str, str], list[str]] = {}
    for each in raced:
        for method, why in each.missing.items():
            scenes.setdefault((method, why), []).append(each.case.name)
    return [f"{method} is left out on {', '.join(names)}: {why}" for (method, why), names in scenes.items()]


def _slopes(raced: Sequence[WorkPrecision]) -> list[list[str]]:
    """One row for each scene, in which a fixed-step method's order is given with its bounds."""
    fixed = list(METHODS)
    rows = [["scene", *fixed, "regularised", "lies beyond"]]
    for each in raced:
        measured, honest = orders(each), lies_beyond(each)
        texts = {
            name: f"{order.value:.2f} ± {order.high - order.value:.2f}" for name, order in measured.items()
        }
        own = [
            f"{name.removeprefix('regularised_')} {texts[name]}"
            for name in texts
            if name.startswith("regularised")
        ]
        last = "always" if honest is None else f"{honest:.3f}"
        rows.append([each.case.name, *(texts.get(name, "") for name in fixed), ", ".join(own), last])
    return rows


def _formula_rows(found: Sequence[dict[str, Any]]) -> list[list[str]]:
    rows = [
        ["arithmetic", "formulas", "values a second", "median error, ulp", "worst error, ulp", "worst is"]
    ]
    for each in found:
        numbers = (f"{each[name]:.3g}" for name in ("values_per_second", "median_ulp", "worst_ulp"))
        rows.append([each["arithmetic"], str(each["formulas"]), *numbers, each["worst"]])
    return rows


def _rows(rows: Sequence[Sequence[str]]) -> list[str]:
    wide = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = [
        "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, wide, strict=True)) + " |"
        for row in rows
    ]
    return [lines[0], "|" + "|".join("-" * (width + 2) for width in wide) + "|", *lines[1:]]


def _write(folder: Path, raced: Sequence[WorkPrecision], found: dict[str, Any], costs: Sequence[str]) -> None:
    from corollary.figure.plots import Curve, lines

    folder.mkdir(parents=True, exist_ok=True)
    (folder / "trade.json").write_text(json.dumps(found, indent=1), encoding="utf-8")
    (folder / "trade.md").write_text(table(raced, found) + "\n", encoding="utf-8")
    for each in raced:
        name = each.case.name.replace(" ", "_").replace("=", "")
        methods = dict.fromkeys(timing.method for timing in each.timings)
        for what in costs:
            curves: list[Curve] = []
            for method in methods:
                # Beyond a hundred per cent a curve says nothing; below 1e-17 there are no doubles left.
                timings = [
                    timing for timing in each.timings if timing.method == method and timing.error <= 1.0
                ]
                curves.append(
                    Curve(
                        method,
                        tuple(COSTS[what][1](timing) for timing in timings),
                        tuple(max(timing.error, 1e-17) for timing in timings),
                    )
                )
            alt = f"{each.case.name}: error of the {each.case.observable} against {what}, for {', '.join(methods)}"
            drawn = lines(
                curves,
                x_label=COSTS[what][0],
                y_label=f"error, {each.case.observable}",
                alt=alt,
                log_x=True,
                log_y=True,
            )
            (folder / f"{name}_{what}.svg").write_text(drawn.replace("<svg ", NAMESPACE, 1), encoding="utf-8")
