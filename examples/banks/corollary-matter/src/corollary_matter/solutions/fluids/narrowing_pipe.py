"""A narrowing pipe: what goes in comes out, and speed costs pressure."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(D, d, v, rho):
    q, u, p = unknowns("q u p")
    return derivation(
        step(
            q,
            "Cross section times speed.",
            law("Flow", "q = pi*D^2/4*v", D=D),
            answers="a",
            mistakes=[
                mistake("You took the diameter for the radius.", wrong("q = pi*D^2*v", D=D)),
                mistake(
                    "That belongs to the narrow part, where the water is faster.",
                    wrong("q = pi*d^2/4*v", d=d),
                ),
            ],
        ),
        step(
            u,
            "As much flows through the narrow part as through the wide one.",
            law("Continuity", "D^2*v = d^2*u", D=D, d=d, u=u),
            answers="b",
            mistakes=[
                mistake(
                    "The cross section goes with the square of the diameter.",
                    wrong("D*v = d*u", D=D, d=d, u=u),
                ),
                mistake(
                    "In the narrow part the water must be faster.", wrong("d^2*v = D^2*u", D=D, d=d, u=u)
                ),
            ],
        ),
        step(
            p,
            "On one level, pressure and kinetic energy per volume together stay the same.",
            law("Bernoulli", "p = rho*u^2/2 - rho*v^2/2", p=p, u=u),
            answers="c",
            mistakes=[
                mistake("It has some kinetic energy before.", wrong("p = rho*u^2/2", p=p, u=u)),
                mistake(
                    "The difference of the squares is not the square of the difference.",
                    wrong("p = rho*(u - v)^2/2", p=p, u=u),
                ),
                mistake(
                    "The factor 1/2 of the kinetic energy is missing.", wrong("p = rho*(u^2 - v^2)", p=p, u=u)
                ),
            ],
        ),
    )
