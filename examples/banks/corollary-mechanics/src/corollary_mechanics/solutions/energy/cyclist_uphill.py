"""Uphill by bike: against gravity and drag, at steady speed."""

from corollary.author import derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, v, s, D, h, g):
    F, P, L, W = unknowns("F P L W")
    return derivation(
        step(
            F,
            "At steady speed the drive balances drag and the component of the weight along the road, which "
            "is s of it.",
            law("Equilibrium", "F = m*g*s + D", D=D),
            answers="a",
            mistakes=[
                mistake("She drives against the air, too.", wrong("F = m*g*s")),
                mistake("Drag acts backwards, like the slope.", wrong("F = m*g*s - D", D=D)),
                mistake("Only a part of the weight pulls down the road.", wrong("F = m*g + D", D=D)),
            ],
        ),
        step(
            P,
            "Power is force times speed.",
            law("Power", "P = F*v", P=P),
            answers="b",
            mistakes=[
                mistake(
                    "That would be a kinetic energy's factor; the force is steady, and so is the speed.",
                    wrong("P = F*v/2", P=P),
                ),
                mistake("That is what lifts her. Drag costs power, too.", wrong("P = m*g*s*v", P=P)),
            ],
        ),
        step(L, "The length of the road.", law("Slope", "h = s*L")),
        step(
            W,
            "Work is force times way.",
            law("Work", "W = F*L", W=W),
            answers="c",
            mistakes=[
                mistake("That is the potential energy gained; drag takes more.", wrong("W = m*g*h", W=W)),
                mistake(
                    "The force acts along the road, which is longer than the height.", wrong("W = F*h", W=W)
                ),
                mistake(
                    "Drag acts along the whole road, not along the height.",
                    wrong("W = m*g*h + D*h", W=W, D=D),
                ),
            ],
            check="The steeper the road, the smaller is the share of drag.",
        ),
    )
