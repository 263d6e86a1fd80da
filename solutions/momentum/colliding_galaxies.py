"""Colliding galaxies: what the total momentum remembers of the past, and what it does not."""

from corollary.author import derivation, explain


def derive():
    return derivation(
        explain(
            "a",
            "Says that the total momentum before equals that after, whatever the internal forces did.",
            "Says under which condition: no net external force on the two galaxies (an isolated system), "
            "and mass that leaves is counted as well.",
            "Says that this is one vector equation for two unknown velocities: only the sum of the momenta "
            "is known (so the velocity of the centre of mass), not how it was shared.",
            "Names something that would settle it: one of the two velocities, the change of kinetic energy "
            "together with a direction of motion, or that they moved along one line elastically.",
            answer="All the forces between the stars and clouds of the two galaxies are internal: by "
            "Newton's third law they come in pairs whose impulses cancel. If "
            "no net external force acts on the two together, "
            "their total momentum is the same before and after, $m_A\\vec v_{A,0} + m_B\\vec v_{B,0} = "
            "m_A\\vec v_{A,1} + m_B\\vec v_{B,1}$, however "
            "complicated the collision was. So we know the total momentum "
            "before, and the velocity of their centre of mass, in size and direction. We do not know how "
            "the momentum was shared: one vector equation, that is "
            "three equations, stands against six unknown components. "
            "If one of the velocities before is known, the other one follows at once. Kinetic energy helps "
            "only if we know how much of it was turned into "
            "other forms, and even then it is a single "
            "equation more, enough only for motion along one line. Mass that was torn away and left must be "
            "counted with its momentum.",
        ),
    )
