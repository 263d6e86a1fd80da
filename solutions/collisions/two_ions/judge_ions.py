"""Students' programs for two ions that repel each other: what they are called with, and how they are judged."""

from __future__ import annotations

import math
from collections.abc import Sequence

import two_bodies
from two_bodies import Force, converged

from corollary.programs import (
    SMOOTH,
    STEPS,
    Called,
    Draw,
    Family,
    Fault,
    Given,
    Inputs,
    Remark,
    Standard,
    catalogue,
    halved,
    in_convention,
    judged,
)

_ = catalogue(__file__)


def ion_force(C: float, *, sign: float = -1.0, power: float = 3.0) -> Force:
    """On A: C over the square of the distance, away from B."""
    return lambda x, y, u, w: (
        sign * C * x / math.hypot(x, y) ** power,
        sign * C * y / math.hypot(x, y) ** power,
    )


def closest(C: float, mA: float, mB: float, r0: float, v: float) -> float:
    """The distance at which ions turn round that approach head-on at the relative speed v, r0 apart."""
    return C / (mA * mB / (mA + mB) * v**2 / 2 + C / r0)


def ion_inputs(given: Given, draw: Draw) -> list[Inputs]:
    """Head-on, oblique, and B moving too; until well after the closest approach, in steps of a hundredth of closest / speed."""
    cases: list[Inputs] = []
    for aside, v_b in ((0.0, 0.0), (0.3, 0.0), (0.5, -0.4)):
        mA, mB = round(draw(0.05, 0.3), 3), round(draw(0.05, 0.3), 3)
        r0, v = round(draw(0.06, 0.15), 3), round(draw(0.6, 1.6), 2)
        energy = mA * mB / (mA + mB) * (v - v_b) ** 2 / 2
        C = round(energy * r0 / draw(1.0, 3.0), 6)
        T = round(4.0 * r0 / (v - v_b), 4)
        case = {
            "C": C,
            "mA": mA,
            "mB": mB,
            "rA": (0.0, 0.0),
            "vA": (v, 0.0),
            "rB": (r0, round(aside * r0, 4)),
            "vB": (v_b, 0.0),
        }
        case |= {"T": T, "dt": 0.0}
        cases.append(case | {"dt": T / round(T * STEPS / _turning(case))})
    return halved(cases)


def judge_ions(given: Given, called: Sequence[Called]) -> Fault | Remark | None:
    """Against steps made ever smaller; then against what the usual wrong programs return, and by the total momentum."""
    return judged(IONS, called)


def _standard(inputs: Inputs) -> Standard:
    """First order: the ions still push each other when the velocities are read."""
    force = ion_force(inputs["C"])
    return two_bodies.standard(
        inputs, force, converged(inputs, force, 1e-9), order=1, unit=_turning(inputs), safety=SMOOTH
    )


def _turning(inputs: Inputs) -> float:
    """The closest distance over the speed: how long the ions take to turn round, more or less."""
    v = two_bodies.speed(inputs)
    return closest(inputs["C"], inputs["mA"], inputs["mB"], math.dist(inputs["rA"], inputs["rB"]), v) / v


def _wrong(called: Called) -> Fault:
    C = called.inputs["C"]
    usual = {
        _(
            "the ions attract. $\\Delta\\vec r$ leads from A to B, so the force on A needs a minus."
        ): ion_force(C, sign=1.0),
        _("the force falls off as $1/\\Delta r$: a unit vector takes one more division."): ion_force(
            C, power=2.0
        ),
    }
    return two_bodies.wrong(
        called, usual, ion_force(C), _("With C = {value} N m²", value=in_convention(f"{C:g}"))
    )


IONS = Family(two_bodies.misfit, _standard, _wrong)
