"""A swing that dies away: exponential decay of amplitude and of energy."""

from math import pi

from corollary.author import code, derivation, file, mistake, module, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.flows import Drag
from corollary.scenes.scene import Body, Scene

SWING = module("damped_swing/judge_swing.py")


def derive(A, B, T, m):
    delta, b, q, h = unknowns("delta b q h")
    return derivation(
        step(
            delta,
            "Ten oscillations take ten periods.",
            law("Decay of the amplitude", "delta = log(A/B)/(10*T)"),
            answers="a",
            mistakes=[
                mistake(
                    "The amplitude was measured after ten oscillations, not after one.",
                    wrong("delta = log(A/B)/T"),
                ),
                mistake(
                    "It does not fall along a straight line: take the logarithm of the ratio.",
                    wrong("delta = (1 - B/A)/(10*T)"),
                ),
            ],
        ),
        step(
            b,
            "As stated.",
            law("Damping", "delta = b/(2*m)"),
            answers="b",
            mistakes=[
                mistake("A factor of 2 is missing.", wrong("delta = b/m")),
                mistake("The factor stands on the other side.", wrong("delta = 2*b/m")),
            ],
        ),
        step(
            q,
            "Energy goes with the square of the amplitude.",
            law("Energy lost", "q = 1 - (B/A)^2"),
            answers="c",
            mistakes=[
                mistake("That is what is left.", wrong("q = (B/A)^2")),
                mistake("The energy goes with the square of the amplitude.", wrong("q = 1 - B/A")),
            ],
        ),
        step(
            h,
            "Halving means a factor 1/2 of the exponential.",
            law("Decay of the amplitude", "1/2 = exp(-delta*h)"),
            answers="d",
            mistakes=[
                mistake("That is when it has fallen to 1/e.", wrong("h = 1/delta")),
                mistake(
                    "By then the energy has fallen to a half, not the amplitude.",
                    wrong("1/2 = exp(-2*delta*h)"),
                ),
            ],
        ),
        code(
            "e",
            "In each step the forces of spring and drag change the velocity, and the new velocity the place.",
            inputs=SWING.swing_inputs,
            judge=SWING.judge_swing,
            example=file("damped_swing/swing.py"),
        ),
    )


def scene(A, B, T, m, answer):
    """A spring with the stiffness that gives the period, and the drag found: at the end of ten periods it turns B away."""
    k = m * ((2 * pi / T) ** 2 + answer["a"] ** 2)
    nail, block = Body(float("inf"), (0.0,), (0.0,)), Body(m, (1.0 + A,), (0.0,))
    swung = Scene((nail, block), (Spring((0, 1), k, length=1.0), Drag(1, linear=answer["b"])), until=10 * T)
    return [simulate(swung, trajectory=(0.0, 1.0 + B))]
