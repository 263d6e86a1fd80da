"""Stopping a ball: a floor that gives way takes the ball's energy, elastic or not."""

import sympy

from corollary.author import (
    choice,
    derivation,
    explain,
    mistake,
    neglected,
    simulate,
    step,
    supposed,
    unknowns,
)
from corollary.laws import conservation_of_momentum, law, restitution, wrong


def derive(v0):
    V, V_n, U, eps = unknowns("V V_n U epsilon")
    n, heavy = supposed("n", "1000", "the floor is at least so many times as heavy as the ball")
    return derivation(
        step(
            V,
            "The collision is elastic: the velocity of the ball relative to the floor is only turned round "
            "(r = 1). The floor is so heavy that its velocity stays V; the ball's is -v₀ before and shall "
            "be 0 after.",
            restitution(1, A=(-v0, 0), B=(V, V)),
            answers="b",
            mistakes=[
                mistake(
                    "If the floor moves away as fast as the ball, they never meet.",
                    wrong("V = -v_0", v_0=v0),
                ),
                mistake(
                    "A floor that comes up to meet the ball sends it back faster: upward velocities are "
                    "positive.",
                    wrong("V = v_0/2", v_0=v0),
                ),
                mistake(
                    "A floor at rest sends an elastic ball back at the speed at which it came.",
                    wrong("V = 0*v_0", v_0=v0),
                ),
                mistake(
                    "Seen from the floor the ball is turned round; a floor this fast would not leave it at "
                    "rest.",
                    wrong("V = -2*v_0", v_0=v0),
                ),
            ],
            check=(
                "Seen from this floor the ball comes at -v₀/2 and leaves at +v₀/2; seen from the ground "
                "it then has -v₀/2 + v₀/2 = 0."
            ),
        ),
        neglected(
            "b",
            "that the floor, too, is pushed",
            eps,
            "A floor n times as heavy as the ball moves at $V_n$ before the hit and at U after it.",
            conservation_of_momentum(before=[(1, -v0), (n, V_n)], after=[(1, 0), (n, U)]),
            restitution(1, A=(-v0, 0), B=(V_n, U)),
            law("Difference", "epsilon = V_n - V", epsilon=eps),
            also=[V_n, U],
            supposing=[heavy],
        ),
        choice(
            "a",
            "The floor must give way, downward, and more slowly than the ball comes: then the ball, turned "
            "round relative to the floor, is at rest relative to the ground.",
            a=False,
            b=V > 0,
            c=V < 0,
            d=sympy.Eq(V, 0),
            mistakes={
                "a": (
                    "The kinetic energy of floor and ball together is kept; the ball may give its own to "
                    "a floor that moves."
                ),
                "b": (
                    "A floor that comes to meet the ball sends it back faster than it came, as a racket does."
                ),
                "d": "From a floor at rest an elastic ball comes back at its own speed.",
            },
        ),
        explain(
            "c",
            "Says that in an elastic collision the total kinetic energy (of ball and floor) is kept, not "
            "that of the ball alone.",
            "Says that a floor that moves away takes energy from the ball: the ball's force on it does "
            "positive work (or argues in the frame of the floor).",
            "Says that seen from the floor the ball is only turned round, and keeps its speed there.",
            answer="Seen from the moving floor the ball comes at half its speed and goes back at half its "
            "speed: there it keeps its kinetic energy, and the collision is elastic. Seen from the "
            "ground the ball is at rest "
            "afterwards. Its kinetic energy is not lost: while they touch, the ball pushes the floor down, "
            "and the floor moves down, so the ball does work on the floor (and on the machine that moves "
            "it). The total is kept.",
        ),
    )


def scene(v0, answer, neglected):
    """The ball against a sphere a thousand million times as heavy, with the velocity found; and against one a thousand times as heavy."""
    hit = {"mA": 1.0, "k": 1e9, "eta": 0.0, "dx": -0.08, "dy": 0.0, "vA": (-v0, 0.0)}
    floor, bound = answer["b"], neglected["b"]
    return [
        simulate(
            "spheres",
            hit | {"mB": 1e9, "vB": (floor, 0.0)},
            animated=True,
            neglected=1e-8,
            velocities=(0.0, 0.0, floor, 0.0),
        ),
        simulate(
            "spheres",
            hit | {"mB": 1e3, "vB": (floor + bound, 0.0)},
            neglected=2 * bound / abs(floor),
            velocities=(0.0, 0.0, floor, 0.0),
        ),
    ]
