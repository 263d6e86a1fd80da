"""External impulse during a collision: gravity has little time, and so it may often be left out."""

import math

from corollary.author import simulate


def scene(mA, mB, vAy, vBy, dt, g, answer):
    """Two elastic spheres that meet head-on in the air, with just the spring that holds them together for the time of the collision.

    The problem does not give the velocities along x; here they come together at 2 m/s.
    """
    vA, vB, mu = (1.5, vAy), (-0.5, vBy), mA * mB / (mA + mB)
    u = math.hypot(vA[0] - vB[0], vA[1] - vB[1])
    # A half swing of the spring takes dt, and so the spheres sink into each other by u dt/pi; they are larger than that.
    spheres = {
        "mA": mA,
        "mB": mB,
        "vA": vA,
        "vB": vB,
        "q": 1.0,
        "k": mu * (math.pi / dt) ** 2,
        "eta": 0.0,
        "R": u * dt,
    }
    apart, touching = ({"dx": way * (vA[0] - vB[0]) * dt, "dy": way * (vAy - vBy) * dt} for way in (3, 2))
    total = mA * vA[0] + mB * vB[0], answer["c"]
    return [
        simulate("spheres", spheres | apart, animated=True, duration=dt),
        simulate(
            "touching_spheres",
            spheres | touching | {"g": g, "t": dt},
            momentum_change=(0.0, answer["a"]),
            momentum=total,
        ),
    ]
