"""A student's function and what it returned: each case once with its step, and once with half of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

Given = Mapping[str, float]
Draw = Callable[[float, float], float]
Inputs = Mapping[str, Any]

STEPS = 100  # in a contact: with so many the book's method errs by 1.2e-4 of the first speed (measured, no damping)


@dataclass(frozen=True, slots=True)
class Called:
    """One call: the keyword arguments, and the numbers that came back."""

    inputs: Inputs
    returned: tuple[float, ...]


def halved(cases: Sequence[Inputs]) -> list[Inputs]:
    """Each case with its step `dt`, and then with half of it."""
    return [inputs for case in cases for inputs in (case, {**case, "dt": case["dt"] / 2})]


def pairs(called: Sequence[Called]) -> list[tuple[Called, Called]]:
    """The calls that `halved` made, two and two."""
    return list(zip(called[::2], called[1::2], strict=True))


def miscounted(called: Called, count: int, what: str) -> str:
    """What to say when not so many numbers came back; "" when they did."""
    many = len(called.returned)
    return (
        ""
        if many == count
        else f"It returns {'one number' if many == 1 else f'{many} numbers'}; return {what}."
    )
