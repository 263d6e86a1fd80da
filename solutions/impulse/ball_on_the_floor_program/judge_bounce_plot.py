"""Figures of a ball on the floor: net force and momentum against time."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from judge_bounce import ARGUMENTS, reference

from corollary.programs import (
    RK4,
    Axes,
    Axis,
    Doubt,
    DrawnCurve,
    Fault,
    Given,
    Graph,
    Numbers,
    Panel,
    catalogue,
    judge_panels,
    march,
)

_ = catalogue(__file__)

TIME = Axis("t [s]")
FORCE = Axis("F [N]", r"\b[pvuek]\b|moment|impuls|energ")
MOMENTUM = Axis("p [kg m/s]", r"\bf\b|force|kraft")
STEPS = 400  # in the contact
OF_WEIGHT = 0.2  # how near the net force must be to -m g before the contact


@dataclass(frozen=True, slots=True)
class NetForce:
    """The net force (N): near the whole curve, and the weight alone before the ball touches the floor, at the time `touch`."""

    curve: Graph
    touch: float
    weight: float

    @property
    def name(self) -> str:
        return self.curve.name

    def middle(self) -> float | None:
        return self.curve.middle()

    def fits(self, curve: DrawnCurve) -> bool:
        return self.curve.fits(curve) and self.has_weight(curve)

    def has_weight(self, curve: DrawnCurve) -> bool:
        """Whether what is drawn before the first touch is the weight."""
        before = curve.y[np.isfinite(curve.y) & (curve.x < self.touch)]
        return bool((np.abs(before + self.weight) <= OF_WEIGHT * self.weight).all())


@lru_cache(maxsize=64)
def _contact(
    m: float, k: float, R: float, v: float, g: float, lasts: float
) -> tuple[Numbers, Numbers, Numbers]:
    """Times (s) since the touch, heights (m) and velocities (m/s) while the ball touches the floor."""
    path = march(RK4, lambda x, v: [k * max(R - x[0], 0.0) ** 1.5 / m - g], [R], [v], lasts / STEPS, STEPS)
    return np.asarray(path.times), np.asarray(path.places)[:, 0], np.asarray(path.velocities)[:, 0]


def judge_bounce_plot(given: Given, figures: Sequence[Axes]) -> Fault | Doubt | None:
    """Net force and momentum against time, each with labelled axes, from before the contact till after it."""
    m, k, R, y0, v0, g = (given[name] for name in ARGUMENTS)
    truth = reference(m, k, R, y0, v0, g)
    touch = (math.sqrt(v0**2 + 2 * g * (y0 - R)) + v0) / g
    leave, lasts = touch + truth.duration, truth.duration
    since, heights, velocities = _contact(m, k, R, v0 - g * touch, g, lasts)
    times = touch + since
    push = k * np.maximum(R - heights, 0.0) ** 1.5

    def force(t: Numbers) -> Numbers:
        return np.interp(t, times, push, 0.0, 0.0) - m * g

    def momentum(t: Numbers) -> Numbers:
        in_contact = np.interp(t, times, velocities)
        return m * (in_contact - g * (np.minimum(t - touch, 0.0) + np.maximum(t - leave, 0.0)))

    span = (max(0.0, touch - 0.1 * lasts), leave + 0.05 * lasts)
    net = NetForce(Graph(_("the net force"), force, span, (lasts, truth.force)), touch, m * g)

    def force_missing(drawn: Sequence[DrawnCurve]) -> Fault | None:
        for curve in drawn:
            if net.curve.fits(curve) and not net.has_weight(curve):
                return Fault(
                    _(
                        "At the start only gravity acts, and the net force is -m g; you drew the force of the floor."
                    ),
                    known=True,
                )
        if any(abs(float(np.nanmax(each.y)) - truth.force) <= 0.05 * truth.force for each in drawn):
            return Fault(
                _(
                    "The curve of the net force must begin before the ball touches the floor, end after it has left it, and show "
                    "the force at each time between."
                )
            )
        return Fault(
            _(
                "There is no curve of the net force for your numbers: from -m g to the largest net force, and back."
            )
        )

    def momentum_missing(drawn: Sequence[DrawnCurve]) -> Fault | None:
        return Fault(
            _(
                "There is no curve of the momentum p(t) for your numbers: from m v at the first touch to the opposite value."
            )
        )

    against = _("the net force against time"), _("the momentum against time")
    return judge_panels(
        (
            Panel(against[0], TIME, FORCE, (net,), force_missing, any_origin=True),
            Panel(
                against[1],
                TIME,
                MOMENTUM,
                (Graph(_("the momentum"), momentum, span, (lasts, m * truth.velocity)),),
                momentum_missing,
                any_origin=True,
            ),
        ),
        figures,
    )
