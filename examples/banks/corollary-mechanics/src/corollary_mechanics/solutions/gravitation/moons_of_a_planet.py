"""Two moons: Kepler's third law, and what stands behind it."""

from math import pi

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def derive(a, T, b, G):
    U, M, q = unknowns("U M q")
    return derivation(
        step(
            U,
            "Round the same planet, the squares of the periods go like the cubes of the radii.",
            law("Kepler's third law", "(U/T)^2 = (b/a)^3", U=U),
            where=U > 0,
            answers="a",
            mistakes=[
                mistake(
                    "The outer moon has a longer way, and it is slower as well.", wrong("U/T = b/a", U=U)
                ),
                mistake(
                    "Squares of the periods, cubes of the radii: you took them the other way round.",
                    wrong("(U/T)^3 = (b/a)^2", U=U),
                    where=U > 0,
                ),
            ],
        ),
        step(
            M,
            "Gravitation keeps the inner moon on its circle.",
            law("Newton's second law", "G*M/a^2 = a*(2*pi/T)^2"),
            answers="b",
            mistakes=[
                mistake("A turn is $2\\pi$ radians: its square is missing.", wrong("G*M/a^2 = a/T^2")),
                mistake("Take orbit and period of the same moon.", wrong("G*M/b^2 = b*(2*pi/T)^2")),
            ],
        ),
        step(
            q,
            "Speeds on circles round the same planet go with the root of the radius, $v^2 = GM/r$.",
            law("Ratio of speeds", "q = (a/T)/(b/U)", U=U),
            answers="c",
            mistakes=[
                mistake("The way counts, too, not only the time.", wrong("q = U/T", U=U)),
                mistake(
                    "The outer moon has the longer way: look at how radius and period enter.",
                    wrong("q = b/a"),
                ),
            ],
        ),
    )


def scene(a, T, b, G, answer):
    """A quarter of a revolution of each moon about a planet that is held, under an inverse square."""
    runs = []
    inner = 2 * pi * a / T
    for r, period, v in ((a, T, inner), (b, answer["a"], inner / answer["c"])):
        planet, moon = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(1.0, (r, 0.0), (0.0, v))
        quarter = Scene((planet, moon), (InverseSquare((0, 1), G * answer["b"]),), until=period / 4)
        runs.append(simulate(quarter, trajectory=(0.0, 0.0, 0.0, r), velocities=(0.0, 0.0, -v, 0.0)))
    return runs
