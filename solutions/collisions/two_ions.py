"""Two ions: a collision without touching, ruled by energy, angular momentum and the reduced mass."""

from corollary.author import (
    module,
    simulate,
)

IONS = module("two_ions/judge_ions.py")


def scene(C, mA, mB, v, r0, s, dx, dy, answer):
    """The pair in its own two constants of motion: head-on, and with the impact parameter."""
    pair = {"C": C, "mA": mA, "mB": mB, "v": v, "r0": r0}
    return [
        simulate("ions", pair | {"s": 0.0}, turning_points=answer["b"]),
        simulate("ions", pair | {"s": s}, animated=True, turning_points=answer["c"]),
    ]
