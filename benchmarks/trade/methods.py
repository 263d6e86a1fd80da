"""The fixed-step methods that are raced: Euler-Cromer, velocity Verlet, RK4, and Yoshida's of order 4, 6 and 8."""

from __future__ import annotations

from collections.abc import Sequence

from corollary.grading.programs.fixed_step import EULER_CROMER, RK4, Method, Splitting


def composed(order: int, outer: Sequence[float]) -> Splitting:
    """Verlet steps of lengths w_k … w_1 w_0 w_1 … w_k (parts of dt, summing to one), neighbouring half kicks joined."""
    middle = 1.0 - 2.0 * sum(outer)
    parts = [*reversed(outer), middle, *outer]
    kicks = [0.5 * (a + b) for a, b in zip([0.0, *parts], [*parts, 0.0], strict=True)]
    return Splitting(order, tuple(kicks), (*parts, 0.0))


VELOCITY_VERLET = composed(2, ())

_CUBE_ROOT = 2.0 ** (1.0 / 3.0)

# Source: H. Yoshida, Construction of higher order symplectic integrators, Phys. Lett. A 150 (1990) 262; solutions A.
YOSHIDA_4 = composed(4, (1.0 / (2.0 - _CUBE_ROOT),))
YOSHIDA_6 = composed(6, (-1.17767998417887, 0.235573213359357, 0.784513610477560))
YOSHIDA_8 = composed(
    8,
    (
        -1.61582374150097,
        -2.44699182370524,
        -0.00716989419708120,
        2.44002732616735,
        0.157739928123617,
        1.82020630970714,
        1.04242620869991,
    ),
)

METHODS: dict[str, Method] = {
    "euler_cromer": EULER_CROMER,
    "velocity_verlet": VELOCITY_VERLET,
    "rk4": RK4,
    "yoshida4": YOSHIDA_4,
    "yoshida6": YOSHIDA_6,
    "yoshida8": YOSHIDA_8,
}
