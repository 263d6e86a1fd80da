"""A scene to race on: what is observed, what it truly is, and the ways to find it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from corollary.scenes.run import Observed

State = Sequence[float]
Knob = Literal["step", "tolerance"]

TOLERANCES = tuple(10.0 ** (-0.75 * i) for i in range(3, 20))
"""From 6e-3 to 6e-15, three quarters of a power of ten apart."""

ONCE = (1e-15,)
"""A model that has no setting is run once."""


@dataclass(frozen=True, slots=True)
class Reference:
    """True values, written out in decimals; `digits` of them are right, and `source` says how they were found."""

    values: tuple[str, ...]
    digits: int
    source: str

    @property
    def numbers(self) -> tuple[float, ...]:
        return tuple(map(float, self.values))


@dataclass(frozen=True, slots=True)
class MethodAnswer:
    """What a method found, and how many times it asked for the force (or for the integrand)."""

    values: tuple[float, ...]
    evaluations: int


@dataclass(frozen=True, slots=True)
class StepProgram:
    """A scene as a program of the chapter sees it: Newton's second law from a start until a time (s).

    `acceleration(x, v)` gives one number for each of x; `switches` are values (of x followed by v) whose signs say which law
    holds; `read(x, v)` makes the observed values of the last state.
    """

    x: tuple[float, ...]
    v: tuple[float, ...]
    acceleration: Callable[[State, State], Sequence[float]]
    until: float
    switches: tuple[Callable[[State], float], ...]
    read: Callable[[State, State], tuple[float, ...]]


@dataclass(frozen=True, slots=True)
class MethodRoute:
    """One method on one scene: each of `settings` (steps in s, or tolerances) is a run, the coarsest first."""

    knob: Knob
    settings: tuple[float, ...]
    run: Callable[[float], MethodAnswer]


@dataclass(frozen=True, slots=True)
class RacedScene:
    """`scales` are the natural sizes of the observed values, `contact_time` (s) is what a step is compared with.

    `own` are the routes that belong to this scene alone; every method in steps comes from the program.
    """

    name: str
    ready: str
    settings: Mapping[str, Observed]
    observable: str
    reference: Reference
    scales: tuple[float, ...]
    contact_time: float
    program: StepProgram
    own: Mapping[str, MethodRoute]


def error_of(case: RacedScene, answer: MethodAnswer) -> float:
    """The largest difference from the reference, in units of each value's natural size."""
    apart = zip(answer.values, case.reference.numbers, case.scales, strict=True)
    return max(abs(value - true) / scale for value, true, scale in apart)
