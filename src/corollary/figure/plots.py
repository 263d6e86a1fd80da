"""Plots of curves as SVG text; the same data give the same bytes."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from io import StringIO
from typing import Any, Final

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from corollary.figure.svg import CYCLE, safe_svg

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
class Curve:
    """One named curve through the points (x, y), in their order."""

    name: str
    x: tuple[float, ...]
    y: tuple[float, ...]


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
def _drawn(height: float, alt: str) -> Generator[tuple[Axes, list[str]]]:
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
