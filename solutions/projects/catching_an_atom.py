"""Catching an atom: a well, a sticking collision in it, and what a plane adds: angular momentum."""

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
    simulated,
    step,
    unknown,
    unknowns,
    vector,
)
from corollary.laws import (
    depth_of_well,
    distance,
    energy_between,
    far_turning_point,
    law,
    on_a_circle,
    oscillation,
    small_excess,
    sticking,
    towards_circle,
    turning_points,
    within,
    wrong,
)

ORBIT = module("catching_an_atom/judge_orbit.py")
CAUGHT = module("catching_an_atom/judge_catch.py")
FIGURE = module("catching_an_atom/judge_orbit_plot.py")


def derive(m, k, b, d, vA0, x, xp, yp, eps, epsx, v0, v, s, alpha, v1):
    U_0, T, v_far, theta, f = unknowns("U_0 T v_far theta f", theta="1 inside the well, 0 outside")
    u, V, V_e, u_e, v_e = unknowns(
        "u V V_e u_e v_e",
        V_e="speed of the pair at which both just get out",
        u_e="speed of A before that collision",
    )
    r_p, kappa, lambda_0, w_e, r_max, T_r, phi = unknowns(
        "r_p kappa lambda_0 w_e r_max T_r phi",
        lambda_0="share of the velocity that is left at the edge",
        w_e="speed along the radius that would just reach the edge",
        kappa="ratio of the kinetic energy to $k b^2/2$",
    )
    r_c, v_max, q = unknowns("r_c v_max q", q="share that is left")
    lambda_k, V_k, u_k, lambda_s, v_s, w_b, x_l = unknowns(
        "lambda_k V_k u_k lambda_s v_s w_b x_l",
        V_k="speed of the pair after the collision, in the limiting case",
        lambda_s="share of A's speed outside that the pair has across the radius at the edge",
        w_b="speed of A along the radius at r = b",
    )
    swing = d * sympy.sqrt(eps)
    p = (unknown("x_near"), unknown("x_far"))
    F = vector("F")
    return derivation(
        plot(
            "a",
            "A parabola with its bottom at b, flat at $U_0$ beyond $b + d$, and a wall at $b - d$. Below "
            "$U_0$ the atom is bound: it swings harmonically about $b$, between the two places where $U = "
            "E$. Above $U_0$ it is free: it comes in "
            "from outside at constant speed, is fastest at $b$, is thrown back by the wall at $b - d$, and "
            "leaves with the speed it came with.",
            judge=FIGURE.judge_potential_plot,
            example=file("catching_an_atom/potential_plot.py"),
        ),
        step(U_0, "The energy at the edge of the well.", depth_of_well(U_0, k=k, d=d)),
        step(
            p,
            "At a turning point all energy is potential energy.",
            turning_points(p, E=eps * U_0, k=k, b=b),
            answers="a1",
            where=p[1] > p[0],
            mistakes=[
                mistake(
                    "The bottom of the well is at b, not at 0: your distances are right, but measured from "
                    "b.",
                    wrong("x = l", x=p, l=(-swing, swing)),
                ),
                mistake(
                    "The energy goes with the square of the distance from b: a quarter of the energy is "
                    "half of the way.",
                    wrong("x = b + l", x=p, l=(-eps * d, eps * d)),
                ),
                mistake(
                    "That is where an atom with exactly the energy U₀ turns round: the ends of the well.",
                    turning_points(p, E=U_0, k=k, b=b),
                ),
            ],
            check="Both lie as far from b, inside the well; for E → U₀ they reach its ends.",
        ),
        step(
            T,
            "Within the well the force is $-k(x - b)$ all the way: the swing is harmonic, whatever its "
            "energy.",
            oscillation(T, m=m, k=k),
            answers="a2",
            mistakes=[
                mistake(
                    "That is the time from one turning point to the other; a full swing is there and back.",
                    wrong("T = pi*sqrt(m/k)"),
                ),
                mistake(
                    "That is the time for one radian, $\\sqrt{m/k}$; a full swing is $2\\pi$ of them.",
                    wrong("T = sqrt(m/k)"),
                ),
            ],
            check="A heavier atom or a softer spring swings more slowly; the energy does not matter.",
        ),
        step(
            v_far,
            "Outside the potential energy is U₀; what is left of the energy is kinetic.",
            law("Conservation of mechanical energy", "E = m*v^2/2 + U_0", E=epsx * U_0, v=v_far),
            answers="a3",
            where=v_far >= 0,
            mistakes=[
                mistake(
                    "Outside the potential energy is U₀, not zero: only the rest of the energy is kinetic.",
                    wrong("E = m*v^2/2", E=epsx * U_0, v=v_far),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong(
                        "E = m*v^2 + U_0",
                        E=epsx * U_0,
                        v=v_far,
                    ),
                ),
            ],
            check="With E = U₀ it just gets out and has no speed left.",
        ),
        step(
            theta,
            "There is a force only inside the well, for x < b + d: θ is 1 there and 0 beyond.",
            within(theta, b + d - x, "b + d - x is positive inside the well"),
        ),
        step(
            f,
            "The force is $-dU/dx$: $-k(x - b)$ inside, and zero where U is constant.",
            law(
                "Force and potential energy",
                "F = -theta*k*(x - b)",
                holds="F = -dU/dx",
                F=f,
            ),
            answers="b",
            scale=k * d,
            mistakes=[
                mistake(
                    "The force is *minus* the slope of the potential energy: it points to the bottom of the "
                    "well.",
                    wrong("F = theta*k*(x - b)", F=f),
                ),
                mistake(
                    "The bottom of the well, where there is no force, is at b and not at 0.",
                    wrong("F = -theta*k*x", F=f),
                ),
                mistake(
                    "The factor 1/2 goes away with the derivative of the square.",
                    wrong(
                        "F = -theta*k*(x - b)/2",
                        F=f,
                    ),
                ),
            ],
            check="It points to b from either side, and it is zero at b and outside the well.",
        ),
        step(
            u,
            "The force on A is conservative. Outside A has the potential energy U₀, at b none; it moves "
            "towards the molecule, so its velocity is negative.",
            energy_between(m=m, v_0=-vA0, U_0=U_0, v_1=u, U_1=0),
            answers="c",
            where=u <= 0,
            mistakes=[
                mistake(
                    "You left out the well: on its way in, A gains the kinetic energy U₀.",
                    wrong("u = -v_0", v_0=vA0),
                ),
                mistake(
                    "The speed is right, but A moves towards the molecule: the velocity is negative.",
                    wrong(
                        "u = sqrt(v_0^2 + 2*U_0/m)",
                        v_0=vA0,
                    ),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong(
                        "u = -sqrt(v_0^2 + U_0/m)",
                        v_0=vA0,
                    ),
                ),
            ],
            check="It is faster than outside; with a very shallow well (d → 0) nothing changes.",
        ),
        step(
            V,
            "In the short collision the pull of the molecule does not matter (it is zero at b anyway): "
            "momentum is kept, and both move on as one.",
            sticking(before=[(m, u), (m, 0)], together=V),
            answers="d",
            mistakes=[
                mistake(
                    "Kinetic energy is not kept when things stick together; momentum is.",
                    wrong("V = u/sqrt(2)"),
                ),
                mistake(
                    "That is an elastic collision: equal masses exchange their velocities only if they do "
                    "not stick.",
                    wrong("V = u"),
                ),
                mistake(
                    "Momentum has a direction: the joined atoms go on towards the molecule.",
                    wrong("V = -u/2"),
                ),
            ],
            check="Half the velocity, half the kinetic energy.",
        ),
        step(
            V_e,
            "Joined, the atoms have the mass 2m, and *each* needs the potential energy U₀ to get out. "
            "Moving inwards first does no harm: the wall throws them back at the same speed.",
            law(
                "Conservation of mechanical energy",
                "2*m*V^2/2 = 2*U_0",
                holds="at the least speed nothing is left outside",
                V=V_e,
            ),
            where=V_e >= 0,
            mistakes=[
                mistake(
                    "Both atoms are in the well: the pair needs $2U_0$.",
                    wrong("2*m*V^2/2 = U_0", V=V_e),
                )
            ],
        ),
        step(
            u_e,
            "The speed of A before the collision that gives this one, from momentum.",
            law("Conservation of momentum", "m*u = 2*m*V", holds="they stick together", u=u_e, V=V_e),
        ),
        step(
            v_e,
            "A has gained U₀ on its way in.",
            energy_between(m=m, v_0=v_e, U_0=U_0, v_1=u_e, U_1=0),
            answers="e",
            where=v_e >= 0,
            mistakes=[
                mistake(
                    "That is the speed A needs at b. On its way in it gains U₀, so outside it may be slower.",
                    wrong("v = u", v=v_e, u=u_e),
                ),
                mistake(
                    "You forgot the collision: that is the case if no kinetic energy were lost when they "
                    "stick.",
                    wrong("m*v^2/2 + U_0 = 2*U_0", v=v_e),
                ),
            ],
            check=(
                "Three times the depth of the well as kinetic energy: one quarter of $m u^2/2 = 4U_0$ is "
                "what each atom needs."
            ),
        ),
        step(r_p, "First the distance from the molecule.", distance(r_p, (xp, yp))),
        step(
            F,
            "U depends on r alone. Its gradient is along the radius: $\\partial r/\\partial x = x/r$ and "
            "$\\partial r/\\partial y = y/r$, so $\\vec F = -k(r - b)\\,\\vec r/r$.",
            towards_circle(F, k=k, b=b, place=(xp, yp), r=r_p),
            answers="f",
            mistakes=[
                mistake(
                    "The sign: inside the distance b the atom is pushed out, outside it is pulled in.",
                    towards_circle(F, k=-k, b=b, place=(xp, yp), r=r_p),
                ),
                mistake(
                    "The force is zero on the circle r = b, not at the molecule.",
                    wrong("F = -k*s", F=F, s=(xp, yp)),
                ),
                mistake(
                    "The size $k(r - b)$ goes with the *unit* vector $\\vec r/r$; you left out the division "
                    "by r.",
                    wrong("F = -k*(r - b)*s/b", F=F, r=r_p, s=(xp, yp)),
                ),
            ],
            check="Its length is $k\\,\\lvert r - b\\rvert$, and it lies along the radius.",
        ),
        code(
            "g",
            "Newton's second law with this force inside r < b + d and no force outside; velocity first, "
            "then the place with the new velocity.",
            inputs=ORBIT.orbit_inputs,
            judge=ORBIT.judge_orbit,
            example=file("catching_an_atom/orbit.py"),
        ),
        plot(
            "g",
            "The trajectory is a rosette between the circles r = b and r = r_max: it touches each of them "
            "once in every swing.",
            judge=FIGURE.judge_orbit_plot,
            example=file("catching_an_atom/orbit_plot.py"),
        ),
        step(
            kappa,
            "How strong the start is against the spring, as a plain number.",
            law("Ratio", "kappa = m*v^2/(k*b^2)", v=v0),
        ),
        step(
            lambda_0,
            "A velocity across the radius at r = b shrinks as 1/r, for angular momentum is kept. At the "
            "edge the share $\\lambda_0$ of it is left.",
            law(
                "Conservation of angular momentum",
                "b = lambda_0*(b + d)",
                holds="m and v are the same on both sides",
            ),
        ),
        step(
            w_e,
            "Does it stay in the well? With an additional speed $w$ along the radius it would just reach "
            "the edge. That $w$ is real says: without it, the atom is bound.",
            law(
                "Conservation of mechanical energy",
                "m*(v^2 + w^2)/2 = U_0 + m*(lambda_0*v)^2/2",
                v=v0,
                w=w_e,
            ),
            where=w_e >= 0,
        ),
        step(
            r_max,
            "At the greatest distance there is no velocity along the radius. Energy: $mv_0^2/2 = k(r - "
            "b)^2/2 + mw^2/2$; angular momentum: $mv_0 b = m w r$. Together they give a cubic equation "
            "for $r/b$ once the start itself, $r = b$, is divided out.",
            far_turning_point(r_max, b=b, kappa=kappa),
            answers="h1",
            mistakes=[
                mistake(
                    "At the greatest distance the atom does not stand still: it still moves across the "
                    "radius, with $v_0 b/r$.",
                    wrong(
                        "r = b + v*sqrt(m/k)",
                        r=r_max,
                        v=v0,
                    ),
                ),
                mistake(
                    "That is the distance where the pull would just be right for a circle at this speed; "
                    "the atom moves outwards and swings further.",
                    wrong("r = b/2 + sqrt(b^2/4 + m*v^2/k)", r=r_max, v=v0),
                ),
            ],
            check=(
                "With v₀ = 0 it stays at b. The distance can never be smaller than b, which is the other "
                "turning point."
            ),
        ),
        simulated(
            T_r,
            "The integral for this time has no simple form; the program measures it between two moments of "
            "smallest distance.",
            scene="atom",
            settings={"m": m, "k": k, "b": b, "d": d, "r0": b, "v0": v0, "dimension": 2},
            observe="period",
            answers="h2",
            mistakes=[
                mistake(
                    "That is the swing on a line. The motion across the radius adds an outward push, and "
                    "the distance swings faster.",
                    oscillation(T_r, m=m, k=k),
                ),
                mistake(
                    "That is the time for a turn about the molecule on the circle r = b at the speed at the "
                    "start; asked is the swing of the distance.",
                    wrong("T = 2*pi*b/v", T=T_r, v=v0),
                ),
            ],
            check="A little shorter than on a line, and more so for a faster start.",
        ),
        simulated(
            phi,
            "The same run gives the angle about the molecule between the two moments.",
            scene="atom",
            settings={"m": m, "k": k, "b": b, "d": d, "r0": b, "v0": v0, "dimension": 2},
            observe="angle",
            answers="h3",
            mistakes=[
                mistake(
                    "That would be a closed orbit, once around for each swing. This orbit does not close.",
                    wrong("phi = 2*pi"),
                ),
                mistake(
                    "The angular velocity is $v_0/b$ only at the start; further out it is smaller, as "
                    "$1/r^2$.",
                    wrong("phi = v/b*T", v=v0, T=T_r),
                ),
            ],
            check="In general it is no simple fraction of a full turn: the orbit does not close.",
        ),
        explain(
            "h",
            "Says that the distance swings between b and a greatest distance, while the atom moves round "
            "the molecule: a rosette.",
            "Says that angular momentum is kept, so the atom turns about the molecule always in the same "
            "sense, faster near b and slower far out.",
            "Says that the curve does not close in general, because the swing of the distance and the turn "
            "around the molecule have different times.",
            "Gives a way to measure a period: times between successive extremes of r (or upward passages of "
            "the radial velocity through zero).",
            answer="The atom starts at the smallest distance, b, where there is no force; it moves "
            "outwards, is pulled back, turns round at $r_{max}$ and returns to b, again and again. All "
            "the while it moves about the molecule "
            "with $r^2\\dot\\varphi = b v_0$. As the time of a swing is no simple fraction of the time of a "
            "turn, the curve is a rosette that does not close. In the program one notes the times at which "
            "r "
            "has a minimum (the radial velocity changes from negative to positive, between two steps found "
            "by interpolation); the period is the mean difference between them.",
        ),
        step(
            r_c,
            "On a circle the pull of the molecule is the whole force towards the centre.",
            on_a_circle(k * (r_c - b), m=m, v=v, r=r_c),
            answers="i1",
            where=r_c >= b,
            mistakes=[
                mistake(
                    "The spring is relaxed at b: it pulls with $k(r - b)$, not with $kr$.",
                    wrong("r = v*sqrt(m/k)", r=r_c),
                ),
                mistake(
                    "The kinetic energy does not become spring energy here; on a circle the speed stays the "
                    "same. The force must hold the atom.",
                    wrong("r = b + v*sqrt(m/k)", r=r_c),
                ),
                mistake(
                    "The factor 1/2 belongs to the kinetic energy; what a circle needs is $mv^2/r$.",
                    wrong("k*(r - b) = m*v^2/(2*r)", r=r_c),
                ),
            ],
            check="A slow atom circles just outside b; the faster it is, the wider the circle.",
        ),
        step(
            v_max,
            "The pull is strongest at the edge of the well, r = b + d. There it is k d; beyond it is zero.",
            on_a_circle(k * d, m=m, v=v_max, r=b + d),
            answers="i2",
            where=v_max >= 0,
            mistakes=[
                mistake(
                    "The widest circle has the radius b + d, not b.", on_a_circle(k * d, m=m, v=v_max, r=b)
                ),
                mistake(
                    "The widest circle has the radius b + d, not d: it goes around the molecule.",
                    on_a_circle(k * d, m=m, v=v_max, r=d),
                ),
                mistake(
                    "The spring is stretched by d only, since it is relaxed at b.",
                    on_a_circle(k * (b + d), m=m, v=v_max, r=b + d),
                ),
            ],
            check="A wider well (larger d) allows faster circles.",
        ),
        step(
            q,
            "Is the circle of (i1) inside the well? Below the largest speed the share $q$ that is left is "
            "real; above it there is no such circle.",
            law("Room left", "(v/v_max)^2 + q^2 = 1"),
            where=q >= 0,
        ),
        choice(
            "i3",
            "The force towards the centre that a circle needs, $mv^2/r$, must be supplied by $k(r - b)$, "
            "which is at most $kd$, at r = b + d. Every speed up to $\\sqrt{kd(b + d)/m}$ has its radius, "
            "and none beyond.",
            a=False,
            b=True,
            c=False,
            d=False,
            mistakes={
                "a": (
                    "The spring pulls the more, the further out, but only up to r = b + d. Beyond there "
                    "is no force at all."
                ),
                "c": "Slow atoms can circle too: just outside b, where the pull is weak.",
                "d": "The pull depends on the distance: each radius has a speed of its own.",
            },
        ),
        explain(
            "i",
            "The velocity must be across the radius, at the distance where $k(r - b) = mv^2/r$.",
            "That distance is larger than b; for the limit v → 0 it is b.",
            "The well ends at b + d: no circle for $v > \\sqrt{kd(b + d)/m}$.",
            answer="Start at the distance r with $k(r - b) = mv^2/r$, so $r = b/2 + \\sqrt{b^2/4 + "
            "mv^2/k}$, and with the velocity at right angles to the radius. Then the pull is just what "
            "the circle needs, and stays so. As r must be smaller "
            "than b + d, only speeds below $\\sqrt{kd(b + d)/m}$ will do.",
        ),
        code(
            "j",
            "At t₁ the velocity is halved (momentum; B was at rest). The pair has twice the mass, and twice "
            "the force, for the molecule pulls on both: the acceleration at a place stays as it was.",
            inputs=CAUGHT.catch_inputs,
            judge=CAUGHT.judge_catch,
            example=file("catching_an_atom/catch.py"),
        ),
        choice(
            "k1",
            "The pair needs enough energy at r = b + d, where angular momentum still leaves it a velocity "
            "across the radius. A fast enough A gives this in every direction; across the radius more speed "
            "is needed than along it.",
            a=False,
            b=False,
            c=True,
            d=False,
            mistakes={
                "a": (
                    "A fraction of the kinetic energy is lost, one half; what is left grows with the "
                    "speed of A without bound."
                ),
                "b": (
                    "Motion across the radius does not keep the pair in: the well only has so much energy "
                    "to offer. It has to be faster then."
                ),
                "d": (
                    "Energy is not all: with angular momentum, part of the kinetic energy cannot be used "
                    "to get out, for the pair must still move across the radius at the edge."
                ),
            },
        ),
        step(
            lambda_k,
            "Joined, at r = b, the velocity V makes the same angle with the radius: $V\\sin\\alpha$ is "
            "across it. Of this the share $\\lambda_0$ is left at the edge; in all, the share $\\lambda$ of "
            "V.",
            law(
                "Across the radius",
                "lambda_k = lambda_0*sin(alpha)",
                holds="angular momentum is kept",
            ),
            mistakes=[
                mistake(
                    "You left out angular momentum: at the edge the pair still moves across the radius, and "
                    "this part of the energy does not help it out.",
                    wrong("w = 0", w=lambda_k),
                ),
                mistake(
                    "The velocity across the radius is not kept. Angular momentum is: further out it is "
                    "smaller.",
                    wrong("w = sin(alpha)", w=lambda_k),
                ),
            ],
        ),
        step(
            V_k,
            "In the limiting case the velocity along the radius has just been used up at the edge; only the "
            "one across it is left.",
            law(
                "Conservation of mechanical energy",
                "2*m*V^2/2 = 2*U_0 + 2*m*(lambda_k*V)^2/2",
                holds="the pull on both atoms is conservative",
                V=V_k,
            ),
            where=V_k > 0,
        ),
        step(
            u_k,
            "Momentum in the collision, as a vector: the same direction, half the speed.",
            law("Conservation of momentum", "m*u = 2*m*V", holds="they stick together", u=u_k, V=V_k),
            answers="k2",
            mistakes=[
                mistake(
                    "That is the speed of the pair after the collision; A must have twice that before.",
                    wrong("u = V", u=u_k, V=V_k),
                ),
                mistake(
                    "Kinetic energy is not kept when they stick together.",
                    wrong("u = sqrt(2)*V", u=u_k, V=V_k),
                ),
            ],
            check="Along the radius (α = 0) it is $2d\\sqrt{k/m}$, as in (e); across it, it is largest.",
        ),
        step(
            lambda_s,
            "The angular momentum that A brings, $mvs$, is kept all the way, in the collision too. At the "
            "edge the pair therefore has the share $\\lambda$ of A's speed outside across the radius.",
            law(
                "Conservation of angular momentum",
                "m*s = 2*m*lambda_s*r_1",
                holds="the molecule pulls along the radius; v is the same on both sides",
                r_1=b + d,
            ),
            mistakes=[
                mistake(
                    "You left out angular momentum: at the edge the pair still moves across the radius.",
                    wrong("w = 0", w=lambda_s),
                ),
            ],
        ),
        step(
            v_s,
            "A has the kinetic energy $mv^2/2 + U_0$ at r = b. Half of it is lost when it sticks to B, for "
            "the pair has twice the mass and half the velocity. What is left must lift both to the edge, "
            "where in the limiting "
            "case only the motion across the radius remains.",
            law(
                "Energy of the pair",
                "(m*v^2/2 + U_0)/2 = 2*U_0 + 2*m*(lambda_s*v)^2/2",
                holds="the pull on both atoms is conservative",
                v=v_s,
            ),
            answers="k3",
            where=v_s > 0,
            mistakes=[
                mistake(
                    "Kinetic energy is not kept when the atoms stick together: half of it is lost.",
                    wrong(
                        "m*v^2/2 + U_0 = 2*U_0 + 2*m*(lambda_s*v)^2/2",
                        v=v_s,
                    ),
                ),
                mistake(
                    "On its way into the well A gains the kinetic energy U₀.",
                    wrong(
                        "m*v^2/4 = 2*U_0 + 2*m*(lambda_s*v)^2/2",
                        v=v_s,
                    ),
                ),
            ],
            check="With s = 0 it is the speed of (e).",
        ),
        step(
            w_b,
            "Does A reach r = b at this speed at all? Its velocity along the radius there must be real.",
            law(
                "Conservation of mechanical energy",
                "m*v^2/2 + U_0 = m*w^2/2 + m*(v*s/b)^2/2",
                holds="across the radius it has v s/b, from angular momentum",
                v=v_s,
                w=w_b,
            ),
            where=w_b >= 0,
        ),
        explain(
            "k",
            "In the collision momentum is kept (half the velocity, same direction), half of A's kinetic "
            "energy is lost.",
            "Before and after it energy and angular momentum about the molecule are kept.",
            "The pair gets out when its energy is at least $2U_0$ plus what angular momentum leaves across "
            "the radius at b + d.",
            answer="Yes. Before and after the collision energy and angular momentum are kept, in the "
            "collision momentum is, while half of A's kinetic energy is lost. The pair of mass 2m "
            "needs $2U_0$ to climb to the edge, and in addition the kinetic "
            "energy of the motion across the radius that it still has there, because its angular momentum "
            "cannot vanish. What it has grows with the square of A's speed, what it needs across the radius "
            "is only the share "
            "$(b\\sin\\alpha/(b + d))^2 < 1$ of it; so a fast enough A will do it in every direction, and "
            "the more easily, the more nearly it moves along the radius. A is fast anyway: it gains U₀ on "
            "its way in.",
        ),
        choice(
            "l1",
            "B rests where nothing pulls it, at r = b, so the collision happens there. A circle through r = "
            "b at a speed $V > 0$ would need the force $2mV^2/b$ towards the molecule; the well supplies "
            "$2k(r - b) = 0$ there.",
            a=sympy.Lt(2 * m * v1**2 / b, 0),
            b=sympy.Ge(2 * m * v1**2 / b, 0),
            c=False,
            mistakes={
                "a": (
                    "Across the radius is right for a circle, but at r = b there is no pull at all, "
                    "whatever the speed."
                ),
                "c": (
                    "Along the radius the pair swings through b on a line; a circle needs a velocity "
                    "across the radius, and a pull."
                ),
            },
        ),
        explain(
            "l",
            "The collision happens at r = b, since B rests there.",
            "At r = b there is no force towards the molecule, so no circle at a speed that is not zero.",
            "A slow motion across the radius comes closest: a rosette between b and a little more.",
            answer="A must meet B where B rests, on the circle r = b. To move on a circle afterwards the "
            "pair would have to move across the radius, and be pulled inwards with $2mV^2/b$; but at r "
            "= b the force is zero. So no choice "
            "of $\\vec r_0$ and $\\vec v_0$ gives a circle (only a pair at rest would stay at r = b). The "
            "best one can do is a slow pair moving across the radius: it stays between b and a distance "
            "only a little larger. "
            "But A always arrives with at least the kinetic energy U₀ from the well, so even that is out of "
            "reach for an atom from outside.",
        ),
        step(
            x_l,
            "Twice the mass and twice the force: the pair moves like one atom with this velocity. Energy "
            "and angular momentum at the greatest distance $b + x$ give $k x (b + x)^2 = m v_1^2 (2b + x)$; "
            "for small speeds $x$ is small against b.",
            small_excess(x_l, m=m, k=k, b=b, v=v1),
            answers="l2",
            mistakes=[
                mistake(
                    "That is where the pull suits a circle: the middle of the swing. The pair swings as far "
                    "again beyond it.",
                    wrong("x = m*v^2/(k*b)", x=x_l, v=v1),
                ),
                mistake(
                    "The mass has doubled, but so has the force: the molecule pulls on both atoms.",
                    wrong("x = 4*m*v^2/(k*b)", x=x_l, v=v1),
                ),
                mistake(
                    "The pair does not stop at the greatest distance: hardly any of its kinetic energy is "
                    "used up, for it still moves across the radius.",
                    wrong("x = v*sqrt(m/k)", x=x_l, v=v1),
                ),
            ],
            check="It goes with the square of the speed: half the speed, a quarter of the excess.",
        ),
    )


