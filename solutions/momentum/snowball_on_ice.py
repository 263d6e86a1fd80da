"""Snowball on ice: momentum is kept along the ice, where nothing pushes from outside."""

import sympy

from corollary.author import derivation, mistake, simulate, step, unknown, vector
from corollary.laws import conservation_of_momentum, law, momentum, same, sticking, wrong


def derive(M, Ms, m, v, theta):
    p = vector("p")
    V, u, V_1, u_1 = unknown("V"), unknown("u"), unknown("V_1"), unknown("u_1")
    flat, up = v * sympy.cos(theta), v * sympy.sin(theta)
    return derivation(
        step(
            p,
            "Momentum is mass times velocity, component by component.",
            momentum(p, m, (flat, up)),
            answers="a",
            mistakes=[
                mistake(
                    "Sine and cosine have changed places: the angle is measured from the horizontal.",
                    momentum(p, m, (up, flat)),
                ),
                mistake("You gave the whole momentum to x; the ball also rises.", momentum(p, m, (v, 0))),
                mistake(
                    "You used your own mass; asked is the momentum of the snowball.",
                    momentum(p, M, (flat, up)),
                ),
            ],
            check="The length of the vector is $mv$, whatever the angle.",
        ),
        step(
            V,
            "Before the throw nothing moves. Along the ice no force acts from outside, so you and the ball "
            "share a total of zero.",
            conservation_of_momentum(before=[(m + M, 0)], after=[(m, p[0] / m), (M, V)]),
            answers="b",
            mistakes=[
                mistake(
                    "Vertically the ice pushes back; only the horizontal part of the ball's momentum is "
                    "taken from you. Use $v\\cos\\theta$.",
                    conservation_of_momentum(before=[(m + M, 0)], after=[(m, v), (M, V)]),
                ),
                mistake(
                    "After the throw the snowball is no longer with you: your mass is M alone.",
                    conservation_of_momentum(before=[(m + M, 0)], after=[(m, p[0] / m), (m + M, V)]),
                ),
                mistake(
                    "You used the vertical component; momentum is kept along the ice.",
                    conservation_of_momentum(before=[(m + M, 0)], after=[(m, up), (M, V)]),
                ),
                mistake(
                    "You and the ball do not share a speed: the momenta are opposite, not the velocities.",
                    wrong("V = -v", V=V, v=flat),
                ),
            ],
            check="You slide away from your son, far slower than the ball, since you are far heavier.",
        ),
        step(
            u,
            "Nothing has touched your son yet.",
            law(
                "Newton's first law",
                "m*v_1 = m*v_0",
                source="(12.16)",
                holds="the net force is zero",
                m=Ms,
                v_1=u,
                v_0=0,
            ),
            answers="b2",
            mistakes=[
                mistake(
                    "He does not move until the ball reaches him; you and the *ball* share the momentum, "
                    "not you and your son.",
                    conservation_of_momentum(before=[(M + Ms, 0)], after=[(M, V), (Ms, u)]),
                ),
                mistake(
                    "He has your speed in the other direction only in a mirror; no force has acted on him "
                    "yet.",
                    wrong("v_1 = -V", v_1=u, V=V),
                ),
            ],
            scale=V,
            check="No force, no change of velocity.",
        ),
        step(
            V_1,
            "Nothing touches you while the ball flies and is caught: your velocity stays.",
            same(V_1, V, "no force acts on you along the ice after the throw"),
            answers="c",
            mistakes=[
                mistake(
                    "The catch happens between the ball and your son. It does not stop you.",
                    wrong("V_1 = 0", V_1=V_1),
                ),
                mistake(
                    "You and your son do not have opposite velocities; each has shared momentum with the "
                    "ball alone.",
                    sticking(before=[(m, -flat), (Ms, 0)], together=V_1),
                ),
            ],
            check="You go on sliding for ever on this lake.",
        ),
        step(
            u_1,
            "Ball and son move as one after the catch; along the ice their momentum is what the ball "
            "brought.",
            sticking(before=[(m, p[0] / m), (Ms, 0)], together=u_1),
            answers="c2",
            mistakes=[
                mistake(
                    "He holds the ball: his mass and the ball's move together.",
                    conservation_of_momentum(before=[(m, p[0] / m), (Ms, 0)], after=[(m, 0), (Ms, u_1)]),
                ),
                mistake(
                    "The vertical momentum is taken by the ice: use the horizontal component "
                    "$v\\cos\\theta$.",
                    sticking(before=[(m, v), (Ms, 0)], together=u_1),
                ),
                mistake(
                    "You used the vertical component; momentum is kept along the ice.",
                    sticking(before=[(m, up), (Ms, 0)], together=u_1),
                ),
                mistake(
                    "Kinetic energy is not kept in a catch; momentum is.",
                    wrong("u = v*sqrt(m/(m + M))", v=flat, M=Ms, u=u_1),
                ),
            ],
            check="Added over you, your son and the ball, the momentum along the ice is still zero.",
        ),
    )


def scene(M, Ms, m, v, theta, answer):
    """A throw and a catch by forces between two bodies at a time."""
    return [
        simulate(
            "snowball",
            {"M": M, "Ms": Ms, "m": m, "v": v, "theta": theta},
            animated=True,
            momentum=answer["a"],
            velocities_after_throw=(answer["b"], answer["b2"]),
            velocities=(answer["c"], answer["c2"]),
        )
    ]
