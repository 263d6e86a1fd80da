"""Elastic collision with a block at rest: momentum and energy together, and what very unequal masses do."""

from corollary.author import simulate


def scene(mA, mB, vA, answer):
    """A row of two balls, from Newton's second law: with these masses, with equal ones, and with very unequal ones."""
    speed = abs(vA)
    return [
        simulate(
            "cradle",
            {"N": 2, "masses": (mA, mB), "v0": speed},
            animated=True,
            velocities=(answer["a"], answer["b"]),
        ),
        simulate("cradle", {"N": 2, "masses": (mA, mA), "v0": speed}, velocities=answer["e"]),
        simulate(
            "cradle", {"N": 2, "masses": (mA, 1e6 * mA), "v0": speed}, neglected=1e-5, velocities=answer["f"]
        ),
        simulate(
            "cradle", {"N": 2, "masses": (mA, 1e-6 * mA), "v0": speed}, neglected=1e-5, velocities=answer["g"]
        ),
    ]
