"""Bullet and a block: work and energy on the rough table, momentum in the hit."""

from corollary.author import derivation, mistake, route, simulate, step, unknowns
from corollary.laws import change_of_kinetic_energy, law, level_floor, sliding_to_rest, sticking, wrong


def derive(m, M, mu, d, g):
    N, u, v, dK = unknowns("N u v dK", u="speed of block and bullet after the hit", N="normal force")
    return derivation(
        step(
            N,
            "On a level table the normal force carries the weight of block and bullet.",
            level_floor(N, m + M, g),
        ),
        step(
            u,
            "On the rough table friction does negative work until all kinetic energy is gone.",
            sliding_to_rest(m=m + M, v=u, mu=mu, N=N, d=d),
            where=u >= 0,
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy on the rough table.",
                    wrong("m*v^2 = mu*N*d", m=m + M, v=u),
                ),
            ],
        ),
        step(
            v,
            "In the hit momentum is kept: no outside force acts along the smooth table. Bullet and block "
            "move on as one.",
            sticking(before=[(m, v), (M, 0)], together=u),
            answers="a",
            where=v >= 0,
            mistakes=[
                mistake(
                    "Kinetic energy is not kept when a bullet gets stuck; momentum is.",
                    wrong("m*v^2/2 = (m + M)*u^2/2"),
                ),
                mistake(
                    "That is the speed of block and bullet just after the hit. One step is left: momentum "
                    "in the collision.",
                    wrong("v = u"),
                ),
                mistake(
                    "After the hit the bullet is in the block: both masses move together.",
                    wrong("m*v = M*u"),
                ),
            ],
            check=(
                "A heavy block that slides far needs a fast bullet; with M → 0 the bullet would simply "
                "slide on at u."
            ),
        ),
        step(
            dK,
            "The change is the kinetic energy of both together just after the hit, less that of the bullet "
            "before it.",
            change_of_kinetic_energy(dK, before=[(m, v), (M, 0)], after=[(m, u), (M, u)]),
            answers="b",
            routes=[
                route(
                    "The same from the bullet's speed alone: the common velocity follows from momentum.",
                    law(
                        "Loss in a perfectly inelastic collision",
                        "dK = -(m*M/(m + M))*v^2/2",
                        source="(12.88)",
                    ),
                ),
                route(
                    "The same from the work of friction: what is left after the hit is m u²/2 of both, and "
                    "u follows from the sliding.",
                    law(
                        "Loss in a perfectly inelastic collision",
                        "dK = mu*g*(m + M)*d - m*v^2/2",
                    ),
                ),
            ],
            mistakes=[
                mistake(
                    "That is the work of friction on the rough table; asked is the change in the collision "
                    "itself.",
                    wrong("dK = -mu*N*d"),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("dK = (m + M)*u^2 - m*v^2"),
                ),
                mistake(
                    "You squared the difference of the velocities; take the difference of the kinetic "
                    "energies.",
                    wrong("dK = m*(u - v)^2/2"),
                ),
            ],
            check="It is negative: a perfectly inelastic collision always costs kinetic energy.",
        ),
    )


def scene(m, M, mu, d, g, answer):
    """A bullet of the speed found is braked inside the block; then friction stops both, where it must."""
    return [
        simulate(
            "bullet_block",
            {"m": m, "M": M, "mu": mu, "g": g, "v": answer["a"]},
            animated=True,
            distance=d,
            energy_change=answer["b"],
        )
    ]
