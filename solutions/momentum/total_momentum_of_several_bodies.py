"""Total momentum of several bodies: vectors are added, each with its own mass and its own signs."""

from corollary.author import derivation, mistake, step, vector
from corollary.laws import total_momentum, wrong


def derive(m1, m2, m3, v1x, v1y, v2x, v2y, v3x, v3y):
    P = vector("P")
    v1, v2, v3 = (v1x, v1y), (v2x, v2y), (v3x, v3y)
    return derivation(
        step(
            P,
            "The total momentum is the sum of the momenta of all bodies, component by component.",
            total_momentum(P, [(m1, v1), (m2, v2), (m3, v3)]),
            answers="a",
            mistakes=[
                mistake(
                    "You added sizes. Momentum has a direction: body 2 moves against the x-axis and body 3 "
                    "against the y-axis, and their terms there are negative.",
                    total_momentum(P, [(m1, v1), (m2, (-v2x, v2y)), (m3, (v3x, -v3y))]),
                ),
                mistake(
                    "You added the velocities first and then multiplied by the total mass; each velocity "
                    "goes with its own mass.",
                    wrong(
                        "P = M*(v_1 + v_2 + v_3)",
                        P=P,
                        M=m1 + m2 + m3,
                        v_1=v1,
                        v_2=v2,
                        v_3=v3,
                    ),
                ),
                mistake(
                    "That is the velocity of the centre of mass; the total momentum is not divided by the "
                    "mass.",
                    wrong(
                        "P = (m_1*v_1 + m_2*v_2 + m_3*v_3)/(m_1 + m_2 + m_3)",
                        P=P,
                        m_1=m1,
                        m_2=m2,
                        m_3=m3,
                        v_1=v1,
                        v_2=v2,
                        v_3=v3,
                    ),
                ),
                mistake(
                    "You added the velocities; a momentum is a mass times a velocity.",
                    wrong("P = v_1 + v_2 + v_3", P=P, v_1=v1, v_2=v2, v_3=v3),
                ),
            ],
            check="If all bodies moved with one velocity, it would be the whole mass times that velocity.",
        ),
    )
