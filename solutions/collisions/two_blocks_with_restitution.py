"""Two blocks on a line with restitution: momentum, and what is left of the relative velocity."""

import math

from corollary.author import derivation, mistake, optimum, proof, route, simulate, step, unknowns
from corollary.laws import change_of_kinetic_energy, conservation_of_momentum, law, restitution, wrong


def derive(mA, mB, vA, vB, r):
    v_A1, v_B1, dK, r_most = unknowns(
        "v_A1 v_B1 dK r_most",
        v_B1="velocity of B after the collision",
        r_most="coefficient of restitution at which most is lost",
    )
    momentum_kept = conservation_of_momentum(before=[(mA, vA), (mB, vB)], after=[(mA, v_A1), (mB, v_B1)])
    given_r = restitution(r, A=(vA, v_A1), B=(vB, v_B1))
    energy = change_of_kinetic_energy(dK, before=[(mA, vA), (mB, vB)], after=[(mA, v_A1), (mB, v_B1)])
    loss = law(
        "Loss in a collision",
        "dK = -m_A*m_B/(2*(m_A + m_B))*(1 - r^2)*(v_A - v_B)^2",
        m_A=mA,
        m_B=mB,
        v_A=vA,
        v_B=vB,
    )
    return derivation(
        step(
            v_A1,
            "Momentum is kept, and the relative velocity is turned round and shrinks by r: two equations "
            "for the two velocities.",
            momentum_kept,
            given_r,
            also=[v_B1],
            answers="a",
            mistakes=[
                mistake(
                    "You let the blocks stick together; they part with r times their relative speed.",
                    restitution(0, A=(vA, v_A1), B=(vB, v_B1)),
                    instead="Coefficient of restitution",
                ),
                mistake(
                    "You used an elastic collision; here some of the relative velocity is lost.",
                    restitution(1, A=(vA, v_A1), B=(vB, v_B1)),
                    instead="Coefficient of restitution",
                ),
                mistake(
                    "The coefficient compares relative velocities, and not the speeds of A and B alone.",
                    law("Coefficient of restitution", "v_A1 = -r*v_A0", v_A0=vA),
                    instead="Coefficient of restitution",
                ),
                mistake(
                    "The velocity of B has a sign; you counted it the other way round.",
                    conservation_of_momentum(before=[(mA, vA), (mB, -vB)], after=[(mA, v_A1), (mB, v_B1)]),
                ),
                mistake(
                    "After the collision B must be ahead: A cannot run through it. Check the sign in the "
                    "coefficient of restitution.",
                    restitution(-r, A=(vA, v_A1), B=(vB, v_B1)),
                    instead="Coefficient of restitution",
                ),
            ],
            check="r = 1 gives the elastic collision, r = 0 the common velocity.",
        ),
        step(
            v_B1,
            "With A's velocity known, momentum gives B's.",
            momentum_kept,
            answers="b",
            routes=[
                route(
                    "Or from the relative velocity: B leaves A at r times the speed at which they came "
                    "together.",
                    given_r,
                )
            ],
            mistakes=[
                mistake(
                    "The velocity of B before the collision has a sign; you counted it the other way round.",
                    conservation_of_momentum(before=[(mA, vA), (mB, -vB)], after=[(mA, v_A1), (mB, v_B1)]),
                ),
                mistake(
                    "You left out the momentum that B had before.",
                    conservation_of_momentum(before=[(mA, vA), (mB, 0)], after=[(mA, v_A1), (mB, v_B1)]),
                ),
                mistake(
                    "That is the speed at which they part, the relative velocity; asked is B's velocity on "
                    "the track.",
                    wrong("v_B1 = r*(v_A0 - v_B0)", v_A0=vA, v_B0=vB),
                ),
            ],
            check="B is now faster than A: they move apart.",
        ),
        step(
            dK,
            "The change is the sum of the kinetic energies after, less that before.",
            energy,
            answers="c",
            routes=[route("The same from the loss of the relative motion alone.", loss)],
            mistakes=[
                mistake(
                    "r² is what is left of the energy of the *relative* motion; the common motion of both "
                    "keeps all of its energy.",
                    wrong(
                        "dK = (r^2 - 1)*(m_A*v_A^2/2 + m_B*v_B^2/2)",
                        m_A=mA,
                        v_A=vA,
                        m_B=mB,
                        v_B=vB,
                    ),
                ),
                mistake(
                    "You squared the changes of the velocities; take the differences of the squares.",
                    wrong(
                        "dK = m_A*(v_A1 - v_A)^2/2 + m_B*(v_B1 - v_B)^2/2",
                        m_A=mA,
                        v_A=vA,
                        m_B=mB,
                        v_B=vB,
                    ),
                ),
                mistake(
                    "Kinetic energy has no direction: that of B counts as positive too, whichever way it "
                    "moves.",
                    wrong(
                        "dK = m_A*(v_A1^2 - v_A^2)/2 - m_B*(v_B1^2 - v_B^2)/2",
                        m_A=mA,
                        v_A=vA,
                        m_B=mB,
                        v_B=vB,
                    ),
                ),
            ],
            check="It is never positive, and it is zero for r = 1.",
        ),
        optimum(
            r_most,
            "Momentum is kept for every r. The change is smallest, the loss largest, where its slope as a "
            "function of r vanishes.",
            of=dK,
            over=r,
            between=(0, 1),
            largest=False,
            check="Nothing is left of the relative motion: the blocks stick together.",
        ),
        proof(
            "e",
            "Momentum and the coefficient of restitution fix both velocities; put into the kinetic energy, "
            "only the relative velocity before is left.",
            momentum_kept,
            given_r,
            energy,
            target=loss,
            lines=[
                "mA*vA + mB*vB = mA*v_A1 + mB*v_B1",
                "v_B1 - v_A1 = r*(vA - vB)",
                "v_A1 = (mA*vA + mB*vB - mB*r*(vA - vB))/(mA + mB)",
                "v_B1 = (mA*vA + mB*vB + mA*r*(vA - vB))/(mA + mB)",
                "dK = mA*v_A1^2/2 + mB*v_B1^2/2 - mA*vA^2/2 - mB*vB^2/2",
                "dK = (mA*vA + mB*vB)^2/(2*(mA + mB)) + mA*mB/(mA + mB)*r^2*(vA - vB)^2/2 - mA*vA^2/2 - "
                "mB*vB^2/2",
                "dK = mA*mB/(mA + mB)*r^2*(vA - vB)^2/2 - mA*mB/(mA + mB)*(vA - vB)^2/2",
                "dK = -mA*mB/(2*(mA + mB))*(1 - r^2)*(vA - vB)^2",
            ],
            mistakes=[
                mistake("Kinetic energy is not kept here: r is not 1.", wrong("dK = 0")),
                mistake(
                    "Check the sign: after the collision B moves away from A.",
                    restitution(-r, A=(vA, v_A1), B=(vB, v_B1)),
                ),
            ],
        ),
    )


def scene(mA, mB, vA, vB, r, answer):
    """Two soft spheres, head-on, with just as much damping in the contact as r asks for."""
    k, loss, mass = 1e9, -math.log(r), mA * mB / (mA + mB)
    eta = 2 * math.sqrt(k * mass) * loss / math.hypot(math.pi, loss)
    settings = {
        "mA": mA,
        "mB": mB,
        "k": k,
        "q": 1,
        "eta": eta,
        "dx": 0.08,
        "dy": 0.0,
        "vA": (vA, 0.0),
        "vB": (vB, 0.0),
    }
    before = (mA * vA * vA + mB * vB * vB) / 2
    return [
        simulate(
            "spheres",
            settings,
            animated=True,
            velocities=(answer["a"], 0.0, answer["b"], 0.0),
            energy_ratio=1 + answer["c"] / before,
        )
    ]
