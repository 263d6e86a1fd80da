"""Uphill by bike: against gravity and drag, at steady speed."""

from math import sqrt

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def derive(m, v, s, D, h, g):
    F, P, L, W = unknowns("F P L W", L="length of the road")
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


def scene(m, v, s, D, h, g, answer):
    """The road is a plane that leans; driven with the power, and with the force, the bike keeps its speed over a thousandth of the way.

    A gain in height on a metre of road is a sine, which is how the statement means it.
    """
    across, up = (-s, sqrt(1 - s**2)), (sqrt(1 - s**2), s)
    bike = Body(m, (0.0, 0.0), (v * up[0], v * up[1]))
    road = HardWall(across, restitution=0.0)
    drag = ForceFunction(0, lambda t, place, velocity: (-D * up[0], -D * up[1]))

    def by_power(t, place, velocity):
        drive = answer["b"] / (velocity[0] * up[0] + velocity[1] * up[1])
        return drive * up[0], drive * up[1]

    def by_force(t, place, velocity):
        return answer["a"] * up[0], answer["a"] * up[1]

    return [
        simulate(
            Scene(
                (bike,),
                (Weight(g), road, drag, ForceFunction(0, drive)),
                until=answer["c"] / answer["b"] / 1000,
            ),
            velocities=bike.velocity,
            trajectory=(h * up[0] / s / 1000, h / 1000),
        )
        for drive in (by_power, by_force)
    ]
