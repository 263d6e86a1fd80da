"""Figures of two spheres that collide in a plane: their trajectories, and both components of their momenta against time."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

from corollary.derive.statements import Fault
from corollary.grading.programs.spheres import sphere_force
from corollary.grading.programs.two_bodies import stepped

TIME, STEP = 0.10, 1e-4
START = {"rA": (0.0, 0.0), "vA": (1.0, 0.0), "rB": (0.08, 0.018), "vB": (0.0, 0.0), "T": TIME, "dt": STEP}
NEAR = 0.03  # of A's momentum at the start: curves are read off as drawn, steps of the student's own choice included
AXES = {"the trajectories": (r"^x", r"^y"), "p_x": (r"^t", r"px|^p.*x"), "p_y": (r"^t", r"py|^p.*y")}


def judge_spheres_plot(given: Mapping[str, float], figures: Sequence[Any]) -> Fault | None:
    """Three pairs of axes, told by their labels; in each a curve for A and one for B with the right ends."""
    inputs = {**START, "mA": given["mA"], "mB": given["mB"]}
    au, aw, bu, bw = stepped(
        inputs, sphere_force(given["R"], given["k"], given["eta"]), steps=8 * round(TIME / STEP)
    )
    start = given["mA"] * START["vA"][0]
    for what, labels in AXES.items():
        axes = next((each for each in figures if _labelled(each, labels)), None)
        if axes is None:
            return Fault(
                f"No axes for {what} were found. Label them with quantity and unit: x [m] and y [m], t [s] "
                f"and p_x [kg m/s], t [s] and p_y [kg m/s]."
            )
        curves = [line for line in axes.lines if line.kind != "bars" and len(line.x) > 20]
        if len(curves) < 2:
            return Fault(f"In the axes for {what} there must be a curve for A and one for B.")
        match what:
            case "the trajectories":
                wanted = {START["rA"], START["rB"]}
                met = all(
                    any(math.dist((line.x[0], line.y[0]), place) < 0.002 for line in curves)
                    for place in wanted
                )
                if not met:
                    return Fault("The trajectories must start at (0, 0) for A and at (0.08, 0.018) m for B.")
            case _:
                ends = (
                    (given["mA"] * au, given["mB"] * bu)
                    if what == "p_x"
                    else (given["mA"] * aw, given["mB"] * bw)
                )
                begins = (start, 0.0) if what == "p_x" else (0.0, 0.0)
                if max(line.x[-1] for line in curves) < 0.9 * TIME:
                    return Fault(f"The curves of {what} must run until {TIME:g} s.")
                if not _pairs(curves, 0, begins, start):
                    return Fault(
                        f"The curves of {what} must start with A's momentum (A moves along x at 1.0 m/s) and "
                        f"with B at rest. Mind that it is momenta that are asked for."
                    )
                if not _pairs(curves, -1, ends, start):
                    return Fault(
                        f"The curves of {what} do not end where this model leads. Check the force law, its "
                        f"signs and the numbers."
                    )
    return None


def _labelled(axes: Any, labels: tuple[str, str]) -> bool:
    """Whether the labels begin as wanted, whatever TeX, spaces and underscores they hold."""
    texts = [re.sub(r"\\mathrm|[^a-z]", "", text.lower()) for text in (axes.xlabel, axes.ylabel)]
    return all(re.search(label, text) for label, text in zip(labels, texts, strict=True))


def _pairs(curves: Sequence[Any], place: int, wanted: tuple[float, float], scale: float) -> bool:
    """Whether each wanted value is met by a curve of its own at this place."""
    values = [line.y[place] for line in curves]
    orders = ((i, j) for i in range(len(values)) for j in range(len(values)) if i != j)
    return any(max(abs(values[i] - wanted[0]), abs(values[j] - wanted[1])) <= NEAR * scale for i, j in orders)
