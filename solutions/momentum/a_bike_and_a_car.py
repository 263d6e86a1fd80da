"""A bike and a car: the same momentum at very different speeds."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import kinetic_energy, momentum, wrong


def derive(mb, M, V):
    p, v = unknowns("p v")
    return derivation(
        step(
            p,
            "The momentum of the car is its mass times its velocity; a velocity in km/h is divided by 3.6 "
            "to have it in m/s.",
            momentum(p, M, V),
        ),
        step(
            v,
            "You are to have the same momentum, with your own, smaller mass.",
            momentum(p, mb, v),
            answers="a",
            where=v >= 0,
            mistakes=[
                mistake(
                    "You asked for the same kinetic energy. Momentum is $mv$, without a square.",
                    kinetic_energy(M * V**2 / 2, mb, v),
                ),
                mistake(
                    "The masses have changed places: with the smaller mass you need the larger speed.",
                    wrong("p = m_b^2*v/M", m_b=mb),
                ),
                mistake(
                    "You put in the speed of the car as if its number in km/h were one in m/s; divide it by "
                    "3.6 first.",
                    wrong("3.6*p = m*v", m=mb),
                ),
            ],
            check=(
                "A car of twelve times your mass has twelve times your momentum at the same speed; so "
                "your speed must be larger by the ratio of the masses."
            ),
        ),
    )
