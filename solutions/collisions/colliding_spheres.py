"""A model of two colliding spheres: a spring along the line of centres, and a brake on their relative motion."""

import math

import sympy

from corollary.author import (
    choice,
    code,
    derivation,
    explain,
    file,
    mistake,
    module,
    plot,
    simulate,
    step,
    unknowns,
    vector,
)
from corollary.laws import distance, overlap, sphere_contact, within

SPHERES = module("colliding_spheres/judge_spheres.py")
FIGURE = module("colliding_spheres/judge_spheres_plot.py")


def derive(R, mA, mB, dx, dy, ux, uy, k, eta):
    r, delta, theta = unknowns("r delta theta", theta="1 during the contact, 0 otherwise")
    F = vector("F")

    def contact(k=k, eta=eta):
        return sphere_contact(
            F, theta=theta, k=k, delta=delta, eta=eta, apart=(dx, dy), r=r, passing=(ux, uy)
        )

    return derivation(
        step(r, "The distance of the centres.", distance(r, (dx, dy))),
        step(
            delta,
            "The spheres touch when their centres are $2R$ apart; they overlap by what is missing.",
            overlap(delta, R=R, r=r),
            mistakes=[
                mistake(
                    "The centres are $2R$ apart when the spheres just touch; you compared with $R$.",
                    overlap(delta, R=R / 2, r=r),
                )
            ],
        ),
        step(
            theta,
            "The force acts only while they overlap: $\\theta$ is 1 then, and 0 while they are apart.",
            within(theta, delta, "δ is positive while the spheres overlap"),
        ),
        step(
            F,
            "The spring pushes A away from B, against $\\Delta\\vec r$. The brake pulls the velocity of A "
            "towards that of B, along $\\Delta\\vec v$.",
            contact(),
            answers="a",
            scale=k * R ** sympy.Rational(3, 2),
            mistakes=[
                mistake(
                    "Your spring pulls A towards B. $\\Delta\\vec r$ points from A to B; A must be pushed "
                    "the other way.",
                    contact(k=-k),
                ),
                mistake(
                    "Your viscous part drives the spheres. To brake the relative motion it must pull the "
                    "velocity of A towards that of B: along $+\\Delta\\vec v$.",
                    contact(eta=-eta),
                ),
                mistake(
                    "That is the force on B; both parts turn round for the force on A.",
                    contact(eta=-eta, k=-k),
                ),
                mistake("You left out the viscous part.", contact(eta=0)),
                mistake(
                    "The spring part is its size times the unit vector $\\Delta\\vec r/\\Delta r$; you left "
                    "out the division by $\\Delta r$.",
                    contact(k=k * r),
                ),
                mistake(
                    "The spring part grows with the power 3/2 of the overlap; you took the overlap itself.",
                    contact(k=k / sympy.sqrt(sympy.Abs(delta))),
                ),
            ],
            check="With η = 0 it points straight from B to A.",
        ),
        choice(
            "b",
            "While the spheres overlap they push each other apart: the spring force on A points from B to "
            "A, which is along $-\\Delta\\vec r$.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": (
                    "With plus the spring on A points along $\\Delta\\vec r$, from A to B: the spheres "
                    "would pull each other in."
                ),
                "c": (
                    "A spring pushes the same way while the overlap grows and while it shrinks; only so "
                    "does it give the energy back."
                ),
            },
        ),
        code(
            "c",
            "Newton's second law for each sphere, with the force on B opposite to that on A; velocities "
            "first, then positions with the new velocities.",
            inputs=SPHERES.sphere_inputs,
            judge=SPHERES.judge_spheres,
            example=file("colliding_spheres/spheres.py"),
        ),
        plot(
            "c",
            "Straight lines before and after the touch; each component of the total momentum stays the same.",
            judge=FIGURE.judge_spheres_plot,
            example=file("colliding_spheres/motion_plot.py"),
        ),
        explain(
            "d",
            "Says that the total momentum stays the same, in x and in y.",
            "Gives the reason: the viscous force too acts on B opposite to how it acts on A; all forces are "
            "internal.",
            "Says that mechanical energy is lost (for as long as the spheres overlap and move against each "
            "other).",
            "Gives the reason: the power of the viscous forces is $-\\eta\\,\\lvert\\Delta\\vec "
            "v\\rvert^2$, never positive; the spring gives back what it took.",
            answer="The total momentum does not change: whatever B does to A, A does to B the other way, "
            "and this holds for the viscous part as well as for the spring. No force comes from "
            "outside. "
            "The mechanical energy falls. The viscous forces do work at the rate $\\eta\\Delta\\vec "
            "v\\cdot\\vec v_A - \\eta\\Delta\\vec v\\cdot\\vec v_B = -\\eta\\lvert\\Delta\\vec v\\rvert^2$, "
            "which is "
            "negative while the spheres touch and move against each other. The spring only stores energy "
            "and gives it back. The larger η, the more is lost.",
        ),
    )


def scene(R, mA, mB, dx, dy, ux, uy, k, eta, answer):
    """The spheres move for a tenth of a microsecond: how much their momenta change in it is the force, but for its own change."""
    u, r, t = math.hypot(ux, uy), math.hypot(dx, dy), 1e-7
    deep, force, mu = 2 * R - r, math.hypot(*answer["a"]), mA * mB / (mA + mB)
    # The spring grows and turns as the spheres move on, the brake changes with their relative velocity.
    growth = (1.5 * k * deep**0.5 + k * deep**1.5 / r) * u + eta * force / mu
    spheres = {
        "R": R,
        "mA": mA,
        "mB": mB,
        "dx": dx,
        "dy": dy,
        "vA": (0.0, 0.0),
        "vB": (ux, uy),
        "k": k,
        "q": 1.5,
        "eta": eta,
        "g": 0.0,
        "t": t,
    }
    return [simulate("touching_spheres", spheres, mean_force=answer["a"], neglected=growth * t / force)]
