"""A dashpot that fades a relative velocity by e^-40, to less than a double tells of it: how scenes let one body get stuck in another."""

from __future__ import annotations

from flint import arb


def fading_by() -> arb:
    """In powers of e, over the time that the sticking is given."""
    return arb(40)


def faded() -> arb:
    """The share of the relative velocity that is left."""
    return (-fading_by()).exp()
