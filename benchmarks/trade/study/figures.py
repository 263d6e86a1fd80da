"""The study's figures: work against precision, stated against true error, and what the chapter's loop would have needed."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from corollary.figure.svg import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, VERMILLION

from .labels import name_curves
from .measured import FAMILIES, Timed, from_rows
from .summary import Curves, cost, costs, curves, error_of, evaluations_of, planned, spread

STYLE = {
    "svg.fonttype": "none",
    "svg.hashsalt": "trade",
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "font.family": "sans-serif",
}
NAMES = {
    "row": "three Hertz balls in a row",
    "spheres": "two damped spheres",
    "wall": "oscillator at a hard wall",
    "friction": "block, spring, dry friction",
    "orbit": "orbit",
    "fluid": "fall in a thick fluid (stiff)",
}
FLOOR = 1e-16


def drawn(document: dict[str, Any], folder: Path) -> None:
    """Write every figure of these runs as SVG."""
    runs = from_rows(document["runs"])
    found = curves(runs)
    with matplotlib.rc_context(STYLE):
        made = {"work": work(found), "stated": stated(runs)}
        if any(family == "spheres" for family, _ in found):
            made["book"] = book(found)
        for name, figure in made.items():
            figure.savefig(folder / f"{name}.svg", metadata={"Date": None})


NAMED = {
    BLUE: "Corollary",
    VERMILLION: "DOP853",
    ORANGE: "LSODA",
    GREEN: "Radau",
    PURPLE: "heyoka",
    BLACK: "chapter's loop",
}
PANEL = (190.0, 165.0)
"""About the size of a panel of the first figure, in points."""


def methods_of(family: str, found: Curves) -> list[tuple[str, str]]:
    """The few that are drawn, with their colours: ours, scipy's, Taylor, the chapter's loop; Radau only where motion is stiff."""
    ends = " events" if (family, "DOP853 events") in found else ""
    return [
        (planned(family), BLUE),
        (f"DOP853{ends}", VERMILLION),
        (f"LSODA{ends}", ORANGE),
        *([(f"Radau{ends}", GREEN)] if family == "fluid" else []),
        ("heyoka", PURPLE),
        ("book compiled", BLACK),
    ]


def work(found: Curves) -> Figure:
    """Error against evaluations, a panel for each family; bands are quartiles over the draws."""
    families = [family for family in FAMILIES if (family, planned(family)) in found]
    figure = Figure(figsize=(9.6, 6.4), layout="constrained")
    figure.suptitle(_finding(found, families), fontsize=11, x=0.01, ha="left")
    grid = figure.subplots(2, 3, sharey=True).ravel()
    for axes, family in zip(grid, families, strict=False):
        axes.set(xscale="log", yscale="log", ylim=(1e-16, 3.0), xlim=(40, 6e5))
        for method, colour in methods_of(family, found):
            if (family, method) in found:
                _curve(axes, list(found[family, method].values()), colour)
        name_curves(axes, NAMED, PANEL)
        axes.set_title(NAMES[family], fontsize=9.5, loc="left")
    for axes in grid[len(families) :]:
        axes.set_visible(False)
    for axes in grid[3:]:
        axes.set_xlabel("evaluations of the right side")
    for axes, what in zip(grid[::3], ("error", "error"), strict=False):
        axes.set_ylabel(what + ", in natural units")
    return figure


def _finding(found: Curves, families: list[str]) -> str:
    """How many evaluations nine digits cost by the planner's choice, as a multiple of scipy's best on the same family."""
    said = []
    for family in families:
        ours = costs(found, family, planned(family), 1e-9)
        names = [
            method
            for name, method in found
            if name == family and method.startswith(("DOP853", "Radau", "LSODA"))
        ]
        rivals = [c.median for name in names if 2 * (c := costs(found, family, name, 1e-9)).reached > c.draws]
        said.append(
            f"{family} {ours.median / min(rivals):.2g}"
            if rivals and ours.reached
            else f"{family}: only one gets there"
        )
    half = (len(said) + 1) // 2
    return (
        "Nine digits with their error cost Corollary, in evaluations as a multiple of scipy's best (which states none):\n"
        + ", ".join(said[:half])
        + (", " + ", ".join(said[half:]) if said[half:] else "")
    )


def _curve(axes: Any, draws: list[list[Timed]], colour: str) -> None:
    points = []
    for same in zip(*draws, strict=False):
        good = [run for run in same if run.outcome == "found" and math.isfinite(error_of(run))]
        if 2 * len(good) > len(same):
            errors = np.quantile([min(max(error_of(run), FLOOR), 1e3) for run in good], (0.25, 0.5, 0.75))
            points.append((float(np.median([evaluations_of(run) for run in good])), *errors))
    if not points:
        return
    x, low, middle, high = zip(*points, strict=True)
    axes.fill_between(x, low, high, color=colour, alpha=0.12, linewidth=0)
    wide = 2.2 if colour == BLUE else 1.2
    axes.plot(x, middle, color=colour, linewidth=wide, marker="o", markersize=2.5)


def stated(runs: list[Timed]) -> Figure:
    """True against stated error of every run of ours, and against the tolerance of every run of DOP853."""
    figure = Figure(figsize=(5.6, 4.6), layout="constrained")
    axes = figure.subplots()
    ours = [r for r in runs if r.outcome == "found" and math.isfinite(r.stated)]
    theirs = [r for r in runs if r.outcome == "found" and r.method in ("DOP853", "DOP853 events")]
    above = sum(r.end > r.setting for r in theirs) / max(len(theirs), 1)
    inside = sum(r.end - 2e-15 <= r.stated for r in ours) / max(len(ours), 1)
    axes.plot(
        [r.setting for r in theirs],
        [min(max(r.end, FLOOR), 9) for r in theirs],
        ".",
        color=VERMILLION,
        markersize=3,
        alpha=0.6,
    )
    axes.plot(
        [max(r.stated, FLOOR) for r in ours],
        [max(r.end, FLOOR) for r in ours],
        ".",
        color=BLUE,
        markersize=3,
        alpha=0.6,
    )
    axes.plot([FLOOR, 10], [FLOOR, 10], color=GREY, linewidth=1)
    axes.set(xscale="log", yscale="log", xlim=(FLOOR, 1), ylim=(FLOOR, 10))
    axes.set(
        xlabel="error as stated (Corollary) or tolerance as asked (DOP853)",
        ylabel="true error at the end, in natural units",
    )
    axes.text(2e-16, 3e-6, "each run of DOP853,\nat the tolerance asked", color=VERMILLION)
    axes.text(1e-8, 3e-14, "each run of Corollary,\nat the error it states", color=BLUE)
    axes.set_title(
        f"{100 * inside:.1f} % of Corollary's {len(ours)} stated errors hold;\n{100 * above:.0f} % of DOP853's runs miss their tolerance",
        loc="left",
        fontsize=11,
    )
    return figure


def book(found: Curves) -> Figure:
    """Steps of the chapter's loop for so many right digits, continued by its last slope where that is beyond what was run."""
    figure = Figure(figsize=(6.4, 3.9), layout="constrained")
    axes = figure.subplots()
    digits = np.arange(2, 10)
    slow = np.median(
        [
            r.seconds / r.evaluations
            for runs in found["spheres", "book"].values()
            for r in runs
            if r.evaluations >= 800
        ]
    )
    last = {}
    for family, colour, label in (
        ("spheres", VERMILLION, "two damped spheres"),
        ("row", ORANGE, "three balls in a row, no damping"),
    ):
        if (family, "book compiled") not in found:
            continue
        needed = [_steps(found[family, "book compiled"], 10.0**-d) for d in digits]
        axes.plot(digits, needed, color=colour, marker="o", markersize=3.5)
        at = 4 if family == "spheres" else -1
        axes.annotate(
            label, (digits[at], needed[at]), (-6, 8), textcoords="offset points", color=colour, ha="right"
        )
        last[family] = needed[-1]
    ours = [
        spread(
            [cost(runs, 10.0**-d, evaluations_of) for runs in found["spheres", planned("spheres")].values()]
        ).median
        for d in digits
    ]
    axes.plot(digits, ours, color=BLUE, linewidth=2.2)
    axes.annotate(
        "Corollary, the same spheres",
        (digits[-1], ours[-1]),
        (0, 5),
        textcoords="offset points",
        color=BLUE,
        ha="right",
    )
    for seconds, name in ((1.0, "a second"), (60.0, "a minute"), (3600.0, "an hour")):
        axes.axhline(seconds / slow, color=GREY, linewidth=0.6, linestyle=":")
        axes.annotate(
            f"{name} of Python",
            (2, seconds / slow),
            (0, 2),
            textcoords="offset points",
            color=GREY,
            fontsize=8,
        )
    axes.set(yscale="log", xlabel="right digits", ylabel="steps (evaluations of the force)", ylim=(20, None))
    axes.set_title(
        f"Each digit more costs the chapter's loop ten times the steps if there is damping:\nfor nine it would take {_long(last['spheres'] * slow)}",
        loc="left",
        fontsize=10.5,
    )
    return figure


def _steps(draws: dict[int, list[Timed]], wanted: float) -> float:
    """The median over draws of the steps for an error, by a line through the runs in the end of their curve."""
    found = []
    for runs in draws.values():
        points = [
            (math.log(r.evaluations), math.log(r.end))
            for r in runs
            if r.outcome == "found" and 1e-13 < r.end < 0.3
        ]
        slope, start = np.polyfit(*zip(*points, strict=True), 1)
        found.append(math.exp((math.log(wanted) - start) / slope))
    return float(np.median(found))


def _long(seconds: float) -> str:
    for name, size in (("days", 86400.0), ("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 2.0 * size:
            return f"{seconds / size:.0f} {name}"
    return f"{seconds:.0f} seconds"
