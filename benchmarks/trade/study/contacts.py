"""Two families with Hertz contacts: three touching balls of drawn masses in a row; two spheres that hit aside, damped.

Their references are in `references.json`, found in 34 digits by `reference_runs.py`.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from random import Random

import numpy as np

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import regularised
from corollary.scenes.line_collision import collide
from corollary.scenes.plan import play
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .problem import Event, Found, Mode, Problem, Truth, halves, nothing, of_run

REFERENCES = Path(__file__).parent / "references.json"
STIFFNESS, SPEED, SIZE = 1e4, 1.0, 0.04
V, X = Observable.VELOCITIES, Observable.TRAJECTORY


def masses_of(draw: int) -> tuple[float, ...]:
    """Of three balls, in kg."""
    chance = Random(f"row {draw}")
    return tuple(round(0.1 * 2.0 ** chance.uniform(-1.0, 1.0), 4) for _ in range(3))


def spheres_of(draw: int) -> dict[str, float]:
    """Masses (kg), how far aside in units of the reach, damping (kg/s)."""
    chance = Random(f"spheres {draw}")
    drawn = {
        "ma": chance.uniform(0.05, 0.2),
        "mb": chance.uniform(0.05, 0.2),
        "aside": chance.uniform(0.1, 0.9),
    }
    return {name: round(value, 4) for name, value in (drawn | {"eta": chance.uniform(0.2, 3.0)}).items()}


def known(family: str, draw: int) -> dict[str, list[list[str]]]:
    return json.loads(REFERENCES.read_text(encoding="utf-8"))[family][draw]


def truth_of(found: dict) -> Truth:
    return Truth(
        np.array([float(v) for v in found["velocities"]]),
        np.array([[float(x) for x in row] for row in found["places"]]),
        16,
    )


def touches(values: list[Callable], mode: Mode) -> list[Event]:
    """Overlaps that begin where they are not and end where they are; the mode is a bit for each."""

    def event(j: int) -> Event:
        on = bool(mode >> j & 1)
        return Event(values[j], -1 if on else 1, lambda y, mode: (y, mode ^ (1 << j)))

    return [event(j) for j in range(len(values))]


def row_right_side(t, y, p, mode):
    n = y.size // 2
    push = p[0] * np.maximum(y[: n - 1] - y[1:n], 0.0) ** 1.5
    found = np.zeros_like(y)
    found[:n] = y[n:]
    found[n : 2 * n - 1] -= push
    found[n + 1 :] += push
    found[n:] /= p[1:]
    return found


def row(draw: int) -> Problem:
    masses, found = masses_of(draw), known("row", draw)
    times, until = tuple(map(float, found["times"])), float(found["until"])
    rest = [SIZE * i for i in range(3)]
    bodies = tuple(
        Body(m, (x,), (SPEED * (i == 0),), SIZE / 2)
        for i, (m, x) in enumerate(zip(masses, rest, strict=True))
    )
    contact = Contact(STIFFNESS, 1.5)
    balls = RowOfBodies(masses, (SPEED, 0.0, 0.0), (0.0, 0.0), (contact,) * 2)

    def planned(tolerance: float) -> Found:
        collide.cache_clear()
        return of_run(play(Scene(bodies, (contact,)), {V}, tolerance), SPEED, slice(0, 3), slice(0, 0), 3, 0)

    def watched(tolerance: float) -> Found:
        run = play(Scene(bodies, (contact,), until=until), {V, X}, tolerance, times)
        made = of_run(run, SPEED, slice(0, 3), slice(0, 3), 3, len(times))
        assert made.places is not None
        return Found(made.velocities, made.places - rest, made.evaluations, made.stated, made.notes)

    def as_one_loop(tolerance: float) -> Found:
        passage = regularised.collide(balls, tolerance, compiled=True)
        return Found(np.array(passage.velocities), None, passage.evaluations)

    gaps = [lambda y, j=j: y[j] - y[j + 1] for j in range(2)]
    return Problem(
        "row",
        row_right_side,
        nothing,
        np.array([STIFFNESS, *masses]),
        np.array([0.0, 0.0, 0.0, SPEED, 0.0, 0.0]),
        until,
        times,
        3,
        lambda mode: touches(gaps, mode),
        truth_of(found),
        (0.1 * SPEED**2 / STIFFNESS) ** 0.4,
        SPEED,
        {"planned": planned, "composed": watched, "compiled": as_one_loop},
        lambda y: halves(y)[0],
        lambda y: halves(y)[1],
    )


def spheres_right_side(t, y, p, mode):
    found = np.zeros_like(y)
    found[:4] = y[4:]
    dx, dy = y[2] - y[0], y[3] - y[1]
    distance = math.sqrt(dx * dx + dy * dy)
    overlap = p[2] - distance
    if overlap > 0.0:
        push = p[0] * overlap**1.5 / distance
        fx, fy = push * dx - p[1] * (y[6] - y[4]), push * dy - p[1] * (y[7] - y[5])
        found[4], found[5], found[6], found[7] = -fx / p[3], -fy / p[3], fx / p[4], fy / p[4]
    return found


def spheres(draw: int) -> Problem:
    drawn, found = spheres_of(draw), known("spheres", draw)
    times, until = tuple(map(float, found["times"])), float(found["until"])
    start = (2.0 * SIZE, drawn["aside"] * SIZE)
    bodies = (
        Body(drawn["ma"], (0.0, 0.0), (SPEED, 0.0), SIZE / 2),
        Body(drawn["mb"], start, (0.0, 0.0), SIZE / 2),
    )
    contact = Contact(2.0 * STIFFNESS, 1.5, drawn["eta"])

    def planned(tolerance: float) -> Found:
        return of_run(play(Scene(bodies, (contact,)), {V}, tolerance), SPEED, slice(0, 4), slice(0, 0), 4, 0)

    def watched(tolerance: float) -> Found:
        run = play(Scene(bodies, (contact,), until=until), {V, X}, tolerance, times)
        return of_run(run, SPEED, slice(0, 4), slice(0, 4), 4, len(times))

    def overlap(y):
        return SIZE - math.hypot(y[2] - y[0], y[3] - y[1])

    return Problem(
        "spheres",
        spheres_right_side,
        nothing,
        np.array([2.0 * STIFFNESS, drawn["eta"], SIZE, drawn["ma"], drawn["mb"]]),
        np.array([0.0, 0.0, *start, SPEED, 0.0, 0.0, 0.0]),
        until,
        times,
        0,
        lambda mode: touches([overlap], mode),
        truth_of(found),
        SIZE,
        SPEED,
        {"planned": planned, "composed": watched},
        lambda y: halves(y)[0],
        lambda y: halves(y)[1],
    )
