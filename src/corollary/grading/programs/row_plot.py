"""Figures of a row of balls: their velocities against time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from corollary.derive.statements import Fault
from corollary.grading.programs.called import Given


def judge_velocity_plot(given: Given, figures: Sequence[Any], balls: int) -> Fault | None:
    """Velocities against time: a curve for each ball, from (v0, 0, …) to where only the last one moves, with labelled axes."""
    v0 = given["v0"]
    for axes in figures:
        curves = [line for line in axes.lines if line.kind in {"line", "points"} and len(line.x) > 10]
        if len(curves) < balls:
            continue
        if missing := [name for name, label, words in (("x", axes.xlabel, "t time zeit tid s"), ("y", axes.ylabel, "v velocity m/s"))
                       if not any(word in label.lower() for word in words.split())]:  # fmt: skip
            return Fault(
                f"The {' and '.join(missing)} axis needs a label that names the quantity and its unit: t [s], v [m/s]."
            )
        starts, ends = sorted(line.y[0] for line in curves[:balls]), [line.y[-1] for line in curves[:balls]]
        if not _near(starts, [0.0] * (balls - 1) + [v0], v0, 0.03):
            return Fault(
                f"The curves must start with one ball at v0 = {v0:g} m/s and the other{'s' if balls > 2 else ''} at rest."
            )
        if not _near(sorted(ends), [0.0] * (balls - 1) + [v0], v0, 0.06):
            return Fault(
                "The curves must run until the balls have parted; then only the last ball moves with v0."
            )
        return None
    return Fault(
        f"No axes with a curve for each of the {balls} balls were found; plot every velocity against time."
    )


def _near(values: Sequence[float], others: Sequence[float], scale: float, tolerance: float) -> bool:
    return len(values) == len(others) and math.dist(values, others) <= tolerance * scale
