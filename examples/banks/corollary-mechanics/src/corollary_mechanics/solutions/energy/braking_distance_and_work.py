"""A box that is pushed off: work in, heat out."""

from math import sqrt

from corollary.author import derivation, mistake, route, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.contact import Friction
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(m, F, s, mu, g):
    f, K, d, Q = unknowns("f K d Q")
    return derivation(
        step(f, "On a level floor the normal force is the weight.", law("Kinetic friction", "f = mu*m*g")),
        step(
            K,
            "The work of the net force is the change of kinetic energy.",
            law("Work and kinetic energy", "(F - f)*s = K"),
            answers="a",
            mistakes=[
                mistake("The box rubs on the floor during the push already.", wrong("F*s = K")),
                mistake("The push helps, friction hinders.", wrong("(F + f)*s = K")),
            ],
        ),
        step(
            d,
            "Friction takes away all the kinetic energy.",
            law("Work of friction", "K = f*d"),
            answers="b",
            mistakes=[
                mistake(
                    "That is the way from the start; how far does it slide after the push?",
                    wrong("F*s = f*d"),
                ),
                mistake(
                    "Friction goes with the normal force, which is the weight, not the mass times anything "
                    "else.",
                    wrong("K = m*g*d"),
                ),
            ],
            check="The stronger the push, the longer the way, in proportion.",
        ),
        step(
            Q,
            "Friction rubs along the whole way.",
            law("Heat of friction", "Q = f*(s + d)", Q=Q),
            answers="c",
            routes=[
                route(
                    "Nothing else is left of the work of the push.",
                    law("Conservation of energy", "Q = F*s", Q=Q),
                )
            ],
            mistakes=[
                mistake("It has rubbed on the floor during the push as well.", wrong("Q = f*d", Q=Q)),
                mistake("That is only the heat during the push.", wrong("Q = f*s", Q=Q)),
            ],
            check="It is exactly the work of the push.",
        ),
    )


def scene(m, F, s, mu, g, answer):
    a, v = F / m - mu * g, sqrt(2 * answer["a"] / m)
    box, rough = Body(m, (0.0,), (0.0,)), Friction(0, mu, g)
    pushed = Scene((box,), (rough, ForceFunction(0, lambda t, x, u: (F,))), until=v / a)
    sliding = Scene((Body(m, (s,), (v,)),), (rough,), until=2 * v / (mu * g))
    return [
        simulate(pushed, trajectory=(s,), velocities=(v,)),
        simulate(sliding, trajectory=(s + answer["b"],)),
    ]
