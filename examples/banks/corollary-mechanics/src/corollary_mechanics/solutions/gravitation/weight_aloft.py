"""On board a space station: gravitation is there, and turns the velocity."""

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import gravitation, law, wrong
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def derive(h, m, M, R, G):
    r, F, v, T = unknowns("r F v T")
    return derivation(
        step(r, "Distances count from the centre of the Earth.", law("Distance", "r = R + h")),
        step(
            F,
            "The law of gravitation.",
            gravitation(F, G=G, M=M, m=m, r=r),
            answers="a",
            mistakes=[
                mistake("That is the weight on the ground.", wrong("F = G*M*m/R^2")),
                mistake(
                    "The force falls with the square of the distance from the centre.",
                    wrong("F = G*M*m/(R*r)"),
                ),
            ],
            check="It is not much less than on the ground.",
        ),
        step(
            v,
            "Gravitation is the force that the circle asks for.",
            law("Newton's second law", "G*M/r^2 = v^2/r"),
            where=v > 0,
            answers="b",
            mistakes=[
                mistake("That is the speed with which it would escape.", wrong("v^2 = 2*G*M/r"), where=v > 0),
                mistake(
                    "Count the radius of the circle from the centre of the Earth.",
                    wrong("v^2 = G*M/R"),
                    where=v > 0,
                ),
            ],
        ),
        step(
            T,
            "Once along the circle.",
            law("Speed on a circle", "v = 2*pi*r/T"),
            answers="c",
            mistakes=[
                mistake("The circle is larger than the Earth.", wrong("v = 2*pi*R/T")),
                mistake("The circumference has the radius twice.", wrong("v = pi*r/T")),
            ],
        ),
        choice(
            "d",
            "Both have the same acceleration, so that nothing presses them together.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "Compare your result in (a) with the weight on the ground.",
                "c": "Things fall in a vacuum, too.",
            },
        ),
    )


def scene(h, m, M, R, G, answer):
    """Bodies that attract each other, in thousands of kilometres: a quarter of an orbit later it stands at right angles."""
    r, v, T = R + h, answer["b"], answer["c"]
    earth, ship = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(m, (r, 0.0), (0.0, v))
    quarter = Scene((earth, ship), (InverseSquare((0, 1), answer["a"] * r**2),), until=T / 4)
    return [simulate(quarter, trajectory=(0.0, 0.0, 0.0, r), velocities=(0.0, 0.0, -v, 0.0))]
