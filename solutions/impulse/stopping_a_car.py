"""Stopping a car: the same change of velocity, and a seatbelt that takes its time."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import change_of_momentum, mean_force, wrong


def derive(v, M, dt, md, td):
    dp, F, dp_d, F_d = unknowns("dp F dp_d F_d")
    return derivation(
        step(
            dp,
            "The car has the velocity v before the crash and stands still after it.",
            change_of_momentum(dp, M, before=v, after=0),
            mistakes=[
                mistake(
                    "The change is what is after less what is before. The car loses forward momentum: the "
                    "change, and with it the force, points backward.",
                    change_of_momentum(dp, M, before=0, after=v),
                ),
                mistake(
                    "You put in the speed in km/h as if it were m/s; divide it by 3.6 first.",
                    wrong("dp = m*(0 - 3.6*v)", m=M),
                ),
                mistake(
                    "You took the kinetic energy for the change of momentum; momentum is $mv$.",
                    wrong("dp = -m*v^2/2", m=M),
                ),
            ],
        ),
        step(
            F,
            "The mean force is the change of momentum, divided by the time it takes.",
            mean_force(F, dp, dt),
            answers="a",
            mistakes=[
                mistake(
                    "You multiplied by the time. A quick stop needs a large force: divide by the time.",
                    wrong("F = J*dt", J=dp),
                ),
                mistake(
                    "You took half of the mean force, as for a mean velocity; the mean force is the whole "
                    "change of momentum divided by the time.",
                    wrong("F = J/(2*dt)", J=dp),
                ),
            ],
            check="It is negative: a car that drives forward is stopped by a force backward.",
        ),
        step(
            dp_d,
            "The dummy rides along at the speed of the car and stops as well; its mass is its own.",
            change_of_momentum(dp_d, md, before=v, after=0),
            mistakes=[
                mistake(
                    "The change is what is after less what is before. The dummy loses forward momentum: the "
                    "change, and with it the force, points backward.",
                    change_of_momentum(dp_d, md, before=0, after=v),
                ),
                mistake(
                    "You put in the speed in km/h as if it were m/s; divide it by 3.6 first.",
                    wrong("dp = m*(0 - 3.6*v)", dp=dp_d, m=md),
                ),
                mistake(
                    "You put in the mass of the car. Asked is the force on the dummy, which stops the dummy "
                    "alone.",
                    change_of_momentum(dp_d, M, before=v, after=0),
                ),
            ],
        ),
        step(
            F_d,
            "Again the mean force is the change of momentum divided by the time, which is now longer.",
            mean_force(F_d, dp_d, td),
            answers="b",
            mistakes=[
                mistake(
                    "You let the dummy stop as quickly as the car, as if the force on the car were shared out by "
                    "the masses. Divide by the dummy's own time: the belt lets it take longer.",
                    mean_force(F_d, dp_d, dt),
                ),
                mistake(
                    "You multiplied by the time; divide by it.",
                    wrong("F = J*dt", F=F_d, J=dp_d, dt=td),
                ),
            ],
            check=(
                "With the same time the force would be smaller than that on the car by the ratio of the "
                "masses; the longer time makes it smaller still."
            ),
        ),
    )


def scene(v, M, dt, md, td, answer):
    """The film run backwards: the same forces the other way bring car and dummy from rest to v."""
    return [
        simulate("kick", {"m": M, "v0": 0.0, "F": -answer["a"], "dt": dt}, velocities=(v,)),
        simulate("kick", {"m": md, "v0": 0.0, "F": -answer["b"], "dt": td}, velocities=(v,)),
    ]
