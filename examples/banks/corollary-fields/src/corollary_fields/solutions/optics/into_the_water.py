"""Light into water: Snell's law, both ways."""

from corollary.author import HALF_PI, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(alpha, h, n):
    beta, x, gam = unknowns("beta x phi")
    return derivation(
        step(
            beta,
            "Snell's law; in air the refractive index is 1.",
            law("Snell's law", "sin(alpha) = n*sin(beta)"),
            where=(beta > 0) & (beta < HALF_PI),
            answers="a",
            mistakes=[
                mistake("The sines stand in that ratio, not the angles.", wrong("alpha = n*beta")),
                mistake(
                    "Angles count from the vertical.",
                    wrong("cos(alpha) = n*sin(beta)"),
                    where=(beta > 0) & (beta < HALF_PI),
                ),
            ],
            check="In the denser medium the ray is closer to the vertical.",
        ),
        step(
            x,
            "Depth and distance make a triangle with the ray.",
            law("Triangle", "tan(beta) = x/h"),
            answers="b",
            mistakes=[
                mistake("The ray is bent at the surface.", wrong("tan(alpha) = x/h")),
                mistake("h is the upright side, not the length of the ray.", wrong("sin(beta) = x/h")),
            ],
        ),
        step(
            gam,
            "At the limit the ray outside would run along the surface.",
            law("Snell's law", "n*sin(phi) = 1", phi=gam),
            where=(gam > 0) & (gam < HALF_PI),
            answers="c",
            mistakes=[
                mistake("The sine stands in the law.", wrong("n*tan(phi) = 1", phi=gam)),
                mistake(
                    "That angle counts from the surface.",
                    wrong("n*cos(phi) = 1", phi=gam),
                    where=(gam > 0) & (gam < HALF_PI),
                ),
            ],
        ),
    )
