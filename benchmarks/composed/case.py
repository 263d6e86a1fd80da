"""One composed scene, what is asked of it, and what must come out."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from random import Random

from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, GuardFailed, Observable, components
from corollary.scenes.scene import Scene

SHARP = 1e-6
"""A value is right when the truth is within its stated error and that is no more than this part of its size."""


@dataclass(frozen=True, slots=True)
class Case:
    """`truth` holds for each observable the reference values; nan where nothing is compared. `doubt` is how far off these may be themselves."""

    family: str
    scene: Scene
    truth: Mapping[Observable, tuple[float, ...]]
    times: tuple[float, ...] = ()
    doubt: Mapping[Observable, float] = field(default_factory=dict[Observable, float])


def drawn(families: Sequence[Callable[[Random], Case]], each: int, seed: int) -> Iterator[Case]:
    """So many cases of every family."""
    for family in families:
        draw = Random(f"{family.__name__} {seed}")
        for _ in range(each):
            yield family(draw)


@dataclass(frozen=True, slots=True)
class Verdict:
    """`ratio` is the worst true error over the stated one; `outcome` what became of the case."""

    case: Case
    outcome: str
    ratio: float
    why: str
    relative: float = 0.0


def judged(case: Case, tolerance: float = 1e-10) -> Verdict:
    """Play a case: right, honest (the truth lies within a larger stated error), refused, or wrong."""
    try:
        found = play(case.scene, set(case.truth), tolerance, case.times)
    except (BadSetting, GuardFailed) as refused:
        return Verdict(case, "refused", 0.0, str(refused))
    ratio, sharp, why, relative = 0.0, True, "", 0.0
    for what, truth in case.truth.items():
        measured = found.measured[what.value]
        values, errors = components(measured.value), components(measured.error)
        if len(values) != len(truth):
            return Verdict(case, "wrong", math.inf, f"{what.value}: {values} for {truth}")
        for value, error, true in zip(values, errors, truth, strict=True):
            if math.isnan(true):
                continue
            off = abs(value - true)
            # References are doubles: a few roundings of their own size are theirs, and what they leave open.
            off = max(off - 4e-15 * max(abs(true), measured.size) - case.doubt.get(what, 0.0), 0.0)
            here = off / error if error else (0.0 if off == 0.0 else math.inf)
            relative = max(relative, error / max(measured.size, 1e-300))
            sharp = sharp and error <= SHARP * max(measured.size, 1e-300)
            if here > ratio:
                ratio, why = here, f"{what.value}: {value!r} ± {error:.1e} for {true!r}"
    outcome = "wrong" if ratio > 1.0 else "right" if sharp else "honest"
    return Verdict(case, outcome, ratio, why, relative)
