"""Down a playground slide: what is missing in the energy has been the work of friction."""

from math import asin, sqrt

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import falling, law, wrong


def derive(m, h, v, L, g):
    u, W, f = unknowns("u W f")
    return derivation(
        step(
            u,
            "All the potential energy becomes kinetic energy.",
            falling(u, g, h),
            where=u > 0,
            answers="a",
            mistakes=[
                mistake(
                    "You took the length of the slide. For gravity only the height counts.",
                    wrong("u^2 = 2*g*L"),
                    where=u > 0,
                ),
                mistake("The factor 1/2 of the kinetic energy is missing.", wrong("u^2 = g*h"), where=u > 0),
            ],
            check="It is the speed of a free fall through the same height.",
        ),
        step(
            W,
            "The kinetic energy at the bottom is the potential energy from the top and the work of friction.",
            law("Energy and work", "m*g*h + W = m*v^2/2", W=W),
            answers="b",
            mistakes=[
                mistake(
                    "Friction acts against the motion: what sign has its work?",
                    wrong("m*g*h - W = m*v^2/2", W=W),
                ),
                mistake(
                    "That is the kinetic energy at the bottom; compare it with what was there at the top.",
                    wrong("W = m*v^2/2", W=W),
                ),
                mistake(
                    "The squares of the speeds make the energies: it is not the energy of the difference of "
                    "the speeds.",
                    wrong("W = -m*(u - v)^2/2", W=W),
                ),
            ],
            check="Negative: friction takes energy away.",
        ),
        step(
            f,
            "Work is force times way; friction points against the way.",
            law("Work", "W = -f*L", W=W),
            answers="c",
            mistakes=[
                mistake("Friction acts along the slide; the height is not its way.", wrong("W = -f*h", W=W)),
                mistake("That is the component of the weight along the slide.", wrong("f = m*g*h/L")),
            ],
        ),
    )


def scene(m, h, v, L, g, answer):
    """A straight slide, smooth and then as rough as it takes for the mean friction: the bank's own ready-made scene."""
    sine, cosine = h / L, sqrt(1 - (h / L) ** 2)
    rough = answer["c"] / (m * g * cosine)
    return [
        simulate(
            "slide",
            {"m": m, "theta": asin(sine), "mu": mu, "g": g, "t": 2 * L / speed},
            velocities=(speed * cosine, -speed * sine),
        )
        for mu, speed in ((0.0, answer["a"]), (rough, v))
    ]
