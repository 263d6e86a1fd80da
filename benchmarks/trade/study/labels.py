"""Names of curves, each beside its own and off all others."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

# The height of a line of text and the width of a letter, over the font's size; how far a name stays off its curve, in points.
HEIGHT, LETTER, OFF = 1.2, 0.68, 4.0


def name_curves(axes: Any, names: dict[str, str], size: tuple[float, float], font: float = 8.0) -> None:
    """Write beside each line of axes with logarithmic scales its label in `names` (by colour), where it hides least.

    `size` is about that of the panel, in points. Of places that hide nothing it is the one nearest the curve's end.
    """
    lines = [line for line in axes.get_lines() if line.get_color() in names]
    spots = [_on_page(axes, line, size) for line in lines]
    crossed = np.concatenate([_densely(each) for each in spots])
    taken: list[tuple[float, float, float, float]] = []
    for line, corners in zip(lines, spots, strict=True):
        text = names[line.get_color()]
        wide, high = LETTER * font * len(text), HEIGHT * font
        tried = [
            (x + dx, y + dy)
            for x, y in corners[::-1]
            for dx in (OFF, -OFF - wide, -0.5 * wide)
            for dy in (-0.5 * high, OFF, -OFF - high)
        ]
        x, y = min(tried, key=lambda at: _hidden((*at, wide, high), crossed, taken, size))
        taken.append((x, y, wide, high))
        axes.annotate(
            text,
            (x / size[0], y / size[1]),
            xycoords="axes fraction",
            color=line.get_color(),
            fontsize=font,
            va="bottom",
            annotation_clip=False,
        )


def _on_page(axes: Any, line: Any, size: tuple[float, float]) -> NDArray[np.float64]:
    """The corners of a line that are in sight, in points from the panel's lower left: a row each."""
    limits = np.log10([axes.get_xlim(), axes.get_ylim()])
    at = (np.log10(line.get_xydata()) - limits[:, 0]) / (limits[:, 1] - limits[:, 0])
    at[:, 1] = np.clip(at[:, 1], 0.0, 1.0)
    return at * size


def _densely(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    along = np.linspace(0.0, len(corners) - 1.0, 60 * len(corners))
    return np.stack([np.interp(along, np.arange(len(corners)), corners[:, i]) for i in (0, 1)], axis=1)


def _hidden(
    box: tuple[float, float, float, float],
    crossed: NDArray[np.float64],
    taken: list[tuple[float, float, float, float]],
    size: tuple[float, float],
) -> float:
    """How much a name in this box (left, bottom, width, height) would hide: points of curves, names; and how far it is outside."""
    x, y, wide, high = box
    under = np.all((crossed > (x - 1.0, y - 1.0)) & (crossed < (x + wide + 1.0, y + high + 1.0)), axis=1)
    names = sum(abs(x - a) < max(wide, w) and abs(y - b) < max(high, h) for a, b, w, h in taken)
    outside = sum(
        max(-at, at + long - most, 0.0) for at, long, most in zip((x, y), (wide, high), size, strict=True)
    )
    return float(under.sum()) + 1e3 * names + 10.0 * outside
