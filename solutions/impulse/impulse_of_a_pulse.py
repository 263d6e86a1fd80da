"""Impulse of a pulse: the area under the curve, and the rectangle of the same area."""

import sympy

from corollary.author import derivation, mistake, simulate, step, unknown, unknowns
from corollary.laws import impulse_of, mean_force, wrong


def derive(F0, T):
    J_s, F_s, J_t, F_t = unknowns("J_s F_s J_t F_t")
    t = unknown("t")
    sine, rising, falling = F0 * sympy.sin(sympy.pi * t / T), 2 * F0 * t / T, 2 * F0 * (1 - t / T)
    return derivation(
        step(
            J_s,
            "The impulse is the integral of the force over the time: $J = \\int_0^T F_0\\sin(\\pi t/T)\\,dt "
            "= F_0\\left[-\\frac{T}{\\pi}\\cos\\frac{\\pi t}{T}\\right]_0^T$.",
            impulse_of(J_s, t, (sine, 0, T)),
            answers="a",
            mistakes=[
                mistake(
                    "You took the largest force for the whole time; the force is smaller before and after.",
                    impulse_of(J_s, t, (F0, 0, T)),
                ),
                mistake(
                    "Half of base times height is the area of a triangle; under the sine there is more.",
                    impulse_of(J_s, t, (rising, 0, T / 2), (falling, T / 2, T)),
                ),
                mistake(
                    "That is the area under half of the pulse, from 0 to its peak.",
                    impulse_of(J_s, t, (sine, 0, T / 2)),
                ),
                mistake(
                    "The inner derivative: the integral of $\\sin(\\pi t/T)$ is $-\\cos(\\pi t/T)$ times a "
                    "time.",
                    wrong("J = 2*F", J=J_s, F=F0),
                ),
            ],
            check=(
                "It lies between the area of the triangle in the pulse and that of the rectangle around it."
            ),
        ),
        step(
            F_s,
            "The mean force would give the same impulse in the same time if it were constant.",
            mean_force(F_s, J_s, T),
            answers="b",
            mistakes=[
                mistake(
                    "You multiplied by the time; divide the impulse by it.",
                    wrong("F = J*t", F=F_s, J=J_s, t=T),
                ),
                mistake(
                    "The root of the mean square is another mean; here the force itself is averaged over "
                    "the time.",
                    wrong("F = F_0/sqrt(2)", F=F_s, F_0=F0),
                ),
                mistake(
                    "You took the middle between nothing and the largest force; the sine stays high for "
                    "longer than that.",
                    wrong("F = F_0/2", F=F_s, F_0=F0),
                ),
            ],
            check=(
                "It does not depend on how long the pulse lasts, and is about two thirds of the largest "
                "force."
            ),
        ),
        step(
            J_t,
            "The area of a triangle of the base T and the height F₀, or the integral in two pieces: $F = "
            "2F_0t/T$ till $T/2$, then $F = 2F_0(1 - t/T)$.",
            impulse_of(J_t, t, (rising, 0, T / 2), (falling, T / 2, T)),
            answers="c",
            mistakes=[
                mistake(
                    "That is the rectangle around the pulse; the triangle fills only a part of it.",
                    impulse_of(J_t, t, (F0, 0, T)),
                ),
                mistake(
                    "You counted only the time in which the force grows.",
                    impulse_of(J_t, t, (rising, 0, T / 2)),
                ),
                mistake(
                    "That is the area under the half sine; a triangle inside it is smaller.",
                    impulse_of(J_t, t, (sine, 0, T)),
                ),
            ],
            check="A little less than the half sine, which bulges over the triangle.",
        ),
        step(
            F_t,
            "Again the impulse, divided by the time.",
            mean_force(F_t, J_t, T),
            answers="d",
            mistakes=[
                mistake(
                    "You multiplied by the time; divide the impulse by it.",
                    wrong("F = J*t", F=F_t, J=J_t, t=T),
                ),
                mistake(
                    "You divided by the time until the peak; the pulse lasts twice as long.",
                    mean_force(F_t, J_t, T / 2),
                ),
            ],
            check="Straight up and straight down: the mean lies in the middle between nothing and the peak.",
        ),
    )


def scene(F0, T, answer):
    """A body pushed by half a sine of this mean force: the run tells the peak and the impulse."""
    return [simulate("kick", {"F": answer["b"], "dt": T, "pulse": 1}, peak_force=F0, impulse=answer["a"])]
