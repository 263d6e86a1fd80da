"""A hole in a barrel: Torricelli, and a horizontal throw."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def derive(H, y, d, g):
    v, t, x, q = unknowns("v t x q", t="time of the fall")
    return derivation(
        step(
            v,
            "As fast as after a free fall from the surface to the hole.",
            law("Torricelli", "v^2 = 2*g*(H - y)", H=H, y=y),
            where=v > 0,
            answers="a",
            mistakes=[
                mistake("How deep below the surface is the hole?", wrong("v^2 = 2*g*H", H=H), where=v > 0),
                mistake(
                    "That is the fall from the hole to the ground.", wrong("v^2 = 2*g*y", y=y), where=v > 0
                ),
            ],
        ),
        step(
            t,
            "From the hole the water falls to the ground.",
            law("Free fall", "y = g*t^2/2", y=y),
            where=t > 0,
        ),
        step(
            x,
            "Meanwhile it keeps its horizontal velocity.",
            law("Constant velocity", "x = v*t"),
            answers="b",
            mistakes=[
                mistake("The fall begins at the hole, not at the surface.", wrong("x = v*sqrt(2*H/g)", H=H)),
                mistake("The horizontal velocity does not fade.", wrong("x = v*t/2")),
            ],
            check="A hole as far below the surface as another is above the ground sends its jet as far.",
        ),
        step(
            q,
            "Area of the hole times speed.",
            law("Flow", "q = pi*d^2/4*v"),
            answers="c",
            mistakes=[
                mistake("You took the diameter for the radius.", wrong("q = pi*d^2*v")),
                mistake("The hole is round.", wrong("q = d^2*v")),
            ],
        ),
    )


def scene(H, y, d, g, answer):
    """A drop of the jet."""
    drop = Body(1e-4, (0.0, y), (answer["a"], 0.0))
    flight = Scene((drop,), (Weight(g),), until=answer["b"] / answer["a"])
    return [simulate(flight, trajectory=(answer["b"], 0.0))]
