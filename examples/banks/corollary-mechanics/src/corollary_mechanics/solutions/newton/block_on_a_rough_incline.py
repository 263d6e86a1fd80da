"""Down a rough incline: the normal force, friction, and what is left to accelerate."""

from math import cos, sin

from sympy import cos as cosine
from sympy import sin as sine

from corollary.author import along, choice, derivation, force, forces, mistake, simulate, step, unknowns
from corollary.laws import balance, kinetic_friction, law, second_law, without_time, wrong


def derive(m, theta, mu, L, g):
    N, f, a, v = unknowns("N f a v", N="normal force")
    return derivation(
        step(
            N,
            "At right angles to the slope nothing accelerates: the slope carries that component of the "
            "weight.",
            balance(N, m * g * cosine(theta)),
        ),
        step(
            f,
            "The block slides, so that friction is kinetic.",
            kinetic_friction(f, mu=mu, N=N),
            answers="a",
            mistakes=[
                mistake(
                    "On a slope the normal force is smaller than the weight: only a component of it presses "
                    "on the slope.",
                    wrong("f = mu*m*g"),
                ),
                mistake(
                    "That component of the weight lies along the slope. Which one presses the block against "
                    "it?",
                    wrong("f = mu*m*g*sin(theta)"),
                ),
            ],
            check="On a level floor it would be $\\mu m g$.",
        ),
        step(
            a,
            "Along the slope, a component of the weight pulls downwards and friction upwards.",
            second_law(m * g * sine(theta) - f, m=m, a=a),
            answers="b",
            mistakes=[
                mistake("Friction is missing.", law("Newton's second law", "m*g*sin(theta) = m*a")),
                mistake(
                    "Friction acts against the motion, up the slope: look at its sign.",
                    law("Newton's second law", "m*g*sin(theta) + f = m*a"),
                ),
                mistake(
                    "Not the whole weight pulls along the slope.", law("Newton's second law", "m*g - f = m*a")
                ),
            ],
            check="The mass cancels; with $\\mu = \\tan\\theta$ the block would not speed up at all.",
        ),
        step(
            v,
            "It speeds up steadily from rest.",
            without_time(v, v_0=0, a=a, s=L),
            where=v >= 0,
            answers="c",
            mistakes=[
                mistake("The factor 2 is missing: $v^2 = 2aL$.", wrong("v^2 = a*L"), where=v >= 0),
                mistake(
                    "That is the speed of a free fall through the length of the slide; the slope is in the "
                    "way.",
                    wrong("v^2 = 2*g*L"),
                    where=v >= 0,
                ),
            ],
        ),
        forces(
            "e",
            "The Earth pulls, and the slope pushes and rubs; nothing else touches the block.",
            force("a", m * g, "down"),
            force("b", N, "away from the slope"),
            force("c", f, "up the slope"),
            laws=[
                along("down the slope", second_law(m * g * sine(theta) - f, m=m, a=a)),
                along("away from the slope", balance(N, m * g * cosine(theta))),
            ],
            mistakes={
                "d": "No force is needed to keep up a motion; what else touches the block, or attracts it?",
                "e": "That is a force on the slope, not on the block.",
            },
        ),
        choice(
            "d",
            "The weight, the normal force, and friction all double, and so does the inertia.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "Twice the inertia, but do the forces stay as they are?",
                "c": "Twice the force, but what is accelerated is heavier, too.",
            },
        ),
    )


def scene(m, theta, mu, L, g, answer):
    """The bank's own ready-made scene, watched for the time that the slide takes."""
    v = answer["c"]
    return [
        simulate(
            "slide",
            {"m": m, "theta": theta, "mu": mu, "g": g, "t": 2 * L / v},
            velocities=(v * cos(theta), -v * sin(theta)),
            trajectory=(L * cos(theta), -L * sin(theta)),
        )
    ]
