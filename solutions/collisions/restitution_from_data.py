"""Coefficient of restitution from data: from velocities, from heights, and from the force itself."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import damped_frequency, damped_rebound, damping_rate, law, restitution, wrong


def derive(vA0, vB0, vA1, vB1, h0, h1, m, k, c):
    r_v, r_h, beta, omega, T, r_c = unknowns("r_v r_h beta omega T r_c", T="duration of the contact")
    return derivation(
        step(
            r_v,
            "The coefficient compares the relative velocity after with that before; the minus sign stands "
            "for its being turned round.",
            restitution(r_v, A=(vA0, vA1), B=(vB0, vB1)),
            answers="a",
            mistakes=[
                mistake(
                    "The coefficient is what is left of the relative velocity: after over before.",
                    wrong(
                        "r*(v_B1 - v_A1) = -(v_B0 - v_A0)",
                        r=r_v,
                        v_A0=vA0,
                        v_A1=vA1,
                        v_B0=vB0,
                        v_B1=vB1,
                    ),
                ),
                mistake(
                    "That compares the speed of B after with that of A before; what counts are the "
                    "velocities of A and B *relative to each other*.",
                    wrong("r = v_B1/v_A0", r=r_v, v_A0=vA0, v_B1=vB1),
                ),
                mistake(
                    "Mind the signs: a relative velocity is the difference of the two velocities, not their "
                    "sum.",
                    wrong(
                        "r = (v_B1 + v_A1)/(v_A0 + v_B0)",
                        r=r_v,
                        v_A0=vA0,
                        v_A1=vA1,
                        v_B0=vB0,
                        v_B1=vB1,
                    ),
                ),
            ],
            check="It lies between 0 (they move on together) and 1 (elastic).",
        ),
        step(
            r_h,
            "The speed at the floor is √(2gh₀) on the way down and √(2gh₁) on the way up; their ratio is r.",
            law(
                "Height of a bounce",
                "h_1 = r^2*h_0",
                source="(Fig. 12.11)",
                holds="only gravity works in the air",
                r=r_h,
                h_0=h0,
                h_1=h1,
            ),
            answers="b",
            where=r_h >= 0,
            mistakes=[
                mistake(
                    "The heights tell the energies; r compares the *speeds*, which go with the root of the "
                    "height.",
                    wrong("r = h_1/h_0", r=r_h, h_0=h0, h_1=h1),
                ),
                mistake(
                    "The speed grows with the root of the height, not with its square.",
                    wrong("r = (h_1/h_0)^2", r=r_h, h_0=h0, h_1=h1),
                ),
                mistake(
                    "That is what belongs to the height that is lost; use the height of the bounce.",
                    wrong("r = sqrt(1 - h_1/h_0)", r=r_h, h_0=h0, h_1=h1),
                ),
            ],
            check="A ball that comes back to its old height has r = 1. The value of g does not matter.",
        ),
        step(
            beta,
            r"While it touches, Newton's second law reads $m\ddot x = -kx - c\dot x$: a damped oscillation, "
            r"which starts at $x = 0$.",
            damping_rate(beta, m, c),
        ),
        step(
            omega,
            "The damping makes the swing slower. If β² reached k/m there would be no swing at all, and no "
            "rebound.",
            damped_frequency(omega, m, k, beta),
        ),
        step(
            T,
            "The bumper is back at $x = 0$ after half a swing, for $x = (v/\\omega)\\,e^{-\\beta "
            "t}\\sin\\omega t$.",
            law("Half a swing", "omega*T = pi"),
            mistakes=[
                mistake(
                    "That is a whole swing; the contact ends after half of one.",
                    wrong("omega*T = 2*pi"),
                ),
                mistake(
                    "That is a quarter of a swing, up to the deepest point; the ball still has to come out "
                    "again.",
                    wrong("omega*T = pi/2"),
                ),
            ],
        ),
        step(
            r_c,
            "There the velocity has the opposite direction, and is smaller by the factor by which the swing "
            "has died away.",
            damped_rebound(r_c, beta, T),
            answers="c",
            mistakes=[
                mistake(
                    "That is the share of the kinetic energy that is left, r²; the coefficient compares "
                    "velocities.",
                    wrong("r = exp(-2*beta*T)", r=r_c),
                ),
                mistake(
                    "You took T from β alone: the time of contact comes from the spring.",
                    wrong("r = exp(-pi)", r=r_c),
                ),
                mistake(
                    "That is the share of the speed that is lost.",
                    wrong("r = 1 - exp(-beta*T)", r=r_c),
                ),
            ],
            check=(
                "No damping (c = 0): r = 1. Much damping: r goes to 0. The speed of the ball does not matter."
            ),
        ),
    )


def scene(vA0, vB0, vA1, vB1, h0, h1, m, k, c, answer):
    """The ball on its bumper, from Newton's second law, at 1 m/s."""
    return [
        simulate(
            "ball_on_floor",
            {"m": m, "k": k, "q": 1, "g": 0.0, "R": 0.02, "y0": 0.02, "v0": -1.0, "eta": c},
            rebound_speed=answer["c"],
        )
    ]
