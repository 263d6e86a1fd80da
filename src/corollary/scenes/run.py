"""What can be observed of a scene, and what became of it: the values, how sure they are, which model found them, at what cost."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Literal

Model = Literal["conservation", "quadrature", "piecewise exact", "integration"]
Outcome = Literal["released", "sticks", "missed", "bound", "escaped"]
Observed = float | tuple[float, ...]


class BadSetting(ValueError):
    """A setting that is unknown or against the physics; one sentence says which and what to do."""


class GuardFailed(ArithmeticError):
    """A run that lost momentum or energy beyond what its accuracy allows; its numbers are not handed out."""


class Observable(Enum):
    """Each is defined so exactly that two programs must agree on it; the value is the name under which a run reports it."""

    VELOCITIES = "velocities"
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
    Observable.DURATION: "from the moment of the first touch to that of the last opening (s), not counted in samples",
    Observable.LARGEST_OVERLAP: "the largest there is at any moment between any two bodies, none if they never touch (m)",
    Observable.PEAK_FORCE: "the largest contact force there is at any moment between any two bodies, drag included (N)",
    Observable.ENERGY_RATIO: "kinetic energy at the end over that at the start",
    Observable.TURNING_POINTS: "distances from the origin at which the first body turns back, smallest first (m)",
    Observable.PERIOD: "time between two returns of the first body's distance to its smallest value (s)",
    Observable.IMPULSE: "of all forces on each body that is no wall, from start to end: its change of momentum (kg m/s)",
    Observable.MOMENTUM: "of all bodies that are no walls together, at the end (kg m/s)",
    Observable.ENERGY: "kinetic energy, and potential energy of every force that has one, at the end (J); zero as each force defines it",
    Observable.TRAJECTORY: "places of all bodies, body after body, at each of the times asked for, time after time (m); looked up within "
    "the steps, not between samples. Without times: at 101 equally spaced ones, from 0 to the end that the scene names",
}


@dataclass(frozen=True, slots=True)
class Run:
    """One scene, played.

    `observed` is in SI. `errors` gives for each observed value the estimate of its error in units of its natural scale (the first
    speed, the time of contact, …), and `error` is the largest of them. `evaluations` counts the forces evaluated, those for the
    error estimate included. `scene`, `settings` and `seconds` are filled in by who had it played.
    """

    observed: dict[str, Observed]
    errors: dict[str, float]
    model: Model
    why: str
    evaluations: int
    outcome: Outcome
    scene: str = ""
    settings: Mapping[str, Observed] = field(default_factory=dict[str, Observed])
    seconds: float = 0.0

    @property
    def error(self) -> float:
        """The largest of the errors; nan when nothing was observed."""
        return max(self.errors.values(), default=float("nan"))
