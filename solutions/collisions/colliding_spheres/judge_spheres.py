"""Two spheres that collide in a plane: what students' programs are called with, and how they are judged."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import two_bodies
from two_bodies import Force

from corollary.programs import (
    STEPS,
    Called,
    Draw,
    Family,
    Fault,
    Given,
    Inputs,
    Remark,
    Run,
    Standard,
    catalogue,
    contact_time,
    halved,
    in_convention,
    judged,
    run,
)

_ = catalogue(__file__)


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
        cases.append(case | {"dt": contact_of(case) / STEPS})
    return halved(cases)


def judge_spheres(given: Given, called: Sequence[Called]) -> Fault | Remark | None:
    """Against the scene; then against what the usual wrong programs return, and by the total momentum."""
    return judged(SPHERES, called)


def _standard(inputs: Inputs) -> Standard:
    truth = _played(inputs).observed["velocities"]
    assert isinstance(truth, tuple)
    order = 1 if inputs["eta"] else 2  # the brake sets in at once when the spheres touch
    force = sphere_force(inputs["R"], inputs["k"], inputs["eta"])
    return two_bodies.standard(inputs, force, truth, order=order, unit=contact_of(inputs))


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
        called, usual, sphere_force(R, k, eta), _("With eta = {value} kg/s", value=in_convention(f"{eta:g}"))
    )


SPHERES = Family(two_bodies.misfit, _standard, _wrong)


def contact_of(inputs: Inputs) -> float:
    mA, mB = inputs["mA"], inputs["mB"]
    return contact_time(mA * mB / (mA + mB), inputs["k"], 1.5, two_bodies.speed(inputs))


def _played(inputs: Inputs) -> Run:
    (ax, ay), (bx, by) = inputs["rA"], inputs["rB"]
    settings = {name: inputs[name] for name in ("mA", "mB", "R", "k", "eta", "vA", "vB")}
    return run("spheres", {**settings, "q": 1.5, "dx": bx - ax, "dy": by - ay}, tolerance=1e-9)