def scene(m, k, b, d, vA0, x, xp, yp, eps, epsx, v0, v, s, alpha, v1, answer):
    """The atom bound on a line and across it, falling in, circling, and the pair (as light and as hard as one atom) just out and just not."""
    well = {"m": m, "k": k, "b": b, "d": d}
    line, edge, swift = well | {"dimension": 1}, (b + d) * (1 - 1e-9), 1 + 1e-9
    near, far = answer["a1"]
    pair = well | {"m": 2 * m, "k": 2 * k}
    sin, cos = math.sin(alpha), math.cos(alpha)
    return [
        simulate("atom", line | {"r0": near, "v0": 0.0}, turning_points=(near, far), period=answer["a2"]),
        simulate("atom", line | {"r0": b, "v0": math.sqrt(epsx * k / m) * d}, velocities=answer["a3"]),
        simulate("atom", line | {"r0": b, "v0": -answer["c"]}, velocities=vA0),
        simulate(
            "atom",
            well | {"r0": b, "v0": v0},
            turning_points=(b, answer["h1"]),
            period=answer["h2"],
            angle=answer["h3"],
        ),
        simulate(
            "atom",
            well | {"r0": answer["i1"], "v0": v},
            turning_points=(answer["i1"], answer["i1"]),
            neglected=1e-7,
        ),
        simulate(
            "atom",
            pair | {"r0": (b, 0.0), "v0": (swift * answer["k2"] / 2 * cos, swift * answer["k2"] / 2 * sin)},
            escapes=1.0,
        ),
        simulate(
            "atom",
            pair | {"r0": (b, 0.0), "v0": (answer["k2"] / 2 / swift * cos, answer["k2"] / 2 / swift * sin)},
            escapes=0.0,
        ),
        *(
            simulate(
                "atom",
                pair | {"r0": (b, 0.0), "v0": halved(m, k, b, d, s, answer["k3"] * share)},
                escapes=out,
            )
            for share, out in ((swift, 1.0), (1 / swift, 0.0))
        ),
        simulate(
            "atom", well | {"r0": (b, 0.0), "v0": halved(m, k, b, d, 0.0, answer["e"] * swift)}, escapes=1.0
        ),
        simulate("atom", well | {"r0": edge, "v0": (0.0, 0.999 * answer["i2"])}, escapes=0.0),
    ]


def halved(m, k, b, d, s, v):
    """Velocity of the pair just after the collision at (b, 0), when A had the speed v and the impact parameter s outside."""
    across = v * s / b
    return math.sqrt(v**2 + k * d**2 / m - across**2) / 2, across / 2
