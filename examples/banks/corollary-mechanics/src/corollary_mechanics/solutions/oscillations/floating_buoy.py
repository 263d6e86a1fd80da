"""A bobbing float: what the water pushes more drives it back, like a spring."""

from math import pi, sqrt

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(d, m, A, rho, g):
    S, x, F, T = unknowns("S x F T")
    return derivation(
        step(S, "The cross section of the float.", law("Area of a circle", "S = pi*d^2/4", S=S)),
        step(
            x,
            "At rest the water displaced weighs as much as the float.",
            law("Archimedes", "rho*S*x = m", S=S),
            answers="a",
            mistakes=[
                mistake(
                    "The area of a circle goes with the radius, and you were given the diameter.",
                    wrong("rho*pi*d^2*x = m"),
                ),
                mistake("The float is round: its cross section is not a square.", wrong("rho*d^2*x = m")),
            ],
        ),
        step(
            F,
            "Pushed down by A, it displaces that much more water.",
            law("Archimedes", "F = rho*g*S*A", S=S, A=A),
            answers="b",
            mistakes=[
                mistake(
                    "That is all of the buoyancy; the weight takes most of it away.",
                    wrong("F = rho*g*S*(x + A)", S=S, A=A),
                ),
                mistake("That is the weight of the float.", wrong("F = m*g")),
            ],
        ),
        step(
            T,
            "A force in proportion to the distance: an oscillator whose spring constant is F/A.",
            law("Period of an oscillator", "T = 2*pi*sqrt(m*A/F)", A=A),
            answers="c",
            mistakes=[
                mistake("That is the time for a radian.", wrong("T = sqrt(m*A/F)", A=A)),
                mistake("That is from the lowest point to the highest.", wrong("T = pi*sqrt(m*A/F)", A=A)),
            ],
            check=(
                "It is that of a pendulum as long as the float is deep in the water; the push does not "
                "matter."
            ),
        ),
    )


def scene(d, m, A, rho, g, answer):
    """Water that is pushed aside pushes back; a quarter of a period, from where the float is let go to where it rests."""
    depth, period = answer["a"], answer["c"]
    net = ForceFunction(0, lambda t, x, v: (m * g - rho * g * pi * d**2 / 4 * (depth + x[0]),))
    let_go = Scene((Body(m, (A,), (0.0,)),), (net,), until=period / 4)
    fastest = sqrt(
        answer["b"] * A / m
    )  # the force falls evenly to zero, so its work is half of force times way
    return [simulate(let_go, trajectory=(0.0,), velocities=(-fastest,))]
