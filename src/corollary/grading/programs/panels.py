"""Figures judged pair of axes by pair of axes: what is asked for in each, its labels and units, and that nothing else is drawn."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from corollary.derive.statements import Doubt, Fault
from corollary.grading.programs.curves import Asked, DrawnCurve, HasMiddle, curves
from corollary.messages import catalogue
from corollary.sandbox.job import Axes
from corollary.units.dimension import Dimension, Unit
from corollary.units.unit import read_unit

_ = catalogue(__name__)

FONTS = r"\\(?:math(?:rm|it|bf|sf)|text(?:rm|it|bf|normal)?|mbox|operatorname)\s*\{((?:[^{}]|\{[^{}]*\})*)\}"
NESTED = (
    (re.compile(FONTS), r"\1 "),
    (re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}"), r"\1/(\2)"),
)
TEX = (
    (re.compile(r"\\(?:rm|it|left|right|displaystyle)\b"), ""),
    (re.compile(r"\\(?:cdot|times|ast)\b"), "*"),
    (re.compile(r"\\mu\b"), "u"),
    (re.compile(r"\\[,;:! ]|~"), " "),
    (re.compile(r"\\([A-Za-z]+)"), r" \1 "),
    (re.compile(r"[${}]|\\"), ""),
)
BRACKETS = re.compile(r"\[([^\[\]]+)\]|\(((?:[^()]|\([^()]*\))+)\)")
LED_IN = re.compile(r"\bin\s+|[,;:]")  # `time in ms`, `Zeit, ms`
METRES = re.compile(r"\bms(\s?\^?\s?[-⁻][12¹²])")  # no millisecond on an axis is raised to -1
LONGEST = 200
MOST_ENDS = 6  # brackets, or places after which a unit may stand


@dataclass(frozen=True, slots=True)
class Label:
    """What a label names: its letters and words without the unit, in small letters, and the units it may name, likeliest first.

    A unit in brackets is the only one. Without them a last letter may be a unit or a name (`time t`, `F/N`).
    """

    name: str
    units: tuple[Unit, ...]

    def unit(self, dimension: Dimension) -> Unit | None:
        """Its unit, when it may be one of this dimension."""
        return next((unit for unit in self.units if unit.dimension == dimension), None)


def read_label(text: str) -> Label:
    """The label of an axis as typed: a bracket decides; else what stands below a slash, after `in` or a comma, or at the end."""
    text = _without_tex(text[:LONGEST])
    for name, inside in _bracketed(text):
        if (found := _unit(inside.removeprefix("in "))) is not None:
            return Label(name, (found,))
    words = text.split()
    ends = [
        text.partition("/")[2],
        *(text[lead.end() :] for lead in list(LED_IN.finditer(text))[-MOST_ENDS:]),
    ]
    ends += [" ".join(words[-count:]) for count in range(min(4, len(words)), 0, -1)]
    units = [found for end in ends if (found := _unit(_bare(end))) is not None]
    name = text.partition("/")[0] if units and "/" in text else text
    return Label(_name(name), tuple(dict.fromkeys(units)))


def _bracketed(text: str) -> Iterator[tuple[str, str]]:
    """Each bracket from the last one on, with what stands around it."""
    for found in reversed(list(BRACKETS.finditer(text))[-MOST_ENDS:]):
        yield _name(text[: found.start()] + " " + text[found.end() :]), found[1] or found[2]


def _without_tex(text: str) -> str:
    for _ in range(3):  # fractions and fonts stand in each other
        for pattern, by in NESTED:
            text = pattern.sub(by, text)
    for pattern, by in TEX:
        text = pattern.sub(by, text)
    return " ".join(text.split())


def _bare(text: str) -> str:
    text = text.strip()
    return text[1:-1] if text[:1] == "(" and text[-1:] == ")" else text


def _unit(text: str) -> Unit | None:
    text = text.strip()
    found = read_unit(METRES.sub(r"m s\1", text)) if text else None
    return found if isinstance(found, Unit) else None


def _name(text: str) -> str:
    """Letters and words in small letters; `p_x`, `p_{x}` and `p x` are the same."""
    return " ".join(re.sub(r"[^\w]|_", " ", text.lower()).split())


MOST_AXES = 20  # looked at
MOST_CURVES = (
    12  # in one pair of axes: what is asked for, some help for the eye, and what a person may want to look at
)
MOST_IN_ALL = 30
FOR_A_PERSON = 3  # so many curves beside those asked for may have a reason; more are a guess


@dataclass(frozen=True, slots=True)
class Axis:
    """What an axis shows: its label with its SI unit (`F [N]`), and a pattern of names that would say it is another quantity."""

    label: str
    others: str = "$^"

    @property
    def unit(self) -> Unit:
        return read_label(self.label).units[0]

    def named_by(self, label: Label) -> bool:
        return label.unit(self.unit.dimension) is not None and not re.search(self.others, label.name)


def nothing_more(curves: Sequence[DrawnCurve]) -> Fault | None:
    """What is said of curves that are not those asked for, when nothing more is known of them."""
    return None


def straight(curve: DrawnCurve) -> bool:
    """Whether it helps the eye: an axis, a level, a marked point."""
    return curve.straight


@dataclass(frozen=True, slots=True)
class Panel:
    """One pair of axes, or several that share their quantities: `what` it shows in words, its quantities, the curves asked for.

    `missing` says more of the curves (in SI) when those asked for are not among them; `helps` tells curves that may stand beside
    them; `any_origin`: x may be counted from anywhere, as a time may.
    """

    what: str
    x: Axis
    y: Axis
    asked: tuple[Asked, ...]
    missing: Callable[[Sequence[DrawnCurve]], Fault | None] = nothing_more
    helps: Callable[[DrawnCurve], bool] = straight
    any_origin: bool = False


@dataclass(frozen=True, slots=True)
class _Seen:
    """One pair of axes as read once for all panels: its labels, and its curves in the numbers drawn."""

    x: Label
    y: Label
    curves: list[DrawnCurve]

    def in_units(self, x: Unit, y: Unit) -> list[DrawnCurve]:
        return [curve.in_units(x.si, y.si) for curve in self.curves]


@dataclass(frozen=True, slots=True)
class _Found:
    """The curves of one pair of axes as one panel's: which of those asked for are not there, and which curves are none of them."""

    curves: list[DrawnCurve]
    missing: tuple[Asked, ...]
    others: frozenset[int]


