"""Students' programs for a damped swing: what they are called with, and how they are judged."""

from __future__ import annotations

import math

from corollary.programs import (
    EULER,
    EULER_CROMER,
    NAMED,
    STEPS,
    Family,
    Fault,
    Standard,
    halved,
    judged,
    march,
    measured,
    miscounted,
)

NAMES = ("m", "k", "b", "x", "v", "T")


def swing_inputs(given, draw):
    """Drawn aside and let go, and pushed; for one to two swings, in steps of a hundredth of half a swing."""
    cases = []
    for push in (0.0, 0.6, -0.9):
        m, k, x = round(draw(0.2, 1.0), 2), round(draw(4.0, 20.0), 1), round(draw(0.05, 0.2), 2)
        omega = math.sqrt(k / m)
        b, v = round(draw(0.1, 0.3) * m * omega, 3), round(push * x * omega, 3)
        count = round(STEPS * draw(2.0, 4.0))
        dt = math.pi / omega / STEPS
        cases.append({"m": m, "k": k, "b": b, "x": x, "v": v, "T": count * dt, "dt": dt})
    return halved(cases)


def judge_swing(given, called):
    return judged(SWING, called)


def moved(m, k, b, x, v, T):
    """Place and velocity after the time T, by the formula of a damped swing."""
    delta = b / (2 * m)
    omega = math.sqrt(k / m - delta**2)
    fade, c, s = math.exp(-delta * T), math.cos(omega * T), math.sin(omega * T)
    return (
        fade * (x * c + (v + delta * x) / omega * s),
        fade * (v * c - (delta * v + k / m * x) / omega * s),
    )


def stepped(m, k, b, x, v, T, dt, method=EULER_CROMER):
    path = march(method, lambda x, v: [-(k * x[0] + b * v[0]) / m], [x], [v], dt, round(T / dt))
    return path.places[-1][0], path.velocities[-1][0]


def apart(inputs, found, truth):
    """How far two states are from each other, in parts of the first amplitude and of its velocity."""
    omega = math.sqrt(inputs["k"] / inputs["m"])
    amplitude = math.hypot(inputs["x"], inputs["v"] / omega)
    return math.hypot(found[0] - truth[0], (found[1] - truth[1]) / omega) / amplitude


def standard(inputs):
    numbers = [inputs[name] for name in NAMES]
    half = math.pi / math.sqrt(inputs["k"] / inputs["m"])

    def book(steps):
        # As many whole steps as come nearest to T: the truth is taken at their end.
        count = round(inputs["T"] / half * steps)
        found = stepped(*numbers[:5], count * half / steps, half / steps)
        return (apart(inputs, found, moved(*numbers[:5], count * half / steps)),)

    return Standard(lambda found: (apart(inputs, found, moved(*numbers)),), measured(1, book), half)


def wrong(called):
    m, k, b, x, v, T = (called.inputs[name] for name in NAMES)
    dt = called.inputs["dt"]
    usual = {
        "The drag is missing: the velocity changes by -(k x + b v)/m dt.": stepped(m, k, 0.0, x, v, T, dt),
        "The drag drives the swing: it must act against the velocity.": stepped(m, k, -b, x, v, T, dt),
        "This is forward Euler, and its energy grows: step the velocity first, then the place with the new one.": stepped(
            m, k, b, x, v, T, dt, EULER
        ),
    }
    for sentence, end in usual.items():
        size = max(1.0, apart(called.inputs, end, (0.0, 0.0)))
        if apart(called.inputs, called.returned, end) <= NAMED * size:
            return Fault(sentence, known=True)
    return Fault(
        "Place and velocity after the time T are not right: check the two forces, and that you reach T."
    )


SWING = Family(lambda called: miscounted(called, 2, "the pair of place and velocity (x, v)"), standard, wrong)
