"""Weighed in water: the difference is the weight of the water displaced."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, F, rho, g):
    B, V, d = unknowns("B V d")
    return derivation(
        step(
            B,
            "The thread and the water together carry the weight.",
            law("Equilibrium of forces", "F + B = m*g"),
            answers="a",
            mistakes=[
                mistake("That is what is left for the thread.", wrong("B = F")),
                mistake("The water pushes upwards: the weight is the sum of both.", wrong("B = m*g + F")),
            ],
        ),
        step(
            V,
            "The buoyant force is the weight of the water displaced.",
            law("Archimedes", "B = rho*g*V", V=V),
            answers="b",
            mistakes=[
                mistake("The thread's pull is not the buoyancy.", wrong("F = rho*g*V", V=V)),
                mistake("That is the volume of as much water as the metal weighs.", wrong("m = rho*V", V=V)),
            ],
        ),
        step(
            d,
            "Mass by volume.",
            law("Density", "d = m/V", d=d, V=V),
            answers="c",
            mistakes=[
                mistake(
                    "The mass of the metal does not change in the water; only the thread feels less.",
                    wrong("d = F/(g*V)", d=d, V=V),
                ),
                mistake(
                    "Compare the weight with the buoyancy, not with the pull that is left.",
                    wrong("d = rho*m*g/F", d=d),
                ),
            ],
            check="In units of the density of water it is $mg/B$.",
        ),
    )
