"""Super-ball: a fall, a floor, and an elastic collision, one after the other."""

import math

import sympy

from corollary.author import (
    derivation,
    mistake,
    neglected,
    reject,
    route,
    simulate,
    step,
    supposed,
    unknowns,
    vector,
)
from corollary.laws import (
    after_elastic,
    conservation_of_momentum,
    elastic,
    falling,
    in_the_limit,
    law,
    restitution,
    wrong,
)


def derive(mA, mB, h0, g):
    v_0, v_B1, v_A1, h_1, v_most, h_most = unknowns(
        "v_0 v_B1 v_A1 h_1 v_most h_most",
        v_A1="velocity of A after both have met",
        v_most="speed of B with a very heavy A",
    )
    f, other = (
        vector("f", "third equal triple heavy"),
        vector(
            "a", "third equal triple heavy", meaning="velocity of A after both have met, in units of $v_0$"
        ),
    )
    lightness = (sympy.Integer(3), sympy.Integer(1), sympy.Rational(1, 3), sympy.Integer(0))
    u, eps = unknowns("u epsilon")
    tau, touch = supposed("tau", "1 ms", "small balls of hard rubber touch no longer")
    before, after = [(mA, v_0), (mB, -v_0)], [(mA, v_A1), (mB, v_B1)]
    return derivation(
        step(
            v_0,
            "Only gravity works on the balls as they fall.",
            falling(v_0, g, h0),
            answers="a",
            where=v_0 >= 0,
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", h=h0, v=v_0),
                ),
                mistake(
                    "The factor 2 stands on the other side: $v^2/2 = gh$.",
                    wrong("g*h = 2*v^2", h=h0, v=v_0),
                ),
            ],
            check="Both balls have it: a fall does not depend on the mass.",
        ),
        step(
            v_B1,
            "The floor has turned A round: A moves up at +v₀, B still down at -v₀. The contact is so short "
            "that gravity has no say in it: momentum is kept, and energy too.",
            conservation_of_momentum(before=before, after=after),
            elastic(before=before, after=after),
            also=[v_A1],
            answers="b",
            reject=[
                reject(
                    "the velocities would be those from before: the balls would have passed through each "
                    "other",
                    v_A1=v_0,
                    v_B1=-v_0,
                )
            ],
            mistakes=[
                mistake(
                    "B is not at rest when A meets it: it still falls at v₀.",
                    law("B at rest", "v_B1 = 2*m_A/(m_A + m_B)*v_0", m_A=mA, m_B=mB),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "You let the balls move on together; an elastic collision keeps the kinetic energy.",
                    law("Perfectly inelastic", "v_A = v_B", v_A=v_A1, v_B=v_B1),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "B is not just turned round, as it would be by a floor at rest: A comes up to meet it.",
                    law("Turned round", "v_B1 = v_0"),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "A does not give all of its energy to B; momentum must be kept as well.",
                    law(
                        "All energy to B",
                        "v_B1 = sqrt((m_A + m_B)/m_B)*v_0",
                        m_A=mA,
                        m_B=mB,
                    ),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check="With equal masses the balls exchange their velocities: B goes up at v₀.",
        ),
        step(
            v_A1,
            "With B's velocity known, momentum gives A's.",
            conservation_of_momentum(before=before, after=after),
            answers="c",
            routes=[
                route(
                    "In an elastic collision the relative velocity is only turned round (r = 1): they part "
                    "at 2v₀.",
                    restitution(1, A=(v_0, v_A1), B=(-v_0, v_B1)),
                )
            ],
            mistakes=[
                mistake(
                    "B's momentum before the collision points down: it counts as negative.",
                    conservation_of_momentum(before=[(mA, v_0), (mB, v_0)], after=after),
                ),
                mistake(
                    "You left out B's momentum before the collision.",
                    conservation_of_momentum(before=[(mA, v_0), (mB, 0)], after=after),
                ),
                mistake(
                    "That is A's velocity before it met B.",
                    wrong("v_A1 = v_0"),
                ),
            ],
            check="If A is three times as heavy as B, A stops: B has taken all of the energy.",
        ),
        step(
            h_1,
            "On its way up only gravity works on B.",
            falling(v_B1, g, h_1),
            answers="d",
            mistakes=[
                mistake(
                    "The height goes with the square of the speed.",
                    wrong(
                        "h_1 = h_0*v_B1/v_0",
                        h_0=h0,
                    ),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", h=h_1, v=v_B1),
                ),
                mistake("You used A's speed; asked is how high B rises.", falling(v_A1, g, h_1)),
            ],
            check="With equal masses it is the height from which they fell.",
        ),
        step(
            v_most,
            r"Divide numerator and denominator by $m_A$, $v_{B,1} = \frac{3 - m_B/m_A}{1 + m_B/m_A}v_0$, "
            r"and let $m_B/m_A$ go to 0.",
            in_the_limit(
                v_most,
                after_elastic(A=(mA, v_0), B=(mB, -v_0))[1],
                mB,
                0,
                "B's mass is negligible beside A's",
            ),
            mistakes=[
                mistake(
                    "Twice A's speed is right for a B at rest; but here B comes down at v₀ as well.",
                    wrong("v = 2*v_0", v=v_most),
                ),
            ],
        ),
        step(
            h_most,
            "Again only gravity works on the way up.",
            falling(v_most, g, h_most),
            answers="e",
            mistakes=[
                mistake(
                    "The height goes with the square of the speed: three times the speed is more than three "
                    "times the height.",
                    wrong(
                        "h = h_0*v/v_0",
                        h=h_most,
                        h_0=h0,
                        v=v_most,
                    ),
                ),
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong("g*h = v^2", h=h_most, v=v_most),
                ),
            ],
            check="However heavy A is, B does not rise higher than this.",
        ),
        step(
            f,
            "In units of v₀, and with q = m_B/m_A: A comes with 1, B with -1. The relative velocity 2 is "
            "turned round, and the momentum 1 - q is kept; q is 3, 1, 1/3 and 0.",
            law("Conservation of momentum", "1 - q = x_A + q*x_B", q=lightness, x_A=other, x_B=f),
            law("Coefficient of restitution", "x_B - x_A = 2", source="(12.108)", x_A=other, x_B=f),
            also=other,
            answers="f",
            mistakes=[
                mistake(
                    "B is not at rest when A meets it: it comes down with -1.",
                    law("Conservation of momentum", "x_B*(1 + q) = 2", x_B=f, q=lightness),
                ),
                mistake(
                    "The ratio of the masses is the other way round: a heavy A sends B up.",
                    law(
                        "Conservation of momentum",
                        "x_B = c",
                        x_B=f,
                        c=tuple((3 * q - 1) / (q + 1) for q in lightness),
                    ),
                ),
            ],
            check="The heavier A is, the faster B goes up, but never faster than 3v₀.",
        ),
        neglected(
            "b",
            "gravity during both contacts",
            u,
            "While A touches the floor, B falls on for the time τ, which makes it a little faster after the "
            "hit; while the balls touch, both fall, which makes it slower. Each is at most gτ, and they "
            "work against each other.",
            law("Free fall", "u = g*tau"),
            supposing=[touch],
        ),
        neglected(
            "d",
            "gravity during both contacts",
            eps,
            "It changes B's velocity by at most gτ, as in (b), and the height with it: $v^2/2g$ by "
            "$v\\,u/g$.",
            law("Change of the height", "epsilon = v*u/g", epsilon=eps, v=v_B1, u=g * tau),
            supposing=[touch],
        ),
    )


