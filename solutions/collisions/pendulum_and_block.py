"""Pendulum and block: energy on the way down and up, momentum and energy in the collision."""

import math

from corollary.author import (
    derivation,
    mistake,
    neglected,
    reject,
    simulate,
    step,
    supposed,
    unknowns,
    vector,
)
from corollary.laws import conservation_of_momentum, elastic, falling, law, wrong


def derive(m, M, L, g):
    v_0, h_1 = unknowns("v_0 h_1")
    x, F, J, w, eps = unknowns("x F J w epsilon")
    _tau, touch = supposed("tau", "1 ms", "hard things touch no longer")
    swing = (
        law("Way", "x = v_0*tau"),
        law("Pull of the rope", "F = m*(g + v_0^2/L)*x/L"),
        law("Impulse", "J = F*tau", source="(12.20)"),
    )
    u = vector("u", "m M")
    before, after = [(m, v_0), (M, 0)], [(m, u[0]), (M, u[1])]
    return derivation(
        step(
            v_0,
            "The rope pulls at right angles to the motion; only gravity does work. The sphere comes down by "
            "the length of the rope.",
            falling(v_0, g, L),
            answers="a0",
            where=v_0 >= 0,
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", h=L, v=v_0),
                ),
                mistake(
                    "The factor 2 stands on the other side: $v^2/2 = gh$.",
                    wrong("g*h = 2*v^2", h=L, v=v_0),
                ),
                mistake(
                    "The sphere starts at the height of the rope's upper end: it comes down by L, not by 2L.",
                    wrong("g*h = v^2/2", h=2 * L, v=v_0),
                ),
            ],
            check="It is the speed of a free fall through L; the mass does not matter.",
        ),
        step(
            u,
            "In the short collision momentum is kept (the rope is vertical and does not push along the "
            "table), and so is the kinetic energy.",
            conservation_of_momentum(before=before, after=after),
            elastic(before=before, after=after),
            answers="a",
            reject=[
                reject(
                    "the velocities would be those from before: the sphere would have gone through the block",
                    u_m=v_0,
                    u_M=0,
                )
            ],
            mistakes=[
                mistake(
                    "You let them stick together; an elastic collision keeps the kinetic energy.",
                    law("Perfectly inelastic", "v_A = v_B", v_A=u[0], v_B=u[1]),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "The sphere stops only if both masses are equal.",
                    law("Sphere stops", "v_A = 0", v_A=u[0]),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "The sphere is turned round without loss of speed only by something infinitely heavy.",
                    law("Turned round", "v_A = -v_0", v_A=u[0]),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check=(
                "A sphere lighter than the block comes back (negative); they part as fast as they came "
                "together."
            ),
        ),
        step(
            h_1,
            "On its way up only gravity works on the sphere.",
            falling(u[0], g, h_1),
            answers="b",
            mistakes=[
                mistake(
                    "You used the speed of the block; the pendulum is the sphere.", falling(u[1], g, h_1)
                ),
                mistake(
                    "The height goes with the square of the speed.",
                    wrong("h = L*abs(u)/v_0", h=h_1, u=u[0]),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", h=h_1, v=u[0]),
                ),
                mistake(
                    "That is how high it would swing without the block; it has given energy away.",
                    wrong("h = L", h=h_1),
                ),
            ],
            check="It is less than L, and does not depend on g. With M = 2m it is a ninth of L.",
        ),
        neglected(
            "a",
            "the swing of the rope during the hit",
            w,
            "The sphere moves by at most x while they touch, and the rope, which carries its weight on a "
            "circle, pulls it back with at most F. "
            "The momentum J that it takes changes the sphere's velocity by at most J/m and the block's by "
            "at most 2J/m.",
            *swing,
            law("Change of both velocities", "w = sqrt(1 + 2^2)*J/m"),
            also=[x, F, J],
            supposing=[touch],
        ),
        neglected(
            "b",
            "the swing of the rope during the hit",
            eps,
            "It changes the sphere's velocity by at most J/m, as in (a), and the height $u^2/2g$ with it.",
            *swing,
            law("Change of the height", "epsilon = abs(u)*J/(m*g)", epsilon=eps, u=u[0]),
            also=[x, F, J],
            supposing=[touch],
        ),
    )


def scene(m, M, L, g, answer, neglected):
    """Sphere and block during the collision, from Newton's second law; and the whole way of the pendulum, with a touch that takes its time."""
    whole = {"m": m, "M": M, "L": L, "g": g}
    return [
        simulate("cradle", {"N": 2, "masses": (m, M), "v0": answer["a0"]}, velocities=answer["a"]),
        simulate(
            "pendulum_block",
            whole,
            velocities=answer["a"],
            neglected=neglected["a"] / math.hypot(*answer["a"]),
        ),
        simulate(
            "pendulum_block", whole, animated=True, height=answer["b"], neglected=neglected["b"] / answer["b"]
        ),
    ]
