"""Tolerances of questions, as each kind of file states them."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from contextlib import suppress

from corollary.audit.record import ForgivenError

RELATIVE, ABSOLUTE, DIGITS = 1e-2, 1e-8, 2  # of PrairieLearn, where the input does not say
WEBWORK = 1e-3  # relative, where neither the context nor the answer says
WEBWORK_OPTION = re.compile(
    r"""\b(tolerance|tolType|relTol|reltol|absTol|abstol|tol)["']?\s*=>\s*["']?([^\s,"')}]+)"""
)
OLDER = re.compile(r"^(?:std_|strict_)?(?:num|NumberWithUnits)_cmp\s*\(|^num_\w*cmp\s*\(")


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


def forgiven_from(text: str) -> ForgivenError:
    """`1 %` of the key, or a number in the unit of the answer. Raises ValueError."""
    number, percent = text.strip(), False
    if number.endswith("%"):
        number, percent = number[:-1], True
    try:
        size = float(number)
    except ValueError:
        size = math.nan
    if not _sizes(size):
        raise ValueError(
            f"{text!r} is not a tolerance; write a share of the answer, `1 %`, or a number in its unit, `0.5`"
        )
    return ForgivenError(size / 100, 0.0) if percent else ForgivenError(0.0, size)


def forgiven_absolutely(text: str) -> ForgivenError | None:
    """The tolerance of a number in Moodle or R/exams; None where none is stated, or it is worked out."""
    try:
        size = float(text)
    except ValueError:
        return None
    return ForgivenError(0.0, size) if _sizes(size) else None


def forgiven_in_webwork(flags: Mapping[str, str], answer: str) -> ForgivenError | None:
    """The tolerance of an answer: its own options, else the `flags` of its context, else WeBWorK's own.

    `num_cmp` and its relatives state a relative tolerance in percent, MathObjects as a share. None where it is worked out.
    """
    older = OLDER.match(answer) is not None
    percent = 0.01 if older else 1.0
    flags = {} if older else dict(flags)
    for option, value in WEBWORK_OPTION.findall(answer):
        match option.lower():
            case "reltol":
                flags |= {"tolerance": value, "tolType": "relative"}
            case "tol" | "abstol":
                flags |= {"tolerance": value, "tolType": "absolute"}
            case _:
                flags[option] = value
    try:
        size = float(flags["tolerance"]) if "tolerance" in flags else WEBWORK / percent
    except ValueError:
        return None
    if not _sizes(size):
        return None
    absolute = flags.get("tolType", "relative") == "absolute"
    return ForgivenError(0.0, size) if absolute else ForgivenError(size * percent, 0.0)


def _sizes(*numbers: float) -> bool:
    return all(math.isfinite(each) and each >= 0 for each in numbers)
