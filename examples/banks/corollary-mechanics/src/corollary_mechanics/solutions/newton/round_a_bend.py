"""Round a bend: what turns the velocity must come from the road."""

from math import hypot, pi

from corollary.author import HALF_PI, choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, on_a_circle, wrong
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(m, r, v, mu, g):
    f, w, N, beta = unknowns("f w N beta", N="normal force")
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


def scene(m, r, v, mu, g, answer):
    """The car from above, for a quarter of a turn: at its speed with the friction it needs, and at the highest one with all there is."""
    runs = []
    for force, speed in ((answer["a"], v), (mu * m * g, answer["b"])):
        inwards = ForceFunction(0, lambda t, x, v, F=force: (-F * x[0] / hypot(*x), -F * x[1] / hypot(*x)))
        quarter = Scene((Body(m, (r, 0.0), (0.0, speed)),), (inwards,), until=pi * r / (2 * speed))
        runs.append(simulate(quarter, trajectory=(0.0, r), velocities=(-speed, 0.0)))
    return runs
