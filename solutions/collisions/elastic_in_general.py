"""General elastic collision: momentum and energy, with both blocks moving."""

from corollary.author import derivation, mistake, reject, route, simulate, step, unknowns
from corollary.laws import conservation_of_momentum, elastic, law, restitution, wrong


def derive(mA, mB, vA, vB):
    v_A1, v_B1 = unknowns("v_A1 v_B1", v_B1="velocity of B after the collision")
    before, after = [(mA, vA), (mB, vB)], [(mA, v_A1), (mB, v_B1)]
    wrong_way = [(mA, vA), (mB, -vB)]
    return derivation(
        step(
            v_A1,
            "Momentum and kinetic energy are both kept: two equations for two velocities.",
            conservation_of_momentum(before=before, after=after),
            elastic(before=before, after=after),
            also=[v_B1],
            answers="a",
            reject=[
                reject(
                    "the velocities would be those from before: A would have passed through B",
                    v_A1=vA,
                    v_B1=vB,
                )
            ],
            mistakes=[
                mistake(
                    "You let the blocks stick together; an elastic collision keeps the kinetic energy.",
                    law("Perfectly inelastic", "v_A = v_B", v_A=v_A1, v_B=v_B1),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "Only equal masses exchange their velocities.",
                    law("Exchange", "v_A1 = v_B", v_B=vB),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "You used the formula for a block B at rest; here B moves too.",
                    law("B at rest", "v_A1 = (m_A - m_B)/(m_A + m_B)*v_A", m_A=mA, m_B=mB, v_A=vA),
                    instead="Conservation of mechanical energy",
                ),
                mistake(
                    "The velocity of B has a sign, and it counts in the momentum.",
                    law(
                        "Sign of B",
                        "v_A1 = ((m_A - m_B)*v_A + 2*m_B*v_B)/(m_A + m_B)",
                        m_A=mA,
                        m_B=mB,
                        v_A=vA,
                        v_B=-vB,
                    ),
                    instead="Conservation of mechanical energy",
                ),
            ],
            check=(
                "With B at rest this is the simpler formula; with equal masses it is B's velocity from "
                "before."
            ),
        ),
        step(
            v_B1,
            "With A's velocity known, momentum gives B's.",
            conservation_of_momentum(before=before, after=after),
            answers="b",
            routes=[
                route(
                    "In an elastic collision the relative velocity is only turned round (r = 1): B leaves A "
                    "as fast as A came towards B.",
                    restitution(1, A=(vA, v_A1), B=(vB, v_B1)),
                )
            ],
            mistakes=[
                mistake(
                    "The velocity of B before the collision has a sign, and it counts in the momentum.",
                    conservation_of_momentum(before=wrong_way, after=after),
                ),
                mistake(
                    "You left out the momentum that B had before.",
                    conservation_of_momentum(before=[(mA, vA), (mB, 0)], after=after),
                ),
                mistake(
                    "Momentum has a direction: put A's velocity after the collision in with its sign.",
                    wrong(
                        "m_A*v_A + m_B*v_B = -m_A*v_A1 + m_B*v_B1",
                        m_A=mA,
                        v_A=vA,
                        m_B=mB,
                        v_B=vB,
                    ),
                ),
            ],
            check="After the collision B is faster than A by as much as A was faster than B before.",
        ),
    )


def scene(mA, mB, vA, vB, answer):
    """Two elastic spheres, head-on, from Newton's second law."""
    settings = {
        "mA": mA,
        "mB": mB,
        "k": 1e9,
        "eta": 0.0,
        "dx": 0.08,
        "dy": 0.0,
        "vA": (vA, 0.0),
        "vB": (vB, 0.0),
    }
    return [simulate("spheres", settings, animated=True, velocities=(answer["a"], 0.0, answer["b"], 0.0))]
