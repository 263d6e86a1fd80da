"""A flywheel: constant angular acceleration, moment of inertia, torque."""

from corollary.author import derivation, mistake, route, step, unknowns
from corollary.laws import angular_second_law, law, wrong


def derive(n, t, M, R):
    I, K, phi, N, alpha, D = unknowns("I K phi N alpha D")
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
