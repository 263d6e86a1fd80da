"""Observables of a scene and the outcome of a run: values, errors, the model that found them, and its cost."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Literal

Model = Literal["conservation", "quadrature", "piecewise exact", "integration"]
Outcome = Literal["released", "sticks", "missed", "bound", "escaped"]
Observed = float | tuple[float, ...]
ErrorKind = Literal["bound", "estimate"]

DEARER: tuple[Model, ...] = ("conservation", "quadrature", "piecewise exact", "integration")
"""The models, each dearer than those before it."""

ROUNDING = 2e-15
"""What rounding leaves of a closed formula, as a part of the largest number in it."""

ILL = 1e6
"""From this condition on (how many times larger a small change of the data comes out in a value) it is worth a warning."""

COARSEST = 1e-6
"""Beyond this tolerance steps are so long that two runs take the same and cannot tell their error; they cost little less, too."""

FINER = 20.0
"""How much finer that run of a scene of one's own is whose values are given than the one it is compared with."""

NEVER_PART = "They never part: the contact has no duration."
STEPS = "Newton's second law, step by step"


class BadSetting(ValueError):
    """A setting that is unknown or against the physics; one sentence says which and what to do."""


class GuardFailed(ArithmeticError):
    """A run that lost momentum or energy beyond what its accuracy allows; its numbers are not handed out.

    With `finer` it may be followed with a finer tolerance.
    """

    def __init__(self, sentence: str, finer: bool = False) -> None:
        super().__init__(sentence)
        self.finer = finer


class NoForce(ArithmeticError):
    """A function of somebody's own has no value where it was asked; a step that only tries to go there is not taken."""


class Observable(Enum):
    """Each is defined so exactly that two programs must agree on it; the value is the name under which a run reports it."""

    VELOCITIES = "velocities"
    SPINS = "spins"
    DURATION = "duration"
    LARGEST_OVERLAP = "largest_overlap"
    PEAK_FORCE = "peak_force"
    ENERGY_RATIO = "energy_ratio"
    TURNING_POINTS = "turning_points"
    PERIOD = "period"
    IMPULSE = "impulse"
    MOMENTUM = "momentum"
    ENERGY = "energy"
    TRAJECTORY = "trajectory"


MEANING: dict[Observable, str] = {
    Observable.VELOCITIES: "of every body at the end: after the last opening, or at the time asked for (m/s)",
    Observable.SPINS: "of every body at the end (rad/s, counter-clockwise); zero for bodies that nothing turns",
    Observable.DURATION: "from the moment of the first touch to that of the last opening (s), not counted in samples",
    Observable.LARGEST_OVERLAP: "the largest there is at any moment between any two bodies, none if they never touch (m); with a point only where a contact acts",
    Observable.PEAK_FORCE: "the largest contact force there is at any moment between any two bodies, drag included, friction of surfaces left out (N)",
    Observable.ENERGY_RATIO: "kinetic energy at the end over that at the start",
    Observable.TURNING_POINTS: "the smallest and the largest of the distances from the origin at which the first body turns back (m): one if "
    "they are the same, none if it never does; twice its distance if that does not change by more than steps may be off, as on a circle",
    Observable.PERIOD: "time between two returns of the first body's distance to its smallest value (s)",
    Observable.IMPULSE: "of all forces on each body that is not a wall, from start to end: its change of momentum (kg m/s)",
    Observable.MOMENTUM: "of all bodies that are no walls together, at the end (kg m/s)",
    Observable.ENERGY: "kinetic energy, and potential energy of every force that has one, at the end (J); zero as each force defines it",
    Observable.TRAJECTORY: "places of all bodies, body after body, at each of the times asked for, time after time (m); looked up within "
    "the steps, not between samples. Without times: at 101 equally spaced ones, from 0 to the end that the scene names",
}


@dataclass(frozen=True, slots=True)
class Measurement:
    """One observed value (SI), and how sure it is.

    `error` is absolute, in the value's own unit, one for each of its components. `error_is` says whether it is proven ("bound") or
    found by comparing runs ("estimate"). `size` is what a relative error refers to: the largest component, or the scene's natural
    scale where that is larger. `condition` says how much larger a small change of the data comes out in the value, both relative to their
    size; none where it was not looked for. Raises GuardFailed for a value that is not a number.
    """

    value: Observed
    error: Observed
    error_is: ErrorKind
    model: Model
    why: str
    size: float
    condition: float | None = None

    def __post_init__(self) -> None:
        if any(map(math.isnan, (*components(self.value), *components(self.error)))):
            raise GuardFailed("What came out is not a number: these settings are beyond what doubles hold.")

    @property
    def relative_error(self) -> float:
        """The largest error of a component in units of `size`; infinite where there is nothing to compare with."""
        largest = max(components(self.error), default=0.0)
        if not largest:
            return 0.0
        return largest / self.size if self.size else math.inf


