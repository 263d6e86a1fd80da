"""Pulled by a hanging block: friction on the one, weight on the other."""

from corollary.author import derivation, mistake, route, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.contact import Friction
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(M, m, mu, g):
    N, f, a, T, S = unknowns("N f a T S", N="normal force", T="tension of the string")
    return derivation(
        step(N, "Vertically the table carries the block on it.", law("Equilibrium", "N = M*g")),
        step(f, "The block slides.", law("Kinetic friction", "f = mu*N")),
        step(
            a,
            "Newton's second law for each block along its way; the tension is the same at both ends.",
            law("Newton's second law, hanging block", "m*g - T = m*a"),
            law("Newton's second law, block on the table", "T - f = M*a"),
            also=[T],
            answers="a",
            mistakes=[
                mistake(
                    "Friction is missing.",
                    law("Newton's second law, block on the table", "T = M*a"),
                    instead="Newton's second law, block on the table",
                ),
                mistake(
                    "You let the string pull with the whole weight of the hanging block. If it did, what "
                    "would be left to accelerate that block?",
                    law("Tension", "T = m*g"),
                    instead="Newton's second law, hanging block",
                ),
                mistake(
                    "Friction acts against the motion: mind its sign.",
                    law("Newton's second law, block on the table", "T + f = M*a"),
                    instead="Newton's second law, block on the table",
                ),
            ],
            check=(
                "Without friction, and with a very light block on the table, the other one would fall freely."
            ),
        ),
        step(
            T,
            "From the hanging block.",
            law("Newton's second law", "m*g - T = m*a"),
            answers="b",
            routes=[
                route(
                    "Or from the block on the table.",
                    law("Newton's second law, block on the table", "T - f = M*a"),
                )
            ],
            mistakes=[
                mistake("With that tension the hanging block would not be accelerated.", wrong("T = m*g")),
                mistake(
                    "The hanging block is accelerated downwards: which force is the larger one?",
                    wrong("T = m*g + m*a"),
                ),
                mistake("The string must overcome friction, too.", wrong("T = M*a")),
            ],
        ),
        step(
            S,
            "Nothing is accelerated: the string carries the hanging block.",
            law("Equilibrium", "S = m*g", S=S),
            answers="c",
            mistakes=[
                mistake(
                    "The tension changes at the moment it is let go; what does the string carry as long as "
                    "all is at rest?",
                    wrong("S = T", S=S),
                ),
                mistake(
                    "The hand holds the block on the table; look at the forces on the hanging one.",
                    wrong("S = m*g - mu*M*g", S=S),
                ),
            ],
            check="It is more than while they move.",
        ),
    )


def scene(M, m, mu, g, answer):
    """The string laid out in a line, for a second: a rod from the block that rubs to the one that its weight pulls; and that one alone."""
    a = answer["a"]
    blocks = (Body(M, (0.0,), (0.0,)), Body(m, (1.0,), (0.0,)))
    pulled = (Rod((0, 1)), Friction(0, mu, g), ForceFunction(1, lambda t, x, v: (m * g,)))
    net = ForceFunction(0, lambda t, x, v: (m * g - answer["b"],))
    return [
        simulate(Scene(blocks, pulled, until=1.0), velocities=(a, a), trajectory=(a / 2, 1.0 + a / 2)),
        simulate(Scene((Body(m, (0.0,), (0.0,)),), (net,), until=1.0), velocities=(a,)),
    ]
