"""Nearest and furthest: energy and angular momentum, then Kepler."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def derive(p, v, M, G):
    r, u, T = unknowns("r u T", u="speed at the far end")
    angular = law("Conservation of angular momentum", "p*v = r*u", u=u)
    return derivation(
        step(
            r,
            "Gravitation does no torque about the star, and it is conservative; at both ends the velocity is "
            "at right angles to the radius.",
            law("Conservation of energy", "v^2/2 - G*M/p = u^2/2 - G*M/r", u=u),
            angular,
            also=[u],
            where=r > p,
            answers="a",
            mistakes=[
                mistake(
                    "Far out it does not come to rest; it still runs round the star.",
                    law("At rest", "u = 0", u=u),
                    instead="Conservation of angular momentum",
                    where=True,
                ),
                mistake(
                    "That is half of the longest diameter, the mean of both distances.",
                    law("Energy of an orbit", "v^2/2 - G*M/p = -G*M/(2*r)"),
                    instead="Conservation of energy",
                    where=True,
                ),
            ],
        ),
        step(
            u,
            "From the angular momentum.",
            angular,
            answers="b",
            mistakes=[
                mistake("Further out the comet is slower.", wrong("u*p = r*v", u=u)),
                mistake(
                    "So a circular orbit at that distance would need it; the comet is slower there and falls "
                    "back.",
                    wrong("u^2 = G*M/r", u=u),
                    where=u > 0,
                ),
            ],
        ),
        step(
            T,
            "Kepler's third law holds with half of the longest diameter in place of the radius.",
            law("Kepler's third law", "G*M*T^2 = 4*pi^2*((p + r)/2)^3"),
            where=T > 0,
            answers="c",
            mistakes=[
                mistake(
                    "Half of the longest diameter is meant, not all of it.",
                    wrong("G*M*T^2 = 4*pi^2*(p + r)^3"),
                    where=T > 0,
                ),
                mistake(
                    "That is a circle at the largest distance.", wrong("G*M*T^2 = 4*pi^2*r^3"), where=T > 0
                ),
            ],
        ),
    )


def scene(p, v, M, G, answer):
    """Half a revolution under an inverse square."""
    r, u = answer["a"], answer["b"]
    strength = (v**2 - u**2) / 2 / (1 / p - 1 / r)
    star, comet = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(1.0, (p, 0.0), (0.0, v))
    half = Scene((star, comet), (InverseSquare((0, 1), strength),), until=answer["c"] / 2)
    return [simulate(half, trajectory=(0.0, 0.0, -r, 0.0), velocities=(0.0, 0.0, 0.0, -u))]
