"""Figures of a row of balls: the velocity of each against time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from judge_cradle import pushed

from corollary.programs import (
    RK4,
    Axes,
    Axis,
    Called,
    Doubt,
    DrawnCurve,
    Fault,
    Given,
    Graph,
    Numbers,
    Panel,
    catalogue,
    contact_time,
    in_convention,
    judge_panels,
    march,
    run,
)

_ = catalogue(__file__)

TIME = Axis("t [s]")
VELOCITY = Axis("v [m/s]", r"\b[pfx]\b|moment|impuls|force|kraft")
STEPS = 300  # in a contact
STEEPEST = 10.0  # exponents of a contact


def judge_two_balls(given: Given, figures: Sequence[Axes]) -> Fault | Doubt | None:
    """The curves of two balls."""
    return judge_velocity_plot(given, figures, balls=2)


def judge_three_balls(
    given: Given, figures: Sequence[Axes], called: Sequence[Called]
) -> Fault | Doubt | None:
    """The curves of three balls, for the (k, q) that was returned."""
    return judge_velocity_plot(given, figures, balls=3, called=called)


def judge_velocity_plot(
    given: Given, figures: Sequence[Axes], balls: int, called: Sequence[Called] | None = None
) -> Fault | Doubt | None:
    """A curve for each ball, from the first touch until they have parted; with `called` for the (k, q) that was returned."""
    k, q, v0 = given["k"], 1.0, given["v0"]
    if called is not None and any(axes.lines for axes in figures):
        pair = called[0].returned if called else ()
        if len(pair) != 2 or not (0 < pair[0] < math.inf and 1 <= pair[1] <= STEEPEST):
            return Doubt(
                _(
                    "The figure shows the contact of your function, which gives no pair (k, q) to compare with, so your teacher will mark it."
                )
            )
        k, q = pair
    times, velocities = _motion(balls, q)
    unit = contact_time(given["m"] / 2, k, q, v0)
    until = float(times[-1]) * unit

    def velocity(ball: int) -> Graph:
        def at(t: Numbers) -> Numbers:
            return v0 * np.interp(t / unit, times, velocities[:, ball])

        return Graph(_("ball {letter}", letter="ABCDEFGH"[ball]), at, (0.0, until), (unit, v0))

    asked = tuple(velocity(ball) for ball in range(balls))

    def missing(drawn: Sequence[DrawnCurve]) -> Fault | None:
        return _missing([curve for curve in drawn if not curve.straight], asked, v0)

    what = _("the velocities of the {balls} balls against time", balls=balls)
    return judge_panels((Panel(what, TIME, VELOCITY, asked, missing, any_origin=True),), figures)


def _missing(drawn: Sequence[DrawnCurve], asked: Sequence[Graph], v0: float) -> Fault | None:
    """What is said of curves that are not these: of their number, their beginnings and ends."""
    balls = len(asked)
    if len(drawn) < balls:
        return Fault(
            _(
                "No axes with a curve for each of the {balls} balls were found; plot every velocity against time.",
                balls=balls,
            )
        )
    begins = sorted(float(curve.y[np.isfinite(curve.y)][0]) for curve in drawn)
    if math.dist(begins[:1] + begins[-1:], (0.0, v0)) > 0.05 * v0:
        return Fault(
            _.plural(
                "The curves must start with one ball at v0 = {v0} m/s and the other at rest.",
                "The curves must start with one ball at v0 = {v0} m/s and the others at rest.",
                balls - 1,
                v0=in_convention(f"{v0:g}"),
            )
        )
    ends = sorted(float(curve.y[np.isfinite(curve.y)][-1]) for curve in drawn)
    wanted = sorted(float(each.at(np.array([each.span[1]]))[0]) for each in asked)
    if len(drawn) == balls and math.dist(ends, wanted) > 0.1 * v0:
        return Fault(_("The curves must run until the balls have parted, and no two touch any more."))
    return Fault(
        _(
            "The velocities begin and end well, but between they do not change as in this contact: each curve follows from "
            "Newton's second law, step by step."
        )
    )


@lru_cache(maxsize=64)
def _motion(balls: int, q: float) -> tuple[Numbers, Numbers]:
    """Velocities of a row (a column each) in units of v0, at times in units of the contact of two balls, until all have parted."""
    lasts = run("cradle", {"N": balls, "m": 1.0, "k": 1.0, "q": q, "v0": 1.0}, tolerance=1e-6).observed[
        "duration"
    ]
    assert isinstance(lasts, float)
    contact = contact_time(0.5, 1.0, q, 1.0)
    steps = math.ceil(STEPS * lasts / contact)
    path = march(RK4, pushed(q), [0.0] * balls, [1.0] + [0.0] * (balls - 1), lasts / steps, steps)
    return np.asarray(path.times) / contact, np.asarray(path.velocities)
