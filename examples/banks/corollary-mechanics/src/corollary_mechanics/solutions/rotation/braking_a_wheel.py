"""A grindstone: friction at the rim slows a disc down."""

from corollary.author import derivation, mistake, simulate, step, unknowns
from corollary.laws import angular_second_law, law, wrong
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(M, R, n, N, mu):
    D, I, alpha, t, Q = unknowns("D I alpha t Q", alpha="angular acceleration")
    return derivation(
        step(
            D,
            "Friction acts along the rim, at the distance R from the axis.",
            law("Torque of friction", "D = mu*N*R", D=D, N=N),
            answers="a",
            mistakes=[
                mistake(
                    "The push itself points to the axis and turns nothing. What does?",
                    wrong("D = N*R", D=D, N=N),
                ),
                mistake("The arm is the radius.", wrong("D = 2*mu*N*R", D=D, N=N)),
            ],
        ),
        step(I, "A solid disc about its axis.", law("Moment of inertia of a disc", "I = M*R^2/2", I=I)),
        step(alpha, "The torque slows the disc down.", angular_second_law(D, I=I, alpha=alpha)),
        step(
            t,
            "The angular velocity falls steadily to zero.",
            law("Angular velocity", "n = alpha*t"),
            answers="b",
            mistakes=[
                mistake("The mass of a disc does not all sit on its rim.", wrong("n = D/(M*R^2)*t", D=D)),
                mistake("It must lose all of its angular velocity: you halved it.", wrong("n/2 = alpha*t")),
                mistake("A rotation is more than a radian.", wrong("n/(2*pi) = alpha*t")),
            ],
        ),
        step(
            Q,
            "All the kinetic energy becomes heat.",
            law("Kinetic energy of rotation", "Q = I*n^2/2", Q=Q, I=I),
            answers="c",
            mistakes=[
                mistake("The factor 1/2 of the kinetic energy is missing.", wrong("Q = I*n^2", Q=Q, I=I)),
                mistake(
                    "The push points to the axis and does no work. Which force rubs along the rim?",
                    wrong("Q = N*R*n*t/2", Q=Q, N=N),
                ),
            ],
            check="Neither the push nor the friction matters for the heat, only for the time.",
        ),
    )


def scene(M, R, n, N, mu, answer):
    """A disc that turns in a corner, pressed on the rough side, and held by the smooth one: after half of the time it has half of
    its spin and a quarter of its energy; and all that friction does in that time is torque times time."""
    corner = (
        HardWall((0.0, 1.0), restitution=0.0, mu=mu),
        HardWall((1.0, 0.0), restitution=0.0),
        ForceFunction(0, lambda t, place, velocity: (0.0, -N)),
    )
    disc = Body(M, (R, R), (0.0, 0.0), radius=R, spin=n, inertia=M * R**2 / 2)
    half = Scene((disc,), corner, until=answer["b"] / 2)
    spin = n - answer["a"] / (M * R**2 / 2) * answer["b"] / 2
    return [
        simulate(half, spins=(n / 2,), energy=answer["c"] / 4),
        simulate(half, spins=(spin,)),
    ]
