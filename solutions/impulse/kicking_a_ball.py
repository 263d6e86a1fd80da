"""Kicking a ball: an impulse is a change of momentum, and a force is how fast it comes."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import change_of_momentum, impulse_momentum, mean_force, wrong


def derive(m, v, w, dt):
    dp, J, F, dp_r, F_r = unknowns("dp J F dp_r F_r")
    return derivation(
        step(
            dp,
            "The ball is at rest before the kick and has the velocity v after it.",
            change_of_momentum(dp, m, before=0, after=v),
            answers="a",
            mistakes=[
                mistake(
                    "That is the kinetic energy, $mv^2/2$; momentum is mass times velocity.",
                    wrong("K = m*v^2/2", K=dp),
                ),
                mistake(
                    "That is the rate at which the momentum changes, a force; the change itself does not "
                    "ask how long the kick lasts.",
                    wrong("p = m*v/dt", p=dp),
                ),
            ],
            check="It points the way the ball goes, and grows with mass and with speed.",
        ),
        step(
            J,
            "The impulse of the net force on the ball is its change of momentum.",
            impulse_momentum(J, dp),
            answers="b",
            mistakes=[
                mistake(
                    "You divided the change of momentum by the time: that is the mean force. The impulse is "
                    "the whole change of momentum.",
                    wrong("F = dp/dt", F=J),
                ),
                mistake(
                    "You multiplied the change of momentum by the time; an impulse is a force times a time, "
                    "and that is the change of momentum already.",
                    wrong("J = dp*dt"),
                ),
            ],
            check="1 N s = 1 kg m/s: an impulse and a momentum have the same unit.",
        ),
        step(
            F,
            "A mean force, times the time it acts, is the impulse.",
            mean_force(F, J, dt),
            answers="c",
            mistakes=[
                mistake(
                    "You multiplied by the time. A short kick needs a large force: divide the impulse by "
                    "the time.",
                    wrong("F = J*dt"),
                ),
                mistake(
                    "You took half of the mean force, as for a mean velocity; the mean force over the "
                    "contact is the impulse divided by the time.",
                    wrong("F = J/(2*dt)"),
                ),
            ],
            check="The same impulse in half the time would take twice the force.",
        ),
        step(
            dp_r,
            "Velocity has a direction: the ball arrives at -w and leaves at +v.",
            change_of_momentum(dp_r, m, before=-w, after=v),
            mistakes=[
                mistake(
                    "Momentum has a direction. The ball arrives with a negative velocity and leaves with a "
                    "positive one: the two speeds add.",
                    change_of_momentum(dp_r, m, before=w, after=v),
                ),
                mistake(
                    "You left out the momentum with which the ball arrives; the kick must first stop it.",
                    change_of_momentum(dp_r, m, before=0, after=v),
                ),
                mistake(
                    "You counted only the stopping of the ball, not its way back.",
                    change_of_momentum(dp_r, m, before=-w, after=0),
                ),
            ],
        ),
        step(
            F_r,
            "Again the mean force is the impulse, which is the change of momentum, divided by the time.",
            mean_force(F_r, dp_r, dt),
            answers="d",
            mistakes=[
                mistake(
                    "You multiplied by the time; divide the impulse by it.",
                    wrong("F = J*dt", F=F_r, J=dp_r),
                )
            ],
            check="With w = 0 this is the force of part (c); every bit of incoming speed adds to it.",
        ),
    )


def scene(m, v, w, dt, answer):
    """A push of the mean force found, over the time of contact, must give the ball its velocity."""
    return [
        simulate(
            "kick",
            {"m": m, "v0": 0.0, "F": answer["c"], "dt": dt},
            animated=True,
            velocities=(v,),
            impulse=answer["b"],
        ),
        simulate("kick", {"m": m, "v0": -w, "F": answer["d"], "dt": dt}, velocities=(v,)),
    ]
