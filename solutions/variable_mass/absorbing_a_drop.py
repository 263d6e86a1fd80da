"""Absorbing a drop, and thrust: the momentum of everything that will be one body in the end."""

from corollary.author import derivation, mistake, route, simulate, step, unknowns
from corollary.laws import (
    change_in_absorption,
    change_of_momentum,
    growing,
    impulse_of_growing_weight,
    law,
    sticking,
    thrust,
    wrong,
)


def derive(m, dm, V, v, u, vrel, mdot, t, R, g, dv):
    v_1, dp, F_t, M, J, v_2 = unknowns("v_1 dp F_t M J v_2")
    return derivation(
        step(
            v_1,
            "Body and drop together are isolated: their momentum before is that of the body and drop moving "
            "as one after.",
            sticking(before=[(m, v), (dm, u)], together=v_1),
            answers="a",
            mistakes=[
                mistake(
                    "The drop comes to meet the body: its velocity is negative, and so is its momentum.",
                    wrong("m*v - dm*u = (m + dm)*v_1"),
                ),
                mistake(
                    "The drop brings momentum of its own; you treated it as if it were at rest.",
                    wrong("m*v = (m + dm)*v_1"),
                ),
                mistake(
                    "Afterwards the mass is $m + \\Delta m$: the drop moves on with the body.",
                    wrong("m*v + dm*u = m*v_1"),
                ),
            ],
            check=(
                "The new velocity lies between those of the body and the drop, closer to that of the "
                "heavier one."
            ),
        ),
        step(
            dp,
            "The system is body and drop, before and after: before, the drop already has the momentum "
            "$u\\,\\Delta m$.",
            change_in_absorption(dp, m=m, dm=dm, v=v, u=u, dv=dv),
            answers="b",
            routes=[
                route(
                    "Or straight from the definition, with all the momentum after and all the momentum "
                    "before.",
                    law(
                        "Change of momentum",
                        "dp = (m + dm)*(v + dv) - (m*v + dm*u)",
                    ),
                )
            ],
            mistakes=[
                mistake(
                    "That is the change for the body alone. Bringing the drop from $u$ to the body's "
                    "velocity takes momentum too.",
                    change_of_momentum(dp, m, before=v, after=v + dv),
                ),
                mistake(
                    "You left out the momentum the drop had before: use $(v - u)\\,\\Delta m$.",
                    wrong("dp = m*dv + v*dm + dm*dv"),
                ),
                mistake(
                    "The velocity of the drop relative to the body is $u - v$; the drop has to gain $v - "
                    "u$, so $u$ is subtracted.",
                    wrong("dp = m*dv + (v + u)*dm + dm*dv"),
                ),
            ],
            check="With $\\Delta m = 0$ it is $m\\,\\Delta v$, the familiar case.",
        ),
        step(
            F_t,
            "In the rocket equation the mass thrown out acts like a force; only the velocity relative to "
            "the rocket counts.",
            thrust(F_t, vrel, mdot),
            answers="c",
            mistakes=[
                mistake(
                    "The velocity relative to the ground is not what counts; the exhaust is pushed off from "
                    "the rocket.",
                    wrong("F = (v_rel + V)*R", F=F_t, v_rel=vrel, R=mdot),
                ),
                mistake(
                    "The rocket loses mass (dm/dt is negative) and the exhaust goes backwards (negative): "
                    "the product of both signs pushes forward.",
                    wrong("F = -v_rel*R", F=F_t, v_rel=vrel, R=mdot),
                ),
            ],
            check=(
                "Positive: exhaust backwards, push forwards. It does not depend on how fast the rocket "
                "flies already."
            ),
        ),
        step(
            M,
            "The mass of the falling drop after the time t.",
            growing(M, m=m, R=R, t=t),
        ),
        step(
            J,
            "The weight grows with the mass. Its impulse is $\\int_0^t (m + R\\,t')\\,g\\,dt'$.",
            impulse_of_growing_weight(J, m=m, R=R, g=g, t=t),
            mistakes=[
                mistake(
                    "The weight grows on the way: you used the weight of the drop at the start.",
                    wrong("J = m*g*t"),
                ),
                mistake(
                    "The weight grows on the way: you used the weight of the drop at the end all the time.",
                    wrong("J = M*g*t"),
                ),
            ],
        ),
        step(
            v_2,
            "The vapour brings no momentum ($u = 0$), so the momentum of the drop changes by the impulse of "
            "its weight alone.",
            law(
                "Impulse",
                "M*v_1 - m*v_0 = J",
                source="(12.19), (12.127)",
                holds="what is taken up was at rest",
                v_1=v_2,
                v_0=v,
            ),
            answers="d",
            mistakes=[
                mistake(
                    "That is free fall of a drop of constant mass. Vapour at rest has to be brought up to "
                    "speed.",
                    wrong("v_1 = v_0 + g*t", v_1=v_2, v_0=v),
                ),
                mistake(
                    "You left out the momentum with which the drop starts.",
                    wrong("M*v_1 = J", v_1=v_2),
                ),
                mistake(
                    "The momentum after is that of the grown drop: its mass is $m + Rt$.",
                    wrong("m*v_1 - m*v_0 = J", v_1=v_2, v_0=v),
                ),
            ],
            check=(
                "With R = 0 this is $v + gt$; the faster it grows, the more it is held back, down to "
                "$gt/2$ for a drop that grows from almost nothing."
            ),
        ),
    )


def scene(m, dm, V, v, u, vrel, mdot, F, t, R, g, dv, answer):
    """The drop is dragged along by the body; the rocket, a million times as heavy as the fuel of the moment, throws it out in puffs."""
    drop, caught = {"m": m, "dm": dm, "v": v, "u": u}, v + dv
    # The force brings body and drop to that velocity in the time in which its impulse is the change of their momentum.
    pushed = {"F": F, "t": answer["b"] / F, "dt": 1e-9 * answer["b"] / F}
    fuel = -mdot
    rocket = {"m0": 1e6 * fuel, "m1": 1e6 * fuel - fuel, "v_rel": -vrel}
    return [
        simulate("absorbed_drop", drop, animated=True, velocities=(answer["a"], answer["a"])),
        simulate("absorbed_drop", drop | pushed, velocities=(caught, caught), momentum_change=answer["b"]),
        # Seen from the rocket: its velocity V does not count. In one second its mass changes by a millionth.
        simulate("rocket", rocket, velocities=answer["c"] / (1e6 * fuel), neglected=1e-6),
        simulate("growing_drop", {"m": m, "v": v, "R": R, "g": g, "t": t}, velocities=answer["d"]),
    ]
