"""Toppling a book: a ball that comes back has changed its momentum more than one that stays."""

from corollary.author import simulate


def scene(m, M, v, h, I, answer):
    """A free book is a row of two balls; a book that turns is, where it is hit, as heavy as I/h² (hit at h, it moves at omega h)."""
    return [
        simulate(
            "cradle", {"N": 2, "masses": (m, M), "v0": v}, velocities=(v - answer["d"] / m, answer["d"] / M)
        ),
        simulate(
            "cradle",
            {"N": 2, "masses": (m, I / h**2), "v0": v},
            velocities=(v - I / h * answer["e"] / m, h * answer["e"]),
        ),
    ]
