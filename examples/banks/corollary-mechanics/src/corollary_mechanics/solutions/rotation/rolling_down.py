"""Rolling down: a part of the energy turns the ball."""

from math import cos, sin

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(m, theta, L, g):
    v, a, f = unknowns("v a f")
    return derivation(
        step(
            v,
            "The potential energy becomes motion of the centre and rotation; for a solid ball that rolls, "
            "the rotation has 2/5 of the energy of the centre's motion.",
            law("Energy of rolling", "m*g*L*sin(theta) = m*v^2/2 + (2/5)*m*v^2/2"),
            where=v > 0,
            answers="a",
            mistakes=[
                mistake(
                    "Rolling takes energy, too: the ball does not only slide.",
                    wrong("m*g*L*sin(theta) = m*v^2/2"),
                    where=v > 0,
                ),
                mistake(
                    "That is the moment of inertia of a disc; a ball has its mass nearer to the axis.",
                    wrong("m*g*L*sin(theta) = m*v^2/2 + m*v^2/4"),
                    where=v > 0,
                ),
                mistake(
                    "The height counts, not the length of the incline.",
                    wrong("m*g*L = m*v^2/2 + (2/5)*m*v^2/2"),
                    where=v > 0,
                ),
            ],
            check="Neither mass nor radius matters.",
        ),
        step(
            a,
            "The centre speeds up steadily from rest.",
            law("Velocity and way", "v^2 = 2*a*L"),
            answers="b",
            mistakes=[
                mistake("That is a body that slides without friction.", wrong("a = g*sin(theta)")),
                mistake("The factor 2 is missing: $v^2 = 2aL$.", wrong("v^2 = a*L")),
            ],
        ),
        step(
            f,
            "Along the incline: what gravity pulls more than the centre is accelerated, friction holds back.",
            law("Newton's second law", "m*g*sin(theta) - f = m*a"),
            answers="c",
            mistakes=[
                mistake("That is what accelerates the centre; friction is the rest.", wrong("f = m*a")),
                mistake(
                    "So much friction would keep the ball from speeding up at all.",
                    wrong("f = m*g*sin(theta)"),
                ),
            ],
            check="It is 2/7 of what pulls down the slope: it turns the ball.",
        ),
        choice(
            "d",
            "The hollow ball has its mass further from the axis: more of the energy goes into rotation.",
            a=False,
            b=False,
            c=True,
            mistakes={
                "a": "Which of them needs more energy to turn equally fast?",
                "b": "Mass and radius cancel. Does the way the mass is spread?",
            },
        ),
    )


def scene(m, theta, L, g, answer):
    """A ball with a radius on a rough wall that leans; it grips, and rolls by itself."""
    v, a, r = answer["a"], answer["b"], 0.05
    normal = (sin(theta), cos(theta))
    ball = Body(m, (r * normal[0], r * normal[1]), (0.0, 0.0), radius=r)
    rough = HardWall(normal, restitution=0.0, mu=0.9)
    return [
        simulate(
            Scene((ball,), (Weight(g), rough), until=v / a),
            velocities=(v * cos(theta), -v * sin(theta)),
            spins=(-v / r,),
        )
    ]
