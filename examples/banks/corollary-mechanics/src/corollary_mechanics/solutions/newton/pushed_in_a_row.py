"""Two crates, one push: what stands between must move the other crate only."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(m, M, F):
    a, P, Q = unknowns("a P Q")
    return derivation(
        step(
            a,
            "The push moves both crates.",
            law("Newton's second law", "F = (m + M)*a"),
            answers="a",
            mistakes=[
                mistake("Your push moves the crate in front as well.", wrong("F = m*a")),
                mistake("That is as if the crate in front were alone.", wrong("F = M*a")),
            ],
        ),
        step(
            P,
            "The crate in front is moved by nothing but its neighbour.",
            law("Newton's second law", "P = M*a"),
            answers="b",
            mistakes=[
                mistake(
                    "Your push does not act on the crate in front; part of it is needed for the rear one.",
                    wrong("P = F"),
                ),
                mistake("Look at the forces on the crate in front only; its mass counts.", wrong("P = m*a")),
                mistake("The push is not shared in halves. How much does each crate need?", wrong("P = F/2")),
            ],
            check="It is less than your push, since the rear crate needs some of it.",
        ),
        step(
            Q,
            "Now the first crate is the one that is pushed by its neighbour alone; the acceleration is as "
            "large as before.",
            law("Newton's second law", "Q = m*a"),
            answers="c",
            mistakes=[
                mistake(
                    "The roles have changed: which crate is pushed by the other one only?", wrong("Q = P")
                ),
                mistake("Your push acts on one crate only.", wrong("Q = F")),
            ],
            check="Both forces between the crates together make up your push.",
        ),
    )


def scene(m, M, F, answer):
    """Each crate with the forces on it alone: both must stay together for a second."""

    def together(rear, front):
        pushes = (ForceFunction(0, lambda t, x, v: (rear,)), ForceFunction(1, lambda t, x, v: (front,)))
        return Scene((Body(m, (0.0,), (0.0,)), Body(M, (1.0,), (0.0,))), pushes, until=1.0)

    a = answer["a"]
    return [
        simulate(together(F - answer["b"], answer["b"]), velocities=(a, a)),
        simulate(together(-answer["c"], answer["c"] - F), velocities=(-a, -a)),
    ]
