"""Scenes at the ends of the range: each obeys a law that must hold there, or is refused in a sentence."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from dataclasses import dataclass

from corollary.derive.ready_scenes import run
from corollary.scenes.run import BadSetting, GuardFailed, Observed

from .scene_laws import SceneLaw

ROUNDING = 2e-14  # a law is met when it is off by no more than the run states, and a few roundings


@dataclass(frozen=True, slots=True)
class Extreme:
    """A scene far out, and a law that holds there."""

    what: str
    scene: str
    settings: Mapping[str, Observed]
    law: SceneLaw


@dataclass(frozen=True, slots=True)
class ExtremeRun:
    """`outcome` is that of the run, or `refused`; `why` says why so, or by which model it ran. `off` is how far the law was missed, `stated` the
    error the run states for what it observed."""

    what: str
    scene: str
    outcome: str
    why: str
    off: float
    stated: float
    seconds: float

    @property
    def ok(self) -> bool:
        return self.outcome == "refused" or self.off <= self.stated + ROUNDING


def play(extreme: Extreme) -> ExtremeRun:
    """Run one; a refusal is an outcome."""
    begin = time.perf_counter()
    try:
        found = run(extreme.scene, extreme.settings)
    except (BadSetting, GuardFailed) as refused:
        return ExtremeRun(
            extreme.what, extreme.scene, "refused", str(refused), 0.0, 0.0, time.perf_counter() - begin
        )
    off, stated = extreme.law.off(found), found.relative_error(extreme.law.observed)
    seconds = time.perf_counter() - begin
    # A law that cannot even be evaluated is broken.
    return ExtremeRun(
        extreme.what,
        extreme.scene,
        found.outcome,
        found.why,
        math.inf if math.isnan(off) else off,
        stated,
        seconds,
    )
