"""Meteor impact: no force is known, and yet the velocity after it is."""

import math

from corollary.author import derivation, explain, mistake, route, simulate, step, unknown, vector
from corollary.laws import change_of_kinetic_energy_in_plane, law, sticking, wrong


def derive(mA, mB, vAx, vAy, vBx, vBy):
    v, dv, dK = vector("v"), vector("dv"), unknown("dK")
    vA, vB = (vAx, vAy), (vBx, vBy)
    before, after = [(mA, vA), (mB, vB)], [(mA, v), (mB, v)]
    return derivation(
        step(
            v,
            "The forces between meteor and planet are a pair: their impulses cancel, and the total momentum "
            "is kept in each direction. Afterwards both have one velocity.",
            sticking(before=before, together=v),
            answers="a",
            mistakes=[
                mistake(
                    "You added sizes. Momentum has a direction: the components along -x and -y are negative.",
                    sticking(before=[(mA, (vAx, -vAy)), (mB, (-vBx, vBy))], together=v),
                ),
                mistake(
                    "You took the mean of the velocities; each velocity counts with its mass.",
                    wrong("v_1 = (v_A0 + v_B0)/2", v_1=v, v_A0=vA, v_B0=vB),
                ),
                mistake(
                    "You left out the momentum of the planet, which moves as well before the impact.",
                    sticking(before=[(mA, vA), (mB, (0, 0))], together=v),
                ),
                mistake(
                    "After the impact the meteor is a part of what moves: both masses share the momentum.",
                    wrong(
                        "m_A*v_A0 + m_B*v_B0 = m_B*v_1",
                        m_A=mA,
                        v_A0=vA,
                        m_B=mB,
                        v_B0=vB,
                        v_1=v,
                    ),
                ),
            ],
            check=(
                "It lies between the two velocities, much nearer to that of the heavy planet; a meteor "
                "without mass would change nothing."
            ),
        ),
        step(
            dv,
            "The planet had the velocity before, and has the common velocity after.",
            law("Change of velocity", "dv = v_1 - v_0", dv=dv, v_1=v, v_0=vB),
            answers="b",
            routes=[
                route(
                    "The same at once, since the impulse on both has the same size: the change is the "
                    "relative velocity, shared by the masses.",
                    law(
                        "Change of velocity",
                        "dv = m_A/(m_A + m_B)*(v_A - v_B)",
                        dv=dv,
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                        v_B=vB,
                    ),
                )
            ],
            mistakes=[
                mistake(
                    "A change is what is after less what is before; you took it the other way.",
                    wrong("dv = v_0 - v_1", dv=dv, v_1=v, v_0=vB),
                ),
                mistake(
                    "That is the change of the meteor's velocity; asked is the planet's.",
                    wrong("dv = v_1 - v_0", dv=dv, v_1=v, v_0=vA),
                ),
                mistake(
                    "You added the velocities; a change is a difference.",
                    wrong("dv = v_1 + v_0", dv=dv, v_1=v, v_0=vB),
                ),
            ],
            check="It points the way the meteor came, as seen from the planet.",
        ),
        step(
            dK,
            "The kinetic energy of both together after the impact, less that of meteor and planet before "
            "it; the square of a speed is the sum of the squares of the components.",
            change_of_kinetic_energy_in_plane(dK, before=before, after=after),
            answers="c",
            routes=[
                route(
                    "The same from the relative velocity and the reduced mass: only the motion against each "
                    "other is lost.",
                    law(
                        "Loss in a perfectly inelastic collision",
                        "dK = -m_A*m_B/(m_A + m_B)*((v_Ax - v_Bx)^2 + (v_Ay - v_By)^2)/2",
                        source="(12.88)",
                        dK=dK,
                        m_A=mA,
                        m_B=mB,
                        v_Ax=vAx,
                        v_Ay=vAy,
                        v_Bx=vBx,
                        v_By=vBy,
                    ),
                )
            ],
            mistakes=[
                mistake(
                    "You left out the factor 1/2 of the kinetic energy.",
                    wrong(
                        "dK = M*(u_x^2 + u_y^2) - m_A*(v_Ax^2 + v_Ay^2) - m_B*(v_Bx^2 + v_By^2)",
                        dK=dK,
                        M=mA + mB,
                        u_x=v[0],
                        u_y=v[1],
                        m_A=mA,
                        v_Ax=vAx,
                        v_Ay=vAy,
                        m_B=mB,
                        v_Bx=vBx,
                        v_By=vBy,
                    ),
                ),
                mistake(
                    "That is the kinetic energy that is lost; the change is after less before, and negative.",
                    change_of_kinetic_energy_in_plane(dK, before=after, after=before),
                ),
                mistake(
                    "You kept only the motion along x; the squares of both components count.",
                    change_of_kinetic_energy_in_plane(
                        dK, before=[(mA, (vAx, 0)), (mB, (vBx, 0))], after=[(mA, (v[0], 0)), (mB, (v[0], 0))]
                    ),
                ),
                mistake(
                    "That is the change of the meteor's kinetic energy alone.",
                    change_of_kinetic_energy_in_plane(dK, before=[(mA, vA)], after=[(mA, v)]),
                ),
            ],
            check=(
                "Negative: two bodies that stick together always lose kinetic energy, to heat, to "
                "melting, to dust."
            ),
        ),
        explain(
            "d",
            "Says that momentum gives one vector equation (one equation for each direction) for two unknown "
            "velocities, so only their sum, weighted with the masses, is known.",
            "Says that here both move on as one, with the same velocity, which leaves a single unknown "
            "velocity.",
            "Names another possible fact: kinetic energy is conserved, a known loss of energy or "
            "coefficient of restitution, or one of the velocities measured.",
            answer="In each direction there is one equation, but two unknowns: the velocities of the two "
            "bodies. Momentum fixes $m_A\\vec v_{A,1} + m_B\\vec v_{B,1}$ "
            "and says nothing on how it is shared. In this impact "
            "we know besides that the meteor stays in the planet: $\\vec v_{A,1} = \\vec v_{B,1} = \\vec "
            "v_1$. That is the second vector equation, and the "
            "common velocity follows. In other collisions one may know "
            "that the kinetic energy is kept (elastic), how much of it is lost (a coefficient of "
            "restitution), or have measured one of the velocities.",
        ),
    )