def judge_panels(panels: Sequence[Panel], figures: Sequence[Axes]) -> Fault | Doubt | None:
    """Each panel must be there, with labels that name its quantities and units; curves that were not asked for go to a person."""
    seen = [axes for axes in figures if axes.lines][:MOST_AXES]
    if (
        any(len(axes.lines) > MOST_CURVES for axes in seen)
        or sum(len(axes.lines) for axes in seen) > MOST_IN_ALL
    ):
        return Fault(_("There are too many curves to tell apart. Draw only the curves asked for."))
    read = [_Seen(read_label(axes.xlabel), read_label(axes.ylabel), curves(axes.lines)) for axes in seen]
    compared = [[_found(panel, axes) for axes in read] for panel in panels]
    for panel, of_axes in zip(panels, compared, strict=True):
        labelled = [(axes, found) for axes, found in zip(read, of_axes, strict=True) if found is not None]
        right = [axes for axes, found in labelled if not found.missing] or _spread(panel, read)
        if not right:
            return _unlabelled(panel, read) or _incomplete(panel, [found for _axes, found in labelled])
        if fault := _wrong_name(panel, right):
            return fault
    others = 0
    for of_panels in zip(*compared, strict=True):
        found = [each.others for each in of_panels if each is not None]
        others += sum(all(place in each for each in found) for place in found[0]) if found else 0
    return _beside(others)


def _beside(others: int) -> Fault | Doubt | None:
    if not others:
        return None
    if others > FOR_A_PERSON:
        return Fault(
            _(
                "There are many other curves ({others}) besides those asked for. Draw only the curves asked for.",
                others=others,
            )
        )
    return Doubt(
        _(
            "The curves asked for are there, but others, too, so your teacher will mark it. (Not asked for: {others}.)",
            others=others,
        )
    )


