"""Ball reflected from a wall: momentum is a vector, and only one component of it is turned round."""

import sympy

from corollary.author import HALF_PI, derivation, mistake, optimum, simulate, step, unknown, vector
from corollary.laws import change_of_momentum, mean_force, third_law, wrong


def derive(m, v0, theta, dt):
    dp, J, F = vector("dp"), vector("J"), vector("F")
    steepest = unknown("theta_max")
    along, across = v0 * sympy.cos(theta), v0 * sympy.sin(theta)
    return derivation(
        step(
            dp,
            "Along the wall the velocity stays; across it, it changes from towards the wall to away from it.",
            change_of_momentum(dp, m, before=(along, -across), after=(along, across)),
            answers="a",
            mistakes=[
                mistake(
                    "Your angle is measured from the normal; here θ lies between the velocity and the "
                    "surface, so the normal component is $v_0\\sin\\theta$.",
                    change_of_momentum(dp, m, before=(across, -along), after=(across, along)),
                ),
                mistake(
                    "You turned the whole velocity round. The wall is smooth: the component along it stays "
                    "as it is.",
                    change_of_momentum(dp, m, before=(along, -across), after=(-along, across)),
                ),
                mistake(
                    "The speed is the same, but momentum is a vector: its normal component is turned round, "
                    "so it does change.",
                    change_of_momentum(dp, m, before=(along, across), after=(along, across)),
                ),
                mistake(
                    "You stopped the ball at the wall; it also has to be thrown back.",
                    change_of_momentum(dp, m, before=(along, -across), after=(along, 0)),
                ),
            ],
            check=(
                "A grazing ball (θ → 0) is hardly turned; a head-on one (θ = 90°) changes its momentum by "
                "$2mv_0$."
            ),
        ),
        step(
            J,
            "What the wall does to the ball, the ball does to the wall, the other way.",
            third_law(J, dp),
            answers="b",
            mistakes=[
                mistake(
                    "That is the impulse on the ball. The wall is pushed the opposite way.",
                    wrong("J = dp", J=J, dp=dp),
                ),
                mistake(
                    "You divided by the time: that is a force. The impulse is the whole change of momentum.",
                    wrong("J = -dp/dt", J=J, dp=dp),
                ),
            ],
            check="The two impulses add up to nothing, as they must.",
        ),
        step(
            F,
            "The mean force on the ball is its change of momentum, divided by the time it takes.",
            mean_force(F, dp, dt),
            answers="c",
            mistakes=[
                mistake(
                    "You multiplied by the time of contact; divide by it.",
                    wrong("F = J*dt", F=F, J=dp),
                ),
                mistake(
                    "That is the force on the wall; asked is the force on the ball.",
                    wrong("F = -J/dt", F=F, J=dp),
                ),
            ],
            check="It points away from the wall: a wall can only push.",
        ),
        optimum(
            steepest,
            "Only the angle changes; the force is largest where its slope as a function of the angle "
            "vanishes, or at an end of the range.",
            of=F[1],
            over=theta,
            between=(0, HALF_PI),
            answers="d",
            mistakes=[
                mistake(
                    "There the ball only grazes the wall: the force is smallest.",
                    wrong("x = 0", x=steepest),
                ),
                mistake(
                    "At 45° $\\sin\\theta\\cos\\theta$ would be largest, but the force grows with "
                    "$\\sin\\theta$ alone.",
                    wrong("x = pi/4", x=steepest),
                ),
            ],
            check="A head-on hit turns all of the momentum round.",
        ),
    )


def scene(m, v0, theta, dt, answer):
    """A smooth wall that gives like a spring and lets go after dt."""
    return [
        simulate(
            "wall",
            {"m": m, "v0": v0, "theta": theta, "dt": dt},
            animated=True,
            momentum_change=answer["a"],
            impulse=answer["b"],
            mean_force=answer["c"],
        )
    ]
