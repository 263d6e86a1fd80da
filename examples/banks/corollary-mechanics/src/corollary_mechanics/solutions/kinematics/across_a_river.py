"""Across a river: velocities add as vectors, component by component."""

from math import cos, sin

from corollary.author import HALF_PI, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.scene import Body, Scene


def derive(w, u, c):
    t, x, beta, T = unknowns("t x beta T")
    return derivation(
        step(
            t,
            "Across the river the boat does u; the current has no component that way.",
            law("Constant velocity", "w = u*t"),
            answers="a",
            mistakes=[
                mistake(
                    "The current makes the path longer and the boat over ground faster. What is its velocity "
                    "across the river?",
                    wrong("w = sqrt(u^2 + c^2)*t"),
                ),
                mistake(
                    "Across, the current takes nothing away from the boat's velocity.", wrong("w = (u - c)*t")
                ),
            ],
            check="It is the same as without a current.",
        ),
        step(
            x,
            "Meanwhile the water carries the boat along.",
            law("Constant velocity", "x = c*t"),
            answers="b",
            mistakes=[
                mistake(
                    "That is how long the way over ground is; asked is its part along the bank.",
                    wrong("x = sqrt(u^2 + c^2)*t"),
                ),
                mistake(
                    "You turned the proportion round: the drift is to the width as the current to the boat.",
                    wrong("x = w*u/c"),
                ),
            ],
        ),
        step(
            beta,
            "Along the river the boat must do through the water what the current does the other way.",
            law("No drift", "u*sin(beta) = c"),
            where=(beta > 0) & (beta < HALF_PI),
            answers="c",
            mistakes=[
                mistake(
                    "u is the hypotenuse here: the boat's velocity through the water is the slanted one.",
                    wrong("u*tan(beta) = c"),
                ),
                mistake(
                    "That is the angle from the bank.",
                    wrong("u*cos(beta) = c"),
                    where=(beta > 0) & (beta < HALF_PI),
                ),
            ],
            check=(
                "With a current as fast as the boat it would have to point straight upstream, and never "
                "arrive."
            ),
        ),
        step(
            T,
            "Only the component across counts.",
            law("Constant velocity", "w = u*cos(beta)*T"),
            answers="d",
            mistakes=[
                mistake(
                    "That is the first crossing. Now part of the boat's velocity is spent against the "
                    "current.",
                    wrong("w = u*T"),
                ),
                mistake(
                    "By Pythagoras the velocities do not add: u is the longest side.",
                    wrong("w = sqrt(u^2 + c^2)*T"),
                ),
            ],
        ),
    )


def scene(w, u, c, answer):
    """Free motion with the velocity over ground."""
    drifting = Scene((Body(1.0, (0.0, 0.0), (c, u)),), (), until=answer["a"])
    beta = answer["c"]
    straight = Scene((Body(1.0, (0.0, 0.0), (c - u * sin(beta), u * cos(beta))),), (), until=answer["d"])
    return [simulate(drifting, trajectory=(answer["b"], w)), simulate(straight, trajectory=(0.0, w))]
