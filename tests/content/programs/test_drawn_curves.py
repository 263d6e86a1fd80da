"""Figures of the chapter as curves: from where they must begin, to where they must end, and as many as there are bodies."""

import math

import numpy as np
from tests.judges import judges

from corollary.derive.statements import Fault
from corollary.grading.programs.convergence import Called
from corollary.sandbox.job import Axes, DrawnLine

(judge_bounce_plot,) = judges("impulse/ball_on_the_floor_program/judge_bounce_plot.py", "judge_bounce_plot")
(judge_orbit_plot,) = judges("projects/catching_an_atom/judge_orbit_plot.py", "judge_orbit_plot")
(judge_velocity_plot,) = judges("projects/newtons_cradle/judge_velocity_plot.py", "judge_velocity_plot")


def axes(x_label, y_label, *curves):
    """One pair of axes with a line for each (x, y)."""
    ends = (0.0, 1.0)
    lines = tuple(DrawnLine(tuple(map(float, x)), tuple(map(float, y)), "", "line") for x, y in curves)
    return [Axes("", x_label, y_label, ends, ends, "linear", "linear", (), lines)]


ATOM = {"m": 1.5, "k": 90.0, "b": 1.2, "d": 0.5, "v0": 1.7}


def trajectory(swings):
    """Two columns: the places of the atom by steps of second order, as fine as a thousandth of a swing."""
    stiffness, b = ATOM["k"] / ATOM["m"], ATOM["b"]
    dt = 2 * math.pi / math.sqrt(stiffness) / 1000
    r, v, places = np.array([b, 0.0]), np.array([0.0, ATOM["v0"]]), []
    for _ in range(round(1000 * swings)):
        places.append(r)
        half = r + v * dt / 2
        length = math.hypot(*half)
        v = v - stiffness * (length - b) * half / length * dt
        r = half + v * dt / 2
    return np.array(places).T


def test_a_trajectory_begins_where_the_atom_starts():
    x, y = trajectory(4.0)
    assert judge_orbit_plot(ATOM, axes("x [m]", "y [m]", (x, y))) is None
    turned = np.arctan2(y, x)
    begun = next(at for at, angle in enumerate(turned) if angle > 0.045)
    late = judge_orbit_plot(ATOM, axes("x [m]", "y [m]", (x[begun:], y[begun:])))
    assert isinstance(late, Fault)
    assert late.sentence == "The trajectory must start at (b, 0)."


ROW = {"m": 0.1, "k": 1e4, "v0": 0.3}


def velocities(times=1.3, v0=ROW["v0"], first=1.0):
    """Two balls with a linear spring between them exchange their velocities as half a swing of a cosine."""
    lasts = math.pi * math.sqrt(ROW["m"] / 2 / ROW["k"])
    t = np.linspace(0.0, times * lasts, 500)
    a = np.where(t < lasts, first * v0 / 2 * (1 + np.cos(math.pi * t / lasts)), 0.0)
    return (t, a), (t, v0 - a)


def said(*curves, called=None, balls=2):
    found = judge_velocity_plot(ROW, axes("t [s]", "v [m/s]", *curves), balls, called)
    return found.sentence if found is not None else ""


def test_the_velocities_of_two_balls_are_told_by_their_number_their_beginnings_and_their_ends():
    assert said(*velocities()) == ""
    assert said(velocities()[0]).startswith("No axes with a curve for each of the 2 balls were found")
    slow = (velocities()[0][0], 0.8 * velocities()[0][1])
    assert said(slow, velocities()[1]) == (
        "The curves must start with one ball at v0 = 0.3 m/s and the other at rest."
    )
    assert said(*velocities(times=0.6)).startswith("The curves must run until the balls have parted")
    (t, _a), (_, _b) = velocities()
    bent = ROW["v0"] * np.clip(t / t[-1] * 1.3, 0.0, 1.0) ** 3
    assert said((t, ROW["v0"] - bent), (t, bent)).startswith("The velocities begin and end well")


def test_a_steep_contact_runs_until_the_balls_have_parted():
    """With F = k x^6 the first ball of two ends at rest as with any other law, and the other has v0."""
    called = [Called({}, (1e18, 6.0))]
    stiff, q, m, v0, dt = 1e18, 6.0, ROW["m"], ROW["v0"], 0.0
    reach = ((q + 1) * m / 2 * v0**2 / 2 / stiff) ** (1 / (q + 1))
    dt = reach / v0 / 300
    x, v, rows = np.zeros(2), np.array([v0, 0.0]), []
    for step in range(4000):
        rows.append((step * dt, *v))
        force = stiff * max(x[0] - x[1], 0.0) ** q
        v = v + np.array([-force, force]) / m * dt
        x = x + v * dt
        if step > 100 and x[0] < x[1] - 0.3 * reach:
            break
    t, a, b = np.array(rows).T
    assert said((t, a), (t, b), called=called) == ""
    cut = a > 0.5 * v0
    assert "parted" in said((t[cut], a[cut]), (t[cut], b[cut]), called=called)


def test_what_is_missing_is_called_by_what_it_shows():
    """Without labels it is the labels of the force that are asked for first, then those of the momentum."""
    given = {"m": 0.1, "k": 1e6, "R": 0.02, "y0": 0.021, "v0": -2.8, "g": 9.8}
    none = judge_bounce_plot(given, [])
    assert isinstance(none, Fault)
    assert none.sentence.startswith("No axes were found that show the net force against time.")
