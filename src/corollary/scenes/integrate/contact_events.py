"""Contacts that begin or end within a step: which is the first, and which matter at all."""

from __future__ import annotations

from collections.abc import Sequence

from corollary.scenes.forces.contact import push
from corollary.scenes.integrate.row_problem import RowProblem
from corollary.scenes.integrate.step import IntegrationStep
from corollary.scenes.integrate.time_variable import TIME, TimeVariable

# A step in time must leave so much of an overlap whose force is not smooth where it ends: nearer to the end the error of the step
# would not be known. The contact's own variable takes over.
NEAR_CONTACT = 0.3


def first_crossing(
    problem: RowProblem,
    state: list[float],
    base: Sequence[float],
    step: IntegrationStep,
    speeds: Sequence[float],
    touching: Sequence[bool],
) -> int | None:
    """The contact that begins or ends first in a step, too slow ones apart: those change nothing that can be seen.

    `base` and `speeds` hold the closing speeds before and after.
    """
    first, when, noise = None, 2.0, problem.noise
    for j, on in enumerate(touching):
        before, after = state[1 + j], step.after[1 + j]
        near = (
            before > 0.0
            and speeds[j] < 0.0
            and after < NEAR_CONTACT * before
            and _rough(problem, state, step, j)
            and not turns(state, base, j)
        )
        ends = after < 0.0 < before or near
        if j == step.variable.contact or not (ends if on else after > 0.0):
            continue
        if abs(base[j]) <= noise and abs(speeds[j]) <= noise:
            continue
        if before / (before - after) < when:
            first, when = j, before / (before - after)
    return first


def _rough(problem: RowProblem, state: list[float], step: IntegrationStep, j: int) -> bool:
    """Whether the end of a contact can be felt in a step in time: its force is not smooth there, and not too faint to matter."""
    pushed = push(problem.line.contacts[j], state[1 + j], 0.0) * (step.after[0] - state[0])
    return step.variable is TIME and problem.powers[j] > 1 and pushed > problem.tolerance


def grazes(
    problem: RowProblem,
    state: list[float],
    base: Sequence[float],
    step: IntegrationStep,
    speeds: Sequence[float],
    touching: Sequence[bool],
) -> bool:
    """Whether an overlap may pass zero and come back inside a step; judged by a parabola, so it errs on shorter steps."""
    lasted = step.after[0] - state[0]
    for j, on in enumerate(touching):
        sign = 1.0 if on else -1.0
        before, after = sign * base[j], sign * speeds[j]
        if before < 0.0 < after and sign * state[1 + j] < 0.5 * before**2 * lasted / (after - before):
            return True
    return False


def due(
    problem: RowProblem, state: list[float], base: Sequence[float], lasting: float, touching: Sequence[bool]
) -> int | None:
    """The contact that is sure to begin or end next, within so long; none when its speed may turn before."""
    count, first, soonest = len(touching), None, lasting
    for j, on in enumerate(touching):
        overlap, speed = state[1 + j], base[j]
        if (overlap > 0.0 and speed < -problem.noise) if on else (overlap < 0.0 and speed > problem.noise):
            after = -overlap / speed
            if (
                after < soonest
                and abs(overlap * (base[count + j] - base[count + j + 1])) < 0.3 * speed * speed
            ):
                first, soonest = j, after
    return first


def nears_zero(
    problem: RowProblem, state: list[float], base: Sequence[float], variable: TimeVariable
) -> bool:
    """Whether the overlap that is the variable still moves toward zero; its speed may have faded or turned on the problem."""
    j = variable.contact
    return (
        j is not None
        and abs(base[j]) > problem.noise
        and (base[j] < 0.0) == (state[1 + j] > 0.0)
        and not turns(state, base, j)
    )


def turns(state: list[float], base: Sequence[float], j: int) -> bool:
    """Whether an overlap on its way to zero would turn before, if its acceleration stayed as it is."""
    left = len(base) // 2 + j
    growth = base[left] - base[left + 1]
    return growth * base[j] < 0.0 and base[j] * base[j] < 2.0 * abs(state[1 + j] * growth)
