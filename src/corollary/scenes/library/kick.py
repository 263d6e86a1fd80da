"""A body pushed for a short time: what the push does to its velocity (exercises 12.5 and 12.6)."""

from __future__ import annotations

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.models.certain import ComplexBall, Evaluated, by_formulas, integral

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


SCENE = by_formulas("a body pushed for a short time by a force of given mean", SETTINGS, _evaluated)
