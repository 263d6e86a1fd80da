"""Toppling a book: a ball that comes back has changed its momentum more than one that stays."""

from corollary.author import (
    always,
    choice,
    derivation,
    explain,
    mistake,
    neglected,
    reject,
    simulate,
    step,
    supposed,
    unknowns,
)
from corollary.laws import (
    conservation_of_momentum,
    elastic,
    elastic_on_hinge,
    hit_on_hinge,
    law,
    momentum,
    sticking,
    wrong,
)


def derive(m, M, v, h, I):
    u, V, V_s, J, J_s, rho, omega, u_h = unknowns(
        "u V V_s J J_s rho omega u_h",
        V="velocity of the book after the elastic hit",
        u="velocity of the ball then",
        V_s="velocity of both after the sticky hit",
        u_h="velocity of the ball after it has hit the book that turns",
    )
    R, J_f = unknowns("R J_f")
    _tau, touch = supposed("tau", "1 ms", "hard things touch no longer")
    _mu, rough = supposed("mu", "0.5", "wood on paper or cloth slides more easily")
    _g, weight = supposed("g", "9.8 m/s^2", "on the ground")
    before, after = [(m, v), (M, 0)], [(m, u), (M, V)]
    return derivation(
        step(
            V,
            "Elastic ball, free book: momentum and kinetic energy are kept.",
            conservation_of_momentum(before=before, after=after),
            elastic(before=before, after=after),
            also=[u],
            reject=[
                reject(
                    "the velocities would be those from before: the ball would have flown through the book",
                    u=v,
                    V=0,
                )
            ],
        ),
        always("the elastic ball comes back", u < 0),
        step(
            J,
            "The book was at rest; its impulse is the momentum it has after.",
            momentum(J, M, V),
            answers="d",
            mistakes=[
                mistake(
                    "That is the impulse of a ball that stays on the book; the elastic one also comes back.",
                    law("Impulse", "J = m*M/(m + M)*v"),
                    instead="Momentum",
                ),
                mistake(
                    "The ball would change its momentum by 2mv at a wall; a free book gives way.",
                    law("Impulse", "J = 2*m*v"),
                    instead="Momentum",
                ),
                mistake(
                    "That is all the momentum of the ball before; it gives exactly that only if it stops.",
                    law("Impulse", "J = m*v"),
                    instead="Momentum",
                ),
            ],
            check="For a very heavy book it is 2mv, as at a wall.",
        ),
        step(V_s, "Sticky ball, free book: both move on together.", sticking(before=before, together=V_s)),
        step(J_s, "Again the book's impulse is the momentum it has after.", momentum(J_s, M, V_s)),
        step(
            rho,
            "Compare the two impulses.",
            law("Ratio", "q = J_elastic/J_sticking", q=rho, J_elastic=J, J_sticking=J_s),
            answers="c",
            mistakes=[
                mistake(
                    "Both balls bring the same momentum, but they do not give the same to the book.",
                    wrong("q = 1", q=rho),
                ),
                mistake(
                    "That is the ratio the other way round.",
                    wrong("q = J_s/J_e", q=rho, J_e=J),
                ),
                mistake(
                    "You used 2mv for the elastic ball, as at a wall; the book gives way for both balls.",
                    wrong("q = 2*m*v/J_s", q=rho),
                ),
            ],
            check=(
                "It does not depend on the masses: the relative velocity changes from v to -v instead of "
                "from v to 0."
            ),
        ),
        choice(
            "a",
            "The elastic ball comes back: its momentum changes more, and so does that of the book. The book "
            "gets the larger impulse.",
            a=rho > 1,
            b=rho < 1,
            c=False,
            mistakes={
                "b": (
                    "A ball that stays hands over its momentum, but one that comes back hands over still "
                    "more."
                ),
                "c": (
                    "Both bring the same momentum. But what the book gets is what the ball's momentum "
                    "*changes* by."
                ),
            },
        ),
        explain(
            "b",
            "Says that what topples the book is the impulse on it (or its torque about the lower edge), and "
            "that this is the opposite of the change of the ball's momentum.",
            "Says that the elastic ball is turned round, so that its momentum changes more than that of the "
            "ball that stays.",
            "Concludes that the elastic ball gives the book the larger impulse, so it is the better choice.",
            answer="The book topples if it gets enough of a push, that is, enough impulse at the height "
            "where it is hit. By Newton's third law this impulse is opposite to the change of the "
            "ball's momentum. A sticky ball "
            "is only slowed down to the book's speed. An elastic ball is first slowed down just as much and "
            "then pushed back, so its momentum changes by twice as much, and the book gets twice the "
            "impulse. Choose the elastic ball.",
        ),
        step(
            omega,
            "The edge may push as it likes: its force has no torque about itself, so the angular momentum "
            "about the edge is kept. The hit is elastic, so the kinetic energy is kept too.",
            hit_on_hinge(m=m, h=h, before=v, after=u_h, I=I, omega=omega),
            elastic_on_hinge(m=m, before=v, after=u_h, I=I, omega=omega),
            also=[u_h],
            answers="e",
            reject=[reject("nothing would have happened", u_h=v, omega=0)],
            mistakes=[
                mistake(
                    "That is the angular velocity with a ball that stays on the book; this one comes back.",
                    law("Stays on the book", "v_1 = omega*h", v_1=u_h),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "The ball does not stop: it comes back (or goes on), and keeps angular momentum of its "
                    "own.",
                    law("Stops", "I*omega = m*v*h"),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "You turned the ball round as at a wall; the book gives way and the ball comes back "
                    "more slowly.",
                    law("As at a wall", "I*omega = 2*m*v*h"),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check=(
                "For a book very hard to turn (large I) it is 2mvh/I: the ball is turned round as at a wall."
            ),
        ),
        neglected(
            "d",
            "the friction of the table during the hit",
            J_f,
            "It is at most R while they touch.",
            law("Kinetic friction", "R = mu*M*g"),
            law("Impulse", "J = R*tau", source="(12.20)", J=J_f),
            also=[R],
            supposing=[rough, weight, touch],
            asked=True,
        ),
    )


def scene(m, M, v, h, I, answer):
    """A free book is a row of two balls; a book that turns is, where it is hit, as heavy as I/h² (hit at h, it moves at omega h)."""
    return [
        simulate(
            "cradle", {"N": 2, "masses": (m, M), "v0": v}, velocities=(v - answer["d"] / m, answer["d"] / M)
        ),
        simulate(
            "cradle",
            {"N": 2, "masses": (m, I / h**2), "v0": v},
            velocities=(v - I / h * answer["e"] / m, h * answer["e"]),
        ),
    ]
