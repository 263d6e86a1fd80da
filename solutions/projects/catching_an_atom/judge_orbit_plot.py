"""Figures of an atom near a molecule: its potential energy, and its trajectory."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from judge_orbit import Pull

from corollary.programs import (
    NEAR,
    OFFSETS,
    RK4,
    Axes,
    Axis,
    Doubt,
    DrawnCurve,
    Fault,
    Graph,
    Numbers,
    Panel,
    catalogue,
    covers,
    judge_panels,
    march,
    near_all,
    run,
)

_ = catalogue(__file__)

PLACE = Axis("x [m]", r"\by\b")
ACROSS = Axis("y [m]", r"\bx\b")
ENERGY = Axis("U [J]", r"\b[fw]\b|force|kraft|work|arbeit")
LEVEL = 0.04  # how near a level line must be to its energy, relative
SWINGS = 2.0  # of the distance that a trajectory must show
DRIFT = 0.03  # of the angle: steps of a hundredth of half a swing turn a trajectory by up to 0.02
STEPS = 400  # in a swing


@dataclass(frozen=True, slots=True)
class Level:
    """A horizontal line."""

    name: str
    energy: float

    def fits(self, curve: DrawnCurve) -> bool:
        y = curve.y[np.isfinite(curve.y) & np.isfinite(curve.x)]
        return curve.joined and len(y) >= 2 and bool((np.abs(y - self.energy) <= LEVEL * self.energy).all())


@dataclass(frozen=True, slots=True)
class PotentialCurve:
    """The potential energy; within the wall, at x < b - d, whatever is above U0 stands for infinity."""

    curve: Graph
    wall: float

    @property
    def name(self) -> str:
        return self.curve.name

    def fits(self, curve: DrawnCurve) -> bool:
        d, top = self.curve.scales
        within = (curve.x <= self.wall + NEAR * d) & (curve.y >= (1 - 2 * NEAR) * top)
        return self.curve.fits(DrawnCurve(np.where(within, np.nan, curve.x), curve.y, curve.joined))


def judge_potential_plot(given: Mapping[str, float], figures: Sequence[Axes]) -> Fault | Doubt | None:
    """The bottom at b, a parabola up to U0 on both sides, the flat top beyond b + d, and a level line for either energy."""
    b, d, k = given["b"], given["d"], given["k"]
    depth = k * d**2 / 2

    def energy(x: Numbers) -> Numbers:
        return np.where(x < b + d, k * (x - b) ** 2 / 2, depth)

    well = PotentialCurve(
        Graph(_("the potential energy"), energy, (b - 0.9 * d, b + 1.2 * d), (d, depth)), b - d
    )
    below = Level(_("the total energy below U0"), given["eps"] * depth)
    above = Level(_("the total energy above U0"), given["epsx"] * depth)

    def missing(drawn: Sequence[DrawnCurve]) -> Fault | None:
        if not any(well.fits(curve) for curve in drawn):
            return Fault(
                _(
                    "No curve is this potential: it must have its bottom at x = b, rise to U0 at b + d on the right and on the left too, and stay at U0 beyond b + d."
                )
            )
        for level, name in ((below, _("below")), (above, _("above"))):
            if not any(level.fits(curve) for curve in drawn):
                return Fault(
                    _(
                        "The level line of the total energy {name} U0 is missing; draw E as a horizontal line at the energy asked for.",
                        name=name,
                    )
                )
        return None

    what = _("the potential energy against the place of the atom")
    return judge_panels((Panel(what, PLACE, ENERGY, (well, below, above), missing),), figures)


@dataclass(frozen=True, slots=True)
class Rosette:
    """A trajectory about the origin from (b, 0), told by its distance at each angle: `at` gives it for angles counted on from 0;
    `swing` is the angle (rad) of one swing, `b` and `far` are the least and the greatest distance (m)."""

    name: str
    at: Graph
    swing: float
    b: float
    far: float

    def fits(self, curve: DrawnCurve) -> bool:
        x, y = curve.points((self.b, self.b))
        if len(x) < 2 or math.dist((x[0] * self.b, y[0] * self.b), (self.b, 0.0)) > 0.03 * self.b:
            return False
        angle, r = np.unwrap(np.arctan2(y, x)), np.hypot(x, y) * self.b
        if angle.min() < -NEAR * self.swing or not near_all(angle, r, self._far):
            return False
        scale = self.at.scales[1]
        asked = np.linspace(0.0, SWINGS * self.swing, 400)
        drift = angle / self.swing, r / scale
        return covers(drift, (asked / self.swing, self.at.at(asked) / scale))

    def _far(self, angle: Numbers, r: Numbers) -> bool:
        """Whether any distance is too far from those about its angle."""
        slack = np.maximum(DRIFT * np.abs(angle), 1e-12)[:, None]
        moved = np.concatenate([slack * np.linspace(-1, 1, 17), slack + OFFSETS * self.swing], axis=1)
        cost = np.maximum(np.abs(moved) - slack, 0.0) / self.swing
        apart = np.abs(r[:, None] - self.at.at(angle[:, None] + moved)) / self.at.scales[1] + cost
        return bool((apart.min(axis=1) > 2 * NEAR).any())


def judge_orbit_plot(given: Mapping[str, float], figures: Sequence[Axes]) -> Fault | Doubt | None:
    """A curve from (b, 0) that swings between r = b and the far turning point, as far round as the force turns it."""
    b = given["b"]
    angles, distances, far = _swing(*(given[name] for name in ("m", "k", "b", "d", "v0")))
    swing = float(angles[-1])

    def distance(angle: Numbers) -> Numbers:
        folded: Numbers = angle - swing * np.floor(angle / swing)
        return np.interp(folded, angles, distances)

    scale = max(far - b, 0.1 * b)
    graph = Graph("", distance, (0.0, swing), (swing, scale))
    rosette = Rosette(_("the trajectory"), graph, swing, b, far)

    def missing(drawn: Sequence[DrawnCurve]) -> Fault | None:
        return _off(rosette, drawn)

    def helps(curve: DrawnCurve) -> bool:
        r = np.hypot(curve.x, curve.y)
        return curve.straight or float(np.nanmax(r) - np.nanmin(r)) <= 1e-6 * b

    panel = Panel(_("the trajectory"), PLACE, ACROSS, (rosette,), missing, helps)
    return judge_panels((panel,), figures)


@lru_cache(maxsize=64)
def _swing(m: float, k: float, b: float, d: float, v0: float) -> tuple[Numbers, Numbers, float]:
    """Angles (rad) and distances (m) from the start at b until the atom is there again, and the greatest distance."""
    settings = {"m": m, "k": k, "b": b, "d": d, "v0": v0}
    seen = run("atom", settings | {"r0": b}, tolerance=1e-9).observed
    far, period = seen["turning_points"], seen["period"]
    assert isinstance(far, tuple)
    assert isinstance(period, float)
    path = march(RK4, Pull(k / m, b, b + d).within, [b, 0.0], [0.0, v0], period / STEPS, STEPS)
    x, y = np.asarray(path.places).T
    return np.unwrap(np.arctan2(y, x)), np.hypot(x, y), far[-1]


def _off(rosette: Rosette, drawn: Sequence[DrawnCurve]) -> Fault:
    """What is wrong with the longest curve."""
    b = rosette.b
    longest = max(drawn, key=lambda curve: len(curve.x), default=None)
    if longest is None or len(longest.x) < 20:
        return Fault(_("No trajectory was found; plot y against x, as a curve of many points."))
    seen = np.isfinite(longest.x) & np.isfinite(longest.y)
    x, y = longest.x[seen], longest.y[seen]
    r = np.hypot(x, y)
    if math.dist((x[0], y[0]), (b, 0.0)) > 0.03 * b:
        return Fault(_("The trajectory must start at (b, 0)."))
    if r.min() < 0.98 * b:
        return Fault(
            _(
                "The atom comes closer than b. It starts across the radius, and the force at r > b is not strong enough to pull it in further: check force and step."
            )
        )
    if abs(r.max() - rosette.far) > 0.02 * b:
        return Fault(
            _(
                "The greatest distance of your trajectory is not that of (h1). Let it run for some swings, and check v0, force and step."
            )
        )
    return Fault(
        _(
            "The trajectory reaches the right distances, but it does not lead from one to the next as the force does. Let it run "
            "for some swings, draw it with many points, and check force and step."
        )
    )
