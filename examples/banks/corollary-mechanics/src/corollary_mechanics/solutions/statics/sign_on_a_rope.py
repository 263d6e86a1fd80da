"""A sign on a bracket: torques about the hinge, then the forces."""

from corollary.author import derivation, mistake, route, step, unknowns
from corollary.laws import law, wrong


def derive(m, M, L, theta, g):
    S, H, V = unknowns("S H V")
    return derivation(
        step(
            S,
            "About the hinge its own force has no arm; the weight of the beam acts in its middle.",
            law("Equilibrium of torques", "S*L*sin(theta) = m*g*L + M*g*L/2", S=S),
            answers="a",
            mistakes=[
                mistake(
                    "The weight of the beam acts in its middle, not at its end.",
                    wrong("S*L*sin(theta) = m*g*L + M*g*L", S=S),
                ),
                mistake("The beam has a weight of its own.", wrong("S*L*sin(theta) = m*g*L", S=S)),
                mistake(
                    "Which component of the tension turns the beam about the hinge?",
                    wrong("S*L*cos(theta) = m*g*L + M*g*L/2", S=S),
                ),
            ],
            check="A flat rope must pull hard: as the angle goes to zero, the tension grows without limit.",
        ),
        step(
            H,
            "Horizontally the rope pulls towards the wall, the hinge pushes away from it.",
            law("Equilibrium of forces", "H = S*cos(theta)", H=H, S=S),
            answers="b",
            mistakes=[
                mistake(
                    "That is the vertical component of the tension.", wrong("H = S*sin(theta)", H=H, S=S)
                ),
                mistake("Only a component of the tension points along the beam.", wrong("H = S", H=H, S=S)),
            ],
        ),
        step(
            V,
            "Vertically the rope and the hinge carry both weights.",
            law("Equilibrium of forces", "V + S*sin(theta) = (m + M)*g", V=V, S=S),
            answers="c",
            routes=[
                route(
                    "Or torques about the outer end of the beam, where neither the rope nor the sign has an "
                    "arm.",
                    law("Equilibrium of torques", "V*L = M*g*L/2", V=V),
                )
            ],
            mistakes=[
                mistake("The rope carries some of it.", wrong("V = (m + M)*g", V=V)),
                mistake(
                    "Take torques about the outer end: how much of the beam does the hinge carry?",
                    wrong("V = M*g", V=V),
                ),
            ],
            check="Half of the beam's weight, whatever hangs at its end.",
        ),
    )
