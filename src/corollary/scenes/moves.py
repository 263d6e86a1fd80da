"""Whether a function of the time that moves a wall gives what it must: offset, velocity and acceleration that belong to each other."""

from __future__ import annotations

import math
from collections.abc import Callable

from corollary.scenes.refused import OWN_FAILS
from corollary.scenes.run import BadSetting, GuardFailed
from corollary.scenes.sound import short_text, size_of

Shift = Callable[[float], tuple[float, float, float]]
WHEN = (0.1234, 0.3456, 0.5432, 0.7654, 0.9321)
"""The parts of the time at which it is looked at."""
NEAR = (1e-6, 1e-4, 1e-8)
"""Differences are taken over such parts of the time; one that is right over any of them is right."""
GROSS = 0.1


def refuse_moves(scene: str, moves: Shift, until: float) -> None:
    """Raises BadSetting for one that does not give three finite numbers, or a velocity or an acceleration that is grossly another than
    its offset or its velocity changes by; looked at a few times until then (s)."""
    _at(scene, moves, 0.0)
    for part in WHEN if until else ():
        time = part * until
        now = _at(scene, moves, time)
        wrong = {1: True, 2: True}
        for near in NEAR:
            h = near * until
            before, after = _at(scene, moves, time - h), _at(scene, moves, time + h)
            for i, still in wrong.items():
                change = (after[i - 1] - before[i - 1]) / (2.0 * h)
                noise = 8.0 * math.ulp(max(abs(before[i - 1]), abs(after[i - 1]))) / h
                wrong[i] = still and abs(change - now[i]) > GROSS * max(abs(change), abs(now[i])) + noise
            if not any(wrong.values()):
                break
        for i, what, of in ((1, "velocity", "offset"), (2, "acceleration", "velocity")):
            if wrong[i]:
                raise BadSetting(
                    f"{scene}: HardWall(moves=…) gives the {what} {now[i]:.6g} at {time:.6g} s, but its {of} changes otherwise; "
                    "it must give offset, velocity and acceleration along the normal."
                )


def _at(scene: str, moves: Shift, time: float) -> tuple[float, float, float]:
    try:
        found = moves(time)
        if not math.isfinite(size_of(found, 3, f"{scene}: HardWall(moves=…)", time)):
            raise BadSetting(
                f"{scene}: HardWall(moves=…) gives {short_text(found)} at {time:.6g} s; it must be finite."
            )
    except BadSetting:
        raise
    except GuardFailed as error:
        raise BadSetting(str(error)) from None
    except OWN_FAILS as error:
        raise BadSetting(
            f"{scene}: HardWall(moves=…) fails at {time:.6g} s ({type(error).__name__}: {error}); mend it."
        ) from error
    return found