def scene(mA, mB, h0, g, answer, neglected):
    """A, on its way up, meets B on its way down, as two elastic spheres; the fall again with its own weight; and all of it in one go.

    There the balls are weighed while they touch, as hard ones do for some tenths of a millisecond.
    """
    fall = answer["a"]
    met = {
        "mA": mA,
        "mB": mB,
        "k": 1e9,
        "eta": 0.0,
        "dx": 0.08,
        "dy": 0.0,
        "vA": (fall, 0.0),
        "vB": (-fall, 0.0),
    }
    dropped = {"mA": mA, "mB": mB, "h0": h0, "g": g, "q": 1.0, "k": 1e9, "weighed": 1}
    return [
        simulate("spheres", met, velocities=(answer["c"], 0.0, answer["b"], 0.0)),
        simulate(
            "spheres",
            met | {"mA": 1e6 * mB},
            neglected=1e-5,
            velocities=(fall, 0.0, math.sqrt(2 * g * answer["e"]), 0.0),
        ),
        simulate(
            "ball_on_floor", {"m": mA, "g": g, "R": 0.02, "y0": 0.02 + h0, "v0": 0.0}, rebound_speed=fall
        ),
        simulate(
            "super_ball",
            dropped,
            animated=True,
            heights=(answer["c"] ** 2 / (2 * g), answer["d"]),
            neglected=neglected["d"] / answer["d"],
        ),
    ]
