"""Two bodies in a plane that push each other: their motion step by step, and what a program for it is measured by."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

from corollary.programs import (
    EULER,
    EULER_CROMER,
    N_,
    NAMED,
    RK4,
    SAFETY,
    Called,
    Fault,
    Inputs,
    Method,
    Standard,
    catalogue,
    march,
    measured,
    miscounted,
)

_ = catalogue(__file__)

FINEST = 1 << 15  # steps: beyond, a reference that has not converged will not
LOST = (math.inf,) * 4
FORWARD_EULER = N_(
    "this is forward Euler: the position is stepped with the old velocity. Step the velocity first, then the position "
    "with the new one."
)
ONE_SIDED = N_("only A feels a force. What B does to A, A does to B, the other way.")
NOT_CONSERVED = N_(
    "the total momentum is not kept. The force on B is that on A, the other way, and each has its own mass."
)
CONSERVED = N_(
    "the total momentum is kept, but the velocities after the time T are not right. Check the force law, and that you "
    "reach T."
)
Force = Callable[[float, float, float, float], tuple[float, float]]  # on A, from r_B - r_A and v_B - v_A


def misfit(called: Called) -> str:
    return miscounted(called, 4, _("the four velocities v_Ax, v_Ay, v_Bx, v_By"))


def speed(inputs: Inputs) -> float:
    """The relative speed at the start: the scale of all errors."""
    return math.dist(inputs["vA"], inputs["vB"])


def marched(
    inputs: Inputs, force: Force, method: Method, count: int, *, both: bool = True
) -> tuple[float, ...]:
    """Velocities (A x, A y, B x, B y) at the time T after so many steps; inf when the bodies are lost.

    Not `both`: B feels no force, a usual mistake.
    """
    mA, mB = inputs["mA"], inputs["mB"] if both else math.inf

    def acceleration(x: Sequence[float], v: Sequence[float]) -> list[float]:
        fx, fy = force(x[2] - x[0], x[3] - x[1], v[2] - v[0], v[3] - v[1])
        return [fx / mA, fy / mA, -fx / mB, -fy / mB]

    places, velocities = [*inputs["rA"], *inputs["rB"]], [*inputs["vA"], *inputs["vB"]]
    try:
        end = march(method, acceleration, places, velocities, inputs["T"] / count, count).velocities[-1]
    except (OverflowError, ZeroDivisionError):  # beyond the doubles, or one body on the other
        return LOST
    return end if all(map(math.isfinite, end)) else LOST


def steps_of(inputs: Inputs) -> int:
    """How many steps of dt lead to the time T."""
    return max(1, round(inputs["T"] / inputs["dt"]))


def converged(inputs: Inputs, force: Force, tolerance: float) -> tuple[float, ...]:
    """The velocities at the time T of a smooth force: steps of fourth order halved until they change by less than this (relative).

    Raises ArithmeticError when that does not come about.
    """
    count = max(128, round(inputs["T"] / inputs["dt"] / 4))
    coarse = marched(inputs, force, RK4, count)
    while count < FINEST:
        count *= 2
        fine = marched(inputs, force, RK4, count)
        if math.dist(coarse, fine) <= tolerance * speed(inputs):
            return fine
        coarse = fine
    raise ArithmeticError("the reference motion of the two bodies does not settle")


def standard(
    inputs: Inputs, force: Force, truth: Sequence[float], *, order: int, unit: float, safety: float = SAFETY
) -> Standard:
    """Bounds measured for this case; `unit` is the time that steps are counted in."""

    def errors(found: Sequence[float]) -> tuple[float, ...]:
        return (math.dist(found, truth) / speed(inputs),)

    def book(steps: float) -> tuple[float, ...]:
        return errors(marched(inputs, force, EULER_CROMER, round(inputs["T"] / unit * steps)))

    return Standard(errors, measured(order, book, safety), unit)


def wrong(called: Called, usual: Mapping[str, Force], right: Force, case: str) -> Fault:
    """What is said of a program that ends too far away: the usual mistake it is nearest to, or what it does not keep."""
    inputs, returned = called.inputs, called.returned
    count = steps_of(inputs)
    ends = {
        f"{case} {sentence}": marched(inputs, force, EULER_CROMER, count) for sentence, force in usual.items()
    }
    ends[f"{case} {_(FORWARD_EULER)}"] = marched(inputs, right, EULER, count)
    ends[f"{case} {_(ONE_SIDED)}"] = marched(inputs, right, EULER_CROMER, count, both=False)
    sentence, end = min(ends.items(), key=lambda item: math.dist(returned, item[1]))
    if math.dist(returned, end) <= NAMED * speed(inputs):
        return Fault(sentence, known=True)
    if math.dist(returned, (*inputs["vA"], *inputs["vB"])) <= NAMED * speed(inputs):
        return Fault(
            _("{case} nothing has happened to the velocities. Step forward until the time T.", case=case)
        )
    mA, mB = inputs["mA"], inputs["mB"]
    lost = [mA * (returned[i] - inputs["vA"][i]) + mB * (returned[i + 2] - inputs["vB"][i]) for i in (0, 1)]
    if math.hypot(*lost) > 0.01 * mA * speed(inputs):
        return Fault(f"{case} {_(NOT_CONSERVED)}", known=True)
    return Fault(f"{case} {_(CONSERVED)}")
