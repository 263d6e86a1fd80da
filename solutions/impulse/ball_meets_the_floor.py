"""Ball colliding with the floor: energy gives the velocity after it, momentum the mean force."""

from corollary.author import derivation, mistake, reject, simulate, step, unknowns
from corollary.laws import change_of_momentum, energy_at_heights, force_on_standing, mean_force, wrong


def derive(m, v0, dt, g):
    v_1, dp, F, N = unknowns("v_1 dp F N", v_1="velocity after the contact")
    return derivation(
        step(
            v_1,
            "Weight and the force of the floor depend on the height alone, so mechanical energy is kept; "
            "the height is the same at first and last touch (we call it 0).",
            energy_at_heights(g, before=(v0, 0), after=(v_1, 0)),
            reject=[reject("with the velocity it came with the ball would still be on its way down", v_1=v0)],
            mistakes=[
                mistake(
                    "You let the ball stop on the floor. No energy is lost here: it leaves as fast as it "
                    "came.",
                    wrong("v = 0", v=v_1),
                ),
            ],
        ),
        step(
            dp,
            "The change is the momentum at last touch less that at first touch; the velocity has turned "
            "round.",
            change_of_momentum(dp, m, before=v0, after=v_1),
            answers="a",
            mistakes=[
                mistake(
                    "You subtracted the speeds. The velocity has turned round, so momentum, a vector, has "
                    "changed although the speed has not.",
                    change_of_momentum(dp, m, before=v0, after=v0),
                ),
                mistake(
                    "Check the sign: the ball first moves down (negative) and then up. What is after less "
                    "what was before is positive.",
                    change_of_momentum(dp, m, before=v_1, after=v0),
                ),
                mistake(
                    "That is a kinetic energy; momentum is $mv$.",
                    wrong("dp = m*v^2/2", v=v0),
                ),
            ],
            check=(
                "It points up: the floor can only push. Its size is twice the momentum with which the "
                "ball arrives."
            ),
        ),
        step(
            F,
            "The impulse of the net force is the change of momentum; divided by the time it is the mean net "
            "force.",
            mean_force(F, dp, dt),
            answers="b",
            mistakes=[
                mistake(
                    "You multiplied by the time; divide by it.",
                    wrong("F = J*dt", J=dp),
                ),
                mistake(
                    "You took half of it, as for a mean velocity; the mean force is the whole change of "
                    "momentum divided by the time.",
                    wrong("F = J/(2*dt)", J=dp),
                ),
            ],
            check="Many times the weight of the ball: that is what makes a collision a collision.",
        ),
        step(
            N,
            "The net force is the force of the floor less the weight, at every moment and so in the mean.",
            force_on_standing(F, N, m, g),
            answers="c",
            mistakes=[
                mistake(
                    "That is the weight. A ball at rest would be carried by it; this one is also thrown "
                    "back.",
                    wrong("N = m*g"),
                ),
                mistake("That is the impulse; asked is a force.", wrong("N = J", J=dp)),
                mistake(
                    "You took half of the force: the floor must stop the ball and throw it back, all within "
                    "this time.",
                    wrong("F/2 = N - m*g"),
                ),
            ],
            check=(
                "A little more than the mean net force: the floor also has to carry the weight, which "
                "matters the less the shorter the contact."
            ),
        ),
    )


def scene(m, v0, dt, g, answer):
    """The mean net force, for the time of contact, turns the velocity round."""
    return [
        simulate(
            "kick", {"m": m, "v0": v0, "F": answer["b"], "dt": dt}, velocities=(-v0,), impulse=answer["a"]
        )
    ]
