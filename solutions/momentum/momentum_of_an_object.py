"""Momentum of an object: a vector along the velocity, and what becomes of Newton's second law when a mass changes."""

from corollary.author import choice, derivation, mistake, step, unknown, vector
from corollary.laws import kinetic_energy, magnitude, momentum, wrong


def derive(m, vx, vy):
    p, size = vector("p"), unknown("p")
    return derivation(
        step(
            p,
            "Momentum is mass times velocity, component by component.",
            momentum(p, m, (vx, vy)),
            answers="a",
            mistakes=[
                mistake(
                    "You lost a sign: a component of the momentum has the sign of that component of the "
                    "velocity.",
                    momentum(p, m, (vx, -vy)),
                ),
                mistake(
                    "Those are kinetic energies; momentum is $mv$, without a square.",
                    *(kinetic_energy(p[i], m, v) for i, v in enumerate((vx, vy))),
                ),
                mistake("The components have changed places.", momentum(p, m, (vy, vx))),
                mistake(
                    "That is the velocity; multiply it by the mass.",
                    wrong("p = v", p=p, v=(vx, vy)),
                ),
            ],
            check="It points the way the object moves.",
        ),
        step(
            size,
            "The magnitude of a vector follows from its components by Pythagoras.",
            magnitude(size, p),
            answers="b",
            mistakes=[
                mistake(
                    "You added the components. They are at right angles: add their squares and take the "
                    "root.",
                    wrong("p = p_x + p_y", p=size, p_x=p[0], p_y=p[1]),
                ),
                mistake(
                    "You added the sizes of the components. They are at right angles: add their squares and "
                    "take the root.",
                    wrong("p = p_x - p_y", p=size, p_x=p[0], p_y=p[1]),
                ),
                mistake(
                    "Take the root of the sum of the squares.",
                    wrong("p = p_x^2 + p_y^2", p=size, p_x=p[0], p_y=p[1]),
                ),
                mistake(
                    "The squares of both components add up, whatever their signs.",
                    wrong("p = sqrt(abs(p_x^2 - p_y^2))", p=size, p_x=p[0], p_y=p[1]),
                ),
            ],
            check="It is the mass times the speed, larger than each component and smaller than their sum.",
        ),
        choice(
            "c",
            "Momentum $m\\vec v$ has the direction of the velocity; kinetic energy $mv^2/2$ has only a size.",
            a=True,
            b=False,
            c=False,
            d=False,
            mistakes={
                "b": (
                    "It is the other way round: look at which of the two turns round when the velocity does."
                ),
                "c": (
                    "Kinetic energy does not change when you turn the velocity round; what kind of "
                    "quantity does that make it?"
                ),
                "d": "Momentum turns round when the velocity does; what kind of quantity does that make it?",
            },
        ),
        choice(
            "d",
            "Mass that comes or goes carries momentum with it. Newton's second law speaks of a definite lot "
            "of matter; so count the object and that mass "
            "together, and the law holds. For the object "
            "alone, $d(mv)/dt = m\\,dv/dt + v\\,dm/dt$ depends on who looks: to an observer who moves "
            "along, the last term vanishes, yet the force is the same for both.",
            a=False,
            b=False,
            c=True,
            d=False,
            mistakes={
                "a": (
                    "Think of a rocket in empty space: no external force acts on it, and yet it accelerates."
                ),
                "b": (
                    "Think of a wagon that leaks sand: it goes on at the same velocity without any force, "
                    "though $mv$ of the wagon shrinks."
                ),
                "d": (
                    "It does, if you choose the system well: what is the same lot of matter before and after?"
                ),
            },
        ),
    )
