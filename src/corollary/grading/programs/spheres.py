"""Two spheres that collide in a plane: what students' programs are called with, and how they and figures are judged."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

from corollary.derive.statements import Fault, Remark
from corollary.grading.programs import two_bodies
from corollary.grading.programs.convergence import (
    STEPS,
    Called,
    Draw,
    Family,
    Given,
    Inputs,
    Standard,
    halved,
    judged,
)
from corollary.grading.programs.two_bodies import Force
from corollary.messages import catalogue
from corollary.scenes.catalogue import run
from corollary.scenes.integrate.fixed_step import EULER_CROMER
from corollary.scenes.models.bounce import contact_time
from corollary.scenes.run import Run

_ = catalogue(__name__)

TIME, STEP = 0.10, 1e-4
START: Inputs = {
    "rA": (0.0, 0.0),
    "vA": (1.0, 0.0),
    "rB": (0.08, 0.018),
    "vB": (0.0, 0.0),
    "T": TIME,
    "dt": STEP,
}
NEAR = 0.03  # of A's momentum at the start: curves are read off as drawn, steps of the student's own choice included
AXES = {"the trajectories": (r"^x", r"^y"), "p_x": (r"^t", r"px|^p.*x"), "p_y": (r"^t", r"py|^p.*y")}


def sphere_force(
    R: float, k: float, eta: float, *, spring: float = -1.0, drag: float = 1.0, q: float = 1.5
) -> Force:
    """On A: k overlap^q along the line of centres and eta times the relative velocity, while the spheres overlap."""

    def force(x: float, y: float, u: float, w: float) -> tuple[float, float]:
        r = math.hypot(x, y)
        if r >= 2 * R:
            return 0.0, 0.0
        push = spring * k * (2 * R - r) ** q / r
        return push * x + drag * eta * u, push * y + drag * eta * w

    return force


def sphere_inputs(given: Given, draw: Draw) -> list[Inputs]:
    """A head-on hit, an oblique one, an oblique one with damping; until the spheres have parted."""
    cases: list[Inputs] = []
    for eta, aside in ((0.0, 0.0), (0.0, 0.8), (1.0, 0.6)):
        mA, mB, R = (round(draw(low, high), 4) for low, high in ((0.05, 0.3), (0.05, 0.3), (0.015, 0.03)))
        k, eta = round(draw(1e4, 4e4)), round(eta * draw(0.5, 1.5), 2)
        case: dict[str, Any] = {
            "mA": mA,
            "mB": mB,
            "R": R,
            "k": k,
            "eta": eta,
            "rA": (0.0, 0.0),
            "rB": (2.2 * R, round(aside * R, 5)),
            "vA": (round(draw(0.6, 1.4), 2), 0.0),
            "vB": (0.0, round(draw(-0.2, 0.2), 2)),
        }
        time = _played(case).observed["duration"]
        assert isinstance(time, float)
        case["T"] = (0.2 * R + 2 * R * (1 - math.sqrt(1 - (aside / 2) ** 2)) + 0.3 * R) / case["vA"][
            0
        ] + 1.5 * time
        cases.append(case | {"dt": _contact(case) / STEPS})
    return halved(cases)


def judge_spheres(given: Given, called: Sequence[Called]) -> Fault | Remark | None:
    """Against the scene; then against what the usual wrong programs return, and by the total momentum."""
    return judged(SPHERES, called)


def _standard(inputs: Inputs) -> Standard:
    truth = _played(inputs).observed["velocities"]
    assert isinstance(truth, tuple)
    order = 1 if inputs["eta"] else 2  # the brake sets in at once when the spheres touch
    force = sphere_force(inputs["R"], inputs["k"], inputs["eta"])
    return two_bodies.standard(inputs, force, truth, order=order, unit=_contact(inputs))


def _wrong(called: Called) -> Fault:
    R, k, eta = (called.inputs[name] for name in ("R", "k", "eta"))
    usual = {
        _(
            "the spheres pull each other together while they overlap. The spring pushes A away from B, against $\\Delta\\vec r$."
        ): sphere_force(R, k, eta, spring=1.0),
        _(
            "the damping drives the spheres instead of braking them. The force on A must pull its velocity towards that of B: $+\\eta\\,\\Delta\\vec v$."
        ): sphere_force(R, k, eta, drag=-1.0),
        _("the spring force grows linearly with the overlap. Its power is 3/2."): sphere_force(
            R, k, eta, q=1.0
        ),
        _("there is no damping. Add the term with $\\eta$."): sphere_force(R, k, 0.0),
    }
    return two_bodies.wrong(
        called, usual, sphere_force(R, k, eta), _("With eta = {value} kg/s", value=f"{eta:g}")
    )


SPHERES = Family(two_bodies.misfit, _standard, _wrong)


def _contact(inputs: Inputs) -> float:
    mA, mB = inputs["mA"], inputs["mB"]
    return contact_time(mA * mB / (mA + mB), inputs["k"], 1.5, two_bodies.speed(inputs))


def _played(inputs: Inputs) -> Run:
    (ax, ay), (bx, by) = inputs["rA"], inputs["rB"]
    settings = {name: inputs[name] for name in ("mA", "mB", "R", "k", "eta", "vA", "vB")}
    return run("spheres", {**settings, "q": 1.5, "dx": bx - ax, "dy": by - ay}, tolerance=1e-9)


def judge_spheres_plot(given: Mapping[str, float], figures: Sequence[Any]) -> Fault | None:
    """Three pairs of axes, told by their labels; in each a curve for A and one for B with the right ends."""
    inputs = {**START, "mA": given["mA"], "mB": given["mB"]}
    force = sphere_force(given["R"], given["k"], given["eta"])
    au, aw, bu, bw = two_bodies.marched(inputs, force, EULER_CROMER, 8 * round(TIME / STEP))
    start = given["mA"] * START["vA"][0]
    for what, labels in AXES.items():
        axes = next((each for each in figures if _labelled(each, labels)), None)
        if axes is None:
            return Fault(
                _(
                    "No axes for {what} were found. Label them with quantity and unit: x [m] and y [m], t [s] and p_x [kg m/s], t [s] and p_y [kg m/s].",
                    what=what,
                )
            )
        curves = [line for line in axes.lines if line.kind != "bars" and len(line.x) > 20]
        if len(curves) < 2:
            return Fault(_("In the axes for {what} there must be a curve for A and one for B.", what=what))
        match what:
            case "the trajectories":
                wanted = {START["rA"], START["rB"]}
                met = all(
                    any(math.dist((line.x[0], line.y[0]), place) < 0.002 for line in curves)
                    for place in wanted
                )
                if not met:
                    return Fault(
                        _("The trajectories must start at (0, 0) for A and at (0.08, 0.018) m for B.")
                    )
            case _:
                ends = (
                    (given["mA"] * au, given["mB"] * bu)
                    if what == "p_x"
                    else (given["mA"] * aw, given["mB"] * bw)
                )
                begins = (start, 0.0) if what == "p_x" else (0.0, 0.0)
                if max(line.x[-1] for line in curves) < 0.9 * TIME:
                    return Fault(
                        _("The curves of {what} must run until {time} s.", what=what, time=f"{TIME:g}")
                    )
                if not _pairs(curves, 0, begins, start):
                    return Fault(
                        _(
                            "The curves of {what} must start with A's momentum (A moves along x at 1.0 m/s) and with B at rest. Mind that it is momenta that are asked for.",
                            what=what,
                        )
                    )
                if not _pairs(curves, -1, ends, start):
                    return Fault(
                        _(
                            "The curves of {what} do not end where this model leads. Check the force law, its signs and the numbers.",
                            what=what,
                        )
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
