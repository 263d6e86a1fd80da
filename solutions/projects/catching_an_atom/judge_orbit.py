"""An atom in the plane of a molecule: its motion, what students' programs are called with, and how they are judged."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from corollary.programs import (
    EULER,
    EULER_CROMER,
    N_,
    NAMED,
    RK4,
    STEPS,
    Called,
    Draw,
    Family,
    Fault,
    Given,
    Inputs,
    Path,
    Remark,
    Standard,
    catalogue,
    halved,
    judged,
    march,
    measured,
    miscounted,
)

_ = catalogue(__file__)

State = tuple[float, float, float, float]
FORWARD_EULER = N_(
    "this is forward Euler: the position is stepped with the old velocity, and energy grows. Step the velocity first."
)


@dataclass(frozen=True, slots=True)
class Pull:
    """Acceleration -stiffness (r - b) along the radius for r < edge, none beyond; `stiffness` is k/m."""

    stiffness: float
    b: float
    edge: float

    def within(self, x: Sequence[float], v: Sequence[float]) -> list[float]:
        """As if there were no edge."""
        r = math.hypot(*x)
        return [-self.stiffness * (r - self.b) / r * place for place in x]

    def acceleration(self, x: Sequence[float], v: Sequence[float]) -> list[float]:
        return self.within(x, v) if math.hypot(*x) < self.edge else [0.0, 0.0]


Walk = Callable[[Pull, State, float, int], State]  # a method: the state after a time, in so many steps


def pull_of(inputs: Inputs) -> Pull:
    return Pull(inputs["k"] / inputs["m"], inputs["b"], inputs["b"] + inputs["d"])


def start_of(inputs: Inputs) -> State:
    return inputs["x"], inputs["y"], inputs["vx"], inputs["vy"]


def half_a_swing(pull: Pull) -> float:
    """From r = b out and back: as long as the atom is pulled in on a line, and what steps are counted in."""
    return math.pi / math.sqrt(pull.stiffness)


def moved(pull: Pull, state: State, time: float, least: int = 400) -> State:
    """The state after a time: fourth order, steps cut where the edge is crossed; six digits with 400 steps a swing."""
    count = max(1, math.ceil(time * math.sqrt(pull.stiffness) / (2 * math.pi) * least))
    inside = math.hypot(*state[:2]) < pull.edge
    for _ in range(count):
        left = time / count
        while left > 0:
            after = _step(pull, state, left, inside)
            if (math.hypot(*after[:2]) < pull.edge) is inside:
                state, left = after, 0.0
                continue
            low, high = 0.0, left
            while high - low > 1e-15 * time:
                middle = 0.5 * (low + high)
                here = math.hypot(*_step(pull, state, middle, inside)[:2]) < pull.edge
                low, high = (middle, high) if here is inside else (low, middle)
                if middle in (0.0, left):
                    break
            state, left, inside = _step(pull, state, high, inside), left - high, not inside
    return state


def _step(pull: Pull, state: State, dt: float, inside: bool) -> State:
    """One step of fourth order, by the law on one side of the edge."""
    if not inside:
        x, y, u, w = state
        return x + u * dt, y + w * dt, u, w
    return _end(march(RK4, pull.within, state[:2], state[2:], dt, 1))


def stepped(pull: Pull, state: State, time: float, steps: int) -> State:
    """The state after a time by the book's method."""
    return _end(march(EULER_CROMER, pull.acceleration, state[:2], state[2:], time / steps, steps))


def forward_euler(pull: Pull, state: State, time: float, steps: int) -> State:
    """The same with the position stepped by the old velocity."""
    return _end(march(EULER, pull.acceleration, state[:2], state[2:], time / steps, steps))


def _end(path: Path) -> State:
    (x, y), (u, w) = path.places[-1], path.velocities[-1]
    return x, y, u, w


def turned(state: State, angle: float) -> State:
    """Place and velocity turned about the molecule."""
    x, y, u, w = state
    c, s = math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y, c * u - s * w, s * u + c * w


def orbit_inputs(given: Given, draw: Draw) -> list[Inputs]:
    """Bound and started across the radius; bound and oblique; past the molecule from outside; away over the edge."""
    cases: list[Inputs] = []
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
    pull, start, T = pull_of(inputs), start_of(inputs), inputs["T"]
    return place_standard(pull, moved(pull, start, T), lambda dt: stepped(pull, start, T, round(T / dt)))


def place_standard(pull: Pull, truth: State, book: Callable[[float], State]) -> Standard:
    """Places against the distance b, or the distance from the molecule when it is larger. First order: the atom is still pulled."""
    contact, scale = half_a_swing(pull), max(pull.b, math.hypot(*truth[:2]))

    def errors(found: Sequence[float]) -> tuple[float, ...]:
        return (math.dist(found, truth[:2]) / scale,)

    return Standard(errors, measured(1, lambda steps: errors(book(contact / steps)[:2])), contact)


def _wrong(called: Called) -> Fault:
    inputs = called.inputs
    pull, start = pull_of(inputs), start_of(inputs)
    steps = round(inputs["T"] / inputs["dt"])
    stiffness, b, edge = pull.stiffness, pull.b, pull.edge
    wrong = {
        _(
            "the force pushes away from the distance b. Outside b it must pull inwards: there is a minus sign."
        ): Pull(-stiffness, b, edge),
        _(
            "the atom is still pulled back beyond b + d. There the potential energy is constant: no force."
        ): Pull(stiffness, b, math.inf),
        _(
            "the force pulls to the molecule itself, as if b were 0. The spring is relaxed at the distance b."
        ): Pull(stiffness, 0.0, edge),
        _("the mass is missing: the acceleration is the force divided by m."): Pull(
            stiffness * inputs["m"], b, edge
        ),
    }
    usual = {sentence: stepped(other, start, inputs["T"], steps) for sentence, other in wrong.items()}
    usual[_(FORWARD_EULER)] = forward_euler(pull, start, inputs["T"], steps)
    return named(called, usual)


def misfit(called: Called) -> str:
    return miscounted(called, 2, _("the pair (x, y)"))


def named(called: Called, usual: Mapping[str, State]) -> Fault:
    """The usual wrong program that ends nearest, when it ends near."""
    sentence, end = min(usual.items(), key=lambda item: math.dist(called.returned, item[1][:2]))
    if math.dist(called.returned, end[:2]) <= NAMED * max(called.inputs["b"], math.hypot(*end[:2])):
        return Fault(_("At the time T {sentence}", sentence=sentence), known=True)
    return Fault(
        _(
            "The atom is not where it should be at the time T. Check the force on both sides of r = b, beyond b + d, and that you reach T."
        )
    )


ORBIT = Family(misfit, _standard, _wrong)
