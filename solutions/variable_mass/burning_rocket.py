"""A rocket burns its fuel: the last kilogram gives more speed than the first."""

from corollary.author import simulate


def scene(m0, m1, vrel, v0, dv, answer):
    """Ten thousand small puffs, with momentum kept at every one."""
    burn = {"v_rel": vrel, "m0": m0, "v0": v0, "N": 10000}
    return [
        simulate("rocket", burn | {"m1": m1}, velocities=answer["a"]),
        simulate("rocket", burn | {"m1": answer["b"]}, velocities=v0 + dv),
    ]
