"""Round a bend: what turns the velocity must come from the road."""

from corollary.author import HALF_PI, choice, derivation, mistake, step, unknowns
from corollary.laws import law, on_a_circle, wrong


def derive(m, r, v, mu, g):
    f, w, N, beta = unknowns("f w N beta")
    return derivation(
        step(
            f,
            "Only friction pushes the car inwards; it is as large as the circle asks, not as large as it can "
            "be.",
            on_a_circle(f, m=m, v=v, r=r),
            answers="a",
            mistakes=[
                mistake(
                    "That is the most that static friction can give. Does the bend ask for so much?",
                    wrong("f = mu*m*g"),
                ),
                mistake(
                    "A force: multiply the centripetal acceleration by the mass, and square the speed.",
                    wrong("f = m*v^2/(2*r)"),
                ),
            ],
        ),
        step(
            w,
            "At the highest speed static friction is at its limit.",
            on_a_circle(mu * m * g, m=m, v=w, r=r),
            where=w > 0,
            answers="b",
            mistakes=[
                mistake("The coefficient of friction is missing.", wrong("w^2 = g*r"), where=w > 0),
                mistake(
                    "That is a fall through the radius; there is no factor 2 on a circle.",
                    wrong("w^2 = 2*mu*g*r"),
                    where=w > 0,
                ),
            ],
            check="The mass cancels.",
        ),
        step(
            beta,
            "Without friction the normal force alone must carry the weight and push the car inwards.",
            law("Equilibrium", "N*cos(beta) = m*g"),
            law("Newton's second law", "N*sin(beta) = m*v^2/r"),
            also=[N],
            where=(beta > 0) & (beta < HALF_PI) & (N > 0),
            answers="c",
            mistakes=[
                mistake(
                    "The road pushes harder than the weight here: only the vertical component of the normal "
                    "force carries.",
                    law("Equilibrium", "N = m*g"),
                    instead="Equilibrium",
                    where=(beta > 0) & (beta < HALF_PI),
                ),
                mistake(
                    "You took what friction can give; here none is needed, and v counts.",
                    law("Newton's second law", "N*sin(beta) = mu*m*g"),
                    instead="Newton's second law",
                    where=(beta > 0) & (beta < HALF_PI) & (N > 0),
                ),
            ],
            check="$\\tan\\beta = v^2/(gr)$: the mass cancels again.",
        ),
        choice(
            "d",
            "Friction and the force that the circle asks for grow alike.",
            a=False,
            b=True,
            c=False,
            mistakes={
                "a": "More inertia must be turned. What does the larger weight do to friction?",
                "c": "Friction grows with the weight. What else does?",
            },
        ),
    )
