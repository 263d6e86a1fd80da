"""Figures of an atom near a molecule: the potential with levels of energy, and a trajectory in the plane."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from corollary.derive.statements import Fault
from corollary.scenes.catalogue import run

NEAR = 0.04  # of the depth of the well: a sketch is judged, not a measurement


def judge_potential_plot(given: Mapping[str, float], figures: Sequence[Any]) -> Fault | None:
    """The bottom at b, a quarter of the depth half-way, the flat top beyond b + d, and a level line for either energy."""
    b, d, depth = given["b"], given["d"], given["k"] * given["d"] ** 2 / 2
    axes = next((each for each in figures if each.lines), None)
    if axes is None:
        return Fault(
            "No axes with a curve were found; plot the potential energy against the place of the atom."
        )
    named = {axes.xlabel.lower(): ("x", "r", "m]"), axes.ylabel.lower(): ("u", "energy", "j]")}
    if not all(any(word in label for word in words) for label, words in named.items()):
        return Fault("The axes need labels that name quantity and unit: x [m] and U [J].")
    curves = [line for line in axes.lines if line.kind == "line" and len(line.x) > 20]
    if not curves:
        return Fault("The potential must be drawn as a curve of more than 20 points.")
    if not any(
        _reads(line, {b: 0.0, b - d / 2: depth / 4, b + d / 2: depth / 4, b + 1.2 * d: depth}, depth)
        for line in curves
    ):
        return Fault(
            "No curve is this potential: it must have its bottom at x = b, rise to U0 at b + d on the right "
            "and on the left too, and stay at U0 beyond b + d."
        )
    for name, level in (("below", given["eps"] * depth), ("above", given["epsx"] * depth)):
        if not any(_level(line, level, NEAR * level) for line in axes.lines):
            return Fault(
                f"The level line of the total energy {name} U0 is missing; draw E as a horizontal line at the "
                f"energy asked for."
            )
    return None


def judge_orbit_plot(given: Mapping[str, float], figures: Sequence[Any]) -> Fault | None:
    """A curve from (b, 0) that swings between r = b and the far turning point, at least once."""
    b = given["b"]
    settings = {name: given[name] for name in ("m", "k", "b", "d", "v0")}
    far = run("atom", settings | {"r0": b}, tolerance=1e-9).observed["turning_points"]
    assert isinstance(far, tuple)
    for axes in figures:
        for line in axes.lines:
            if len(line.x) < 50:
                continue
            if [label.strip(" $").lower()[:1] for label in (axes.xlabel, axes.ylabel)] != ["x", "y"]:
                return Fault("The axes need labels that name quantity and unit: x [m] and y [m].")
            r = np.hypot(line.x, line.y)
            if math.dist((line.x[0], line.y[0]), (b, 0.0)) > 0.02 * b:
                return Fault("The trajectory must start at (b, 0).")
            if r.min() < 0.98 * b:
                return Fault(
                    "The atom comes closer than b. It starts across the radius, and the force at r > b is not "
                    "strong enough to pull it in further: check force and step."
                )
            if abs(r.max() - far[-1]) > 0.02 * b:
                return Fault(
                    "The greatest distance of your trajectory is not that of (h1). Let it run for some "
                    "swings, and check v0, force and step."
                )
            return None
    return Fault("No trajectory was found; plot y against x, as a curve of many points.")


def _reads(line: Any, wanted: Mapping[float, float], scale: float) -> bool:
    """Whether the curve passes through the points, between its own points interpolated."""
    order = np.argsort(line.x, kind="stable")
    x, y = np.asarray(line.x)[order], np.asarray(line.y)[order]
    known = np.isfinite(x) & np.isfinite(y)
    x, y = x[known], y[known]
    return bool(len(x)) and all(
        x[0] <= place <= x[-1] and abs(float(np.interp(place, x, y)) - value) <= NEAR * scale
        for place, value in wanted.items()
    )


def _level(line: Any, level: float, allowed: float) -> bool:
    return len(line.y) >= 2 and all(abs(y - level) <= allowed for y in line.y)
