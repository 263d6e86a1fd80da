"""A falling pole: the centre falls, the whole pole turns."""

from math import pi

from scipy.special import ellipkinc

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(L, M, g):
    I, K, w, v = unknowns("I K omega v")
    return derivation(
        step(I, "A thin rod about its end.", law("Moment of inertia of a rod", "I = M*L^2/3", I=I)),
        step(
            K,
            "The centre of mass comes down by half of the length.",
            law("Conservation of energy", "K = M*g*L/2"),
            answers="a",
            mistakes=[
                mistake(
                    "Only the tip comes down so far. How far does the centre of mass come down?",
                    wrong("K = M*g*L"),
                ),
                mistake("The centre of a uniform pole is in its middle.", wrong("K = M*g*L/3")),
            ],
        ),
        step(
            w,
            "All of it is rotation about the hinge.",
            law("Kinetic energy of rotation", "K = I*w^2/2", I=I, w=w),
            where=w > 0,
            answers="b",
            mistakes=[
                mistake(
                    "That moment of inertia is about the middle; the pole turns about its end.",
                    wrong("K = M*L^2/12*w^2/2", w=w),
                    where=w > 0,
                ),
                mistake(
                    "So it would be if all mass sat at the tip.", wrong("K = M*L^2*w^2/2", w=w), where=w > 0
                ),
                mistake(
                    "The factor 1/2 of the kinetic energy is missing.",
                    wrong("K = I*w^2", I=I, w=w),
                    where=w > 0,
                ),
            ],
        ),
        step(
            v,
            "The tip goes along a circle with the radius L.",
            law("Speed on a circle", "v = w*L", w=w),
            answers="c",
            mistakes=[
                mistake("That is the speed of the middle.", wrong("v = w*L/2", w=w)),
                mistake("That is a stone that falls freely from the tip's height.", wrong("v = sqrt(2*g*L)")),
            ],
            check="$v = \\sqrt{3gL}$, whatever the mass.",
        ),
        choice(
            "d",
            "$\\sqrt{3gL}$ is more than $\\sqrt{2gL}$: the rest of the pole pulls the tip along.",
            a=True,
            b=False,
            c=False,
            mistakes={
                "b": "The tip is not alone: it is part of something rigid.",
                "c": "The hinge holds the pole. But what does the rest of the pole do to the tip?",
            },
        ),
    )


def scene(L, M, g, answer):
    """A pendulum that swings as the pole does: three quarters of its mass at two thirds of its length, on a rod without mass.

    It is pushed over with a thousandth of the last angular velocity, for upright it would stay. When it lies flat is an elliptic
    integral; that it does then, and how fast it is, is Newton's second law.
    """
    arm, last = 2 * L / 3, answer["b"]
    push = last / 1000
    falls = 2 / push * ellipkinc(pi / 4, -6 * g / L / push**2)
    nail, weight = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(3 * M / 4, (0.0, arm), (push * arm, 0.0))
    return [
        simulate(
            Scene((nail, weight), (Rod((0, 1)), Weight(g)), until=float(falls)),
            trajectory=(0.0, 0.0, arm, 0.0),
            velocities=(0.0, 0.0, 0.0, -2 * answer["c"] / 3),
            energy=answer["a"],
            neglected=2e-6,
        )
    ]
