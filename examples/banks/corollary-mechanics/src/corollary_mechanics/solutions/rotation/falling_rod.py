"""A falling pole: the centre falls, the whole pole turns."""

from corollary.author import choice, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


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
