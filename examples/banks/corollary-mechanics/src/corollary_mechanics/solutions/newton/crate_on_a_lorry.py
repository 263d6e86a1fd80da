"""A crate on a lorry: static friction is as large as it must be, up to a limit."""

from corollary.author import choice, derivation, mistake, simulate, step, unknowns
from corollary.laws import law, wrong
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(m, v, a, mu, g):
    f, b, s = unknowns("f b s", b="largest deceleration that friction can give")
    return derivation(
        step(
            f,
            "Friction is the only force along the bed; it must give the crate the lorry's acceleration.",
            law("Newton's second law", "f = m*a"),
            answers="a",
            mistakes=[
                mistake(
                    "That is the most that static friction could give. Is so much needed?",
                    wrong("f = mu*m*g"),
                ),
                mistake(
                    "The coefficient says the limit only; what must the crate be given?", wrong("f = mu*m*a")
                ),
            ],
        ),
        choice(
            "b",
            "The crate is accelerated forward, and nothing but friction pushes it.",
            a=True,
            b=False,
            mistakes={
                "b": "Without friction the crate would stay behind. So which way does friction pull it?"
            },
        ),
        step(
            b,
            "At the limit static friction gives the largest deceleration.",
            law("Newton's second law at the limit", "mu*m*g = m*b", b=b),
        ),
        step(
            s,
            "The whole speed is lost with this deceleration.",
            law("Velocity and way", "v^2 = 2*b*s"),
            answers="c",
            mistakes=[
                mistake(
                    "The factor 2 is missing: in the mean the lorry has half of its speed.",
                    wrong("v^2 = b*s"),
                ),
                mistake(
                    "The crate can stand more than the acceleration of the start; ask for the limit.",
                    wrong("v^2 = 2*a*s"),
                ),
            ],
            check="The mass of the crate does not matter: a heavier one holds better, and needs more.",
        ),
    )


def scene(m, v, a, mu, g, answer):
    """The crate with friction alone: for two seconds forward, and from v to rest in the way found."""
    start = Scene((Body(m, (0.0,), (0.0,)),), (ForceFunction(0, lambda t, x, u: (answer["a"],)),), until=2.0)
    braking = Scene(
        (Body(m, (0.0,), (v,)),), (ForceFunction(0, lambda t, x, u: (-mu * m * g,)),), until=v / (mu * g)
    )
    return [simulate(start, velocities=(2 * a,)), simulate(braking, trajectory=(answer["c"],))]
