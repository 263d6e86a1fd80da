"""Students' programs for an atom near a molecule, before and after it catches another one: how they are judged."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from corollary.derive.said import Said

TOLERANCE = 0.01  # of b, or of the distance when it is larger: the book's method errs by a fifth of it at the steps asked for
EULER = "this is forward Euler: the position is stepped with the old velocity, and energy grows. Step the velocity first."
Given = Mapping[str, float]
Draw = Callable[[float, float], float]
State = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Well:
    """Acceleration -pull (r - b) along the radius for r < edge, none beyond; `pull` is k/m."""

    pull: float
    b: float
    edge: float


def well_of(inputs: Mapping[str, Any]) -> Well:
    return Well(inputs["k"] / inputs["m"], inputs["b"], inputs["b"] + inputs["d"])


def orbit_inputs(given: Given, draw: Draw) -> list[dict[str, Any]]:
    """Bound and started across the radius; bound and oblique; past the molecule from outside; away over the edge."""
    inputs = []
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
        period = 2 * math.pi / omega
        case = {"m": m, "k": k, "b": b, "d": d, "x": x, "y": y, "vx": vx, "vy": vy}
        inputs.append(case | {"T": round(1.6 * period, 4), "dt": period / 1000})
    return inputs


def judge_orbit(given: Given, inputs: Mapping[str, Any], returned: Sequence[float]) -> Said | None:
    """The place of the atom at the time T: against small exact steps, then against the usual wrong programs."""
    well, start = well_of(inputs), _start(inputs)
    reference = moved(well, start, inputs["T"])
    steps = round(inputs["T"] / inputs["dt"])
    pull, b, edge = well.pull, well.b, well.edge
    wrong = {
        "the force pushes away from the distance b. Outside b it must pull inwards: there is a minus sign.": Well(-pull, b, edge),
        "the atom is still pulled back beyond b + d. There the potential energy is constant: no force.": Well(pull, b, math.inf),
        "the force pulls to the molecule itself, as if b were 0. The spring is relaxed at the distance b.": Well(pull, 0.0, edge),
        "the mass is missing: the acceleration is the force divided by m.": Well(pull * inputs["m"], b, edge),
    }
    usual = {sentence: stepped(other, start, inputs["T"], steps) for sentence, other in wrong.items()}
    usual[EULER] = stepped(well, start, inputs["T"], steps, euler=True)
    return _judged(returned, reference, usual, b)


def catch_inputs(given: Given, draw: Draw) -> list[dict[str, Any]]:
    """A comes from outside and meets B at r = b, once along a radius, twice obliquely; `t1` is a whole number of steps."""
    inputs = []
    for aside in (0.0, 0.3, 0.6):
        m, k, b = round(draw(0.5, 4.0), 2), round(draw(40, 300)), round(draw(0.8, 1.6), 2)
        d = round(draw(0.35, 0.6) * b, 3)
        omega = math.sqrt(k / m)
        x, y, vx, vy = (round(each, 4) for each in (b + 1.6 * d, aside * b, -draw(0.5, 0.9) * omega * d, 0.0))
        case = {"m": m, "k": k, "b": b, "d": d, "x": x, "y": y, "vx": vx, "vy": vy}
        t1 = _arrival(well_of(case), (x, y, vx, vy))
        dt = t1 / round(t1 * omega * 160)
        inputs.append(case | {"t1": t1, "T": t1 + dt * round(5.0 / omega / dt), "dt": dt})
    return inputs


def judge_catch(given: Given, inputs: Mapping[str, Any], returned: Sequence[float]) -> Said | None:
    """The place of both atoms at the time T, when A has met B at rest at the time t1."""
    well, met, left = well_of(inputs), moved(well_of(inputs), _start(inputs), inputs["t1"]), inputs["T"] - inputs["t1"]
    x, y, u, w = met
    joined, elastic = (x, y, u / 2, w / 2), (x, y, u / math.sqrt(2), w / math.sqrt(2))
    half, twice = Well(well.pull / 2, well.b, well.edge), Well(well.pull * 2, well.b, well.edge)
    usual = {
        "the velocity is not changed by the collision. B was at rest: momentum is shared by both.": moved(well, met, left),
        "you kept the kinetic energy. The atoms stick: momentum is kept, kinetic energy is not.": moved(well, elastic, left),
        "the mass has doubled, but not the force. The molecule pulls on A and on B.": moved(half, joined, left),
        "the force has doubled, but not the mass. The pair has the mass of two atoms.": moved(twice, joined, left),
    }
    return _judged(returned, moved(well, joined, left), usual, inputs["b"])


def _judged(returned: Sequence[float], reference: State, usual: Mapping[str, State], b: float) -> Said | None:
    if len(returned) != 2:
        return Said(f"It returns {len(returned)} numbers; return the pair (x, y).")
    allowed = TOLERANCE * max(b, math.hypot(*reference[:2]))
    if math.dist(returned, reference[:2]) <= allowed:
        return None
    for sentence, state in usual.items():
        if math.dist(returned, state[:2]) <= allowed:
            return Said(f"At the time T {sentence}", known=True)
    return Said("The atom is not where it should be at the time T. Check the force on both sides of r = b, beyond b + "
                "d, and that you reach T.")


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
    x, y, u, w = (s + dt / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, one, two, three, four, strict=True))
    return x, y, u, w


def stepped(well: Well, state: State, time: float, steps: int, euler: bool = False) -> State:
    """The state after a time by Euler-Cromer's method, or by forward Euler's, as a student's program finds it."""
    x, y, u, w = state
    dt = time / steps
    for _ in range(steps):
        r = math.hypot(x, y)
        pull = -well.pull * (r - well.b) / r if r < well.edge else 0.0
        if euler:
            x, y, u, w = x + u * dt, y + w * dt, u + pull * x * dt, w + pull * y * dt
        else:
            u, w = u + pull * x * dt, w + pull * y * dt
            x, y = x + u * dt, y + w * dt
    return x, y, u, w


def turned(state: State, angle: float) -> State:
    """Place and velocity turned about the molecule."""
    x, y, u, w = state
    c, s = math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y, c * u - s * w, s * u + c * w


def _arrival(well: Well, start: State) -> float:
    """When an atom from outside first reaches r = b, by halving."""
    x, y, u, _ = start
    low = (x - math.sqrt(well.edge**2 - y**2)) / -u
    high = low + 2 * math.pi / math.sqrt(well.pull)
    grid = [low + (high - low) * i / 200 for i in range(201)]
    first = next(time for time in grid if math.hypot(*moved(well, start, time)[:2]) < well.b)
    low, high = first - (high - low) / 200, first
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if math.hypot(*moved(well, start, middle)[:2]) < well.b else (middle, high)
    return high


def _start(inputs: Mapping[str, Any]) -> State:
    return inputs["x"], inputs["y"], inputs["vx"], inputs["vy"]
