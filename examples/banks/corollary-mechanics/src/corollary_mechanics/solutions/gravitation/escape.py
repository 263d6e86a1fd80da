"""Off a small planet: potential energy that goes with 1/r."""

from math import acos, sqrt

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def derive(R, rho, q, G):
    M, g, v, h = unknowns("M g v h")
    return derivation(
        step(M, "A ball.", law("Mass", "M = 4*pi*R^3*rho/3")),
        step(
            g,
            "The law of gravitation, for a kilogram on the ground.",
            law("Law of gravitation", "g = G*M/R^2"),
            answers="a",
            mistakes=[
                mistake("The volume of a ball has a factor 4π/3.", wrong("g = G*rho*R")),
                mistake(
                    "That is gravity in the middle between the ground and the centre: the distance counts "
                    "from the centre.",
                    wrong("g = G*M/(2*R)^2"),
                ),
            ],
        ),
        step(
            v,
            "The kinetic energy must be as large as what is needed to get infinitely far.",
            law("Conservation of energy", "v^2/2 = G*M/R"),
            where=v > 0,
            answers="b",
            mistakes=[
                mistake(
                    "That is the speed on a circle just above the ground.", wrong("v^2 = G*M/R"), where=v > 0
                ),
                mistake(
                    "Gravity gets weaker on the way up; you also lost a factor.",
                    wrong("v^2 = g*R/2"),
                    where=v > 0,
                ),
            ],
        ),
        step(
            h,
            "At the highest point all is potential energy.",
            law("Conservation of energy", "(q*v)^2/2 - G*M/R = -G*M/(R + h)"),
            answers="c",
            mistakes=[
                mistake("Gravity is not the same all the way up: it gets weaker.", wrong("(q*v)^2/2 = g*h")),
                mistake("That is the distance from the centre.", wrong("(q*v)^2/2 - G*M/R = -G*M/h")),
            ],
            check="As q goes to 1 the height grows without limit.",
        ),
        choice(
            "d",
            "Its energy is negative, as it is slower than the speed of escape, so that it is bound; a circle takes exactly "
            "1/√2 of that speed.",
            a=False,
            b=True,
            c=False,
            d=False,
            mistakes={
                "a": "On a circle the speed is 71 % of that of escape, exactly.",
                "c": "That is the orbit at the speed of escape itself.",
                "d": "Then it would be faster than the speed of escape.",
            },
        ),
    )


def scene(R, rho, q, G, answer):
    """Thrown up against an inverse square, until the closed form of a radial fall says that it turns: there it is."""
    r, v = R + answer["c"], q * answer["b"]
    strength = answer["a"] * R**2
    x = R / r
    t = sqrt(r**3 / (2 * strength)) * (sqrt(x * (1 - x)) + acos(sqrt(x)))
    planet, probe = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(1.0, (R, 0.0), (v, 0.0))
    return [
        simulate(
            Scene((planet, probe), (InverseSquare((0, 1), strength),), until=t), trajectory=(0.0, 0.0, r, 0.0)
        )
    ]