def _found(panel: Panel, axes: _Seen) -> _Found | None:
    """The panel's curves in these axes, in the units that their labels name; None when the labels name other quantities."""
    x, y = axes.x.unit(panel.x.unit.dimension), axes.y.unit(panel.y.unit.dimension)
    return None if x is None or y is None else _compared(panel, axes.in_units(x, y))


def _spread(panel: Panel, read: Sequence[_Seen]) -> list[_Seen]:
    """Axes that hold the curves asked for together, as when each ball has its own below the other's; x counts from one origin."""
    holding: list[_Seen] = []
    drawn: list[DrawnCurve] = []
    for axes in read:
        x, y = axes.x.unit(panel.x.unit.dimension), axes.y.unit(panel.y.unit.dimension)
        if x is not None and y is not None:
            holding.append(axes)
            drawn.extend(axes.in_units(x, y))
    return holding if len(panel.asked) > 1 and not _compared(panel, drawn).missing else []


def _compared(panel: Panel, drawn: list[DrawnCurve]) -> _Found:
    """With x counted from where most of the curves asked for are found."""
    best = _Found(drawn, panel.asked, frozenset(range(len(drawn))))
    for shift in _shifts(panel, drawn):
        fitting = [{asked.name for asked in panel.asked if asked.fits(each.moved(shift))} for each in drawn]
        there = set[str]().union(*fitting)
        missing = tuple(asked for asked in panel.asked if asked.name not in there)
        others = frozenset(
            place
            for place, (curve, names) in enumerate(zip(drawn, fitting, strict=True))
            if not names and not panel.helps(curve)
        )
        best = min(best, _Found(drawn, missing, others), key=lambda found: len(found.missing))
        if not missing:
            break
    return best


def _shifts(panel: Panel, drawn: Sequence[DrawnCurve]) -> Iterator[float]:
    """None first; then those that bring the middle of the first curve onto that of each one asked for."""
    yield 0.0
    if not panel.any_origin:
        return
    first = next((curve for curve in drawn if not curve.straight), None)
    here = first.middle_of_change() if first is not None else None
    for asked in panel.asked:
        there = asked.middle() if isinstance(asked, HasMiddle) else None
        if here is not None and there is not None:
            yield here - there


def _unlabelled(panel: Panel, seen: Sequence[_Seen]) -> Fault | None:
    """The curves are there when the labels are left aside: then it is these that are missing, or name the wrong unit."""
    for axes in seen:
        if not _compared(panel, axes.curves).missing:
            return Fault(
                _(
                    "The curves of {what} are there, but the axes are not labelled so. Label each axis with its "
                    "quantity and unit, and plot the numbers in that unit: for example {x} and {y}.",
                    what=panel.what,
                    x=panel.x.label,
                    y=panel.y.label,
                )
            )
    return None


def _wrong_name(panel: Panel, right: Sequence[_Seen]) -> Fault | None:
    """When each of these axes is labelled as another quantity of the same unit."""
    for quantity, labels in ((panel.x, [a.x for a in right]), (panel.y, [a.y for a in right])):
        if not any(quantity.named_by(label) for label in labels):
            return Fault(
                _(
                    "The axis of {what} is labelled as another quantity: write {label}.",
                    what=panel.what,
                    label=quantity.label,
                )
            )
    return None


def _incomplete(panel: Panel, labelled: Sequence[_Found]) -> Fault:
    if not labelled:
        return Fault(
            _(
                "No axes were found that show {what}. Label them with quantity and unit, for example {x} and {y}.",
                what=panel.what,
                x=panel.x.label,
                y=panel.y.label,
            )
        )
    best = min(labelled, key=lambda found: len(found.missing))
    if (fault := panel.missing(best.curves)) is not None:
        return fault
    return Fault(
        _(
            "The curve of {name} does not match your numbers along its whole length.",
            name=best.missing[0].name,
        )
    )
