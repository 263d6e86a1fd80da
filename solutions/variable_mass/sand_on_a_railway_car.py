"""Sand on a railway car: a force is needed to keep a velocity, when there is ever more to move."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import law, rocket_equation, wrong


def derive(v, R, ux, m0, t):
    F, P, F_c, K, D = unknowns("F P F_c K D")
    return derivation(
        step(
            F,
            "The velocity stays the same, so a = 0; the sand lands with no horizontal velocity, so u = 0.",
            rocket_equation(F, m=m0 + R * t, a=0, v=v, u=0, R=R),
            answers="a",
            mistakes=[
                mistake(
                    "A constant velocity needs no force only as long as the mass stays the same; the sand "
                    "has to be brought up to speed.",
                    wrong("F = m*a", m=m0, a=0),
                ),
                mistake(
                    "The mass of the car itself keeps its momentum; only the sand that arrives has to be "
                    "brought up to speed.",
                    wrong("F = (m + R*t)*v/t", m=m0),
                ),
                mistake(
                    "The factor 1/2 belongs to kinetic energy; momentum has none.",
                    wrong("F = v*R/2"),
                ),
            ],
            check="How much the car weighs, and how long one has waited, does not matter.",
        ),
        step(
            P,
            "The power of a force along the motion is force times velocity.",
            law("Power", "P = F*v"),
            answers="b",
            mistakes=[
                mistake(
                    "That is only how fast the kinetic energy grows; the pull delivers more.",
                    wrong("P = F*v/2"),
                ),
                mistake(
                    "That is the work done in the whole time; the power is the work per second.",
                    wrong("P = F*v*t"),
                ),
            ],
            check="It grows with the square of the speed.",
        ),
        step(
            F_c,
            "Now the sand only has to be brought from $u_x$ to $v$.",
            rocket_equation(F_c, m=m0 + R * t, a=0, v=v, u=ux, R=R),
            answers="c",
            mistakes=[
                mistake(
                    "The sand brings momentum along x; what it has already need not be given to it. You "
                    "left $u_x$ out.",
                    rocket_equation(F_c, m=m0 + R * t, a=0, v=v, u=0, R=R),
                ),
                mistake(
                    "The sand must gain $v - u_x$; you added $u_x$.",
                    rocket_equation(F_c, m=m0 + R * t, a=0, v=v, u=-ux, R=R),
                ),
            ],
            check="Sand that already has the velocity of the car needs no force at all.",
        ),
        step(
            K,
            "Each second the mass R comes to move with the car: so fast grows the kinetic energy.",
            law("Kinetic energy", "K = R*v^2/2", source="(12.2)"),
        ),
        step(
            D,
            "What the pull delivers and what does not become kinetic energy is lost: sand and car rub until "
            "they move as one.",
            law("Energy balance", "P = K + D"),
            answers="d",
            mistakes=[
                mistake(
                    "Energy is not kept here: each grain is caught in a perfectly inelastic collision.",
                    wrong("D = 0*P"),
                ),
                mistake(
                    "Part of what the pull delivers stays as kinetic energy of the sand.",
                    wrong("D = P"),
                ),
            ],
            check="Half of the work is lost, however gently the sand is caught.",
        ),
    )


def scene(v, R, ux, m0, t, answer):
    """The sand comes in a thousand shovels, each caught by the car; once falling straight down, once with its own velocity."""
    still = {"v": v, "R": R, "t": t}
    return [
        simulate(
            "railway_car",
            still | {"ux": 0.0},
            mean_force=answer["a"],
            work=answer["b"] * t,
            energy_lost=answer["d"] * t,
        ),
        simulate("railway_car", still | {"ux": ux}, mean_force=answer["c"]),
    ]
