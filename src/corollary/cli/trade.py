"""`corollary trade`: speed against accuracy, measured; the table and the pictures."""

from __future__ import annotations

import json as plain_json
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from corollary.cli.failure import HOLDS, answer, refuse, say
from corollary.cli.progress import steps
from corollary.scene.trade.case import Case
from corollary.scene.trade.measures import WANTED, orders, reaching
from corollary.scene.trade.race import Lap, Raced, cases, race
from corollary.scene.trade.record import label, record

COSTS: dict[str, tuple[str, Callable[[Lap], float]]] = {
    "evaluations": ("evaluations of the force", lambda lap: float(max(lap.evaluations, 1))),
    "seconds": ("processor time, s", lambda lap: lap.seconds),
}


def run(scenes: list[str], output: Path | None, json: bool, quick: bool) -> int:
    begin = time.perf_counter()
    todo = _chosen(scenes)
    raced = [race(case, quick) for case in steps(todo, lambda case: case.name, "racing")]
    from corollary.mark.arithmetic import measured  # after the races: it brings the bank's formulas and their solver

    found: dict[str, Any] = {"scenes": [record(each) for each in raced], "closed_forms": [] if scenes else measured(quick)}
    found["seconds"] = round(time.perf_counter() - begin, 2)
    folder = output or (None if json else Path("trade"))
    if folder is not None:
        _write(folder, raced, found, ("evaluations",) if quick else ("evaluations", "seconds"))
        say(f"written to {folder}/: trade.json, trade.md, and pictures of each scene")
    if json:
        answer(found)
    else:
        print(table(raced, found))
    return HOLDS


def _chosen(scenes: Sequence[str]) -> list[Case]:
    """Scenes by their own name or by that of the ready-made scene (all of that name); every one when none is named."""
    known = cases()
    for name in scenes:
        if not any(name in (case.name, case.ready) for case in known):
            names = dict.fromkeys([case.ready for case in known] + [case.name for case in known])
            refuse(f"there is no race on a scene called {name!r}; there are {', '.join(names)}")
    return [case for case in known if not scenes or case.name in scenes or case.ready in scenes]


def table(raced: Sequence[Raced], found: dict[str, Any]) -> str:
    """What was measured, as Markdown that also reads well on a terminal."""
    heads = ["scene", *(label(wanted) for wanted in WANTED), "planned"]
    best = [heads]
    for each in raced:
        row = [each.case.name]
        for wanted in WANTED:
            ways = sorted(reaching(each, wanted).values(), key=lambda lap: lap.seconds)
            row.append(f"{ways[0].method}: {ways[0].evaluations}; {1e3 * ways[0].seconds:.2f} ms" if ways else "none")
        best.append([*row, each.planned])
    slopes = [["scene", "euler_cromer", "velocity_verlet", "rk4", "yoshida4", "yoshida6", "yoshida8", "regularised", "lies beyond"]]
    for each, data in zip(raced, found["scenes"], strict=True):
        measured = orders(each)
        own = [f"{name.removeprefix('regularised_')} {o.value:.1f}" for name, o in measured.items() if name.startswith("regularised")]
        honest = data["lies_beyond"]["euler_cromer"]
        fixed = [f"{measured[m].value:.2f} ± {measured[m].high - measured[m].value:.2f}" if m in measured else "" for m in slopes[0][1:7]]
        slopes.append([each.case.name, *fixed, ", ".join(own), "always" if honest is None else f"{honest:.3f}"])
    text = ["The cheapest method for a wanted accuracy (evaluations; processor time), and what the planner takes", "", *_rows(best), ""]
    text += ["Observed orders, with two standard errors; the step, in contact times, beyond which Euler-Cromer is off by 1 %", ""]
    text += [*_rows(slopes), ""]
    if found["closed_forms"]:
        text += ["Closed forms of ten problems (four when quick), many variants of each: speed against error", ""]
        heads = ["arithmetic", "formulas", "values a second", "median error, ulp", "worst error, ulp", "worst is"]
        closed = [
            [c["arithmetic"], str(c["formulas"]), f"{c['values_per_second']:.3g}", f"{c['median_ulp']:.2g}", f"{c['worst_ulp']:.2g}", c["worst"]]
            for c in found["closed_forms"]
        ]
        text += [*_rows([heads, *closed]), ""]
    missing = {f"{each.case.name}: {name}: {why}" for each in raced for name, why in each.missing.items()}
    return "\n".join([*text, *sorted(missing)])


def _rows(rows: Sequence[Sequence[str]]) -> list[str]:
    wide = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = ["| " + " | ".join(cell.ljust(width) for cell, width in zip(row, wide, strict=True)) + " |" for row in rows]
    return [lines[0], "|" + "|".join("-" * (width + 2) for width in wide) + "|", *lines[1:]]


def _write(folder: Path, raced: Sequence[Raced], found: dict[str, Any], costs: Sequence[str]) -> None:
    from corollary.figure.plots import Curve, lines

    folder.mkdir(parents=True, exist_ok=True)
    (folder / "trade.json").write_text(plain_json.dumps(found, indent=1), encoding="utf-8")
    (folder / "trade.md").write_text(table(raced, found) + "\n", encoding="utf-8")
    for each in raced:
        name = each.case.name.replace(" ", "_").replace("=", "")
        methods = dict.fromkeys(lap.method for lap in each.laps)
        for what in costs:
            curves = []
            for method in methods:
                # Beyond a hundred per cent a curve says nothing; below 1e-17 there are no doubles left.
                laps = [lap for lap in each.laps if lap.method == method and lap.error <= 1.0]
                curves.append(Curve(method, tuple(COSTS[what][1](lap) for lap in laps), tuple(max(lap.error, 1e-17) for lap in laps)))
            alt = f"{each.case.name}: error of the {each.case.observable} against {what}, for {', '.join(methods)}"
            drawn = lines(curves, x_label=COSTS[what][0], y_label=f"error, {each.case.observable}", alt=alt, log_x=True, log_y=True)
            (folder / f"{name}_{what}.svg").write_text(drawn, encoding="utf-8")
