"""Figures of two spheres that collide: their trajectories, and the components of their momenta against time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache

import numpy as np
from judge_spheres import contact_of, sphere_force

from corollary.programs import (
    RK4,
    Axes,
    Axis,
    Doubt,
    DrawnCurve,
    Fault,
    Graph,
    Inputs,
    Numbers,
    Panel,
    PlanePath,
    catalogue,
    in_convention,
    judge_panels,
    march,
)

_ = catalogue(__file__)

TIME, STEP = 0.10, 1e-4
START: Inputs = {"rA": (0.0, 0.0), "vA": (1.0, 0.0), "rB": (0.08, 0.018), "vB": (0.0, 0.0)}
NEAR = 0.003  # m, of paths about 0.1 m long
PLACE, ACROSS, T = Axis("x [m]", r"\by\b"), Axis("y [m]", r"\bx\b"), Axis("t [s]")
ALONG_X = Axis("p_x [kg m/s]", r"\bpy\b|\bp y\b|\b[fv]\b|force|kraft")
ALONG_Y = Axis("p_y [kg m/s]", r"\bpx\b|\bp x\b|\b[fv]\b|force|kraft")


def judge_spheres_plot(given: Mapping[str, float], figures: Sequence[Axes]) -> Fault | Doubt | None:
    """Three pairs of axes; in each a curve for A and one for B, from the start to the time asked for."""
    inputs = {**START, "mA": given["mA"], "mB": given["mB"], "k": given["k"]}
    times, places, velocities = _motion(*(given[name] for name in ("mA", "mB", "R", "k", "eta")))
    contact, start = contact_of(inputs), given["mA"] * START["vA"][0]

    def momentum(name: str, mass: float, column: int) -> Graph:
        def at(t: Numbers) -> Numbers:
            return mass * np.interp(t, times, velocities[:, column])

        return Graph(name, at, (0.0, 0.95 * TIME), (contact, start))

    a, b = _("sphere A"), _("sphere B")
    paths = PlanePath(a, (places[:, 0], places[:, 1]), NEAR), PlanePath(b, (places[:, 2], places[:, 3]), NEAR)
    panels = [Panel(_("the trajectories"), PLACE, ACROSS, paths, _paths_missing)]
    for what, quantity, column in (("p_x", ALONG_X, 0), ("p_y", ALONG_Y, 1)):
        asked = momentum(a, given["mA"], column), momentum(b, given["mB"], 2 + column)

        def missing(
            drawn: Sequence[DrawnCurve], what: str = what, asked: tuple[Graph, Graph] = asked
        ) -> Fault | None:
            return _momenta_missing(drawn, what, asked, start)

        panels.append(Panel(what, T, quantity, asked, missing))
    return judge_panels(panels, figures)


@lru_cache(maxsize=64)
def _motion(mA: float, mB: float, R: float, k: float, eta: float) -> tuple[Numbers, Numbers, Numbers]:
    """Times, and the places and velocities (A x, A y, B x, B y) at each of them."""
    force = sphere_force(R, k, eta)

    def acceleration(x: Sequence[float], v: Sequence[float]) -> list[float]:
        fx, fy = force(x[2] - x[0], x[3] - x[1], v[2] - v[0], v[3] - v[1])
        return [fx / mA, fy / mA, -fx / mB, -fy / mB]

    count = 2 * round(TIME / STEP)
    path = march(
        RK4,
        acceleration,
        [*START["rA"], *START["rB"]],
        [*START["vA"], *START["vB"]],
        TIME / count,
        count,
    )
    return np.asarray(path.times), np.asarray(path.places), np.asarray(path.velocities)


def _paths_missing(drawn: Sequence[DrawnCurve]) -> Fault | None:
    what = _("the trajectories")
    if len(drawn) < 2:
        return _two_curves(what)
    begins = [np.array((curve.x[0], curve.y[0])) for curve in drawn]
    if not all(any(np.hypot(*(at - place)) < NEAR for at in begins) for place in (START["rA"], START["rB"])):
        return Fault(_("The trajectories must start at (0, 0) for A and at (0.08, 0.018) m for B."))
    return Fault(
        _(
            "The curves of {what} do not lead where this model does, along their whole length. Check the force law, its signs and the numbers.",
            what=what,
        )
    )


def _two_curves(what: str) -> Fault:
    return Fault(_("In the axes for {what} there must be a curve for A and one for B.", what=what))


def _momenta_missing(
    drawn: Sequence[DrawnCurve], what: str, asked: tuple[Graph, Graph], start: float
) -> Fault | None:
    """What is said of curves that are not these momenta."""
    if len(drawn) < 2:
        return _two_curves(what)
    if max(float(curve.x[-1]) for curve in drawn) < 0.95 * TIME:
        return Fault(
            _("The curves of {what} must run until {time} s.", what=what, time=in_convention(f"{TIME:g}"))
        )
    begins = [float(curve.y[0]) for curve in drawn]
    wanted = [float(each.at(np.array([0.0]))[0]) for each in asked]
    if not all(any(abs(at - value) <= 0.03 * start for at in begins) for value in wanted):
        return Fault(
            _(
                "The curves of {what} must start with A's momentum (A moves along x at 1.0 m/s) and with B at rest. Mind that it is momenta that are asked for.",
                what=what,
            )
        )
    return Fault(
        _(
            "The curves of {what} do not go as this model does, from the touch to the end. Check the force law, its signs and the numbers.",
            what=what,
        )
    )