@dataclass(frozen=True, slots=True)
class Run:
    """One scene, played: what was observed by name, and how it ended.

    `evaluations` counts the forces evaluated, those for the error estimate included. `warnings` are sentences about what makes the
    values uncertain: a grazing hit, bounces without end, chaos. `scene`, `settings` and `seconds` are filled in by who
    had it played.
    """

    measured: dict[str, Measurement]
    evaluations: int
    outcome: Outcome
    warnings: tuple[str, ...] = ()
    scene: str = ""
    settings: Mapping[str, Observed] = field(default_factory=dict[str, Observed])
    seconds: float = 0.0

    @property
    def observed(self) -> dict[str, Observed]:
        """The values alone, by name."""
        return {name: each.value for name, each in self.measured.items()}

    @property
    def errors(self) -> dict[str, Observed]:
        """The absolute errors (SI) alone, by name, shaped as the values."""
        return {name: each.error for name, each in self.measured.items()}

    @property
    def error(self) -> float:
        """The largest of the relative errors; nan when nothing was observed."""
        return max((each.relative_error for each in self.measured.values()), default=float("nan"))

    @property
    def error_is(self) -> ErrorKind:
        """A bound if every error is one."""
        return "bound" if all(each.error_is == "bound" for each in self.measured.values()) else "estimate"

    @property
    def _dearest(self) -> Measurement | None:
        return max(self.measured.values(), key=lambda each: DEARER.index(each.model), default=None)

    @property
    def model(self) -> Model:
        """The dearest model that any of the values needed."""
        return self._dearest.model if self._dearest else "conservation"

    @property
    def why(self) -> str:
        """One line: why that model."""
        return self._dearest.why if self._dearest else "nothing was observed"

    def relative_error(self, name: str) -> float:
        """The error of one observed value in units of its size."""
        return self.measured[name].relative_error

    def only(self, names: Iterable[str]) -> Run:
        """The same run, with some of its values; those that it has not (the duration of a contact that never ends) are left out."""
        return replace(self, measured={name: self.measured[name] for name in names if name in self.measured})

    def without(self, lost: Sequence[str]) -> Run:
        """The same run without values that no double holds, and with a warning for each; what sticks has no duration."""
        warnings = [
            NEVER_PART
            if name == Observable.DURATION.value and self.outcome == "sticks"
            else f"{name} is beyond the numbers of a computer."
            for name in lost
        ]
        found = self.only(name for name in self.measured if name not in lost)
        return replace(found, warnings=tuple(dict.fromkeys((*self.warnings, *warnings))))


def two_runs(
    tolerance: float, coarsest: float = COARSEST, least: tuple[float, float] = (1e-14, 1e-15)
) -> tuple[float, float]:
    """The tolerances of a coarser and a finer run, whose difference is the error of the coarser; not below what doubles can hold."""
    tolerance = min(tolerance, coarsest)
    return max(tolerance, least[0]), max(tolerance / 30.0, least[1])


def components(value: Observed) -> tuple[float, ...]:
    """The numbers a value consists of."""
    return value if isinstance(value, tuple) else (value,)


def by_relative_errors(
    observed: Mapping[str, Observed],
    errors: Mapping[str, float],
    model: Model,
    why: str,
    evaluations: int,
    outcome: Outcome,
    scales: Mapping[str, float] | None = None,
    warnings: tuple[str, ...] = (),
) -> Run:
    """A run of one model whose errors are estimated relative to the largest component of a value, or to its scale (SI) if that is larger."""
    scales, measured = scales or {}, dict[str, Measurement]()
    for name, value in observed.items():
        several = isinstance(value, tuple)
        size = max((scales.get(name, 0.0), *map(abs, filter(math.isfinite, value if several else (value,)))))
        error = errors[name] * size
        off: Observed = (error,) * len(value) if several else error
        measured[name] = Measurement(value, off, "estimate", model, why, size)
    return Run(measured, evaluations, outcome, warnings)
