"""External impulse during a collision: gravity has little time, and so it may often be left out."""

import math

from corollary.author import choice, derivation, explain, mistake, simulate, step, unknowns
from corollary.laws import external_impulse, impulse_of_constant_force, law, total_momentum, wrong


def derive(mA, mB, vAy, vBy, dt, g):
    G, J, P_0, q, P_1 = unknowns("G J P_0 q P_1")
    return derivation(
        step(
            G,
            "The external force along y is the weight of both objects; y points up, so it is negative. The "
            "forces of A on B and of B on A cancel.",
            law("Weight of both", "G = -m_A*g - m_B*g", source="(12.54)", m_A=mA, m_B=mB),
            mistakes=[
                mistake(
                    "The y-axis points up and gravity down: the impulse of gravity is negative.",
                    wrong("G = m_A*g + m_B*g", m_A=mA, m_B=mB),
                ),
                mistake(
                    "You left out the acceleration of gravity: an impulse is a force times a time, and the "
                    "force is the mass times g.",
                    wrong("G = -(m_A + m_B)", m_A=mA, m_B=mB),
                ),
                mistake("Gravity acts on both objects.", wrong("G = -m_A*g", m_A=mA)),
            ],
        ),
        step(
            J,
            "The weight is constant, so its impulse is the force times the time.",
            impulse_of_constant_force(J, G, dt),
            answers="a",
            mistakes=[
                mistake(
                    "That is the weight; the impulse is the force times the time it acts.",
                    wrong("J = G"),
                ),
                mistake(
                    "You divided by the time; an impulse is a force times a time.",
                    wrong("J = F/dt", F=G),
                ),
            ],
            check="It has the unit N s = kg m/s of a momentum, and points down.",
        ),
        step(
            P_0,
            "The total momentum along y at the beginning.",
            total_momentum(P_0, [(mA, vAy), (mB, vBy)]),
            mistakes=[
                mistake(
                    "A velocity along -y counts negative: momenta along a line are added with their signs.",
                    total_momentum(P_0, [(mA, vAy), (mB, -vBy)]),
                ),
                mistake("You counted A alone; B has a momentum, too.", total_momentum(P_0, [(mA, vAy)])),
            ],
        ),
        step(
            q,
            "The ratio of the two magnitudes.",
            law("Ratio", "q = abs(J/P)", P=P_0),
            answers="b",
            mistakes=[
                mistake(
                    "You divided the other way round; asked is how large the impulse is compared with the "
                    "momentum.",
                    wrong("q = abs(P/J)", P=P_0),
                ),
                mistake(
                    "You compared the force with the momentum; compare the impulse.",
                    wrong("q = abs(G/P)", P=P_0),
                ),
            ],
            check=(
                "It is g Δt over the speed of the common centre of mass along y: in a short collision "
                "there is little time for gravity."
            ),
        ),
        step(
            P_1,
            "The total momentum has changed by the impulse of the external force, and by nothing else.",
            external_impulse(J, before=P_0, after=P_1),
            answers="c",
            mistakes=[
                mistake(
                    "Along y the momentum is not conserved: gravity acts. Add its impulse.",
                    wrong("P_1 = P_0"),
                ),
                mistake(
                    "Gravity takes upward momentum away: its impulse counts with its own, negative sign.",
                    wrong("J = P_0 - P_1"),
                ),
            ],
            check=(
                "It is a little further down than at the beginning. How the objects push each other does "
                "not matter."
            ),
        ),
        choice(
            "d",
            "Momentum is conserved in each direction in which the net external force is zero: gravity has "
            "no component along x, but one along y.",
            a=False,
            b=True,
            c=False,
            d=False,
            mistakes={
                "a": (
                    "Which external force acts, and along which axis? It changes the momentum along that "
                    "axis."
                ),
                "c": "It is along y that the external force acts.",
                "d": (
                    "The law holds in each direction on its own. Is there any external force along the "
                    "other axis?"
                ),
            },
        ),
        choice(
            "e",
            "What counts is between whom a force acts: A pulls B and B pulls A, the two forces are a pair "
            "inside the system, and their impulses cancel.",
            a=False,
            b=False,
            c=True,
            d=False,
            mistakes={
                "a": (
                    "The pull of the Earth is external here because the Earth is not part of the system. "
                    "Who pulls in this case?"
                ),
                "b": "A force need not be one of contact to be internal. Between whom does it act?",
                "d": (
                    "By Newton's third law the two forces belong together as a pair. Between whom do they "
                    "act?"
                ),
            },
        ),
        explain(
            "f",
            "States the condition: the net external force on the system is zero (internal forces may be of "
            "any kind).",
            "Says that it may hold for one direction alone, since momentum is a vector.",
            "Says that an external force may be neglected when its impulse during the (short) collision is "
            "small compared with the momentum.",
            answer="The total momentum of a system is conserved when the net external force on it is zero; "
            "the internal forces may be of any kind, for they come in "
            "pairs that cancel. It is a vector law: if the net "
            "external force vanishes in one direction only, the component of the momentum in this direction "
            "is conserved. When an external force does act, the momentum changes by its impulse "
            "$\\int \\vec F^{ext}dt$. If the collision is so short that this impulse is small compared with "
            "the momenta in question, momentum is conserved in "
            "good approximation from just before to just after the collision.",
        ),
    )


def scene(mA, mB, vAy, vBy, dt, g, answer):
    """Two elastic spheres that meet head-on in the air, with just the spring that holds them together for the time of the collision.

    The problem does not give the velocities along x; here they come together at 2 m/s.
    """
    vA, vB, mu = (1.5, vAy), (-0.5, vBy), mA * mB / (mA + mB)
    u = math.hypot(vA[0] - vB[0], vA[1] - vB[1])
    # A half swing of the spring takes dt, and so the spheres sink into each other by u dt/pi; they are larger than that.
    spheres = {
        "mA": mA,
        "mB": mB,
        "vA": vA,
        "vB": vB,
        "q": 1.0,
        "k": mu * (math.pi / dt) ** 2,
        "eta": 0.0,
        "R": u * dt,
    }
    apart, touching = ({"dx": way * (vA[0] - vB[0]) * dt, "dy": way * (vAy - vBy) * dt} for way in (3, 2))
    total = mA * vA[0] + mB * vB[0], answer["c"]
    return [
        simulate("spheres", spheres | apart, animated=True, duration=dt),
        simulate(
            "touching_spheres",
            spheres | touching | {"g": g, "t": dt},
            momentum_change=(0.0, answer["a"]),
            momentum=total,
        ),
    ]
