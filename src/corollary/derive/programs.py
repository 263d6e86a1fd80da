"""Students' programs for a row of balls: what they are called with, and how what they return is judged."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any, Literal

import numpy as np

from corollary.derive.said import Said
from corollary.scene.catalogue import run

TOLERANCE = 0.005  # of v0: forty times what the book's method errs at a hundredth of the contact time (1.2e-4)
Scheme = Literal["euler", "one-sided", "attraction"]
Given = Mapping[str, float]


def contact_time(m: float, k: float, q: float, v: float) -> float:
    """How long two equal balls of mass m touch that push each other with k overlap^q and meet at the relative speed v."""
    mu = m / 2
    deepest = (mu * (q + 1) * v**2 / (2 * k)) ** (1 / (q + 1))
    return 2 * math.sqrt(math.pi) * math.gamma(1 + 1 / (q + 1)) / math.gamma(0.5 + 1 / (q + 1)) * deepest / v


def cradle_inputs(given: Given, draw: Callable[[float, float], float]) -> list[dict[str, Any]]:
    """Two, three and four balls, two laws of contact, masses and speeds of the grader's own; a hundredth of the contact time as step."""
    inputs = []
    for balls, q in ((2, 1.0), (3, 1.0), (3, 1.5), (4, 1.5)):
        m, v0 = round(draw(0.05, 0.4), 3), round(draw(0.4, 2.5), 2)
        k = round(draw(4e3, 4e4) if q == 1 else draw(1e6, 1e7), 0)
        inputs.append({"N": balls, "m": m, "k": k, "q": q, "v0": v0, "dt": contact_time(m, k, q, v0) / 100})
    return inputs


def judge_cradle(given: Given, inputs: Mapping[str, Any], returned: Sequence[float]) -> Said | None:
    """Against the reference first; then by what is kept, and by what the usual wrong programs return for the same numbers."""
    balls, v0 = inputs["N"], inputs["v0"]
    if len(returned) != balls:
        return Said(f"For {balls} balls it returns {len(returned)} numbers; return the {balls} velocities.")
    reference = run("cradle", {name: inputs[name] for name in ("N", "m", "k", "q", "v0")}, tolerance=1e-9).observed["velocities"]
    assert isinstance(reference, tuple)
    if _near(returned, reference, v0):
        return None
    case = f"For N = {balls} and q = {inputs['q']:g}"
    for scheme, sentence in USUAL.items():
        wrong = wrong_cradle(scheme, balls, inputs["m"], inputs["k"], inputs["q"], v0, inputs["dt"])
        if wrong is not None and _near(returned, wrong, v0):
            return Said(f"{case}: {sentence}", known=True)
    if _near(returned, [v0] + [0.0] * (balls - 1), v0):
        return Said(
            f"{case} nothing has happened: the first ball still has v0 and the others are at rest. Step until no two balls touch any more."
        )
    if not math.isclose(sum(returned), v0, rel_tol=1e-6):
        return Said(
            f"{case} the total momentum is not kept. What one ball does to its neighbour, the neighbour does to it, the other way.",
            known=True,
        )
    if sum(v * v for v in returned) > v0 * v0 * (1 + 2 * TOLERANCE):
        return Said(
            f"{case} the kinetic energy has grown. Use the new velocity to step the position, or a smaller step.", known=True
        )
    return Said(
        f"{case} momentum is kept, but the velocities are not those of this contact. Check the force law, and that all contacts have ended."
    )


USUAL: dict[Scheme, str] = {
    "euler": "this is forward Euler: the position is stepped with the old velocity, and energy grows. Step the velocity first, then the position with the new velocity.",
    "one-sided": "each ball feels only one of its neighbours. What a ball does to its neighbour, the neighbour does to it: half of the pair forces is missing.",
    "attraction": "the balls pull each other together while they overlap. The force must push them apart: check its sign.",
}


@lru_cache(maxsize=256)
def wrong_cradle(scheme: Scheme, balls: int, m: float, k: float, q: float, v0: float, dt: float) -> tuple[float, ...] | None:
    """The velocities that a wrong program ends with, or None when it never ends."""
    v, x = np.zeros(balls), np.zeros(balls)
    v[0] = v0
    touched = False
    for _ in range(20_000):
        overlap = np.clip(x[:-1] - x[1:], 0, None)
        if touched and not overlap.any():
            return tuple(v)
        touched = touched or bool(overlap.any())
        force = k * overlap**q * (-1 if scheme == "attraction" else 1)
        a = np.zeros(balls)
        if scheme != "one-sided":
            a[:-1] -= force / m
        a[1:] += force / m
        x, v = (x + v * dt, v + a * dt) if scheme == "euler" else (x + (v + a * dt) * dt, v + a * dt)
        if not np.isfinite(x).all() or np.abs(v).max() > 1e6 * v0:
            return None
    return None


def judge_contact(given: Given, inputs: Mapping[str, Any], returned: Sequence[float]) -> Said | None:
    """Whether the pair (k, q) a student found leaves the middle of three touching balls nearly at rest."""
    if len(returned) != 2:
        return Said(f"It returns {len(returned)} numbers; return the pair (k, q).")
    k, q = returned
    if not (k > 0 and 1 <= q <= 10 and math.isfinite(k)):
        return Said("k must be positive, and q between 1 and 10.")
    velocities = run("cradle", {"N": 3, "m": given["m"], "k": k, "q": q, "v0": given["v0"]}, tolerance=1e-6).observed[
        "velocities"
    ]
    assert isinstance(velocities, tuple)
    left = abs(velocities[1]) / given["v0"]
    if left < 0.02:
        return None
    return Said(f"With your k and q the middle ball keeps {left:.0%} of v0; the goal is less than 2 %. Which of the two matters?")


def judge_velocity_plot(given: Given, figures: Sequence[Any], balls: int) -> Said | None:
    """Velocities against time: a curve for each ball, from (v0, 0, …) to where only the last one moves, with labelled axes."""
    v0 = given["v0"]
    for axes in figures:
        curves = [line for line in axes.lines if line.kind in {"line", "points"} and len(line.x) > 10]
        if len(curves) < balls:
            continue
        if missing := [name for name, label, words in (("x", axes.xlabel, "t time zeit tid s"), ("y", axes.ylabel, "v velocity m/s"))
                       if not any(word in label.lower() for word in words.split())]:  # fmt: skip
            return Said(f"The {' and '.join(missing)} axis needs a label that names the quantity and its unit: t [s], v [m/s].")
        starts, ends = sorted(line.y[0] for line in curves[:balls]), [line.y[-1] for line in curves[:balls]]
        if not _near(starts, [0.0] * (balls - 1) + [v0], v0, 0.03):
            return Said(
                f"The curves must start with one ball at v0 = {v0:g} m/s and the other{'s' if balls > 2 else ''} at rest."
            )
        if not _near(sorted(ends), [0.0] * (balls - 1) + [v0], v0, 0.06):
            return Said("The curves must run until the balls have parted; then only the last ball moves with v0.")
        return None
    return Said(f"No axes with a curve for each of the {balls} balls were found; plot every velocity against time.")


def _near(values: Sequence[float], others: Sequence[float], scale: float, tolerance: float = TOLERANCE) -> bool:
    return len(values) == len(others) and math.dist(values, others) <= tolerance * scale
