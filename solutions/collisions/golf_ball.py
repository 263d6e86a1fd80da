"""Golf ball: a heavy club sends a light ball off faster than itself."""

import math

import sympy

from corollary.author import derivation, explain, mistake, neglected, reject, simulate, step, unknowns
from corollary.laws import (
    after_elastic,
    conservation_of_momentum,
    elastic,
    in_the_limit,
    law,
    restitution,
    wrong,
)


def derive(v, M, m, r):
    u_a, u_b, u_c, V_b, V_c = unknowns(
        "u_a u_b u_c V_b V_c",
        V_b="velocity of the club after an elastic hit",
        V_c="velocity of the club after the real hit",
    )
    eps = unknowns("epsilon")[0]
    before, after_b, after_c = [(M, v), (m, 0)], [(M, V_b), (m, u_b)], [(M, V_c), (m, u_c)]
    return derivation(
        step(
            u_a,
            r"An elastic collision gives the ball at rest $u = \frac{2M}{M + m}v = \frac{2}{1 + m/M}v$; let "
            r"$m/M$ go to 0.",
            in_the_limit(
                u_a,
                after_elastic(A=(M, v), B=(m, 0))[1],
                M,
                sympy.oo,
                "the ball's mass is negligible beside the club's",
            ),
            answers="a",
            mistakes=[
                mistake(
                    "That would be so if the ball stuck to the club; an elastic ball runs ahead of it.",
                    wrong("u = v", u=u_a),
                ),
                mistake(
                    "You gave all of the club's momentum to the ball; a heavy club hardly slows down.",
                    wrong("u = M*v/m", u=u_a),
                ),
                mistake(
                    "You gave all of the club's kinetic energy to the ball; a heavy club keeps nearly all "
                    "of it.",
                    wrong("u = v*sqrt(M/m)", u=u_a),
                ),
                mistake(
                    "That is right with the masses in it; here the ball's mass is to be neglected.",
                    wrong("u = 2*M/(M + m)*v", u=u_a),
                ),
            ],
            check="It does not depend on the masses any more.",
        ),
        step(
            u_b,
            "Momentum and kinetic energy of club and ball are kept.",
            conservation_of_momentum(before=before, after=after_b),
            elastic(before=before, after=after_b),
            also=[V_b],
            answers="b",
            reject=[
                reject(
                    "the velocities would be those from before: the club would have passed through the ball",
                    V_b=v,
                    u_b=0,
                )
            ],
            mistakes=[
                mistake(
                    "You let the ball stay on the club; an elastic collision keeps the kinetic energy.",
                    law("Perfectly inelastic", "V = u", V=V_b, u=u_b),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "You neglected the ball's mass; here it counts.",
                    law("Heavy club", "u = 2*v", u=u_b),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "The masses have changed places: the club is the heavy one.",
                    law("Masses exchanged", "u = 2*m/(M + m)*v", u=u_b),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check="It is a little less than for a very heavy club.",
        ),
        step(
            u_c,
            "Momentum is kept; the relative velocity is turned round and shrinks by r.",
            conservation_of_momentum(before=before, after=after_c),
            restitution(r, A=(v, V_c), B=(0, u_c)),
            also=[V_c],
            answers="c",
            mistakes=[
                mistake(
                    "r compares *relative* velocities: that of ball and club after, with that of club and "
                    "ball before.",
                    law("Coefficient of restitution", "u = r*v", u=u_c),
                ),
                mistake(
                    "Not the whole velocity of the elastic ball shrinks by r: only the part with which it "
                    "runs ahead of the club.",
                    law("Coefficient of restitution", "u = 2*M/(M + m)*r*v", u=u_c),
                ),
                mistake(
                    "You neglected the ball's mass; here it counts.",
                    law("Coefficient of restitution", "u = (1 + r)*v", u=u_c),
                ),
                mistake("You used an elastic collision.", restitution(1, A=(v, V_c), B=(0, u_c))),
            ],
            check="r = 1 gives (b), r = 0 the common velocity Mv/(M + m).",
        ),
        neglected(
            "a",
            "the mass of the ball",
            eps,
            "Beside (b), where it counts, the limit is off by this.",
            law("Difference", "epsilon = u_a - u_b", epsilon=eps),
            asked=True,
        ),
        explain(
            "d",
            "Changes to an observer who moves with the club (or argues with the relative velocity).",
            "Says that there the ball comes at v and is turned round as by a wall: it leaves the club at v.",
            "Comes back to the ground: the club goes on at v, and the ball is faster than the club by v.",
            answer="Ride along with the club. Seen from there the club is at rest, and the ball comes "
            "towards it at the speed v. The club is so heavy that it is a wall for the ball: an "
            "elastic ball is "
            "thrown back at the same speed v. Seen from the ground the club still moves at v, and the ball "
            "runs ahead of it at another v: together 2v.",
        ),
    )


def scene(v, M, m, r, answer):
    """Club and ball as two spheres, head-on: without damping, and with as much of it as r asks for."""
    k, loss, mass = 1e9, -math.log(r), M * m / (M + m)
    eta = 2 * math.sqrt(k * mass) * loss / math.hypot(math.pi, loss)
    hit = {"mA": M, "mB": m, "k": k, "q": 1, "dx": 0.08, "dy": 0.0, "vA": (v, 0.0), "vB": (0.0, 0.0)}
    return [
        simulate(
            "spheres",
            hit | {"eta": 0.0},
            animated=True,
            velocities=(v - m / M * answer["b"], 0.0, answer["b"], 0.0),
        ),
        simulate("spheres", hit | {"eta": eta}, velocities=(v - m / M * answer["c"], 0.0, answer["c"], 0.0)),
    ]
