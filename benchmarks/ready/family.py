"""A family of random runs of one ready scene, and where their true values come from."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from corollary.scenes.run import Run

Reference = Mapping[str, tuple[Any, ...]]


@dataclass(frozen=True, slots=True)
class Family:
    """`draw` gives settings, `reference` the true values of a run (fractions, or numbers of so many `digits`), `known` to so many parts of
    themselves.
    """

    name: str
    scene: str
    against: str
    draw: Callable[[random.Random], dict[str, Any]]
    reference: Callable[[dict[str, Any], Run], Reference]
    tolerance: float = 1e-9
    digits: int = 50
    known: float = 0.0
    second_way: bool = False


def powers(rng: random.Random, low: float, high: float) -> float:
    return 10.0 ** rng.uniform(low, high)
