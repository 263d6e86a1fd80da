"""Ball colliding with the floor, stepped in time: what energy and momentum tell, and what only the motion itself does."""

import sympy

from corollary.author import (
    code,
    derivation,
    file,
    mistake,
    module,
    plot,
    reject,
    simulate,
    simulated,
    step,
    unknowns,
)
from corollary.laws import change_of_momentum, energy_at_heights, force_on_standing, law, mean_force, wrong

BOUNCE = module("ball_on_the_floor_program/judge_bounce.py")
FIGURE = module("ball_on_the_floor_program/judge_bounce_plot.py")


def derive(g, R, m, y0, v0, k):
    v, v_1, dp, N, F, T, F_m = unknowns("v v_1 dp N F T F_m", v_1="velocity after the contact")
    x = sympy.Symbol("x", positive=True)  # a length that is measured: its power 3/2 is real
    contact = {"m": m, "k": k, "q": sympy.Rational(3, 2), "R": R, "y0": R, "v0": v, "g": g}
    return derivation(
        step(
            v,
            "Until the ball touches the floor, at y = R, only gravity does work on it. It moves down, so "
            "the velocity is negative.",
            energy_at_heights(g, before=(v0, y0), after=(v, R)),
            answers="a",
            where=v <= 0,
            mistakes=[
                mistake(
                    "You left out that the ball still falls from its start to the first touch.",
                    wrong("v = v_0", v_0=v0),
                ),
                mistake(
                    "The ball moves down and up is positive: its velocity is negative.",
                    wrong("v = sqrt(v_0^2 + 2*g*(y_0 - R))", v_0=v0, y_0=y0),
                ),
                mistake(
                    "y is the height of the centre: at first touch it is R, and the ball has fallen by y₀ - "
                    "R only.",
                    wrong("v = -sqrt(v_0^2 + 2*g*y_0)", v_0=v0, y_0=y0),
                ),
                mistake(
                    "Speeds do not add up in a fall; their squares do (energy).",
                    wrong("v = v_0 - sqrt(2*g*(y_0 - R))", v_0=v0, y_0=y0),
                ),
            ],
            check="A little faster than at the start.",
        ),
        step(
            v_1,
            "Weight and contact force depend on the height alone, so mechanical energy is kept; at the end "
            "of the contact the ball is again at y = R.",
            energy_at_heights(g, before=(v, R), after=(v_1, R)),
            reject=[
                reject("with the velocity of the first touch the ball would still be on its way down", v_1=v)
            ],
            mistakes=[
                mistake(
                    "You let the ball stop on the floor; it leaves as fast as it came.",
                    wrong("v = 0", v=v_1),
                )
            ],
        ),
        step(
            dp,
            "The change is the momentum at the end of the contact less that at its beginning.",
            change_of_momentum(dp, m, before=v, after=v_1),
            answers="b",
            mistakes=[
                mistake(
                    "Check the sign: the momentum goes from down (negative) to up (positive).",
                    change_of_momentum(dp, m, before=v_1, after=v),
                ),
                mistake(
                    "You subtracted the speeds. The velocity has turned round, so momentum, a vector, has "
                    "changed although the speed has not.",
                    change_of_momentum(dp, m, before=v, after=v),
                ),
                mistake(
                    "That is a kinetic energy; momentum is $mv$.",
                    wrong("dp = m*v^2/2"),
                ),
            ],
            check="Up, and twice the momentum of the first touch.",
        ),
        simulated(
            x,
            "At the deepest point the ball is at rest, and what it had at first touch has gone into the "
            "contact: $\\frac{2}{5}kx^{5/2} = \\frac{1}{2}mv^2 + mgx$. "
            "With gravity this has no solution in closed form: "
            "find it numerically, or step the motion. (Without gravity: $x = (5mv^2/4k)^{2/5}$, very nearly "
            "the same.)",
            scene="ball_on_floor",
            settings=contact,
            observe="largest_overlap",
            answers="c",
            mistakes=[
                mistake(
                    "That is the energy of a linear spring, $kx^2/2$; here the force goes with the power "
                    "3/2.",
                    wrong("x = -v*sqrt(m/k)", x=x),
                ),
                mistake(
                    "You balanced contact force and weight: there the net force is zero, but the ball still "
                    "moves.",
                    wrong("x = (m*g/k)^(2/3)", x=x),
                ),
                mistake(
                    "The work of the contact is an integral of $k\\,x^{3/2}$ over the way, not the largest "
                    "force times the way.",
                    wrong("x = (m*v^2/(2*k))^(2/5)", x=x),
                ),
            ],
            check=(
                "It must stay well below the radius, else the law of the contact would not make sense any "
                "more."
            ),
        ),
        step(
            F,
            "The floor pushes hardest when the ball is squeezed most; the net force is less by the weight.",
            law("Contact force", "N = k*d^(3/2)", source="(12.23)", d=x),
            force_on_standing(F, N, m, g),
            also=[N],
            answers="d",
            mistakes=[
                mistake(
                    "The force goes with the power 3/2 of the compression.",
                    law("Contact force", "N = k*d", d=x),
                    instead="Contact force",
                ),
                mistake(
                    "That is the energy stored in the contact divided by the way, a mean over the way; the "
                    "largest force is $k\\,x^{3/2}$.",
                    law("Contact force", "N = 2*k*d^(3/2)/5", d=x),
                    instead="Contact force",
                ),
            ],
            check="Many times the weight, and about 1.8 times the mean force of part (f).",
        ),
        simulated(
            T,
            "How long the contact lasts only the motion can tell: count the steps in which $y < R$.",
            scene="ball_on_floor",
            settings=contact,
            observe="duration",
            answers="e",
            mistakes=[
                mistake(
                    "The ball does not keep its speed while it is squeezed: way over speed of first touch "
                    "is too short.",
                    wrong("T = 2*x/(-v)", x=x),
                ),
                mistake(
                    "That is half a period of a linear spring; here the force goes with the power 3/2.",
                    wrong("T = pi*sqrt(m/k)"),
                ),
                mistake(
                    "That is the time until the deepest point; the way back takes as long again.",
                    wrong("T = sqrt(pi)*gamma(7/5)/gamma(9/10)*x/(-v)", x=x),
                ),
            ],
            check=(
                "Without gravity it would be 2.943 times the largest compression over the speed of first "
                "touch."
            ),
        ),
        step(
            F_m,
            "The mean net force is the change of momentum divided by the duration.",
            mean_force(F_m, dp, T),
            answers="f",
            mistakes=[
                mistake(
                    "You multiplied by the time; divide by it.",
                    wrong("F = J*dt", F=F_m, J=dp, dt=T),
                ),
                mistake(
                    "That is half of the largest force; the force rises and falls steeply and stays above "
                    "half for longer than that.",
                    wrong("F = F_max/2", F=F_m, F_max=F),
                ),
            ],
            check=(
                "A little more than half of the largest net force: the mean is a fair estimate of how "
                "strong a collision is."
            ),
        ),
        code(
            "g",
            "Newton's second law, stepped forward: the net force from the position, the new velocity, then "
            "the position with the new velocity.",
            inputs=BOUNCE.bounce_inputs,
            judge=BOUNCE.judge_bounce,
            example=file("ball_on_the_floor_program/bounce.py"),
        ),
        plot(
            "g",
            "The net force is -mg but for the contact, where it rises and falls; the area under it takes "
            "the momentum from negative to positive.",
            judge=FIGURE.judge_bounce_plot,
            example=file("ball_on_the_floor_program/force_plot.py"),
        ),
    )


def scene(g, R, m, y0, v0, k, answer):
    """The whole motion from its start above the floor; the impulse of the floor is that of the net force and of the weight."""
    return [
        simulate(
            "ball_on_floor",
            {"m": m, "k": k, "R": R, "y0": y0, "v0": v0, "g": g},
            animated=True,
            rebound_speed=-answer["a"],
            impulse=answer["b"] + m * g * answer["e"],
            peak_force=answer["d"] + m * g,
            largest_overlap=answer["c"],
            duration=answer["e"],
        )
    ]
