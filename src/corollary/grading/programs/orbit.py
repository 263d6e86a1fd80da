"""Students' programs for an atom in the plane of a molecule: what they are called with, and how they are judged."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

from corollary.derive.statements import Fault, Remark
from corollary.grading.programs.bound import NAMED, measured
from corollary.grading.programs.called import STEPS, Called, Draw, Given, Inputs, halved, miscounted
from corollary.grading.programs.convergence import Family, Standard, judged
from corollary.grading.programs.well import (
    State,
    Well,
    forward_euler,
    half_a_swing,
    moved,
    start_of,
    stepped,
    turned,
    well_of,
)

EULER = "this is forward Euler: the position is stepped with the old velocity, and energy grows. Step the velocity first."


def orbit_inputs(given: Given, draw: Draw) -> list[Inputs]:
    """Bound and started across the radius; bound and oblique; past the molecule from outside; away over the edge."""
    cases = []
    for kind in ("across", "oblique", "past", "away"):
        m, k, b = round(draw(0.5, 4.0), 2), round(draw(40, 300)), round(draw(0.8, 1.6), 2)
        d = round(draw(0.35, 0.6) * b, 3)
        omega, turn = math.sqrt(k / m), draw(0.0, 2 * math.pi)
        match kind:
            case "across":
                start, turn = (b, 0.0, 0.0, draw(0.3, 0.5) * omega * d), 0.0
            case "oblique":
                start = (b + 0.3 * d, 0.0, draw(-0.3, 0.3) * omega * d, draw(0.3, 0.4) * omega * d)
            case "past":
                start = (b + 1.5 * d, draw(0.85, 0.95) * b, -draw(0.6, 0.9) * omega * d, 0.0)
            case _:
                start = (b, 0.0, draw(1.3, 1.6) * omega * d, draw(0.2, 0.6) * omega * d)
        x, y, vx, vy = (round(value, 4) for value in turned(start, turn))
        case = {"m": m, "k": k, "b": b, "d": d, "x": x, "y": y, "vx": vx, "vy": vy}
        T = round(3.2 * math.pi / omega, 4)
        cases.append(case | {"T": T, "dt": T / round(T * omega / math.pi * STEPS)})
    return halved(cases)


def judge_orbit(given: Given, called: Sequence[Called]) -> Fault | Remark | None:
    """The place of the atom at the time T: against small exact steps, then against the usual wrong programs."""
    return judged(ORBIT, called)


def _standard(inputs: Inputs) -> Standard:
    well, start, T = well_of(inputs), start_of(inputs), inputs["T"]
    return place_standard(well, moved(well, start, T), lambda dt: stepped(well, start, T, round(T / dt)))


def place_standard(well: Well, truth: State, book: Callable[[float], State]) -> Standard:
    """Places against the distance b, or the distance from the molecule when it is larger. First order: the atom is still pulled."""
    contact, scale = half_a_swing(well), max(well.b, math.hypot(*truth[:2]))

    def errors(found: Sequence[float]) -> tuple[float, ...]:
        return (math.dist(found, truth[:2]) / scale,)

    return Standard(errors, measured(1, lambda steps: errors(book(contact / steps)[:2])), contact)


def _wrong(called: Called) -> Fault:
    inputs = called.inputs
    well, start = well_of(inputs), start_of(inputs)
    steps = round(inputs["T"] / inputs["dt"])
    pull, b, edge = well.pull, well.b, well.edge
    wrong = {
        "the force pushes away from the distance b. Outside b it must pull inwards: there is a minus sign.": Well(
            -pull, b, edge
        ),
        "the atom is still pulled back beyond b + d. There the potential energy is constant: no force.": Well(
            pull, b, math.inf
        ),
        "the force pulls to the molecule itself, as if b were 0. The spring is relaxed at the distance b.": Well(
            pull, 0.0, edge
        ),
        "the mass is missing: the acceleration is the force divided by m.": Well(pull * inputs["m"], b, edge),
    }
    usual = {sentence: stepped(other, start, inputs["T"], steps) for sentence, other in wrong.items()}
    usual[EULER] = forward_euler(well, start, inputs["T"], steps)
    return named(called, usual)


def misfit(called: Called) -> str:
    return miscounted(called, 2, "the pair (x, y)")


def named(called: Called, usual: Mapping[str, State]) -> Fault:
    """The usual wrong program that ends nearest, when it ends near."""
    sentence, end = min(usual.items(), key=lambda item: math.dist(called.returned, item[1][:2]))
    if math.dist(called.returned, end[:2]) <= NAMED * max(called.inputs["b"], math.hypot(*end[:2])):
        return Fault(f"At the time T {sentence}", known=True)
    return Fault(
        "The atom is not where it should be at the time T. Check the force on both sides of r = b, beyond b + d, and that you reach T."
    )


ORBIT = Family(misfit, _standard, _wrong)
