"""Jump from a window: the fall fixes the change of momentum, the landing only shares it out over time or way."""

from corollary.author import derivation, explain, mistake, route, simulate, step, unknowns
from corollary.laws import (
    change_of_momentum,
    falling,
    force_on_standing,
    law,
    mean_force,
    work_of_net_force,
    wrong,
)


def derive(h, m, dt, s, g):
    v, dp, F, N, F_s, N_s = unknowns("v dp F N F_s N_s", F_s="net force, from the way")
    return derivation(
        step(
            v,
            "On the way down only gravity does work, and you start from rest.",
            falling(v, g, h),
            answers="a",
            where=v >= 0,
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2"),
                ),
                mistake(
                    "You did not take the root: energy goes with the square of the speed.",
                    wrong("v = 2*g*h"),
                ),
                mistake(
                    "The factor 1/2 stands at the square of the speed, not at the height.",
                    wrong("g*h = 2*v^2"),
                ),
            ],
            check="Your mass does not matter: all bodies fall alike.",
        ),
        step(
            dp,
            "You arrive with the velocity -v (down) and end at rest.",
            change_of_momentum(dp, m, before=-v, after=0),
            answers="b",
            mistakes=[
                mistake(
                    "Up is positive, so you arrive with a negative velocity; after less before is then "
                    "positive.",
                    change_of_momentum(dp, m, before=v, after=0),
                ),
                mistake(
                    "That is the kinetic energy; momentum is mass times velocity.",
                    wrong("dp = m*v^2/2"),
                ),
                mistake(
                    "You do not bounce back: you end at rest.", change_of_momentum(dp, m, before=-v, after=v)
                ),
            ],
            check="It points up, and the way you land does not change it.",
        ),
        step(
            F,
            "The mean net force is the change of momentum divided by the time it takes.",
            mean_force(F, dp, dt),
            answers="c",
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
            check="Twice the time means half the force.",
        ),
        step(
            N,
            "Two forces act on you in the landing: the ground up and your weight down. Their sum is the net "
            "force.",
            force_on_standing(F, N, m, g),
            answers="d",
            mistakes=[
                mistake(
                    "That is the net force; the ground must carry your weight besides.",
                    wrong("F = N"),
                ),
                mistake(
                    "The weight points down: the ground must push with more than the net force, not with "
                    "less.",
                    wrong("F = N + m*g"),
                ),
                mistake(
                    "That is your weight alone; the ground must also stop you.",
                    wrong("N = m*g"),
                ),
            ],
            check="With a very long stopping time it becomes your weight, as when you stand.",
        ),
        step(
            F_s,
            "Over the way s (downwards, so the displacement is -s) the net force takes all the kinetic "
            "energy.",
            work_of_net_force(F_s, -s, m, before=-v, after=0),
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("F*s = m*v^2", F=F_s),
                ),
                mistake(
                    "That is how momentum and time go together; over a way it is the kinetic energy that "
                    "counts.",
                    wrong("F*s = m*v", F=F_s),
                ),
            ],
        ),
        step(
            N_s,
            "Again the ground has to carry your weight besides.",
            force_on_standing(F_s, N_s, m, g),
            answers="e",
            routes=[
                route(
                    "From window to rest at once: the ground takes, over s, all the energy that gravity "
                    "gives over h + s.",
                    law("Work and kinetic energy", "N*s = m*g*(h + s)", N=N_s),
                )
            ],
            mistakes=[
                mistake(
                    "That is the net force; while you sink by s gravity still does work, and the ground "
                    "must carry your weight besides.",
                    wrong("F = N", F=F_s, N=N_s),
                ),
                mistake(
                    "The weight points down: the ground must push with more than the net force, not with "
                    "less.",
                    wrong("F = N + m*g", F=F_s, N=N_s),
                ),
            ],
            check="It is $mg(1 + h/s)$: stiff legs (a small s) make it enormous.",
        ),
        explain(
            "f",
            "Says that the change of momentum is $mv$, fixed by mass and height of fall alone, whatever the "
            "landing.",
            "Momentum: the mean force is the change of momentum divided by the time, so a long stopping "
            "time (bent knees, rolling) makes it small.",
            "Energy: the work of the force over the stopping distance takes the kinetic energy, so a long "
            "stopping distance makes it small.",
            "Mentions that the ground must carry the weight besides: the force of the ground is the net "
            "force plus $mg$.",
            answer="The fall gives you the speed $v = \\sqrt{2gh}$, and in the landing it goes to zero: "
            "the change of momentum is $mv$ and depends on your mass and "
            "the height only, not on how you land. Momentum: the mean net "
            "force is $mv/\\Delta t$, so make the stopping time long. Energy: the mean net force, taken "
            "over the way $s$ on which you stop, does the work "
            "$\\frac{1}{2}mv^2 = mgh$, so it is $mgh/s$, and you should make "
            "the stopping distance long. Both ask for the same thing: bend your knees, roll off, land on "
            "something soft, for a longer way takes a longer time. "
            "The force from the ground is larger than "
            "the net force by your weight.",
        ),
    )


def scene(h, m, dt, s, g, answer):
    """The film run backwards: the net force the other way brings you from rest to the speed of the landing."""
    return [
        simulate(
            "kick",
            {"m": m, "v0": 0.0, "F": answer["c"], "dt": dt},
            velocities=(answer["a"],),
            impulse=answer["b"],
        )
    ]
