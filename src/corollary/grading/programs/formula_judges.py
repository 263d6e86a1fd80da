"""Functions and figures judged by a formula: what is off, where, and by how much."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from corollary.derive.statements import (
    Code,
    CurveFormula,
    Doubt,
    Fault,
    FunctionFormula,
    LineFormula,
    Plot,
    Remark,
)
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import Expr
from corollary.grading.programs.convergence import Called, Draw, Given, Inputs, miscounted
from corollary.grading.programs.curves import DrawnCurve, Graph, Numbers
from corollary.grading.programs.panels import Axis, Panel, judge_panels, nothing_more
from corollary.messages import catalogue, in_convention
from corollary.sandbox.job import Axes
from corollary.units.unit import show

_ = catalogue(__name__)

CALLS = 6  # with drawn arguments, besides the corners
NOTHING = 1e-9  # of the largest result: what a zero may be off
SAME = 1e-3  # relative spread of a factor, or of a distance, that is the same everywhere
PLACES = 400
ON_CURVE = 0.02  # of the height: a point that lies on the curve
FEW = 20  # points of a curve
FACTORS = (1e3, 1e-3, 1e6, 1e-6, 100.0, 0.01, 60.0, 1 / 60, 3.6, 1 / 3.6, 180 / math.pi, math.pi / 180)
"""Between units that are confused."""


def inputs_from(code: Code) -> Callable[[Given, Draw], Sequence[Inputs]]:
    """What lists the calls of a part's function."""
    judge = code.judge
    if isinstance(judge, FunctionFormula):
        return lambda given, draw: list(_calls(judge, draw))
    assert code.inputs is not None
    return code.inputs


def code_judge(code: Code) -> Callable[[Given, Sequence[Called]], Fault | Remark | None]:
    judge = code.judge
    if isinstance(judge, FunctionFormula):
        return lambda given, called: judge_function(judge, given, called)
    return judge


def plot_judge(plot: Plot) -> Callable[..., Fault | Doubt | None]:
    judge = plot.judge
    if isinstance(judge, CurveFormula):
        return partial(judge_curve, judge)
    return partial(judge_line, judge) if isinstance(judge, LineFormula) else judge


def _calls(judge: FunctionFormula, draw: Draw) -> Iterator[dict[str, float]]:
    def drawn() -> dict[str, float]:
        found: dict[str, float] = {}
        for each in judge.arguments:
            value = draw(each.low, each.high + (1 if each.whole else 0))
            found[each.name] = math.floor(value) if each.whole else float(f"{value:.4g}")
        return found

    for _place in range(CALLS):
        yield drawn()
    whole = {each.name for each in judge.arguments if each.whole}
    for corner in judge.corners:
        yield drawn() | {name: round(value) if name in whole else value for name, value in corner}


def judge_function(judge: FunctionFormula, given: Given, called: Sequence[Called]) -> Fault | None:
    """Each call returns one number, which is that of the formula; else a usual mistake, or the call that is off most plainly."""
    for each in called:
        if problem := miscounted(each, 1, _("one number")):
            return Fault(problem)
    truths = [_value(judge.formula, {**given, **each.inputs}) for each in called]
    if not all(map(math.isfinite, truths)):
        raise ValueError(
            f"the formula of {judge.name} has no value for some arguments that are drawn; narrow their ranges"
        )
    found = [each.returned[0] for each in called]
    size = max(map(abs, truths))
    off = [
        place
        for place, _value_ in enumerate(found)
        if not _near(found[place], truths[place], judge.within, size)
    ]
    if not off:
        return None
    for formula, text in judge.mistakes:
        wrong = [_value(formula, {**given, **each.inputs}) for each in called]
        if all(_near(mine, other, judge.within, size) for mine, other in zip(found, wrong, strict=True)):
            return Fault(text, known=True)
    if len(set(found)) == 1 and len(set(truths)) > 1:
        return Fault(_("It returns the same for all arguments: {value}.", value=_number(found[0])))
    if all(place >= CALLS for place in off):
        return Fault(_("Right but for a special case: {arguments}.", arguments=_named(called[off[0]].inputs)))
    factor = _common([mine / true for mine, true in zip(found, truths, strict=True) if true])
    if factor is not None and len(truths) > 1:
        if abs(factor + 1) < SAME:
            return Fault(_("Every result has the opposite sign."))
        return Fault(_("Every result is {factor} times what it should be.", factor=_number(factor)))
    each, mine, true = called[off[0]], found[off[0]], truths[off[0]]
    return Fault(
        _(
            "For {arguments} it returns {value}, which is off by {share} %.",
            arguments=_named(each.inputs),
            value=_number(mine),
            share=_number(100 * abs(mine - true) / (abs(true) or size or 1.0)),
        )
    )


