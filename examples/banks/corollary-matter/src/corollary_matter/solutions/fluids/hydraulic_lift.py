"""A hydraulic lift: one pressure, two areas, and no energy for nothing."""

from corollary.author import derivation, mistake, route, step, unknowns
from corollary.laws import law, wrong


def derive(m, D, d, h, g):
    p, F, s = unknowns("p F s")
    return derivation(
        step(
            p,
            "The pressure below the large piston carries the car.",
            law("Pressure", "p*pi*D^2/4 = m*g", p=p, D=D),
            answers="a",
            mistakes=[
                mistake("You took the diameter for the radius.", wrong("p*pi*D^2 = m*g", p=p, D=D)),
                mistake("The car stands on the large piston.", wrong("p*pi*d^2/4 = m*g", p=p)),
            ],
        ),
        step(
            F,
            "The same pressure acts on the small piston.",
            law("Pressure", "F = p*pi*d^2/4", p=p),
            answers="b",
            mistakes=[
                mistake("Areas go with the square of the diameter.", wrong("F = m*g*d/D", D=D)),
                mistake("The same pressure, not the same force.", wrong("F = m*g")),
            ],
            check="It is small because the area is.",
        ),
        step(
            s,
            "The volume of oil that leaves the one cylinder goes into the other.",
            law("Volume", "s*d^2 = h*D^2", s=s, D=D),
            answers="c",
            routes=[route("Or the work on both sides is the same.", law("Work", "F*s = m*g*h", s=s))],
            mistakes=[
                mistake("The volumes are the same, not the ways.", wrong("s = h", s=s)),
                mistake("Volumes go with the square of the diameter.", wrong("s*d = h*D", s=s, D=D)),
            ],
            check="What is saved in force is paid in way.",
        ),
    )
