"""Condition of a ready scene's values: runs with each setting moved a little, and what is near an edge."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from corollary.scenes.definition import Setting, Settings
from corollary.scenes.progress import part
from corollary.scenes.run import ILL, BadSetting, GuardFailed, Observed, Run, components

MOVED = 1e-7  # as a share of a setting: small, and still far above what rounding does to values
# Evaluations of forces in all: where runs with one setting moved after the other cost more, all are moved together, in one. The clock does
# not decide it, for on a machine that is busy the same scene would get another condition.
DEAR = 12_000
APART = 0.618  # the golden ratio: its multiples leave parts of one that are all different
DIGITS = 15.95  # of a double


def with_conditions(found: Run, settings: Sequence[Setting], again: Callable[[Settings], Run]) -> Run:
    """The same run of a scene with these settings, which runs `again` with others; each value with its condition, and warnings where it is large or another outcome is near.

    The condition of a value is the largest of its relative changes over the change of one setting: with settings rounded to sixteen
    digits, so many of the value's are lost as it has.
    """
    most: dict[str, float] = {}
    warnings: list[str] = []
    for name, other in _moved(found, settings, again):
        if other.outcome != found.outcome:
            warnings.append(
                f"{name} lies at an edge: changed by {MOVED:g} of itself it makes {other.outcome!r} of {found.outcome!r}."
            )
            continue
        for value in found.measured.keys() & other.measured.keys():
            most[value] = max(most.get(value, 0.0), _change(found, other, value) / MOVED)
    measured = {
        name: replace(each, condition=max(each.condition or 0.0, most[name])) if name in most else each
        for name, each in found.measured.items()
    }
    for name, condition in most.items():
        if condition > ILL:
            digits = math.floor(max(0.0, DIGITS - math.log10(condition)))
            warnings.append(
                f"{name} changes {condition:.0e} times as much as the settings (a grazing hit, contacts that all but coincide, or chaos): "
                f"settings with sixteen digits give it no more than {digits}."
            )
    return replace(found, measured=measured, warnings=(*found.warnings, *warnings))


def _moved(
    found: Run, settings: Sequence[Setting], again: Callable[[Settings], Run]
) -> Iterator[tuple[str, Run]]:
    """Runs with settings moved, each for itself or all at once: where that is refused or makes another outcome, one half and the other.

    Downward, so that a coefficient of restitution of one stays below its end, and upward where that is refused. What is moved at once,
    settings or the numbers of one, goes each by a part of its own, for ratios are to change, too.
    """
    names = [each.name for each in settings if not each.whole and any(components(found.settings[each.name]))]
    at_once = found.evaluations * len(names) > DEAR
    parts = {name: _part(i) if at_once else 1.0 for i, name in enumerate(names)}
    groups = [names] if at_once else [[name] for name in names]
    reached, done = 0.0, 0
    while groups:
        group, other = groups.pop(0), None
        for way in (-MOVED, MOVED):
            begin, reached = reached, 0.5 * (reached + (done + len(group)) / len(names))
            moved = {name: _changed(found.settings[name], way * parts[name]) for name in group}
            with suppress(BadSetting, GuardFailed), part(begin, reached):
                other = again({**found.settings, **moved})
                break
        if len(group) > 1 and (other is None or other.outcome != found.outcome):
            half = (len(group) + 1) // 2
            groups[:0] = group[:half], group[half:]
            continue
        done += len(group)
        if other is not None:
            yield group[0], other


def _changed(value: Observed, share: float) -> Observed:
    """The same, a share more; of numbers in a row the first, and of the others each a part of it, by turns less and more."""
    if isinstance(value, tuple):
        return tuple(x * (1.0 + share * _part(i) * (-1) ** i) for i, x in enumerate(value))
    return value * (1.0 + share)


def _part(i: int) -> float:
    return 1.0 - APART * i % 1.0


def _change(found: Run, other: Run, name: str) -> float:
    """The largest change of a component in units of the value's size."""
    here, there = components(found.observed[name]), components(other.observed[name])
    if len(here) != len(there):
        return 0.0
    size = max(found.measured[name].size, *map(abs, (*here, 0.0, 0.0)))
    return max((abs(x - y) for x, y in zip(here, there, strict=True)), default=0.0) / size if size else 0.0
