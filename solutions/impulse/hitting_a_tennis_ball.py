"""Hitting a tennis ball: momentum is a vector, and an impulse is a difference of vectors."""

import math

import sympy

from corollary.author import derivation, mistake, neglected, printed, simulate, step, unknowns, vector
from corollary.laws import (
    change_of_momentum,
    direction,
    impulse_momentum,
    impulse_of_constant_force,
    law,
    mean_force,
    wrong,
)


def derive(m, v0, v1, w, alpha, dt, g):
    dp, J, F, R = vector("dp"), vector("J"), vector("F"), vector("R")
    dp_l, J_l, F_l = vector("dp_l"), vector("J_l"), vector("F_l")
    beta, W, J_g, W_r, W_l, eps = unknowns("beta W J_g W_r W_l epsilon")
    come, lob = (-v0, 0), (w * sympy.cos(alpha), w * sympy.sin(alpha))
    upright = (w * sympy.sin(alpha), w * sympy.cos(alpha))
    return derivation(
        step(
            J,
            "The ball arrives with the velocity -v₀ along x and leaves with +v₁; nothing happens along y. "
            "The impulse of the net force is its change of momentum.",
            impulse_momentum(J, dp),
            change_of_momentum(dp, m, before=come, after=(v1, 0)),
            also=dp,
            answers="a",
            mistakes=[
                mistake(
                    "The ball turns round: it arrives with a negative velocity and leaves with a positive "
                    "one. Momentum is a vector, and the two speeds add.",
                    change_of_momentum(dp, m, before=(v0, 0), after=(v1, 0)),
                ),
                mistake(
                    "You left out the momentum with which the ball arrives; the racket must first stop it.",
                    change_of_momentum(dp, m, before=(0, 0), after=(v1, 0)),
                ),
                mistake(
                    "Check the sign: the ball is pushed along +x, the way it is returned. The change is "
                    "after less before.",
                    change_of_momentum(dp, m, before=(v1, 0), after=come),
                ),
                mistake(
                    "You put in the mass in grams; in kilograms it is a thousandth of that number.",
                    wrong("dp = 1000*m*(v_1 - v_0)", dp=dp, v_1=(v1, 0), v_0=come),
                ),
                mistake(
                    "You divided by the time: that is a force. The impulse is the whole change of momentum.",
                    wrong("J = dp/dt", J=J, dp=dp),
                ),
            ],
            check="It points the way the ball is returned, and is larger than either momentum alone.",
        ),
        step(
            F,
            "The mean net force is the impulse divided by the time of contact.",
            mean_force(F, J, dt),
            answers="b",
            mistakes=[
                mistake(
                    "You multiplied by the time; a short hit needs a large force.",
                    wrong("F = J*dt", F=F, J=J),
                ),
                mistake(
                    "You put in the time in milliseconds.",
                    wrong("F = J/(1000*dt)", F=F, J=J),
                ),
            ],
            check="A ball twice as heavy, or a contact half as long, would need twice the force.",
        ),
        step(
            R,
            "What the racket does to the ball, the ball does to the racket, the other way.",
            law("Newton's third law", "F_AB = -F_BA", source="(12.44)", F_AB=R, F_BA=F),
            answers="b2",
            mistakes=[
                mistake(
                    "That is the force on the ball. The racket is pushed the opposite way.",
                    wrong("F_AB = F_BA", F_AB=R, F_BA=F),
                ),
                mistake(
                    "That is an impulse; asked is the force.",
                    wrong("J_AB = -J_BA", J_AB=R, J_BA=J),
                ),
            ],
            check="It points against the x-axis: the racket is pushed back.",
        ),
        step(
            J_l,
            "The lob leaves with the components w cos α along x and w sin α along y. Again the impulse is "
            "the change of momentum, component by component.",
            impulse_momentum(J_l, dp_l),
            change_of_momentum(dp_l, m, before=come, after=lob),
            also=dp_l,
            answers="c1",
            mistakes=[
                mistake(
                    "Along x the ball turns round: it arrives with a negative component, and the two add.",
                    change_of_momentum(dp_l, m, before=(v0, 0), after=lob),
                ),
                mistake(
                    "Sine and cosine have changed places: the angle is measured from the x-axis.",
                    change_of_momentum(dp_l, m, before=come, after=upright),
                ),
                mistake(
                    "You left out the momentum with which the ball arrives.",
                    change_of_momentum(dp_l, m, before=(0, 0), after=lob),
                ),
                mistake(
                    "You put in the mass in grams; in kilograms it is a thousandth of that number.",
                    wrong("dp = 1000*m*(v_1 - v_0)", dp=dp_l, v_1=lob, v_0=come),
                ),
                mistake(
                    "You divided by the time: that is a force. The impulse is the whole change of momentum.",
                    wrong("J = dp/dt", J=J_l, dp=dp_l),
                ),
            ],
            check="Along y the ball starts from nothing; along x it is first stopped and then sent back.",
        ),
        step(
            F_l,
            "The mean force is the impulse divided by the time of contact.",
            mean_force(F_l, J_l, dt),
            answers="c2",
            mistakes=[
                mistake(
                    "You multiplied by the time; divide by it.",
                    wrong("F = J*dt", F=F_l, J=J_l),
                ),
                mistake(
                    "You put in the time in milliseconds.",
                    wrong("F = J/(1000*dt)", F=F_l, J=J_l),
                ),
            ],
            check="It has the direction of the impulse.",
        ),
        step(
            beta,
            "The tangent of the angle above the x-axis is the y-component over the x-component; here both "
            "are positive.",
            direction(beta, F_l),
            answers="c3",
            mistakes=[
                mistake(
                    "That is the direction of the ball after the hit. The force has the direction of the "
                    "*change* of momentum.",
                    wrong("beta = alpha"),
                ),
                mistake(
                    "You divided the other way round: that is the angle from the y-axis.",
                    wrong("beta = atan(F_x/F_y)", F_x=F_l[0], F_y=F_l[1]),
                ),
                mistake(
                    "You took the ratio itself; the angle is its arc tangent.",
                    wrong("beta = F_y/F_x", F_x=F_l[0], F_y=F_l[1]),
                ),
            ],
            check=(
                "Smaller than α: besides giving the ball its new velocity, the force has to stop it, and "
                "that takes a push along x."
            ),
        ),
        step(
            W,
            "The weight is mass times the acceleration of gravity.",
            law("Weight", "W = m*g", source="(12.33)"),
            answers="d1",
            mistakes=[
                mistake("You put in the mass in grams.", wrong("W = 1000*m*g")),
                mistake("That is the mass; the weight is a force.", wrong("W = m")),
            ],
            check="Hundreds of times smaller than the force of the racket.",
        ),
        step(
            J_g,
            "The weight is constant, so its impulse is the force times the time.",
            impulse_of_constant_force(J_g, W, dt),
            answers="d2",
            mistakes=[
                mistake(
                    "You divided by the time; an impulse is a force times a time.",
                    wrong("J = F/dt", J=J_g, F=W),
                ),
                mistake("You put in the time in milliseconds.", wrong("J = 1000*F*dt", J=J_g, F=W)),
            ],
            check="As many times smaller than the impulse of the racket: it was right to neglect it.",
        ),
        neglected(
            "b2",
            "the weight of the ball",
            W_r,
            "Racket and weight together make the net force, so the force between ball and racket differs "
            "from the one found by the weight.",
            law("Weight", "W = m*g", source="(12.33)", W=W_r),
        ),
        neglected(
            "c2",
            "the weight of the ball",
            W_l,
            "The force of the racket and the weight together make the net force that was found.",
            law("Weight", "W = m*g", source="(12.33)", W=W_l),
        ),
        neglected(
            "c3",
            "the weight of the ball",
            eps,
            "A small force taken from a large one turns it most when it stands at right angles to what is "
            "left.",
            law(
                "Angle", "epsilon = asin(W/sqrt(F_x^2 + F_y^2))", epsilon=eps, W=m * g, F_x=F_l[0], F_y=F_l[1]
            ),
        ),
        printed("a", "2.28 kg m/s; 0 kg m/s", "(12.31)"),
        printed("b", "1140 N; 0 N", "(12.32)"),
        printed("d1", "0.56 N", "(12.33)"),
        printed("c1", "1.74 kg m/s; 0.60 kg m/s", "(12.37), (12.38)"),
        printed("c2", "8.7e2 N; 3.0e2 N", "(12.40)"),
        printed("c3", "19 deg", "(12.41)"),
    )


def scene(m, v0, v1, w, alpha, dt, g, answer, neglected):
    """A push of the mean force found, over the time of contact, for each component; and the lob with the weight besides."""
    push = {"m": m, "dt": dt}
    return [
        simulate("kick", {**push, "v0": -v0, "F": answer["b"][0]}, velocities=(v1,), impulse=answer["a"][0]),
        simulate(
            "kick",
            {**push, "v0": -v0, "F": answer["c2"][0]},
            velocities=(w * math.cos(alpha),),
            impulse=answer["c1"][0],
        ),
        simulate(
            "kick",
            {**push, "v0": 0.0, "F": answer["c2"][1]},
            velocities=(w * math.sin(alpha),),
            impulse=answer["c1"][1],
        ),
        simulate(
            "kick",
            {**push, "v0": 0.0, "F": answer["c2"][1] - m * g},
            velocities=(w * math.sin(alpha),),
            neglected=neglected["c2"] / answer["c2"][1],
        ),
    ]
