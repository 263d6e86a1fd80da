"""Figures of the chapter's programs: a right one is right, and each thing that is missing is named."""

from __future__ import annotations

import math

import numpy as np
import pytest

from corollary.grading.programs.orbit import judge_orbit_plot, judge_potential_plot
from corollary.grading.programs.spheres import judge_spheres_plot
from corollary.sandbox.result import Axes, DrawnLine

ATOM = {"m": 1.0, "k": 1.0, "b": 1.0, "d": 0.5, "v0": 0.2, "eps": 0.5, "epsx": 1.5}


def axes(xlabel: str, ylabel: str, *curves) -> Axes:
    lines = tuple(DrawnLine(tuple(map(float, x)), tuple(map(float, y)), "", "line") for x, y in curves)
    return Axes("", xlabel, ylabel, (0.0, 1.0), (0.0, 1.0), "linear", "linear", (), lines)


def potential(x):
    """A spring of stiffness k about b, cut off at the distance d on the right; written anew from the exercise's text."""
    b, d, k = ATOM["b"], ATOM["d"], ATOM["k"]
    return np.where(x < b + d, k * (x - b) ** 2 / 2, k * d**2 / 2)


X = np.linspace(0.2, 2.2, 401)
DEPTH = ATOM["k"] * ATOM["d"] ** 2 / 2
LEVELS = [((0.2, 2.2), (share * DEPTH, share * DEPTH)) for share in (0.5, 1.5)]


@pytest.mark.parametrize(
    ("figure", "word"),
    [
        (axes("x [m]", "U [J]", (X, potential(X)), *LEVELS), None),
        (axes("x [m]", "U [J]", (X, potential(X)), LEVELS[0]), "above U0"),
        (axes("x [m]", "U [J]", (X, potential(X)), LEVELS[1]), "below U0"),
        (axes("x [m]", "U [J]", (X, 2 * potential(X)), *LEVELS), "bottom"),
        (axes("x [m]", "U [J]", (X, potential(X) + DEPTH / 2), *LEVELS), "bottom"),
        (axes("x [m]", "U [J]", (X, (X - 1) ** 2 / 2), *LEVELS), "bottom"),
        (axes("x [m]", "U [J]", (X[:20], potential(X[:20])), *LEVELS), "more than 20"),
        (axes("x [m]", "", (X, potential(X)), *LEVELS), "labels"),
        (axes("", "U [J]", (X, potential(X)), *LEVELS), "labels"),
        (axes("x [m]", "U [J]"), "No axes"),
    ],
)
def test_the_potential(figure, word):
    found = judge_potential_plot(ATOM, [figure])
    assert (found is None) if word is None else word in found.sentence


def orbit(steps: int = 40_000, dt: float = 1e-3):
    """Verlet in the plane, from (b, 0) across the radius."""
    place, velocity = np.array([ATOM["b"], 0.0]), np.array([0.0, ATOM["v0"]])

    def pull(at):
        r = math.hypot(*at)
        return -ATOM["k"] / ATOM["m"] * (r - ATOM["b"]) * at / r if r < ATOM["b"] + ATOM["d"] else 0 * at

    path = []
    for _ in range(steps):
        path.append(place)
        half = velocity + pull(place) * dt / 2
        place = place + half * dt
        velocity = half + pull(place) * dt / 2
    return np.array(path).T


def test_the_orbit():
    x, y = orbit()
    few = np.linspace(0, len(x) - 1, 400).astype(int)
    assert judge_orbit_plot(ATOM, [axes("x [m]", "y [m]", (x, y))]) is None
    assert judge_orbit_plot(ATOM, [axes("x [m]", "y [m]", (x[few], y[few]))]) is None
    for figure, word in (
        (axes("x [m]", "y [m]", (x[:49], y[:49])), "No trajectory"),
        (axes("x [m]", "y [m]", (x[:50], y[:50])), "greatest distance"),
        (axes("t [s]", "y [m]", (x, y)), "labels"),
        (axes("x [m]", "y [m]", (x + 0.05, y)), "start at (b, 0)"),
        (axes("x [m]", "y [m]", (np.append(x, 0.5), np.append(y, 0.0))), "closer than b"),
        (axes("x [m]", "y [m]", (np.append(x, 1.4), np.append(y, 0.0))), "greatest distance"),
    ):
        found = judge_orbit_plot(ATOM, [figure])
        assert found is not None
        assert word in found.sentence


SPHERES = {"mA": 0.1, "mB": 0.2, "R": 0.03, "k": 1e4, "eta": 0.0}
"""A of 0.1 kg comes along x at 1 m/s and passes B at rest by 0.018 m, less than two radii."""


@pytest.fixture(scope="module")
def hit():
    """Verlet for two balls that push each other with k overlap^1.5 along the line of centres."""
    a, b = np.array([0.0, 0.0]), np.array([0.08, 0.018])
    u, w = np.array([1.0, 0.0]), np.array([0.0, 0.0])
    dt, rows = 5e-6, []

    def push(a, b):
        apart = b - a
        r = math.hypot(*apart)
        return -SPHERES["k"] * max(2 * SPHERES["R"] - r, 0.0) ** 1.5 * apart / r

    force = push(a, b)
    for n in range(20_001):
        if n % 50 == 0:
            rows.append((n * dt, *a, *b, *(SPHERES["mA"] * u), *(SPHERES["mB"] * w)))
        u, w = u + force / SPHERES["mA"] * dt / 2, w - force / SPHERES["mB"] * dt / 2
        a, b = a + u * dt, b + w * dt
        force = push(a, b)
        u, w = u + force / SPHERES["mA"] * dt / 2, w - force / SPHERES["mB"] * dt / 2
    return np.array(rows).T


def test_two_spheres(hit):
    t, ax, ay, bx, by, pax, pay, pbx, pby = hit
    paths = axes("x [m]", "y [m]", (ax, ay), (bx, by))
    along = axes("t [s]", "p_x [kg m/s]", (t, pax), (t, pbx))
    across = axes("t [s]", "p_y [kg m/s]", (t, pay), (t, pby))
    assert judge_spheres_plot(SPHERES, [paths, along, across]) is None
    swapped = axes("t [s]", "p_x [kg m/s]", (t, pbx), (t, pax))
    assert judge_spheres_plot(SPHERES, [across, swapped, paths]) is None
    for figures, words in (
        ([along, across], ("No axes", "trajectories")),
        ([paths, across], ("No axes", "p_x")),
        ([paths, along], ("No axes", "p_y")),
        ([axes("x [m]", "y [m]", (ax, ay)), along, across], ("a curve for A and one for B",)),
        ([axes("x [m]", "y [m]", (ax + 0.01, ay), (bx, by)), along, across], ("trajectories must start",)),
        ([paths, axes("t [s]", "p_x [kg m/s]", (t, pax), (t, pax)), across], ("must start", "B at rest")),
        ([paths, axes("t [s]", "p_x [kg m/s]", (t, pax * 10), (t, pbx)), across], ("A's momentum",)),
        ([paths, axes("t [s]", "p_x [kg m/s]", (t / 2, pax), (t / 2, pbx)), across], ("must run until",)),
        ([paths, along, axes("t [s]", "p_y [kg m/s]", (t, pay / 2), (t, pby / 2))], ("p_y do not end",)),
        ([paths, along, axes("t [s]", "p_y [kg m/s]", (t, pay), (t, pay))], ("p_y do not end",)),
    ):
        found = judge_spheres_plot(SPHERES, figures)
        assert found is not None
        assert all(word in found.sentence for word in words), found.sentence
