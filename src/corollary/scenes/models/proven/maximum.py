"""The largest value of a function over a step, enclosed by halving wherever its rate may be zero."""

from __future__ import annotations

from collections.abc import Callable

from flint import arb, ctx

from corollary.scenes.run import GuardFailed

MOST_PIECES = 2000


def maximum(value: Callable[[arb], tuple[arb, arb]], length: arb, known: arb) -> arb:
    """A ball about the largest value on 0 … `length`, or about the one `known`, if that is larger. Raises GuardFailed.

    `value` gives it and its rate at a ball of times.

    At a maximum the rate is small: a piece of width w leaves a doubt of w^2, so half the digits of the place are enough.
    """
    fine = arb(2) ** (16 - ctx.prec)
    least = known.max(value(arb(0))[0]).max(value(length)[0])
    found, pieces = least, [(arb(0), length)]
    for _ in range(MOST_PIECES):
        if not pieces:
            return found
        low, high = pieces.pop()
        middle, half = ((low + high) / 2).mid(), ((high - low) / 2).upper()
        here, (whole, rate) = value(middle)[0], value(arb(middle, half))
        if rate > 0 or rate < 0 or whole < least:
            continue
        least, found = least.max(here), found.max(here)
        doubt = (half * abs(rate)).upper()
        if doubt <= fine * (abs(here) + 1) + here.rad() or half < fine * length:
            found = found.max(here + doubt.union(0))
        else:
            pieces += [(low, middle), (middle, high)]
    raise GuardFailed("A largest value of the motion could not be enclosed.")
