"""A ladder against a wall: three balances, one for each question."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, M, L, theta, s, g):
    W, N, mu = unknowns("W N mu")
    return derivation(
        step(
            W,
            "Torques about the foot: the weights have horizontal arms, the push of the wall a vertical one.",
            law("Equilibrium of torques", "W*L*sin(theta) = (M*s + m*L/2)*g*cos(theta)", W=W),
            answers="a",
            mistakes=[
                mistake(
                    "The arm of a force is at right angles to it. How long is it for a horizontal push at "
                    "the top?",
                    wrong("W*L*cos(theta) = (M*s + m*L/2)*g*sin(theta)", W=W),
                ),
                mistake(
                    "The ladder has a weight of its own.", wrong("W*L*sin(theta) = M*s*g*cos(theta)", W=W)
                ),
                mistake(
                    "The weight of a uniform ladder acts in its middle.",
                    wrong("W*L*sin(theta) = (M*s + m*L)*g*cos(theta)", W=W),
                ),
            ],
            check="The steeper the ladder, the smaller the push.",
        ),
        step(
            N,
            "The wall is smooth: the ground alone carries both weights.",
            law("Equilibrium of forces", "N = (m + M)*g"),
            answers="b",
            mistakes=[
                mistake("The ladder is carried, too.", wrong("N = M*g")),
                mistake(
                    "The ground carries upright weights, whatever the angle.",
                    wrong("N = (m + M)*g*sin(theta)"),
                ),
            ],
        ),
        step(
            mu,
            "Friction must hold against the wall's push.",
            law("Limit of static friction", "W = mu*N", W=W),
            answers="c",
            mistakes=[
                mistake("That is the condition for a block on an incline.", wrong("mu = tan(pi/2 - theta)")),
                mistake(
                    "You have turned the ratio round: friction is the smaller force.", wrong("mu = N/W", W=W)
                ),
            ],
            check="It grows as the painter climbs.",
        ),
    )
