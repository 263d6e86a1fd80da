"""How far off the key a question of PrairieLearn lets an answer be."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress

from corollary.audit.record import ForgivenError

RELATIVE, ABSOLUTE, DIGITS = 1e-2, 1e-8, 2  # where the input does not say


def forgiven_by(element: Mapping[str, str]) -> ForgivenError | None:
    """What a `pl-number-input` forgives; None for another input, an exact comparison, and what cannot be read."""
    if element.get("tag") != "pl-number-input":
        return None
    with suppress(ValueError):
        match element.get("comparison", "relabs"):
            case "relabs":
                relative, absolute = (
                    float(element.get("rtol", RELATIVE)),
                    float(element.get("atol", ABSOLUTE)),
                )
                return ForgivenError(relative, absolute) if _sizes(relative, absolute) else None
            case (
                "sigfig"
            ):  # half a unit of the last figure: as a share of the key at most this, at its least figures
                return ForgivenError(0.5 * 10.0 ** (1 - int(element.get("digits", DIGITS))), 0.0)
            case "decdig":
                return ForgivenError(0.0, 0.5 * 10.0 ** -int(element.get("digits", DIGITS)))
            case _:
                return None
    return None


def _sizes(*numbers: float) -> bool:
    return all(math.isfinite(each) and each >= 0 for each in numbers)
