"""Lifting a chain: every link is caught in a small collision of its own."""

import sympy

from corollary.author import derivation, mistake, proof, route, simulate, step, unknowns
from corollary.laws import law, rocket_equation, wrong


def derive(m, L, v0, y, g):
    mu, R, F, W, E, D = unknowns("mu R F W E D", mu="mass per length", R="mass lifted per time")
    lifted = sympy.Dummy("y", positive=True)
    work = sympy.integrate(m / L * (v0**2 + g * lifted), (lifted, 0, L))
    return derivation(
        step(
            mu,
            "The chain is the same all along: the part that hangs has its share of the mass.",
            law("Even chain", "mu = m*y/L"),
        ),
        step(
            R,
            "It grows as fast as the end rises, $dy/dt = v_0$.",
            law("Rate", "R = m/L*v_0", holds="R = dμ/dt and v₀ = dy/dt", v_0=v0),
        ),
        step(
            F,
            "The body is what hangs. It does not accelerate, its weight and your pull act on it, and it "
            "takes up links that were at rest.",
            rocket_equation(F - mu * g, m=mu, a=0, v=v0, u=0, R=R),
            answers="a",
            routes=[
                route(
                    "Or at once, by what part (d) shows.",
                    law("To show", "F = m/L*(v_0^2 + g*y)", v_0=v0),
                )
            ],
            mistakes=[
                mistake(
                    "That is the weight of what hangs. At constant speed too, links at rest have to be "
                    "brought up to speed all the time.",
                    wrong("F = mu*g"),
                ),
                mistake(
                    "You lift the links with the energy $\\mu v^2/2$ in mind; the factor 1/2 is wrong for "
                    "momentum, and half of the work is lost.",
                    wrong("F = mu*g + R*v_0/2", v_0=v0),
                ),
                mistake(
                    "That is the weight of the whole chain; the heap is carried by the table.",
                    wrong("F = m*g + v_0*R", v_0=v0),
                ),
                mistake(
                    "You left out the weight of what hangs already.",
                    wrong("F = v_0*R", v_0=v0),
                ),
            ],
            check="At y = 0 the force is $(m/L)v_0^2$ already: it does not begin at nothing.",
        ),
        proof(
            "p",
            "Newton's second law for what hangs, with the momentum that new links need.",
            law(
                "Newton's second law for a changing mass",
                "F - mu*g = v_0*R",
                source="(12.127)",
                holds="the hanging part does not accelerate",
                v_0=v0,
            ),
            law("Even chain", "mu = m*y/L"),
            law("Rate", "R = m/L*v_0", holds="R = dμ/dt", v_0=v0),
            target=law("The force", "F = (m/L)*(v_0^2 + g*y)", v_0=v0),
            rates={mu: R, y: v0},
            lines=[
                "F - mu*g = v0*R",
                "R = (m/L)*v0",
                "mu = (m/L)*y",
                "F = mu*g + v0*R",
                "F = (m/L)*y*g + (m/L)*v0^2",
                "F = (m/L)*(v0^2 + g*y)",
            ],
            mistakes=[
                mistake(
                    "A constant velocity needs no net force only when the mass stays the same.",
                    wrong("F = mu*g"),
                ),
                mistake(
                    "That is energy, with its factor 1/2; part of the work is lost in catching the links.",
                    wrong("F = mu*g + v_0*R/2", v_0=v0),
                ),
            ],
        ),
        step(
            W,
            "The force is not constant: its work is $\\int_0^L F\\,dy = \\int_0^L (m/L)(v_0^2 + g y)\\,dy$.",
            law(
                "Work",
                "W = S",
                holds="the end moves along the force, from y = 0 to y = L; S is the integral",
                S=work,
            ),
            answers="b",
            mistakes=[
                mistake(
                    "The force grows on the way; you used its value at the end for the whole way.",
                    wrong("W = m/L*(v_0^2 + g*L)*L", v_0=v0),
                ),
                mistake(
                    "That is the energy the chain has in the end. The pull does more work: part of it is "
                    "lost.",
                    wrong("W = m*v_0^2/2 + m*g*L/2", v_0=v0),
                ),
                mistake(
                    "You used the force at the height y of part (a); it is different at every height.",
                    wrong("W = F*L"),
                ),
            ],
            check="The chain's centre rises by L/2, which explains the second term.",
        ),
        step(
            E,
            "In the end the chain hangs, moves with v₀, and its centre of mass is at half its length.",
            law(
                "Mechanical energy",
                "E = m*v_0^2/2 + m*g*L/2",
                source="(12.2), (12.25)",
                v_0=v0,
            ),
        ),
        step(
            D,
            "What was put in and is not there as mechanical energy in the end is lost.",
            law("Energy balance", "W = E + D"),
            answers="c",
            mistakes=[
                mistake(
                    "Catching a link is a perfectly inelastic collision, as links at rest jump to the speed "
                    "of the others: energy is lost.",
                    wrong("D = 0*W"),
                ),
                mistake(
                    "That counts all of $m v_0^2$ as lost; half of it is the kinetic energy of the chain.",
                    wrong("D = m*v_0^2", v_0=v0),
                ),
                mistake(
                    "The centre of the hanging chain is at L/2, not at L.",
                    wrong("W = m*v_0^2/2 + m*g*L + D", v_0=v0),
                ),
            ],
            check="As much is lost as is gained in kinetic energy, for any chain and any speed.",
        ),
    )


def scene(m, L, v0, y, g, answer):
    """A hundred thousand links picked up one by one."""
    return [
        simulate(
            "chain",
            {"N": 100000, "m": m, "L": L, "v0": v0, "g": g, "y": y},
            neglected=2e-5,
            mean_force=answer["a"],
            work=answer["b"],
            energy_lost=answer["c"],
        )
    ]