def _near(mine: float, true: float, within: float, size: float) -> bool:
    return abs(mine - true) <= max(within * abs(true), NOTHING * size)


def _value(formula: Expr, letters: Mapping[str, Any]) -> float:
    try:
        return float(ready(formula, DOUBLES)({name: float(value) for name, value in letters.items()}))
    except (ArithmeticError, ValueError, TypeError):
        return math.nan


def _values(formula: Expr, letters: Given, letter: str) -> Callable[[Numbers], Numbers]:
    evaluate, others = ready(formula, DOUBLES), dict(letters)

    def one(x: float) -> float:
        try:
            return float(evaluate({**others, letter: x}))
        except (ArithmeticError, ValueError, TypeError):
            return math.nan

    return lambda x: np.asarray([one(float(each)) for each in np.ravel(x)], dtype=float).reshape(np.shape(x))


def _named(inputs: Inputs) -> str:
    return ", ".join(f"{name} = {in_convention(f'{value:.4g}')}" for name, value in inputs.items())


def _number(value: float) -> str:
    return in_convention(f"{value:.3g}")


def _common(ratios: Sequence[float]) -> float | None:
    """What all of them are; None where they differ, or say nothing."""
    if not ratios or not all(map(math.isfinite, ratios)):
        return None
    middle = sorted(ratios)[len(ratios) // 2]
    alike = middle and all(abs(each - middle) <= SAME * abs(middle) for each in ratios)
    return middle if alike and abs(middle - 1) > SAME else None


def _on_axis(value: float, axis: Axis) -> str:
    """A value in SI as it is read on an axis."""
    unit = show(axis.unit)
    return _number(value / axis.unit.si) + (f" {unit}" if unit else "")


def _panel(
    labels: tuple[str, str], asked: tuple[Graph, ...], missing: Callable[[Sequence[DrawnCurve]], Fault | None]
) -> Panel:
    x, y = labels
    what = _("{y} against {x}", y=_quantity(y), x=_quantity(x))
    return Panel(what, Axis(x), Axis(y), asked, missing)


def _quantity(label: str) -> str:
    """A label without its unit."""
    return label.partition("[")[0].partition("(")[0].strip() or label


def judge_curve(judge: CurveFormula, given: Given, axes: Sequence[Axes]) -> Fault | Doubt | None:
    """The curve along its whole length, in the units that the labels name."""
    span = _value(judge.ends[0], given), _value(judge.ends[1], given)
    places = np.linspace(*span, PLACES)

    def graph(formula: Expr) -> Graph:
        at = _values(formula, given, judge.letter)
        height = at(places)
        size = float(np.ptp(height)) or float(np.max(np.abs(height))) or 1.0
        return Graph(_quantity(judge.labels[1]), at, span, (span[1] - span[0], size))

    asked = graph(judge.formula)
    if not np.isfinite(asked.at(places)).all():
        raise ValueError("the formula of the curve has no value at some places of its range; narrow it")
    own = _panel(judge.labels, (asked,), nothing_more)

    def missing(drawn: Sequence[DrawnCurve]) -> Fault | None:
        for formula, text in judge.mistakes:
            wrong = replace(graph(formula), scales=asked.scales)
            if any(wrong.fits(each) for each in drawn):
                return Fault(text, known=True)
        curves = sorted(drawn, key=lambda each: (each.straight, -len(each.x)))
        return _difference(asked, curves[0], own) if curves else None

    return judge_panels([replace(own, missing=missing)], axes)


def _difference(asked: Graph, curve: DrawnCurve, panel: Panel) -> Fault:
    """What is off, in words."""
    low, high = asked.span
    width, height = asked.scales
    seen = np.isfinite(curve.x) & np.isfinite(curve.y)
    lost, x, y = int((~seen).sum()), curve.x[seen], curve.y[seen]
    true = asked.at(x)
    inside = np.isfinite(true)
    x, y, true = x[inside], y[inside], true[inside]
    if not len(x):
        return Fault(_("No point of your curve lies where the quantity is defined."))
    off = y - true
    on_curve = bool((np.abs(off) <= ON_CURVE * height).all())
    if lost and on_curve:
        return Fault(_("{count} points of your curve are no numbers (NaN or infinite).", count=lost))
    if on_curve and (x.min() > low + 0.05 * width or x.max() < high - 0.05 * width):
        return Fault(
            _(
                "Your curve is right where it is drawn, from {from_} to {to}. Draw it from {low} to {high}.",
                from_=_on_axis(float(x.min()), panel.x),
                to=_on_axis(float(x.max()), panel.x),
                low=_on_axis(low, panel.x),
                high=_on_axis(high, panel.x),
            )
        )
    if on_curve and len(x) < FEW:
        return Fault(
            _("Your points are right, but {count} are too few for the whole curve. Draw more.", count=len(x))
        )
    if np.ptp(y) <= 1e-9 * max(abs(float(y.max())), 1e-300) and float(np.ptp(true)) > ON_CURVE * height:
        return Fault(
            _("Your curve is constant: it is {value} everywhere.", value=_on_axis(float(y[0]), panel.y))
        )
    turned = asked.at(y)
    if len(x) > 2 and np.isfinite(turned).all() and bool((np.abs(turned - x) <= ON_CURVE * height).all()):
        return Fault(_("The quantities of the two axes have changed places."))
    large = np.abs(true) > 0.05 * float(np.abs(true).max())
    factor = _common([float(each) for each in y[large] / true[large]]) if len(x) > 2 else None
    if factor is not None:
        return Fault(
            _(
                "Your curve is {factor} times as high as it should be everywhere. Do the numbers have the unit of the label?",
                factor=_number(factor),
            )
        )
    for each in FACTORS:
        if len(x) > 2 and bool((np.abs(asked.at(x * each) - y) <= ON_CURVE * height).all()):
            return Fault(_("Along the horizontal axis the numbers do not have the unit of the label."))
    if len(x) > 2 and float(np.ptp(off)) <= ON_CURVE * height:
        distance = _on_axis(abs(float(off.mean())), panel.y)
        if off.mean() > 0:
            return Fault(_("Your curve lies {distance} too high everywhere.", distance=distance))
        return Fault(_("Your curve lies {distance} too low everywhere.", distance=distance))
    if (shift := _shift(asked, x, y)) is not None:
        distance = _on_axis(abs(shift), panel.x)
        return Fault(_("Your curve is shifted along the horizontal axis by {distance}.", distance=distance))
    worst = int(np.argmax(np.abs(off)))
    return Fault(
        _(
            "At {x} your curve is at {y}, which is off by {distance}.",
            x=_on_axis(float(x[worst]), panel.x),
            y=_on_axis(float(y[worst]), panel.y),
            distance=_on_axis(abs(float(off[worst])), panel.y),
        )
    )


def _shift(asked: Graph, x: Numbers, y: Numbers) -> float | None:
    """How far to the right the curve lies; None where it is not that alone."""
    width, height = asked.scales
    apart = {
        shift: float(np.abs(asked.at(x - shift) - y).max())
        for shift in map(float, np.linspace(-1, 1, 201) * width)
    }
    best = min(apart, key=lambda shift: apart[shift] if math.isfinite(apart[shift]) else math.inf)
    return best if len(x) > 2 and apart[best] <= ON_CURVE * height else None


def judge_line(judge: LineFormula, given: Given, axes: Sequence[Axes]) -> Fault | Doubt | None:
    """A straight line through the student's points, by its slope and its intercept; the points may be anywhere."""
    panel = _panel(judge.labels, (), nothing_more)
    intercept = None if judge.intercept is None else _value(judge.intercept, given)
    line = FittedLine(panel.what, _value(judge.slope, given), intercept, judge.within, panel.y)

    def missing(drawn: Sequence[DrawnCurve]) -> Fault | None:
        joined = [each for each in drawn if each.joined]
        return line.fault(joined[0]) if joined else Fault(_("Draw the line through your points, too."))

    return judge_panels([replace(panel, asked=(line,), missing=missing, helps=_any)], axes)


def _any(curve: DrawnCurve) -> bool:
    return True


@dataclass(frozen=True, slots=True)
class FittedLine:
    """The line asked for; `within` is relative, of the intercept to the height of what is drawn."""

    name: str
    slope: float
    intercept: float | None
    within: float
    axis: Axis

    def fits(self, curve: DrawnCurve) -> bool:
        return curve.joined and self.fault(curve) is None

    def fault(self, curve: DrawnCurve) -> Fault | None:
        """Why a drawn line is another; None where it is not."""
        seen = np.isfinite(curve.x) & np.isfinite(curve.y)
        x, y = curve.x[seen], curve.y[seen]
        if len(x) < 2 or not float(np.ptp(x)):
            return Fault(_("A line has two points at least, one beside the other."))
        middle = float(x.mean())
        slope, at_middle = (float(each) for each in np.polyfit(x - middle, y, 1))
        height = float(np.abs(y).max()) or 1.0
        if float(np.abs(y - (slope * (x - middle) + at_middle)).max()) > ON_CURVE * height:
            return Fault(_("What is drawn is no straight line."))
        if abs(slope - self.slope) > self.within * abs(self.slope):
            share = _number(100 * abs(slope / self.slope - 1) if self.slope else 100.0)
            return Fault(_("The slope of your line is off by {share} %.", share=share))
        start = at_middle - slope * middle
        if self.intercept is not None and abs(start - self.intercept) > self.within * height:
            return Fault(
                _(
                    "Your line meets the vertical axis at {value}, which is not right.",
                    value=_on_axis(start, self.axis),
                )
            )
        return None
