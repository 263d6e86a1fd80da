"""Coefficient of restitution: a wall or a floor gives back the fraction r of the speed, and so r² of the energy."""

import math

import sympy

from corollary.author import (
    choice,
    derivation,
    mistake,
    neglected,
    route,
    simulate,
    step,
    supposed,
    unknown,
    unknowns,
)
from corollary.laws import change_of_kinetic_energy, falling, law, restitution, wrong


def derive(m, v0, r, h0, n, g):
    v_1, dK, w, u, h_1, q, h_n = unknowns(
        "v_1 dK w u h_1 q h_n",
        w="speed at the floor",
        u="speed after the bounce",
        q="share of the height that is kept",
    )
    u_g, eps = unknowns("u_g epsilon")
    _tau, touch = supposed("tau", "0.2 ms", "a hard ball touches a hard floor no longer")
    kept = unknown("e_1"), unknown("e_0")
    return derivation(
        step(
            v_1,
            "The wall stays at rest; relative to it the ball comes back with the fraction r of its speed.",
            restitution(r, A=(v0, v_1), B=(0, 0)),
            answers="a",
            mistakes=[
                mistake(
                    "The size is right, but the ball comes back: its velocity changes sign.",
                    wrong("v_1 = r*v_0", v_0=v0),
                ),
                mistake(
                    "r compares velocities, not kinetic energies: no root is needed.",
                    wrong("v_1 = -sqrt(r)*v_0", v_0=v0),
                ),
                mistake(
                    "r is what the ball keeps of its speed, not what it loses.",
                    wrong("v_1 = -(1 - r)*v_0", v_0=v0),
                ),
            ],
            check="For r = 1 the velocity is just turned round.",
        ),
        step(
            dK,
            "The change is the kinetic energy after the hit less that before it.",
            change_of_kinetic_energy(dK, before=[(m, v0)], after=[(m, v_1)]),
            answers="b",
            mistakes=[
                mistake(
                    "You squared the difference of the velocities; take the difference of the squares.",
                    wrong("dK = m*(v_1 - v_0)^2/2", v_0=v0),
                ),
                mistake(
                    "r is the share of the speed that is kept; the kinetic energy goes with the square of "
                    "the speed.",
                    wrong("dK = (r - 1)*m*v_0^2/2", v_0=v0),
                ),
                mistake(
                    "That is the kinetic energy that is left; asked is by how much it changes.",
                    wrong("dK = m*v_1^2/2"),
                ),
            ],
            check="It is never positive: a wall at rest gives no energy to a ball.",
        ),
        step(
            w,
            "On its way down only gravity works on the ball: its speed at the floor.",
            falling(w, g, h0),
            where=w >= 0,
        ),
        step(
            u,
            "The floor turns the velocity from -w into +u (up is positive) and keeps the fraction r of the "
            "speed.",
            restitution(r, A=(-w, u), B=(0, 0)),
        ),
        step(
            h_1,
            "On its way up again only gravity works.",
            falling(u, g, h_1),
            answers="c",
            mistakes=[
                mistake(
                    "The height goes with the square of the speed, and r is a ratio of speeds.",
                    wrong("h_1 = r*h_0", h_0=h0),
                ),
                mistake(
                    "r compares speeds, not energies: square it rather than taking its root.",
                    wrong("h_1 = sqrt(r)*h_0", h_0=h0),
                ),
                mistake(
                    "That is the height that is lost; asked is how high the ball rises.",
                    wrong("h_1 = (1 - r^2)*h_0", h_0=h0),
                ),
            ],
            check="Neither the mass nor g matters; with r = 1 the ball comes back to where it was let go.",
        ),
        step(
            q,
            "Each bounce leaves the same fraction of the height before it.",
            law("Fraction", "q = h_1/h_0", h_0=h0),
        ),
        step(
            h_n,
            "Each bounce multiplies the speed by r and so the height by r²; n bounces do it n times.",
            law("Bounce after bounce", "h_n = h_0*(r^2)^n", h_0=h0),
            answers="d",
            routes=[
                route(
                    "The same from the height of the first bounce: every bounce leaves the same fraction of "
                    "the height.",
                    law("Bounce after bounce", "h_n = h_0*q^n", h_0=h0),
                )
            ],
            mistakes=[
                mistake(
                    "Each bounce multiplies the speed by r, but the height by r².",
                    wrong("h_n = h_0*r^n", h_0=h0),
                ),
                mistake(
                    "You are one bounce short: the first bounce counts too.",
                    wrong("h_n = h_0*(r^2)^(n - 1)", h_0=h0),
                ),
                mistake(
                    "You are one bounce too far.",
                    wrong("h_n = h_0*(r^2)^(n + 1)", h_0=h0),
                ),
                mistake(
                    "Each bounce takes the same *fraction* of the height, not the same number of metres.",
                    wrong("h_n = h_0 - n*(h_0 - h_1)", h_0=h0),
                ),
            ],
            check="One bounce (n = 1) gives the answer of (c).",
        ),
        step(
            kept,
            "The share of the kinetic energy that a resting wall leaves, for r = 1 and for r = 0.",
            law("Kinetic energy", "e = r^2", source="(12.61)", e=kept, r=(1, 0)),
        ),
        choice(
            "f",
            "With r = 1 all of the kinetic energy is kept: elastic. With less than 1 some is lost: "
            "inelastic. With r = 0 the objects do not part again: perfectly inelastic.",
            a=sympy.Eq(kept[0], 1) & sympy.Eq(kept[1], 0),
            b=sympy.Eq(kept[1], 1) & sympy.Eq(kept[0], 0),
            c=False,
            d=False,
            mistakes={
                "b": "Put r = 1 into the change of kinetic energy, $(r^2 - 1)K_0$: is anything lost?",
                "c": (
                    "Perfectly inelastic means that the objects do not part again: what does that say "
                    "about their relative velocity?"
                ),
                "d": (
                    "Only one value of r keeps all of the energy, and only one leaves the objects "
                    "together; nothing happens at 1/2."
                ),
            },
        ),
        neglected(
            "c",
            "gravity during the touch",
            eps,
            "It changes the velocity by at most $u_g$, and the height with it: $u^2/2g$ by $u\\,u_g/g$.",
            law("Free fall", "u = g*tau", u=u_g),
            law("Change of the height", "epsilon = v*u/g", epsilon=eps, v=u, u=u_g),
            also=[u_g],
            supposing=[touch],
        ),
    )


def scene(m, v0, r, h0, n, g, answer, neglected):
    """A floor with just as much damping as r asks for, met at v0 without weight, and at the speed of the fall without it and with it."""
    loss, touch = -math.log(r), 2e-4
    k = m * (math.pi**2 + loss**2) / touch**2
    damped = {"m": m, "k": k, "q": 1, "g": 0.0, "R": 0.02, "y0": 0.02, "eta": 2 * m * loss / touch}
    fall, rise = math.sqrt(2 * g * h0), math.sqrt(2 * g * answer["c"])
    return [
        simulate(
            "ball_on_floor",
            damped | {"v0": -v0},
            rebound_speed=-answer["a"],
            energy_ratio=1 + answer["b"] / (m * v0 * v0 / 2),
        ),
        simulate("ball_on_floor", damped | {"v0": -fall}, rebound_speed=rise),
        simulate(
            "ball_on_floor",
            damped | {"v0": -fall, "g": g},
            animated=True,
            rebound_speed=rise,
            neglected=neglected["c"] / answer["c"] / 2,
        ),
    ]
