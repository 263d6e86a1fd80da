"""What may be asked of a scene, and how it is refused where numbers leave the range of a computer, or a function of one's own fails."""

from __future__ import annotations

import math
from collections.abc import Collection, Generator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from numbers import Real

from corollary.scenes.refused import OWN_FAILS
from corollary.scenes.run import BadSetting, GuardFailed, Measurement, Observable, Run, components
from corollary.scenes.scene import Scene
from corollary.scenes.sound import refuse_tolerance, short_text


def refuse_question(
    scene: Scene, observe: Collection[Observable], tolerance: float, times: Sequence[float]
) -> None:
    """Raises BadSetting where what is asked of a scene is no question."""
    if not _are(observe, Observable):
        names = ", ".join(f"Observable.{o.name}" for o in Observable)
        raise BadSetting(f"{scene.name}: what is to be observed is a set of these: {names}.")
    if not observe:
        names = ", ".join(o.value for o in Observable)
        raise BadSetting(f"{scene.name}: nothing is to be observed; name at least one of {names}.")
    refuse_tolerance(scene.name, tolerance)
    if not _are(times, Real):
        raise BadSetting(
            f"{scene.name}: times = {short_text(times)} must be a tuple of times in s, (1.0,) with its comma for a single one."
        )


def _are(given: object, kind: type) -> bool:
    return isinstance(given, Collection) and all(isinstance(each, kind) for each in given)  # pyright: ignore[reportUnknownVariableType]


@contextmanager
def within_range(scene: Scene) -> Generator[None]:
    """Raises BadSetting where numbers leave the range of a computer, GuardFailed where a function of somebody's own fails on the way."""
    try:
        yield
    except (BadSetting, GuardFailed):
        raise
    except OWN_FAILS as error:
        if isinstance(error, (OverflowError, ZeroDivisionError, ValueError)):
            raise BadSetting(
                f"{scene.name}: with these numbers the range of a computer is left; choose milder ones."
            ) from error
        if not any(force.may_be_brief for force in scene.forces):  # a fault of this package's own
            raise
        raise GuardFailed(
            f"{scene.name}: a function of your own fails on the way ({type(error).__name__}: {error}); mend it."
        ) from error


def within_doubles(scene: Scene, run: Run) -> Run:
    """In floats of Python's own, without the values that no double holds, and with a warning for each. Raises BadSetting when none is left.

    How long a contact lasts that never ends, and how many times the energy grows of what was at rest, is infinite for another reason.
    """
    run = replace(run, measured={name: _in_floats(each) for name, each in run.measured.items()})
    mean = {Observable.DURATION.value, Observable.ENERGY_RATIO.value}
    lost = [
        name
        for name, each in run.measured.items()
        if name not in mean and not all(map(math.isfinite, components(each.value)))
    ]
    if not lost:
        return run
    if len(lost) == len(run.measured):
        raise BadSetting(
            f"{scene.name}: {', '.join(lost)}: with these numbers the range of a computer is left; choose milder ones."
        )
    warnings = tuple(f"{name} is beyond the numbers of a computer." for name in lost)
    finite = {name: each for name, each in run.measured.items() if name not in lost}
    return replace(run, measured=finite, warnings=(*run.warnings, *warnings))


def _in_floats(each: Measurement) -> Measurement:
    value, error = (
        tuple(map(float, given)) if isinstance(given, tuple) else float(given)
        for given in (each.value, each.error)
    )
    return replace(each, value=value, error=error, size=float(each.size))
