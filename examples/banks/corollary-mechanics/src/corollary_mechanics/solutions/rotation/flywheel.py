"""A flywheel: constant angular acceleration, moment of inertia, torque."""

from math import pi

from corollary.author import derivation, mistake, route, simulate, step, unknowns
from corollary.laws import angular_second_law, law, wrong
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def derive(n, t, M, R):
    I, K, phi, N, alpha, D = unknowns("I K phi N alpha D", alpha="angular acceleration")
    return derivation(
        step(I, "A solid disc about its axis.", law("Moment of inertia of a disc", "I = M*R^2/2", I=I)),
        step(
            K,
            "The kinetic energy of rotation.",
            law("Kinetic energy of rotation", "K = I*n^2/2", I=I),
            answers="a",
            mistakes=[
                mistake(
                    "All the mass would have to sit on the rim; a disc has half as large a moment of inertia.",
                    wrong("K = M*R^2*n^2/2"),
                ),
                mistake(
                    "A rotation is $2\\pi$ radians: the angular velocity, not the number of turns, is squared.",
                    wrong("K = I*(n/(2*pi))^2/2", I=I),
                ),
            ],
        ),
        step(
            phi,
            "The angular velocity falls steadily from n to zero: in the mean it is half of that.",
            law("Angle", "phi = n*t/2"),
        ),
        step(
            N,
            "Each turn is $2\\pi$.",
            law("Turns", "phi = 2*pi*N", N=N),
            answers="b",
            mistakes=[
                mistake(
                    "It slows down on the way; you let it turn at full speed for all the time.",
                    wrong("N = n*t/(2*pi)", N=N),
                ),
                mistake("That is the angle in radians. How many turns is it?", wrong("N = phi", N=N)),
            ],
        ),
        step(alpha, "How fast the angular velocity falls.", law("Angular velocity", "n = alpha*t")),
        step(
            D,
            "The torque of friction gives this angular acceleration.",
            angular_second_law(D, I=I, alpha=alpha),
            answers="c",
            routes=[route("Its work is the kinetic energy.", law("Work of a torque", "K = D*phi", D=D))],
            mistakes=[
                mistake(
                    "The moment of inertia of a disc is half of what it would be with all the mass on the "
                    "rim.",
                    wrong("D = M*R^2*alpha", D=D),
                ),
                mistake(
                    "That is the work per turn; a torque's work is torque times angle, in radians.",
                    wrong("D = K/N", D=D, N=N),
                ),
            ],
            check="Torque and energy have the same unit, but mean different things.",
        ),
    )


def scene(n, t, M, R, answer):
    """A disc that turns in a corner, its rim rubbing with the torque of the bearings, for half of the time; and the way of a
    point of the rim, laid out in a line, until it stands."""
    corner = (
        HardWall((0.0, 1.0), restitution=0.0, mu=1.0),
        HardWall((1.0, 0.0), restitution=0.0),
        ForceFunction(0, lambda t, place, velocity: (0.0, -answer["c"] / R)),
    )
    disc = Body(M, (R, R), (0.0, 0.0), radius=R, spin=n, inertia=M * R**2 / 2)
    rim = Body(M / 2, (0.0,), (n * R,))
    rubs = ForceFunction(0, lambda t, place, velocity: (-answer["c"] / R,))
    return [
        simulate(Scene((disc,), corner, until=t / 2), spins=(n / 2,), energy=answer["a"] / 4),
        simulate(Scene((rim,), (rubs,), until=t), velocities=(0.0,), trajectory=(2 * pi * R * answer["b"],)),
    ]
