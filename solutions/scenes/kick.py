"""A body pushed for a short time: what the push does to its velocity (exercises 12.5 and 12.6)."""

from __future__ import annotations

import math

from second_way import second_run, state_after

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.film import Film, film
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.models.certain import ComplexBall, Evaluated, by_formulas, integral
from corollary.scenes.run import Run
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("m", "mass of the body", "kg", 0.43, above=0.0),
    Setting("v0", "velocity before the push", "m/s", 0.0),
    Setting("F", "time-averaged force", "N", 86.0),
    Setting("dt", "time of contact", "s", 0.1, above=0.0),
    Setting(
        "pulse",
        "shape: F(t) goes as sin(pi t/dt)^pulse, 0 for a constant force",
        "1",
        1.0,
        least=0.0,
        most=8.0,
        whole=True,
    ),
)


def _evaluated(m: Ball, v0: Ball, force: Ball, dt: Ball, power: Ball) -> Evaluated:
    """Velocity after the push, impulse, size of the greatest force, and the way made meanwhile: Newton's second law, integrated."""
    whole = round(float(power))
    # The mean of sin^p over half a turn is Gamma((p + 1)/2) / (sqrt(pi) Gamma(p/2 + 1)).
    peak = force * Ball.pi().sqrt() * (power / 2 + 1).gamma() / ((power + 1) / 2).gamma()

    def push(part: ComplexBall) -> ComplexBall:
        return (Ball.pi() * part).sin() ** whole

    impulse = peak * dt * integral(lambda part, _: push(part), Ball(0), Ball(1))
    arm = peak * dt * dt * integral(lambda part, _: push(part) * (1 - part), Ball(0), Ball(1))
    values = {
        "velocities": (v0 + impulse / m,),
        "impulse": impulse,
        "peak_force": abs(peak),
        "way": v0 * dt + arm / m,
    }
    why = "one body, a force given in time: the velocity is an integral over the force"
    return Evaluated("released", values, "quadrature", why)


def second_way(settings: Settings, tolerance: float) -> Run:
    m, v0, force, dt, pulse = numbers(settings, "m", "v0", "F", "dt", "pulse")
    power, nodes = round(pulse), 1000
    # The mean of the pulse by the trapezoidal rule, exact for so smooth a period.
    mean = math.fsum(math.sin(math.pi * i / nodes) ** power for i in range(nodes)) / nodes
    if power % 2:
        mean = math.prod(2.0 * i / (2.0 * i + 1.0) for i in range(1, power // 2 + 1)) * 2.0 / math.pi
    peak = force / mean
    # At most the eighth power of a sine, as long as the scene.
    push = ForceFunction(
        0, lambda t, x, v: (peak * math.sin(math.pi * min(t / dt, 1.0)) ** power,), smooth=True
    )
    (after,), (way,), error = state_after((Body(m, (0.0,), (v0,)),), (push,), dt, tolerance)
    return second_run(
        {"velocities": (after,), "impulse": m * (after - v0), "way": way, "peak_force": abs(peak)},
        error,
        scales={"impulse": m * max(abs(after), abs(v0))},
    )


def filmed(settings: Settings) -> Film:
    m, v0, force, dt, pulse = numbers(settings, "m", "v0", "F", "dt", "pulse")
    power = round(pulse)
    peak = force * math.sqrt(math.pi) * math.gamma(power / 2 + 1) / math.gamma((power + 1) / 2)
    push = ForceFunction(0, lambda t, x, v: (peak * math.sin(math.pi * min(t / dt, 1.0)) ** power,))
    fastest = max(abs(v0), abs(v0 + force * dt / m))
    free = 2.0 * dt
    ball = Body(m, (0.0,), (v0,), name="A")
    return film((ball,), [((), free), ((push,), dt), ((), free)], radii=(0.2 * fastest * dt,))


SCENE = by_formulas(
    "a body pushed for a short time by a force of given mean",
    SETTINGS,
    _evaluated,
    second_way=second_way,
    film=filmed,
)
