"""Absorbing a drop, and thrust: the momentum of everything that will be one body in the end."""

from corollary.author import simulate


def scene(m, dm, V, v, u, vrel, mdot, F, t, R, g, dv, answer):
    """The drop is dragged along by the body; the rocket, a million times as heavy as the fuel of the moment, throws it out in puffs."""
    drop, caught = {"m": m, "dm": dm, "v": v, "u": u}, v + dv
    # The force brings body and drop to that velocity in the time in which its impulse is the change of their momentum.
    pushed = {"F": F, "t": answer["b"] / F, "dt": 1e-9 * answer["b"] / F}
    fuel = -mdot
    rocket = {"m0": 1e6 * fuel, "m1": 1e6 * fuel - fuel, "v_rel": -vrel}
    return [
        simulate("absorbed_drop", drop, animated=True, velocities=(answer["a"], answer["a"])),
        simulate("absorbed_drop", drop | pushed, velocities=(caught, caught), momentum_change=answer["b"]),
        # Seen from the rocket: its velocity V does not count. In one second its mass changes by a millionth.
        simulate("rocket", rocket, velocities=answer["c"] / (1e6 * fuel), neglected=1e-6),
        simulate("growing_drop", {"m": m, "v": v, "R": R, "g": g, "t": t}, velocities=answer["d"]),
    ]
