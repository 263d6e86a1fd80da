"""Ball and a moving wall: ride with the wall, turn the velocity round, come back to the ground."""

import sympy

from corollary.author import derivation, mistake, neglected, simulate, step, supposed, unknowns
from corollary.laws import after_elastic, in_the_limit, law, seen_from, wrong


def derive(vA, vB):
    w_0, w_1, v_1 = unknowns("w_0 w_1 v_1", w_1="velocity after the collision, relative to the wall")
    eps = unknowns("epsilon")[0]
    n, heavy = supposed("n", "10000", "the wall is at least so many times as heavy as the ball")
    m, M = sympy.symbols("m M", positive=True)
    return derivation(
        step(
            w_0,
            "A velocity measured from the ground is the wall's velocity plus the one measured from the wall.",
            seen_from(w_0, vA, vB),
            answers="b",
            mistakes=[
                mistake(
                    "The wall's own velocity is taken off, with its sign: who rides towards the ball sees "
                    "it come faster.",
                    wrong("w = v + u", w=w_0, v=vA, u=vB),
                ),
                mistake(
                    "That is the wall's velocity as seen from the ball; asked is the ball's, seen from the "
                    "wall.",
                    wrong("w = u - v", w=w_0, v=vA, u=vB),
                ),
                mistake(
                    "That is the velocity measured from the ground; someone on the wall moves too.",
                    wrong("w = v", w=w_0, v=vA),
                ),
            ],
            check="If the wall comes towards the ball, the ball seems faster from there.",
        ),
        step(
            w_1,
            "For someone on the wall, a light ball hits a very heavy wall at rest: its velocity is just "
            "turned round.",
            in_the_limit(
                w_1,
                after_elastic(A=(m, w_0), B=(M, 0))[0],
                M,
                sympy.oo,
                "the ball's mass is negligible beside the wall's",
            ),
        ),
        step(
            v_1,
            "Back on the ground the wall's velocity is added again.",
            seen_from(w_1, v_1, vB),
            answers="a",
            mistakes=[
                mistake(
                    "You treated the wall as if it stood still: turn the velocity *relative to the wall* "
                    "round.",
                    wrong("v = -v_A", v=v_1, v_A=vA),
                ),
                mistake(
                    "That is the velocity seen from the wall; come back to the ground.",
                    wrong("v = w", v=v_1, w=w_1),
                ),
                mistake(
                    "The wall's velocity has a sign: you counted it the other way round.",
                    wrong("v = -v_A - 2*v_B", v=v_1, v_A=vA, v_B=vB),
                ),
            ],
            check="A wall at rest gives -v; a wall that comes towards the ball sends it back faster.",
        ),
        neglected(
            "a",
            "that the wall, too, is pushed",
            eps,
            "The law of elastic collisions, for a wall n times as heavy as the ball, less the limit.",
            law(
                "Difference",
                "epsilon = v_n - v_1",
                source="(12.79)",
                epsilon=eps,
                v_n=after_elastic(A=(1, vA), B=(n, vB))[0],
            ),
            supposing=[heavy],
        ),
    )


def scene(vA, vB, answer, neglected):
    """A ball against a sphere a thousand million times as heavy, and against one ten thousand times as heavy."""
    hit = {"mA": 1.0, "k": 1e9, "eta": 0.0, "dx": 0.08, "dy": 0.0, "vA": (vA, 0.0), "vB": (vB, 0.0)}
    after = (answer["a"], 0.0, vB, 0.0)
    return [
        simulate("spheres", hit | {"mB": 1e9}, animated=True, neglected=1e-8, velocities=after),
        simulate(
            "spheres",
            hit | {"mB": 1e4},
            neglected=1.5 * neglected["a"] / max(map(abs, after)),
            velocities=after,
        ),
    ]
