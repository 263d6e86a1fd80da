"""The ready-made scenes by name, and the one door through which they are run."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping
from dataclasses import replace
from importlib import import_module
from pkgutil import iter_modules

from corollary.messages import did_you_mean
from corollary.scenes import library
from corollary.scenes.definition import SceneDefinition, settle
from corollary.scenes.independent import SECOND_WAYS
from corollary.scenes.run import BadSetting, Run, components
from corollary.scenes.validation import refuse_tolerance


class Library(Mapping[str, SceneDefinition]):
    """Every module of the folder `library` is a scene of its name and holds it as SCENE; it is loaded when it is asked for."""

    def __init__(self) -> None:
        self._names = tuple(sorted(module.name for module in iter_modules(library.__path__)))

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __getitem__(self, name: str) -> SceneDefinition:
        if name not in self._names:
            raise KeyError(name)
        return import_module(f"{library.__name__}.{name}").SCENE


SCENES = Library()


def run(
    name: str,
    settings: Mapping[str, object],
    tolerance: float = 1e-12,
    *,
    second_way: bool = False,
) -> Run:
    """Play a ready-made scene with the least model that answers; what confirms a formula asks for its `second_way`, which shares none.

    By the second way only those values are there that it gives; what is followed in steps in any case has none, and the same run is
    given.

    Settings are in SI; those not given take the chapter's values. `tolerance` is relative to the scene's natural scale. A value that
    no double holds, or that does not exist (how long a contact lasts that never ends), is left out, and a warning says so.
    Raises BadSetting when a setting is unknown or unphysical, GuardFailed when momentum or energy is not conserved.
    """
    scene = definition(name)
    refuse_tolerance(name, tolerance)
    settled = settle(name, scene.settings, settings)
    begin = time.perf_counter()
    try:
        found = SECOND_WAYS[name](settled, tolerance) if second_way and name in SECOND_WAYS else None
        found = found or scene.play(settled, tolerance)
    except BadSetting:
        raise
    except (OverflowError, ZeroDivisionError, ValueError):
        raise BadSetting(
            f"{name}: with these settings numbers leave the range of a computer; choose milder ones."
        ) from None
    return replace(_finite(name, found), scene=name, settings=settled, seconds=time.perf_counter() - begin)


def definition(name: str) -> SceneDefinition:
    """What a ready-made scene is and what it takes. Raises BadSetting where there is none of this name."""
    if name not in SCENES:
        raise BadSetting(
            f"There is no scene {name!r}{did_you_mean(name, SCENES)}; there are {', '.join(SCENES)}."
        )
    return SCENES[name]


def _finite(scene: str, found: Run) -> Run:
    """Without the values that are no numbers of a computer, and with a warning for each. Raises BadSetting when none is left."""
    lost = [
        name
        for name, each in found.measured.items()
        if not all(map(math.isfinite, (*components(each.value), *components(each.error))))
    ]
    if len(lost) == len(found.measured):
        raise BadSetting(
            f"{scene}: with these settings numbers leave the range of a computer; choose milder ones."
        )
    return found.without(lost) if lost else found
