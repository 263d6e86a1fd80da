"""What became of a scene: the values observed, how sure they are, which model found them and at what cost."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Model = Literal["conservation", "quadrature", "piecewise exact", "integration"]
Outcome = Literal["released", "sticks", "missed", "bound", "escaped"]
Observed = float | tuple[float, ...]


class BadSetting(ValueError):
    """A setting that is unknown or against the physics; one sentence says which and what to do."""


class GuardFailed(ArithmeticError):
    """A run that lost momentum or energy beyond what its accuracy allows; its numbers are not handed out."""


@dataclass(frozen=True, slots=True)
class Run:
    """One scene, played.

    `observed` is in SI. `errors` gives for each observed value the bound or estimate of its error in units of its natural
    scale (the first speed, the time of contact, …), and `error` is the largest of them. `evaluations` counts the forces
    evaluated, those for the error estimate included.
    """

    scene: str
    settings: dict[str, Observed]
    observed: dict[str, Observed]
    errors: dict[str, float]
    model: Model
    why: str
    evaluations: int
    seconds: float
    outcome: Outcome

    @property
    def error(self) -> float:
        """The largest of the errors; nan when nothing was observed."""
        return max(self.errors.values(), default=float("nan"))
