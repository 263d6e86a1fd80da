"""How long the next step of an adaptive method may be, from the error of the last one: one rule for every loop.

The error estimate of DOP853 grows as the eighth power of the step, so the step that would just keep the tolerance is the last one
times size^(-1/8). Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I (2nd edition, 1993),
equation (II.4.13); K. Gustafsson, ACM Trans. Math. Softw. 17 (1991) 533, on why the factor is bounded. A controller that looks at
two steps (Gustafsson's) gains nothing here: contacts begin and end within some twenty steps, before it would settle.
"""

from __future__ import annotations

import math

ORDER = 8
"""The power of the step with which DOP853's error estimate grows (Hairer, Norsett and Wanner, II.10)."""

SAFETY = 0.9
"""The usual share of the longest step that would do: aiming at it exactly, every second step would be rejected."""

SHORTEST, LONGEST = 0.2, 5.0
"""Bounds of the factor: beyond a power of 5 an error is no longer in the range where the eighth power holds, so it says nothing."""


def factor(size: float) -> float:
    """What to multiply a step with whose error was `size` times the tolerance; a step out of all range (inf, nan) is cut most.

    In the part of Python that numba compiles.
    """
    if size == 0.0:
        return LONGEST
    if not size < math.inf:
        return SHORTEST
    return min(LONGEST, max(SHORTEST, SAFETY * size ** (-1.0 / ORDER)))
