"""An atom in the well of a molecule: its motion, exactly enough to be held against, and step by step as a program finds it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from corollary.grading.programs.called import Inputs
from corollary.scenes.integrate.fixed_step import EULER_CROMER, march

State = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Well:
    """Acceleration -pull (r - b) along the radius for r < edge, none beyond; `pull` is k/m."""

    pull: float
    b: float
    edge: float


Walk = Callable[[Well, State, float, int], State]  # a method: the state after a time, in so many steps


def well_of(inputs: Inputs) -> Well:
    return Well(inputs["k"] / inputs["m"], inputs["b"], inputs["b"] + inputs["d"])


def start_of(inputs: Inputs) -> State:
    return inputs["x"], inputs["y"], inputs["vx"], inputs["vy"]


def half_a_swing(well: Well) -> float:
    """From r = b out and back: as long as the atom is pulled in on a line, and what steps are counted in."""
    return math.pi / math.sqrt(well.pull)


def moved(well: Well, state: State, time: float, least: int = 400) -> State:
    """The state after a time: fourth order, steps cut where the edge is crossed; six digits with 400 steps a swing."""
    count = max(1, math.ceil(time * math.sqrt(well.pull) / (2 * math.pi) * least))
    inside = math.hypot(*state[:2]) < well.edge
    for _ in range(count):
        left = time / count
        while left > 0:
            after = _runge_kutta(well, state, left, inside)
            if (math.hypot(*after[:2]) < well.edge) == inside:
                state, left = after, 0.0
                continue
            low, high = 0.0, left
            while high - low > 1e-15 * time:
                middle = 0.5 * (low + high)
                here = math.hypot(*_runge_kutta(well, state, middle, inside)[:2]) < well.edge
                low, high = (middle, high) if here == inside else (low, middle)
                if middle in (0.0, left):
                    break
            state, left, inside = _runge_kutta(well, state, high, inside), left - high, not inside
    return state


def _runge_kutta(well: Well, state: State, dt: float, inside: bool) -> State:
    def slope(s: Sequence[float]) -> State:
        x, y, u, w = s
        r = math.hypot(x, y)
        pull = -well.pull * (r - well.b) / r if inside else 0.0
        return u, w, pull * x, pull * y

    def shifted(slopes: State, step: float) -> list[float]:
        return [value + step * change for value, change in zip(state, slopes, strict=True)]

    one = slope(state)
    two = slope(shifted(one, dt / 2))
    three = slope(shifted(two, dt / 2))
    four = slope(shifted(three, dt))
    x, y, u, w = (
        s + dt / 6 * (a + 2 * b + 2 * c + d)
        for s, a, b, c, d in zip(state, one, two, three, four, strict=True)
    )
    return x, y, u, w


def stepped(well: Well, state: State, time: float, steps: int) -> State:
    """The state after a time by the book's method."""

    def acceleration(x: Sequence[float], v: Sequence[float]) -> list[float]:
        r = math.hypot(*x)
        pull = -well.pull * (r - well.b) / r if r < well.edge else 0.0
        return [pull * x[0], pull * x[1]]

    path = march(EULER_CROMER, acceleration, state[:2], state[2:], time / steps, steps)
    (x, y), (u, w) = path.places[-1], path.velocities[-1]
    return x, y, u, w


def forward_euler(well: Well, state: State, time: float, steps: int) -> State:
    """The same with the position stepped by the old velocity."""
    x, y, u, w = state
    dt = time / steps
    for _ in range(steps):
        r = math.hypot(x, y)
        pull = -well.pull * (r - well.b) / r if r < well.edge else 0.0
        x, y, u, w = x + u * dt, y + w * dt, u + pull * x * dt, w + pull * y * dt
    return x, y, u, w


def turned(state: State, angle: float) -> State:
    """Place and velocity turned about the molecule."""
    x, y, u, w = state
    c, s = math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y, c * u - s * w, s * u + c * w
