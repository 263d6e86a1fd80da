"""How near a stepped program must come: what the method of the book errs by, measured for the case, times a safety factor."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

SAFETY = 8.0  # right programs by other methods (Heun, midpoint, position first) err by up to 4.1 times as much (tests)
SMOOTH = 3.0  # the same where no contact begins or ends: there the book's method errs most
COARSE = (
    23.4,
    28.7,
    33.1,
    39.8,
    47.3,
)  # steps in a contact; no whole numbers, so that contacts end anywhere in a step
LEAST = 2e-4  # nothing nearer is asked for: solve_ivp with max_step=dt and its usual rtol errs by up to 7e-5
NAMED = (
    0.02  # a program that is wrong is named by the usual one it ends so near to, whatever methods the two use
)
OWN_STEPS = (
    0.01  # without dt: solve_ivp's usual rtol = 1e-3 errs by up to 0.005 here, forward Euler by 0.02 and more
)


@dataclass(frozen=True, slots=True)
class Bound:
    """The error may be `constant` / steps^`order`, steps in a contact; relative to the scale of what is observed."""

    order: int
    constant: float

    def allowed(self, steps: float) -> float:
        return max(LEAST, self.constant / steps**self.order)


def measured(
    order: int, errors: Callable[[float], Sequence[float]], safety: float = SAFETY
) -> tuple[Bound, ...]:
    """The bound of each observed thing: `errors(steps)` are those of the book's method with so many steps in a contact.

    The order is 2 where forces depend on places only and what is observed is read when they have ceased to act; 1 with
    damping, where a force jumps, and for places on the way (observed orders: `corollary trade`).
    """
    found = [(steps, errors(steps)) for steps in COARSE]
    return tuple(
        Bound(order, safety * max(each[i] * steps**order for steps, each in found))
        for i in range(len(found[0][1]))
    )
