"""Plots as SVG text: bars, histograms and curves; the same data give the same bytes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from io import StringIO
from typing import Any, Final

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from corollary.figure.colour import BLUE, CYCLE, ink
from corollary.figure.svg import safe_svg

WIDTH = 7.2
STYLE: Final[dict[Any, object]] = {
    "svg.hashsalt": "corollary",
    "svg.fonttype": "none",
    "font.family": ["DejaVu Sans", "sans-serif"],
    "font.size": 10.5,
    "axes.edgecolor": "#666666",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#DDDDDD",
    "grid.linewidth": 0.8,
    "legend.frameon": False,
}
MARKERS, DASHES = "os^Dv<>P", ("-", "--", "-.", ":")


@dataclass(frozen=True, slots=True)
class Layer:
    """One colour of stacked bars: `values` has one entry for each bar."""

    name: str
    values: tuple[float, ...]
    colour: str


@dataclass(frozen=True, slots=True)
class Curve:
    """One named curve through the points (x, y), in their order."""

    name: str
    x: tuple[float, ...]
    y: tuple[float, ...]


def stacked_bars(labels: Sequence[str], layers: Sequence[Layer], *, x_label: str, alt: str) -> str:
    """Horizontal bars, the first label on top, each made of the layers from left to right with its numbers written in."""
    with _drawn(0.9 + 0.36 * len(labels), alt) as (axes, out):
        total = max((sum(layer.values[at] for layer in layers) for at in range(len(labels))), default=0) or 1
        left = [0.0] * len(labels)
        for layer in layers:
            if not any(layer.values):
                continue
            axes.barh(
                range(len(labels)),
                layer.values,
                0.72,
                left,
                color=layer.colour,
                edgecolor="white",
                label=layer.name,
            )
            number = {"ha": "center", "va": "center", "color": ink(layer.colour), "fontsize": 9}
            for at, value in enumerate(layer.values):
                if value / total > 0.035:
                    axes.text(left[at] + value / 2, at, f"{value:g}", **number)  # pyright: ignore[reportArgumentType]
            left = [start + value for start, value in zip(left, layer.values, strict=True)]
        axes.set_yticks(range(len(labels)), [_verbatim(label) for label in labels])
        axes.set_ylim(len(labels) - 0.4, -0.6)
        axes.set_xlim(0, total)
        axes.set_xlabel(x_label)
        axes.grid(False, axis="y")
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        if any(any(layer.values) for layer in layers):
            axes.figure.legend(
                loc="outside upper center", ncols=7, fontsize=9, handlelength=1.1, columnspacing=1.4
            )
    return out[0]


def histogram(
    values: Sequence[float], *, low: float, high: float, bins: int, x_label: str, y_label: str, alt: str
) -> str:
    """How many values fall in each of `bins` equal intervals from low to high; the last one holds its right end."""
    counts = interval_counts(values, low, high, bins)
    width = (high - low) / bins
    with _drawn(3.0, alt) as (axes, out):
        axes.bar(
            [low + at * width for at in range(bins)],
            counts,
            width=width,
            align="edge",
            color=BLUE,
            edgecolor="white",
        )
        axes.set_xlim(low, high)
        axes.set_xlabel(x_label)
        axes.set_ylabel(y_label)
        axes.grid(False, axis="x")
        axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    return out[0]


def interval_counts(values: Sequence[float], low: float, high: float, bins: int) -> list[int]:
    """How many values lie in each interval; what lies outside counts in the nearest one, what is no number nowhere."""
    counts = [0] * bins
    for value in values:
        if math.isfinite(value):
            inside = min(max(value, low), high)
            counts[min(bins - 1, math.floor((inside - low) / (high - low) * bins))] += 1
    return counts


def lines(
    curves: Sequence[Curve], *, x_label: str, y_label: str, alt: str, log_x: bool = False, log_y: bool = False
) -> str:
    """Curves with a marker at every point, told apart by colour, marker and dash."""
    with _drawn(4.2, alt) as (axes, out):
        for at, curve in enumerate(curves):
            axes.plot(
                curve.x,
                curve.y,
                color=CYCLE[at % len(CYCLE)],
                marker=MARKERS[at % len(MARKERS)],
                markersize=5,
                linestyle=DASHES[at // len(CYCLE) % len(DASHES)],
                linewidth=1.6,
                label=_verbatim(curve.name),
            )
        axes.set_xscale("log" if log_x else "linear")
        axes.set_yscale("log" if log_y else "linear")
        axes.set_xlabel(x_label)
        axes.set_ylabel(y_label)
        if len(curves) > 1:
            axes.legend(fontsize=9.5)
    return out[0]


@contextmanager
def _drawn(height: float, alt: str) -> Iterator[tuple[Axes, list[str]]]:
    """Axes to draw on; when the block ends, the list holds the drawing."""
    out: list[str] = []
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, height), layout="constrained")
        yield figure.add_subplot(), out
        text = StringIO()
        figure.savefig(
            text, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None}
        )
    out.append(safe_svg(text.getvalue(), label=alt))


def _verbatim(text: str) -> str:
    """The text with its dollars as dollars: matplotlib takes two of them for a formula."""
    return text.replace("$", r"\$")
