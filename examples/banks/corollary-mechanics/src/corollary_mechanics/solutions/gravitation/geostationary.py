"""Always above the same place: the period gives the orbit."""

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def derive(T, M, R, G):
    r, h, v = unknowns("r h v", r="distance from the centre of the planet")
    return derivation(
        step(
            r,
            "Gravitation keeps it on a circle with the period of the planet.",
            law("Newton's second law", "G*M/r^2 = r*(2*pi/T)^2"),
            where=r > 0,
        ),
        step(
            h,
            "The radius of the orbit counts from the centre.",
            law("Height", "h = r - R"),
            answers="a",
            mistakes=[
                mistake("That is the distance from the centre of the planet.", wrong("h = r")),
                mistake("Take the radius away from it, not its double.", wrong("h = r - 2*R")),
            ],
        ),
        step(
            v,
            "Once round in T.",
            law("Speed on a circle", "v = 2*pi*r/T"),
            answers="b",
            mistakes=[
                mistake("That is how fast the ground below moves.", wrong("v = 2*pi*R/T")),
                mistake(
                    "The circle goes round the centre; you took its height for its radius.",
                    wrong("v = 2*pi*h/T"),
                ),
            ],
        ),
        choice(
            "c",
            "The mass of the satellite cancels.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "It is attracted more. What does its inertia do?",
                "c": "It has more inertia. What does the attraction do?",
            },
        ),
    )


def scene(T, M, R, G, answer):
    """A quarter of a revolution about a planet that is held, under an inverse square."""
    r, v = R + answer["a"], answer["b"]
    planet, satellite = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(1.0, (r, 0.0), (0.0, v))
    quarter = Scene((planet, satellite), (InverseSquare((0, 1), G * M),), until=T / 4)
    return [simulate(quarter, trajectory=(0.0, 0.0, 0.0, r), velocities=(0.0, 0.0, -v, 0.0))]
