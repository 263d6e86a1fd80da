"""The axes of a graph: ranges that end at whole ticks, the labels of ticks, and what is drawn on the axes in words."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

from corollary.figure.drawing_sheet import FigureItem, NotDrawable
from corollary.figure.lettering import UNIT_AHEAD, spoken
from corollary.messages import catalogue, in_convention

_ = catalogue(__name__)

WIDE: Final = 400.0
"""Of the area between the axes, in the drawing's units where there is room."""
HIGH: Final = 240.0
TICKS: Final = 6  # about so many steps on an axis that names none
FEWEST: Final = 3.5
MOST_TICKS: Final = 60
SLACK: Final = 1e-9  # of a step: a range that ends at a tick ends there whatever rounding does
READ: Final = 20  # parts of a step that can be read off


@dataclass(frozen=True, slots=True)
class GraphScale:
    """From `low` to `high` in whole steps, in the unit of the axis."""

    low: float
    high: float
    step: float

    @classmethod
    def holding(cls, low: float, high: float, step: float = 0.0) -> GraphScale:
        """The range widened to whole steps; without a step, to steps of 1, 2 or 5. Raises NotDrawable."""
        if low > high:
            raise NotDrawable(
                f"graph: an axis from {low:g} to {high:g} has no length; the first must be less"
            )
        if low == high:
            low, high = min(low, 0.0), max(high, 0.0) or 1.0
        step = step or _fitting(low, high) or _neat((high - low) / TICKS)
        first, last = math.floor(low / step + SLACK), math.ceil(high / step - SLACK)
        if last - first > MOST_TICKS:
            raise NotDrawable(
                f"graph: steps of {step:g} are {last - first} on an axis from {low:g} to {high:g}; {MOST_TICKS} at most"
            )
        return cls(first * step, last * step, step)

    @classmethod
    def exactly(cls, low: float, high: float, step: float = 0.0) -> GraphScale:
        """The range as it is, for a sketch, which has no ticks."""
        widened = cls.holding(low, high, step)
        return cls(low, high, widened.step) if low < high else widened

    @property
    def ticks(self) -> list[float]:
        count = round((self.high - self.low) / self.step)
        return [self.low + k * self.step for k in range(count + 1)]

    @property
    def parts(self) -> int:
        """Into how many parts a step is divided by thin lines, each of which is a round number."""
        first = f"{self.step:.6e}"[0]
        return {"1": 5, "2": 4, "5": 5}.get(first, 2)

    def share(self, value: float) -> float:
        """0 at the low end, 1 at the high one."""
        return (value - self.low) / (self.high - self.low)

    def text(self, value: float, parts: int = 1) -> str:
        """A value as the axis writes it, to a `parts`-th of a step."""
        unit = _neat_below(self.step / parts) if parts > 1 else self.step
        places = next((n for n in range(13) if abs(round(unit, n) - unit) <= 1e-9 * unit), 12)
        written = f"{round(value / unit) * unit + 0.0:.{places}f}"
        if parts > 1 and "." in written:
            written = written.rstrip("0").rstrip(".")
        return in_convention(written.replace("-0", "0") if float(written) == 0 else written.replace("-", "−"))


def _fitting(low: float, high: float) -> float:
    """The neat step of which both ends are whole, nearest to the usual number of steps; 0 where none of a few to a dozen is."""
    power = 10.0 ** math.floor(math.log10(high - low))
    counts = {each * power: (high - low) / (each * power) for each in (0.1, 0.2, 0.5, 1, 2, 5)}
    fitting = [
        step
        for step, count in counts.items()
        if FEWEST <= count <= 2 * TICKS
        and all(abs(end / step - round(end / step)) < SLACK for end in (low, high))
    ]
    return min(fitting, key=lambda step: abs(counts[step] - TICKS), default=0.0)


def _neat(size: float) -> float:
    """The number 1, 2 or 5 times a power of ten that is next above."""
    power = 10.0 ** math.floor(math.log10(size))
    return next(each * power for each in (1, 2, 5, 10) if each * power >= size * (1 - SLACK))


def _neat_below(size: float) -> float:
    power = 10.0 ** math.floor(math.log10(size))
    return next(each * power for each in (5, 2, 1) if each * power <= size * (1 + SLACK))


def axis_title(quantity: str, unit: str) -> str:
    """`t in s`: what an axis shows."""
    if not unit:
        return quantity
    title = _("{quantity} in {unit}", quantity=quantity, unit=unit)
    return f"{title.removesuffix(unit).rstrip()}{UNIT_AHEAD}{unit}"


def graph_in_words(items: Sequence[FigureItem]) -> str:
    """The axes of a panel and the values of what is drawn on them, for those who cannot see it; "" for a panel without a graph."""
    graph = next((item for item in items if item.kind == "graph"), None)
    if graph is None:
        return ""
    x, y = GraphScale(*graph.numbers["x"]), GraphScale(*graph.numbers["y"])
    across, up = (spoken(text).replace(UNIT_AHEAD, " ") for text in graph.texts)
    if "sketch" in graph.flags:
        ranges = _("Sketch of {up} against {across}, without numbers.", up=up, across=across)
        return " ".join([ranges, *_curves_in_words(items, x, y, sketched=True)])
    ranges = _(
        "Graph of {up}, from {y_low} to {y_high}, against {across}, from {x_low} to {x_high}.",
        up=up, across=across, x_low=x.text(x.low, READ), x_high=x.text(x.high, READ),
        y_low=y.text(y.low, READ), y_high=y.text(y.high, READ),
    )  # fmt: skip
    return " ".join([ranges, *_curves_in_words(items, x, y)])


def _curves_in_words(
    items: Iterable[FigureItem], x: GraphScale, y: GraphScale, *, sketched: bool = False
) -> Iterable[str]:
    """`sketched`: in parts of the axes, which say what a curve looks like and no value."""

    def value(scale: GraphScale, number: float) -> str:
        return f"{100 * scale.share(number):.0f} %" if sketched else scale.text(number, READ)

    for item in items:
        if not item.data:
            continue
        points = "; ".join(_("{y} at {x}", x=value(x, across), y=value(y, up)) for across, up in item.data)
        name = " ".join(filter(None, (item.name if item.marked else "", *map(spoken, item.texts))))
        match item.kind:
            case "curve" if item.smooth:
                kind = _("A curve")
            case "curve" | "line":
                kind = _("Straight lines")
            case _:
                kind = _("A point")
        label = f"{kind} ({name})" if name else kind
        yield f"{label}: {points}."
