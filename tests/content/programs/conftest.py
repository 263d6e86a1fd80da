"""Programs as students write them, by several methods: one step of each, for accelerations given by places and velocities."""

from __future__ import annotations

import numpy as np


def euler_cromer(a, x, v, dt):
    v = v + a(x, v) * dt
    return x + v * dt, v


def position_first(a, x, v, dt):
    x = x + v * dt
    return x, v + a(x, v) * dt


def verlet(a, x, v, dt):
    half = v + a(x, v) * dt / 2
    x = x + half * dt
    return x, half + a(x, half) * dt / 2


def midpoint(a, x, v, dt):
    y, u = x + v * dt / 2, v + a(x, v) * dt / 2
    return x + u * dt, v + a(y, u) * dt


def heun(a, x, v, dt):
    u = v + a(x, v) * dt
    y = x + v * dt
    return x + (v + u) * dt / 2, v + (a(x, v) + a(y, u)) * dt / 2


def runge_kutta(a, x, v, dt):
    b = a(x, v)
    c = a(x + v * dt / 2, v + b * dt / 2)
    d = a(x + (v + b * dt / 2) * dt / 2, v + c * dt / 2)
    e = a(x + (v + c * dt / 2) * dt, v + d * dt)
    return x + dt * (v + (b + c + d) * dt / 6), v + (b + 2 * c + 2 * d + e) * dt / 6


def forward_euler(a, x, v, dt):
    return x + v * dt, v + a(x, v) * dt


RIGHT = (euler_cromer, position_first, verlet, midpoint, heun, runge_kutta)


def row(inputs, step=euler_cromer, sign=1.0, both=1.0, dt=None, most=30_000):
    """The velocities of a row of balls when none touch any more."""
    m, k, q = inputs["m"], inputs["k"], inputs["q"]

    def a(x, v):
        force = sign * k * np.clip(x[:-1] - x[1:], 0, None) ** q / m
        return np.append(0.0, force) - both * np.append(force, 0.0)

    v, x, touched = np.zeros(inputs["N"]), np.zeros(inputs["N"]), False
    v[0] = inputs["v0"]
    for _ in range(most):
        with np.errstate(over="ignore", invalid="ignore"):
            x, v = step(a, x, v, dt or inputs["dt"])
        if not np.isfinite(v).all():
            break
        touching = bool((x[:-1] > x[1:]).any())
        if touched and not touching:
            break
        touched = touched or touching
    return v


def two(inputs, force, step=euler_cromer, steps=None):
    """The four velocities of two bodies at T."""
    count = steps or round(inputs["T"] / inputs["dt"])
    masses = np.array([inputs["mA"], inputs["mA"], inputs["mB"], inputs["mB"]])

    def a(x, v):
        fx, fy = force(x[2] - x[0], x[3] - x[1], v[2] - v[0], v[3] - v[1])
        return np.array([fx, fy, -fx, -fy]) / masses

    x, v = np.array([*inputs["rA"], *inputs["rB"]]), np.array([*inputs["vA"], *inputs["vB"]])
    for _ in range(count):
        x, v = step(a, x, v, inputs["T"] / count)
    return v


def bounce(inputs, step=euler_cromer, interpolated=False, weight=1.0, power=1.5):
    """Velocity, largest net force and time of contact of a ball on the floor."""
    m, k, R, g, dt = (inputs[name] for name in ("m", "k", "R", "g", "dt"))

    def a(x, v):
        return k * max(R - x, 0.0) ** power / m - weight * g

    x, v, t, begin, largest = inputs["y0"], inputs["v0"], 0.0, None, 0.0
    for _ in range(400_000):
        y, u = step(a, x, v, dt)
        t += dt
        largest = max(largest, m * a(y, u))
        part = (x - R) / (x - y) if interpolated and y != x else 0.0
        if begin is None and y < R:
            begin = t - dt + part * dt
        if begin is not None and y >= R:
            return (
                [v + part * (u - v), largest, t - dt + part * dt - begin]
                if interpolated
                else [u, largest, t - begin]
            )
        x, v = y, u
    return [v, largest, 0.0]


def in_well(well, state, time, dt, step=euler_cromer):
    """Place and velocity of an atom after a time."""

    def a(x, v):
        r = np.hypot(*x)
        return -well.stiffness * (r - well.b) / r * x if r < well.edge else 0.0 * x

    x, v = np.array(state[:2]), np.array(state[2:])
    for _ in range(round(time / dt)):
        x, v = step(a, x, v, dt)
    return (*x, *v)
