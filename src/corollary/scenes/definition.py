"""A ready-made scene: its settings, and how it is played."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from corollary.scenes.run import Model, Observed, Outcome
from corollary.scenes.setting import Setting


@dataclass(frozen=True, slots=True)
class Played:
    """What a scene's play gives; `run` adds the name, the settings and the time it took."""

    observed: dict[str, Observed]
    errors: dict[str, float]
    model: Model
    why: str
    evaluations: int
    outcome: Outcome


@dataclass(frozen=True, slots=True)
class SceneDefinition:
    """`meaning` is one line for a list of scenes."""

    name: str
    meaning: str
    settings: tuple[Setting, ...]
    play: Callable[[Mapping[str, Observed], float], Played]
