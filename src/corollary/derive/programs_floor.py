"""Students' programs for a ball on the floor: what they are called with, and how what they return and draw is judged."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

from corollary.derive.said import Said
from corollary.scene.catalogue import run

STEPS = 200  # steps in a contact
TOLERANCE = 0.012  # with so many steps the book's method errs by 0.006 at most (a soft contact), forward Euler by 0.028 at least
OF_PLOT = 0.03
Scheme = Literal["euler", "weightless", "linear", "floor"]
Given = Mapping[str, float]
ARGUMENTS = ("m", "k", "R", "y0", "v0", "g")


@dataclass(frozen=True, slots=True)
class Bounce:
    """Velocity with which the ball leaves the floor, the largest net force, and how long they touched."""

    velocity: float
    force: float
    duration: float


def bounce_inputs(given: Given, draw: Callable[[float, float], float]) -> list[dict[str, Any]]:
    """A hard quick contact, a long fall before it, and a soft contact in which the weight counts."""
    inputs = []
    for stiffness, mass, speed, fall in (
        ((5e5, 2e6), (0.05, 0.2), (1.5, 4.0), (0.001, 0.01)),
        ((5e5, 2e6), (0.05, 0.2), (0.8, 1.5), (0.2, 0.5)),
        ((2e4, 5e4), (0.3, 0.6), (0.3, 0.6), (0.001, 0.003)),
    ):
        R = round(draw(0.015, 0.04), 3)
        numbers = {"m": round(draw(*mass), 3), "k": round(draw(*stiffness), -2), "R": R, "y0": round(R + draw(*fall), 4),
                   "v0": round(-draw(*speed), 2), "g": 9.8}  # fmt: skip
        inputs.append(numbers | {"dt": reference(*(numbers[name] for name in ARGUMENTS)).duration / STEPS})
    return inputs


@lru_cache(maxsize=256)
def reference(m: float, k: float, R: float, y0: float, v0: float, g: float) -> Bounce:
    """What a program must find, from the energy integral."""
    seen = run("ball_on_floor", {"m": m, "k": k, "q": 1.5, "R": R, "y0": y0, "v0": v0, "g": g}, tolerance=1e-12).observed
    speed, force, duration = seen["rebound_speed"], seen["peak_force"], seen["duration"]
    assert isinstance(speed, float)
    assert isinstance(force, float)
    assert isinstance(duration, float)
    return Bounce(speed, force - m * g, duration)


def judge_bounce(given: Given, inputs: Mapping[str, Any], returned: Sequence[float]) -> Said | None:
    """Against the reference first; then by what the usual wrong programs return for the same numbers."""
    if len(returned) != 3:
        many = "one number" if len(returned) == 1 else f"{len(returned)} numbers"
        return Said(f"It returns {many}; return three: the velocity v, the largest net force F, and the time of contact T.")
    numbers = [inputs[name] for name in ARGUMENTS]
    truth, step = reference(*numbers), inputs["dt"]
    if _meets(returned, truth, step):
        return None
    for scheme, sentence in USUAL.items():
        wrong = wrong_bounce(scheme, *numbers, step)
        if wrong is not None and _meets(returned, wrong, step):
            return Said(sentence, known=True)
    v, force, _ = returned
    if math.isclose(v, numbers[4], rel_tol=1e-9):
        return Said("The velocity is still the one at the start: step until the ball has touched the floor and left it again.")
    if v < 0 and abs(v + truth.velocity) <= TOLERANCE * truth.velocity:
        return Said("The velocity is negative, as on the way down: step until the ball has left the floor again.", known=True)
    if abs(v - truth.velocity) > TOLERANCE * truth.velocity:
        return Said("The ball leaves the floor with a wrong velocity. No energy is lost here: check force and order of steps.")
    if abs(force - truth.force) > TOLERANCE * truth.force:
        return Said("The velocity is right, the largest net force is not: it is the largest value of N - m g in the contact.")
    return Said("Velocity and force are right, the time of contact is not: count only the time in which the ball is below y = R.")


USUAL: dict[Scheme, str] = {
    "euler": "This is forward Euler: the position is stepped with the old velocity, and energy grows. "
             "Step the velocity first, then the position with the new velocity.",
    "weightless": "Gravity is missing: the net force is N - m g, also while the ball is above the floor.",
    "linear": "The floor pushes here like a spring, in proportion to R - y. Its force goes with the power 3/2.",
    "floor": "Velocity and time are right, but the force is that of the floor; the net force is smaller by the weight.",
}  # fmt: skip


@lru_cache(maxsize=256)
def wrong_bounce(scheme: Scheme, m: float, k: float, R: float, y0: float, v0: float, g: float, dt: float) -> Bounce | None:
    """What a wrong program ends with, or None when it never ends."""
    y, v, largest, below = y0, v0, 0.0, 0
    pull = 0.0 if scheme == "weightless" else m * g
    for _ in range(200_000):
        overlap = R - y
        if overlap > 0:
            below += 1
        elif below:
            return Bounce(v, largest, below * dt)
        push = k * overlap ** (1.0 if scheme == "linear" else 1.5) if overlap > 0 else 0.0
        largest = max(largest, push - (0.0 if scheme == "floor" else pull))
        a = (push - pull) / m
        y, v = y + (v if scheme == "euler" else v + a * dt) * dt, v + a * dt
    return None


def judge_bounce_plot(given: Given, figures: Sequence[Any]) -> Said | None:
    """Net force and momentum against time, each with labelled axes, from before the contact till after it."""
    m, g = given["m"], given["g"]
    truth = reference(*(given[name] for name in ARGUMENTS))
    weight, momentum = m * g, m * truth.velocity
    off, odd = OF_PLOT * truth.force, OF_PLOT * momentum
    force = _curve(figures, lambda y: abs(max(y) - truth.force) <= off and abs(min(y) + weight) <= off)
    if force is None:
        return Said("There is no curve of the net force for your numbers: from -m g to the largest net force, and back.")
    if abs(force[1][-1] + weight) > off or abs(force[1][0] + weight) > off:
        return Said("The curve of the net force must begin before the ball touches the floor and end after it has left it.")
    if abs(force[1][0] + weight) > 0.2 * weight:
        return Said("At the start only gravity acts, and the net force is -m g; you drew the force of the floor.", known=True)
    path = _curve(figures, lambda y: abs(min(y) + momentum) <= odd and abs(max(y) - momentum) <= odd)
    if path is None:
        return Said("There is no curve of the momentum p(t) for your numbers: from m v at the first touch to the opposite value.")
    for (axes, _), name, words in ((force, "F [N]", "f force kraft"), (path, "p [kg m/s]", "p momentum")):
        if not _named(axes.xlabel, "t time zeit tid s"):
            return Said("The x axis needs a label that names the quantity and its unit: t [s].")
        if not _named(axes.ylabel, words):
            return Said(f"The y axis needs a label that names the quantity and its unit: {name}.")
    return None


def _curve(figures: Sequence[Any], fits: Callable[[Sequence[float]], bool]) -> tuple[Any, Sequence[float]] | None:
    """The first curve of many points whose heights fit, with its axes."""
    for axes in figures:
        for line in axes.lines:
            if line.kind in {"line", "points"} and len(line.y) > 20 and all(map(math.isfinite, line.y)) and fits(line.y):
                return axes, line.y
    return None


def _named(label: str, words: str) -> bool:
    return any(word in label.lower() for word in words.split())


def _meets(returned: Sequence[float], wanted: Bounce, step: float) -> bool:
    v, force, duration = returned
    return (
        abs(v - wanted.velocity) <= TOLERANCE * wanted.velocity
        and abs(force - wanted.force) <= TOLERANCE * wanted.force
        and abs(duration - wanted.duration) <= 2.5 * step  # a contact counted in steps may be one longer or shorter at each end
    )

