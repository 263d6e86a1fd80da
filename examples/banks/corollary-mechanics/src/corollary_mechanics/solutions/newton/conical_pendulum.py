"""A ball on a cone: the string carries and turns at once."""

from math import sin

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(m, L, theta, g):
    S, r, v, T = unknowns("S r v T")
    return derivation(
        step(
            S,
            "The ball stays at its height: the vertical component of the tension carries the weight.",
            law("Equilibrium", "S*cos(theta) = m*g", S=S),
            answers="a",
            mistakes=[
                mistake(
                    "So it would be for a pendulum at rest at the end of its swing. Here nothing is "
                    "accelerated vertically; take the components along the vertical.",
                    wrong("S = m*g*cos(theta)", S=S),
                ),
                mistake(
                    "The angle is measured from the vertical: which component carries?",
                    wrong("S*sin(theta) = m*g", S=S),
                ),
            ],
            check="It is larger than the weight.",
        ),
        step(r, "The circle is smaller than the string is long.", law("Radius", "r = L*sin(theta)")),
        step(
            v,
            "The horizontal component of the tension turns the velocity.",
            law("Newton's second law", "S*sin(theta) = m*v^2/r", S=S),
            where=v > 0,
            answers="b",
            mistakes=[
                mistake(
                    "The radius of the circle is not the length of the string.",
                    wrong("S*sin(theta) = m*v^2/L", S=S),
                    where=v > 0,
                ),
                mistake(
                    "That component of the tension carries the weight; which one points to the middle of the circle?",
                    wrong("S*cos(theta) = m*v^2/r", S=S),
                    where=v > 0,
                ),
                mistake(
                    "You let the ball fall from the height of the circle's lowest hanging point. Nothing "
                    "falls here.",
                    wrong("v^2 = 2*g*L*(1 - cos(theta))"),
                    where=v > 0,
                ),
            ],
        ),
        step(
            T,
            "Once round the circle.",
            law("Speed on a circle", "v = 2*pi*r/T"),
            answers="c",
            mistakes=[
                mistake("The circumference belongs to the circle, not to the string.", wrong("v = 2*pi*L/T")),
                mistake(
                    "That is the period of a pendulum that swings to and fro.", wrong("T = 2*pi*sqrt(L/g)")
                ),
            ],
            check="$T = 2\\pi\\sqrt{L\\cos\\theta/g}$: a pendulum as long as the cone is high.",
        ),
    )


def scene(m, L, theta, g, answer):
    """The ball from above, for a quarter of a turn: the tension pulls it towards the axis by the share that the string leans."""
    S, v = answer["a"], answer["b"]
    r = L * sin(theta)
    inwards = ForceFunction(0, lambda t, x, v: (-S * x[0] / L, -S * x[1] / L))
    quarter = Scene((Body(m, (r, 0.0), (0.0, v)),), (inwards,), until=answer["c"] / 4)
    return [simulate(quarter, trajectory=(0.0, r), velocities=(-v, 0.0))]
