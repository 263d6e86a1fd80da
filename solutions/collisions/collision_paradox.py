"""A collision paradox: kinetic energy depends on the observer, its change in a collision does not."""

import sympy

from corollary.author import choice, derivation, explain, mistake, route, simulate, step, unknowns
from corollary.laws import change_of_kinetic_energy, law, sticking, wrong


def derive(m, v0, u, m2, w):
    V, dK, V_c, K_0, K_1, dK_c, V_h, dK_h = unknowns(
        "V dK V_c K_0 K_1 dK_c V_h dK_h",
        V="velocity of the wreck",
        V_c="velocity of the wreck, seen from one of the cars",
        V_h="velocity of the wreck, with unequal masses",
    )
    x_1, x_2, X, E_0, E_1, dE = unknowns(
        "x_1 x_2 X E_0 E_1 dE",
        x_1="velocity of the first car, as the observer sees it",
        x_2="that of the second car",
        X="velocity of the wreck, as the observer sees it",
    )
    return derivation(
        step(
            dK,
            "Momentum is kept: equal masses with opposite velocities stop. The change is the kinetic energy "
            "after less that before.",
            sticking(before=[(m, v0), (m, -v0)], together=V),
            change_of_kinetic_energy(dK, before=[(m, v0), (m, -v0)], after=[(m, V), (m, V)]),
            also=[V],
            answers="b",
            mistakes=[
                mistake(
                    "You counted one car only; both lose their kinetic energy.",
                    law("Change of kinetic energy", "dK = -m*v_0^2/2", v_0=v0),
                    instead="Change of kinetic energy",
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    law("Change of kinetic energy", "dK = -2*m*v_0^2", v_0=v0),
                    instead="Change of kinetic energy",
                ),
                mistake(
                    "Asked is the change: what is there after, less what was there before. Mind the sign.",
                    law("Change of kinetic energy", "dK = m*v_0^2", v_0=v0),
                    instead="Change of kinetic energy",
                ),
            ],
            check="Nothing moves afterwards: all of the kinetic energy of both cars is gone.",
        ),
        step(
            K_0,
            "From car 1 the other car comes at twice the speed, and car 1 is at rest.",
            law("Kinetic energy", "K = m*0^2/2 + m*v_2^2/2", K=K_0, v_2=-2 * v0),
            answers="c",
            mistakes=[
                mistake(
                    "The speed has to be doubled *before* squaring: $(2v_0)^2$ is not $2v_0^2$.",
                    wrong("K = m*2*v_0^2/2", K=K_0, v_0=v0),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("K = m*(2*v_0)^2", K=K_0, v_0=v0),
                ),
                mistake(
                    "In its own frame a car is at rest; only the other one counts.",
                    wrong("K = m*v_0^2/2 + m*(2*v_0)^2/2", K=K_0, v_0=v0),
                ),
            ],
            check="It is twice the kinetic energy seen from the road.",
        ),
        step(
            V_c,
            "In this frame momentum is kept too: one car at rest, one at -2v₀, and then both together.",
            sticking(before=[(m, 0), (m, -2 * v0)], together=V_c),
        ),
        step(
            K_1,
            "The wreck moves on, and both cars are in it.",
            law("Kinetic energy", "K = 2*m*V^2/2", K=K_1, V=V_c),
            answers="d",
            routes=[
                route(
                    "Seen from the road the wreck is at rest; an observer who moves at v₀ sees it move at "
                    "v₀.",
                    law("Kinetic energy", "K = 2*m*v_0^2/2", K=K_1, v_0=v0),
                )
            ],
            mistakes=[
                mistake(
                    "In this frame the wreck is not at rest: momentum was not zero before.",
                    wrong("K = 0*m*V^2", K=K_1, V=V_c),
                ),
                mistake(
                    "Both cars are in the wreck: its mass is 2m.",
                    wrong("K = m*V^2/2", K=K_1, V=V_c),
                ),
                mistake(
                    "The wreck does not move on at 2v₀: it has twice the mass.",
                    wrong("K = 2*m*(2*v_0)^2/2", K=K_1, v_0=v0),
                ),
            ],
            check="Half of what was there before in this frame.",
        ),
        step(
            dK_c,
            "After less before, in this frame.",
            law("Change of kinetic energy", "dK = K_1 - K_0", dK=dK_c),
            answers="e",
            routes=[
                route(
                    "The loss is the energy of the relative motion, which is the same for every observer.",
                    law("Change of kinetic energy", "dK = -(m/2)*(2*v_0)^2/2", dK=dK_c, v_0=v0),
                )
            ],
            mistakes=[
                mistake(
                    "That is the argument of the riddle: it forgets that the wreck still moves in this "
                    "frame.",
                    wrong("dK = -K_0", dK=dK_c),
                ),
                mistake(
                    "Asked is the change: after less before. Mind the sign.",
                    wrong("dK = K_0 - K_1", dK=dK_c),
                ),
            ],
            check="It is the same as seen from the road.",
        ),
        choice(
            "a",
            "In the frame of one car the wreck still moves after the collision. Half of the larger kinetic "
            "energy is left, and the loss is the same as seen from the road.",
            a=sympy.Ne(dK, dK_c),
            b=sympy.Eq(dK, dK_c),
            c=False,
            d=False,
            mistakes={
                "a": (
                    "The kinetic energy depends on the observer. But work out what is left after the "
                    "collision in the frame of the car."
                ),
                "c": (
                    "In the frame of the car the other one comes at twice the speed: the kinetic energy "
                    "before is larger."
                ),
                "d": (
                    "An observer who moves at a steady velocity may use the same laws; the argument fails "
                    "elsewhere."
                ),
            },
        ),
        explain(
            "f",
            "Says that kinetic energy before depends on the observer, and that this is no contradiction.",
            "Says that in the frame of one car the wreck is not at rest after the collision: it moves at v₀ "
            "and has the kinetic energy m v₀².",
            "Concludes that the change is the same, -m v₀², in both frames.",
            answer="The kinetic energy before is indeed twice as large in the frame of one car. But the "
            "argument takes for granted that nothing is left of it. In that frame the total momentum "
            "is not zero, so the wreck "
            "moves on, at v₀, and has the kinetic energy ½(2m)v₀² = mv₀². The change is mv₀² - 2mv₀² = "
            "-mv₀², just as seen from the road. It must be: the heat and the dents do not depend on who "
            "looks at them.",
        ),
        step(
            (x_1, x_2),
            "The observer sees every velocity less by u.",
            law("Relative motion", "v = u + w", source="(12.74)", v=(v0, -v0), w=(x_1, x_2)),
            mistakes=[
                mistake(
                    "Take the observer's velocity off both cars' velocities, with its sign and theirs: one "
                    "car seems faster, the other slower.",
                    wrong("w = c", w=(x_1, x_2), c=(v0 - u, -(v0 - u))),
                )
            ],
        ),
        step(X, "Momentum is kept for this observer too.", sticking(before=[(m, x_1), (m, x_2)], together=X)),
        step(
            (E_0, E_1, dE),
            "Both cars before, the wreck of both after, and the difference.",
            law("Before", "K_0 = m*v_1^2/2 + m*v_2^2/2", K_0=E_0, v_1=x_1, v_2=x_2),
            law("After", "K_1 = 2*m*V^2/2", K_1=E_1, V=X),
            law("Change of kinetic energy", "dK = K_1 - K_0", dK=dE, K_1=E_1, K_0=E_0),
            answers="g",
            mistakes=[
                mistake(
                    "For a moving observer the wreck is not at rest.",
                    law("After", "K_1 = 0*m*V^2", K_1=E_1, V=X),
                    instead="After",
                ),
                mistake(
                    "Both cars are in the wreck: its mass is 2m.",
                    law("After", "K_1 = m*V^2/2", K_1=E_1, V=X),
                    instead="After",
                ),
                mistake(
                    "That is the kinetic energy before seen from the road; the observer moves.",
                    law("Before", "K_0 = m*v_0^2", K_0=E_0, v_0=v0),
                    instead="Before",
                ),
            ],
            check="The change does not depend on u. With u = v₀ these are the answers of (c), (d), (e).",
        ),
        step(
            V_h,
            "Now the momenta do not cancel: the wreck moves on.",
            sticking(before=[(m, v0), (m2, -w)], together=V_h),
        ),
        step(
            dK_h,
            "After less before.",
            change_of_kinetic_energy(dK_h, before=[(m, v0), (m2, -w)], after=[(m, V_h), (m2, V_h)]),
            answers="h",
            routes=[
                route(
                    "The loss is the energy of the relative motion.",
                    law(
                        "Loss in a perfectly inelastic collision",
                        "dK = -m_1*m_2/(m_1 + m_2)*(v_0 + w)^2/2",
                        dK=dK_h,
                        m_1=m,
                        m_2=m2,
                        v_0=v0,
                    ),
                )
            ],
            mistakes=[
                mistake(
                    "Unequal cars do not stop each other: the wreck still moves.",
                    wrong(
                        "dK = -m_1*v_0^2/2 - m_2*w^2/2",
                        dK=dK_h,
                        m_1=m,
                        v_0=v0,
                        m_2=m2,
                    ),
                ),
                mistake(
                    "Head-on the cars come together at the *sum* of their speeds.",
                    wrong(
                        "dK = -m_1*m_2/(m_1 + m_2)*(v_0 - w)^2/2",
                        dK=dK_h,
                        m_1=m,
                        m_2=m2,
                        v_0=v0,
                    ),
                ),
                mistake(
                    "You used the mass of car 1 for both.",
                    wrong("dK = -m_1/2*(v_0 + w)^2/2", dK=dK_h, m_1=m, v_0=v0),
                ),
            ],
            check="With equal masses and speeds it is the answer of (b).",
        ),
    )


def scene(m, v0, u, m2, w, answer):
    """One car gets stuck in the other, seen from the other, where the change of kinetic energy must be the same."""
    return [
        simulate(
            "bullet_block", {"m": m, "M": m, "v": 2 * v0}, velocities=(v0, v0), energy_change=answer["e"]
        ),
        simulate("bullet_block", {"m": m, "M": m2, "v": v0 + w}, energy_change=answer["h"]),
    ]
