"""Elastic collision with a block at rest: momentum and energy together, and what very unequal masses do."""

import sympy

from corollary.author import derivation, mistake, reject, route, simulate, step, unknowns, vector
from corollary.laws import (
    after_elastic,
    conservation_of_momentum,
    elastic,
    in_the_limit,
    law,
    momentum,
    restitution,
    wrong,
)


def derive(mA, mB, vA):
    v_A1, v_B1, q, p = unknowns("v_A1 v_B1 q p", v_B1="velocity of B after the collision")
    e, f, g = vector("e", "A B"), vector("f", "A B"), vector("g", "A B")
    before, after = [(mA, vA), (mB, 0)], [(mA, v_A1), (mB, v_B1)]
    twins, apart = [(mA, vA), (mA, 0)], [(mA, e[0]), (mA, e[1])]
    formulas = after_elastic(A=(mA, vA), B=(mB, 0))
    return derivation(
        step(
            v_A1,
            "Momentum and kinetic energy are both kept: two equations for two velocities.",
            conservation_of_momentum(before=before, after=after),
            elastic(before=before, after=after),
            also=[v_B1],
            answers="a",
            reject=[
                reject(
                    "the velocities would be those from before: A would have passed through B",
                    v_A1=vA,
                    v_B1=0,
                )
            ],
            mistakes=[
                mistake(
                    "You let the blocks stick together; an elastic collision keeps the kinetic energy.",
                    law("Perfectly inelastic", "v_A = v_B", v_A=v_A1, v_B=v_B1),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "The masses have changed places: a light A bounces back from a heavy B.",
                    law(
                        "Conservation of mechanical energy",
                        "v_A1 = (m_B - m_A)/(m_A + m_B)*v_A",
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                    ),
                ),
            ],
            check="With equal masses A stops. A lighter A bounces back (negative), a heavier one moves on.",
        ),
        step(
            v_B1,
            "With A's velocity known, momentum gives B's.",
            conservation_of_momentum(before=before, after=after),
            answers="b",
            routes=[
                route(
                    "In an elastic collision the relative velocity is only turned round (r = 1).",
                    restitution(1, A=(vA, v_A1), B=(0, v_B1)),
                )
            ],
            mistakes=[
                mistake(
                    "A keeps some momentum, or takes more than it had: it is not all given to B. Put A's "
                    "velocity in, with its sign.",
                    wrong("m_A*v_A = m_B*v_B1", m_A=mA, v_A=vA, m_B=mB),
                ),
                mistake(
                    "Momentum has a direction: put A's velocity after the collision in with its sign.",
                    wrong(
                        "m_A*v_A = -m_A*v_A1 + m_B*v_B1",
                        m_A=mA,
                        v_A=vA,
                        m_B=mB,
                    ),
                ),
            ],
            check="B moves off as fast ahead of A as A came towards B.",
        ),
        step(
            q,
            "B had no kinetic energy before; what it has now came from A.",
            law(
                "Fraction of the kinetic energy",
                "q = (m_B*v_B1^2/2)/(m_A*v_A^2/2)",
                m_B=mB,
                m_A=mA,
                v_A=vA,
            ),
            answers="c",
            mistakes=[
                mistake(
                    "That is a fraction of the momentum; the kinetic energy goes with the square of the "
                    "speed.",
                    wrong(
                        "q = m_B*v_B1/(m_A*v_A)",
                        m_B=mB,
                        m_A=mA,
                        v_A=vA,
                    ),
                ),
                mistake(
                    "That is the fraction that A keeps.",
                    wrong("q = v_A1^2/v_A^2", v_A=vA),
                ),
                mistake(
                    "You left out the masses: kinetic energy is mv²/2.",
                    wrong("q = v_B1^2/v_A^2", v_A=vA),
                ),
            ],
            check="It is 1 for equal masses, and never more: nobody gives away more than there is.",
        ),
        step(
            p,
            "B had no momentum before; what it has now was given to it by A.",
            momentum(p, mB, v_B1),
            answers="d",
            routes=[
                route(
                    "The same from what A has lost.",
                    law("Conservation of momentum", "p = m_A*v_A - m_A*v_A1", m_A=mA, v_A=vA),
                )
            ],
            mistakes=[
                mistake("That is the momentum A keeps; asked is what it gives to B.", momentum(p, mA, v_A1)),
                mistake(
                    "That is all of A's momentum; it gives exactly that only if it stops.",
                    momentum(p, mA, vA),
                ),
                mistake("Take B's own mass with B's velocity.", momentum(p, mA, v_B1)),
            ],
            check="If A bounces back, it has given away more momentum than it had.",
        ),
        step(
            e,
            "The same two laws with equal masses.",
            conservation_of_momentum(before=twins, after=apart),
            elastic(before=twins, after=apart),
            answers="e",
            reject=[
                reject(
                    "the velocities would be those from before: A would have passed through B", e_A=vA, e_B=0
                )
            ],
            mistakes=[
                mistake(
                    "You let the blocks move on together; an elastic collision keeps the kinetic energy.",
                    law("Perfectly inelastic", "v_A = v_B", v_A=e[0], v_B=e[1]),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "A does not bounce back from a block of the same mass at rest.",
                    law("Turned round", "v_A1 = -v_A", v_A1=e[0], v_A=vA),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check="The blocks exchange their velocities.",
        ),
        step(
            f,
            r"Divide numerator and denominator of the general result by $m_B$: $v_{A,1} = \frac{m_A/m_B - "
            r"1}{m_A/m_B + 1}v_A$ and $v_{B,1} = \frac{2m_A/m_B}{m_A/m_B + 1}v_A$, and let $m_A/m_B$ go to "
            r"0.",
            in_the_limit(f, formulas, mB, sympy.oo, "A's mass is negligible beside B's"),
            answers="f",
            mistakes=[
                mistake(
                    "You have taken the other limit: here B is the heavy one.",
                    in_the_limit(f, formulas, mB, 0, "B's mass is negligible beside A's"),
                ),
                mistake(
                    "They do not stick together: an elastic collision leaves A all of its kinetic energy.",
                    wrong("v = 0", v=f),
                ),
                mistake(
                    "B takes up twice A's momentum, but it is so heavy that its velocity is negligible.",
                    wrong("v = v_limit", v=f, v_limit=(-vA, 2 * vA)),
                ),
                mistake(
                    "B hardly notices; so A keeps its speed, but it cannot go on through B.",
                    wrong("v = v_limit", v=f, v_limit=(vA, 0)),
                ),
            ],
            check="A wall: the velocity is just turned round.",
        ),
        step(
            g,
            r"Divide by $m_A$ instead: $v_{A,1} = \frac{1 - m_B/m_A}{1 + m_B/m_A}v_A$ and $v_{B,1} = "
            r"\frac{2}{1 + m_B/m_A}v_A$, and let $m_B/m_A$ go to 0.",
            in_the_limit(g, formulas, mB, 0, "B's mass is negligible beside A's"),
            answers="g",
            mistakes=[
                mistake(
                    "You have taken the other limit: here B is the light one.",
                    in_the_limit(g, formulas, mB, sympy.oo, "A's mass is negligible beside B's"),
                ),
                mistake(
                    "B does not stay with A: they part as fast as they came together.",
                    wrong("v = v_limit", v=g, v_limit=(vA, vA)),
                ),
                mistake(
                    "They exchange their velocities only if the masses are equal; a heavy A is not stopped "
                    "by a light B.",
                    wrong("v = v_limit", v=g, v_limit=(0, vA)),
                ),
            ],
            check="Seen from A, the light block comes at it and is turned round, as from a wall.",
        ),
    )


def scene(mA, mB, vA, answer):
    """A row of two balls, from Newton's second law: with these masses, with equal ones, and with very unequal ones."""
    speed = abs(vA)
    return [
        simulate(
            "cradle",
            {"N": 2, "masses": (mA, mB), "v0": speed},
            animated=True,
            velocities=(answer["a"], answer["b"]),
        ),
        simulate("cradle", {"N": 2, "masses": (mA, mA), "v0": speed}, velocities=answer["e"]),
        simulate(
            "cradle", {"N": 2, "masses": (mA, 1e6 * mA), "v0": speed}, neglected=1e-5, velocities=answer["f"]
        ),
        simulate(
            "cradle", {"N": 2, "masses": (mA, 1e-6 * mA), "v0": speed}, neglected=1e-5, velocities=answer["g"]
        ),
    ]
