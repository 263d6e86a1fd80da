"""A weight on a hanging spring: the weight moves the equilibrium, and nothing else."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(m, d, b, g):
    k, T, a, F = unknowns("k T a F")
    return derivation(
        step(
            k,
            "At rest the spring carries the weight.",
            law("Hooke's law", "k*d = m*g"),
            answers="a",
            mistakes=[
                mistake(
                    "The block was lowered until it hung at rest; it did not fall. Forces balance there, not "
                    "energies.",
                    wrong("k*d^2/2 = m*g*d"),
                ),
                mistake(
                    "At that moment it is stretched by d alone: the pull comes later.",
                    wrong("k*(d + b) = m*g"),
                ),
            ],
        ),
        step(
            T,
            "The weight only moves the position of equilibrium.",
            law("Period of an oscillator", "T = 2*pi*sqrt(m/k)"),
            answers="b",
            mistakes=[
                mistake("That is the time from top to bottom.", wrong("T = pi*sqrt(m/k)")),
                mistake(
                    "It is the stretching at rest that stands for a pendulum's length, not that of the pull.",
                    wrong("T = 2*pi*sqrt(b/g)"),
                ),
            ],
            check="It equals that of a pendulum as long as the spring is stretched at rest.",
        ),
        step(
            a,
            "The net force is that of the further stretching.",
            law("Newton's second law", "k*b = m*a"),
            answers="c",
            mistakes=[
                mistake(
                    "That is all of the spring's force; the weight takes some of it away.",
                    wrong("k*(d + b) = m*a"),
                ),
                mistake(
                    "The further pull acts in full at that moment; halves belong to energies.",
                    wrong("k*b/2 = m*a"),
                ),
            ],
        ),
        step(
            F,
            "The spring is stretched by both together.",
            law("Hooke's law", "F = k*(d + b)"),
            answers="d",
            mistakes=[
                mistake("It was stretched by the weight before.", wrong("F = k*b")),
                mistake("That holds it at rest. It has been pulled further.", wrong("F = m*g")),
            ],
        ),
    )


def scene(m, d, b, g, answer):
    """A spring on a nail, and weight: half a period later the block is as far above the place of rest."""
    nail, block = Body(float("inf"), (0.0,), (0.0,)), Body(m, (-1.0 - d - b,), (0.0,))
    half = Scene((nail, block), (Spring((0, 1), answer["a"], length=1.0), Weight(g)), until=answer["b"] / 2)
    return [simulate(half, trajectory=(0.0, -1.0 - d + b))]
