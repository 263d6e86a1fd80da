"""Figures of a ball on the floor: net force and momentum against time."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from corollary.derive.statements import Fault
from corollary.grading.programs.called import Given
from corollary.grading.programs.floor import ARGUMENTS, reference

OF_PLOT = 0.03


def judge_bounce_plot(given: Given, figures: Sequence[Any]) -> Fault | None:
    """Net force and momentum against time, each with labelled axes, from before the contact till after it."""
    m, g = given["m"], given["g"]
    truth = reference(*(given[name] for name in ARGUMENTS))
    weight, momentum = m * g, m * truth.velocity
    off, odd = OF_PLOT * truth.force, OF_PLOT * momentum
    force = _curve(figures, lambda y: abs(max(y) - truth.force) <= off and abs(min(y) + weight) <= off)
    if force is None:
        return Fault(
            "There is no curve of the net force for your numbers: from -m g to the largest net force, and back."
        )
    if abs(force[1][-1] + weight) > off or abs(force[1][0] + weight) > off:
        return Fault(
            "The curve of the net force must begin before the ball touches the floor and end after it has left it."
        )
    if abs(force[1][0] + weight) > 0.2 * weight:
        return Fault(
            "At the start only gravity acts, and the net force is -m g; you drew the force of the floor.",
            known=True,
        )
    path = _curve(figures, lambda y: abs(min(y) + momentum) <= odd and abs(max(y) - momentum) <= odd)
    if path is None:
        return Fault(
            "There is no curve of the momentum p(t) for your numbers: from m v at the first touch to the opposite value."
        )
    for (axes, _), name, words in ((force, "F [N]", "f force kraft"), (path, "p [kg m/s]", "p momentum")):
        if not _named(axes.xlabel, "t time zeit tid s"):
            return Fault("The x axis needs a label that names the quantity and its unit: t [s].")
        if not _named(axes.ylabel, words):
            return Fault(f"The y axis needs a label that names the quantity and its unit: {name}.")
    return None


def _curve(
    figures: Sequence[Any], fits: Callable[[Sequence[float]], bool]
) -> tuple[Any, Sequence[float]] | None:
    """The first curve of many points whose heights fit, with its axes."""
    for axes in figures:
        for line in axes.lines:
            if (
                line.kind in {"line", "points"}
                and len(line.y) > 20
                and all(map(math.isfinite, line.y))
                and fits(line.y)
            ):
                return axes, line.y
    return None


def _named(label: str, words: str) -> bool:
    return any(word in label.lower() for word in words.split())
