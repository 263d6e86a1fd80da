"""A scene that must confirm the algebra: what to run, and what it must show."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from corollary.derive.load import AUTHOR_S, AUTHOR_WALL_S, Loaded, NotDerivable, authors_code, load
from corollary.derive.time_limit import time_limit
from corollary.problem.bank import Bank
from corollary.problem.variant import Variant
from corollary.scenes.scene import Scene

Seen = float | tuple[float, ...]
NONE: Mapping[str, object] = {}
"""No settings."""


@dataclass(frozen=True, slots=True)
class Simulation:
    """One run of a ready-made scene by its name, or of a composed one, which is followed by Newton's second law until its `until`.

    `expect` has what `Observable` names; a `trajectory` is where the bodies are at the end. `neglected` bounds what the algebra leaves
    out, relative to each expected value; `line` is where the solution asks for it. One that is `animated` is the motion of the exercise, and
    is played beside it. A ready-made scene is one of the `bank`, or of the chapter's. Raises TypeError for settings of a composed scene.
    """

    scene: str | Scene
    settings: Mapping[str, object]
    expect: Mapping[str, Seen]
    neglected: float
    line: int
    animated: bool = False
    bank: Bank | None = None

    def __post_init__(self) -> None:
        if self.settings and isinstance(self.scene, Scene):
            raise TypeError("a composed scene has no settings: put the numbers into its bodies and forces")

    @property
    def name(self) -> str:
        return self.scene.name if isinstance(self.scene, Scene) else self.scene


def simulations(
    bank: Bank, variant: Variant, answers: Mapping[str, Seen], neglected: Mapping[str, float] | None = None
) -> list[Simulation]:
    """What a solution wants simulated for a variant; none where it has no scene function. Raises NotDerivable.

    A scene function that takes `neglected` gets for each part the most that what it neglects can change of its answer (in SI).
    """
    return simulations_of(load(bank, variant.problem), variant, answers, neglected)


def simulations_of(
    loaded: Loaded,
    variant: Variant,
    answers: Mapping[str, Seen],
    neglected: Mapping[str, float] | None = None,
) -> list[Simulation]:
    """The same of a solution that is loaded. Raises NotDerivable."""
    if loaded.scene is None:
        return []
    scene = loaded.scene()
    line, path = scene.__code__.co_firstlineno, Path(scene.__code__.co_filename)
    with time_limit(AUTHOR_S, AUTHOR_WALL_S), authors_code(path, "scene fails", line):
        bounds = {"neglected": neglected or {}} if "neglected" in inspect.signature(scene).parameters else {}
        wanted = list(scene(**variant.si, answer=answers, **bounds))
    if not all(isinstance(each, Simulation) for each in wanted):
        raise NotDerivable(path, line, "scene must return a list of simulate(…)")
    return [replace(each, bank=loaded.bank) for each in wanted]
