"""A pulled sledge: a rope that also lifts."""

from math import cos, sin

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def derive(m, F, theta, mu, g):
    N, f, a = unknowns("N f a")
    return derivation(
        step(
            N,
            "Vertically nothing is accelerated: the ground and the rope together carry the weight.",
            law("Equilibrium", "N + F*sin(theta) = m*g"),
            answers="a",
            mistakes=[
                mistake("The rope pulls upwards, too.", wrong("N = m*g")),
                mistake(
                    "The rope lifts; it does not press the sledge down.", wrong("N = m*g + F*sin(theta)")
                ),
                mistake("Which component of the pull points upwards?", wrong("N + F*cos(theta) = m*g")),
            ],
        ),
        step(
            f,
            "The sledge slides.",
            law("Kinetic friction", "f = mu*N"),
            answers="b",
            mistakes=[
                mistake(
                    "Friction goes with what presses the surfaces together. That is less than the weight "
                    "here.",
                    wrong("f = mu*m*g"),
                ),
                mistake(
                    "The coefficient multiplies the force that presses, and that is not the pull.",
                    wrong("f = mu*F"),
                ),
            ],
        ),
        step(
            a,
            "Along the ground the rope pulls forward, and friction backward.",
            law("Newton's second law", "F*cos(theta) - f = m*a"),
            answers="c",
            mistakes=[
                mistake("Friction is missing.", wrong("F*cos(theta) = m*a")),
                mistake("Only a component of the pull points forward.", wrong("F - f = m*a")),
                mistake("That component of the pull lifts the sledge.", wrong("F*sin(theta) - f = m*a")),
            ],
            check=(
                "A rope held higher pulls less, but lifts more: on rough ground there is a best angle "
                "between."
            ),
        ),
    )


def scene(m, F, theta, mu, g, answer):
    """A body on a rough floor, pulled for two seconds."""
    rope = ForceFunction(0, lambda t, x, v: (F * cos(theta), F * sin(theta)))
    ground = HardWall((0.0, 1.0), restitution=0.0, mu=mu)
    pulled = Scene((Body(m, (0.0, 0.0), (0.0, 0.0)),), (Weight(g), rope, ground), until=2.0)
    return [simulate(pulled, velocities=(2 * answer["c"], 0.0), trajectory=(2 * answer["c"], 0.0))]
