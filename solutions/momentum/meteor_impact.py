"""Meteor impact: no force is known, and yet the velocity after it is."""

import math

from corollary.author import simulate


def scene(mA, mB, vAx, vAy, vBx, vBy, answer):
    """Meteor and planet as two spheres of 10 km that meet off centre and do not part: how large and how hard they are does not matter.

    Once a spring and a brake push them apart, too weakly; once it is all mud, and the meteor is followed until it lies still in it.
    """
    (ux, uy), mu, R = (vAx - vBx, vAy - vBy), mA * mB / (mA + mB), 1e4
    u, before = math.hypot(ux, uy), mA * (vAx**2 + vAy**2) / 2 + mB * (vBx**2 + vBy**2) / 2
    bodies = {"mA": mA, "mB": mB, "vA": (vAx, vAy), "vB": (vBx, vBy), "R": R}
    # B lies ahead of A, and beside its way by half a radius; the mud begins where they overlap a little.
    far, near = (
        {"dx": (ahead * ux - 0.5 * uy) * R / u, "dy": (ahead * uy + 0.5 * ux) * R / u} for ahead in (3, 1.8)
    )
    # Springs alone would stop them within a tenth of a radius; of the motion through mud, after the time t, the part e^-30 is left.
    spring = {"k": 1.25 * mu * u**2 / (0.1 * R) ** 2.5, "eta": 3 * mu * u / (0.1 * R)}
    eta, t = mu * u / (0.3 * R), 30 * 0.3 * R / u
    mud = {"q": 1.0, "k": 1e-13 * eta * u / R, "eta": eta, "g": 0.0, "t": t}
    together = {"velocities": (*answer["a"], *answer["a"]), "energy_ratio": 1 + answer["c"] / before}
    return [
        simulate(
            "spheres",
            bodies | far | spring,
            animated=True,
            **together,
            impulse=tuple(mB * dv for dv in answer["b"]),
        ),
        simulate(
            "touching_spheres",
            bodies | near | mud,
            **together,
            mean_force=tuple(-mB * dv / t for dv in answer["b"]),
        ),
    ]