def scene(mA, mB, vAx, vAy, vBx, vBy, answer):
    """Meteor and planet as two spheres of 10 km that meet off centre and do not part: how large and how hard they are does not matter.

    Once a spring and a brake push them apart, too weakly; once it is all mud, and the meteor is followed until it lies still in it.
    """
    (ux, uy), mu, R = (vAx - vBx, vAy - vBy), mA * mB / (mA + mB), 1e4
    u, before = math.hypot(ux, uy), mA * (vAx**2 + vAy**2) / 2 + mB * (vBx**2 + vBy**2) / 2
    bodies = {"mA": mA, "mB": mB, "vA": (vAx, vAy), "vB": (vBx, vBy), "R": R}
    # B lies ahead of A, and beside its way by half a radius; the mud begins where they overlap a little.
    far, near = (
        {"dx": (ahead * ux - 0.5 * uy) * R / u, "dy": (ahead * uy + 0.5 * ux) * R / u} for ahead in (3, 1.8)
    )
    # Springs alone would stop them within a tenth of a radius; of the motion through mud, after the time t, the part e^-30 is left.
    spring = {"k": 1.25 * mu * u**2 / (0.1 * R) ** 2.5, "eta": 3 * mu * u / (0.1 * R)}
    eta, t = mu * u / (0.3 * R), 30 * 0.3 * R / u
    mud = {"q": 1.0, "k": 1e-13 * eta * u / R, "eta": eta, "g": 0.0, "t": t}
    together = {"velocities": (*answer["a"], *answer["a"]), "energy_ratio": 1 + answer["c"] / before}
    return [
        simulate(
            "spheres",
            bodies | far | spring,
            animated=True,
            **together,
            impulse=tuple(mB * dv for dv in answer["b"]),
        ),
        simulate(
            "touching_spheres",
            bodies | near | mud,
            **together,
            mean_force=tuple(-mB * dv / t for dv in answer["b"]),
        ),
    ]
