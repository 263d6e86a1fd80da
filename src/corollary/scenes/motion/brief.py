"""Forces of somebody's own that may act for shorter than a step lasts: a kick that falls between a step's stages is not felt by it."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math

import numpy as np

from corollary.scenes.motion.isolation import POINTS, Array, coefficients
from corollary.scenes.motion.path import Stretch
from corollary.scenes.scene import Force, Scene

LOOKS = 4000
"""So often each such force is looked at between a scene's start and end: what acts for longer than two looks are apart is seen."""
UNSEEN = 100.0
"""What a step has not seen is to change no speed by more than so many times what the step may be off by."""


def overlooked(scene: Scene, stretch: Stretch, allowed: float) -> bool:
    """Whether such a force does on a step what the step does not know of; `allowed` is the speed (m/s) that a step may be off by.

    What it is at many moments is compared with the series through those at which events are looked for.
    """
    forces = [force for force in scene.forces if force.may_be_brief]
    looks = math.ceil(LOOKS * stretch.lasts / (scene.until or math.inf)) if forces else 0
    if looks < 2:
        return False
    parts = (np.arange(looks) + 0.5) / looks
    known, there = _felt(scene, forces, stretch, POINTS), _felt(scene, forces, stretch, parts)
    between = np.polynomial.chebyshev.chebval(2.0 * parts - 1.0, coefficients(known.T).T).T
    unseen = float(np.abs(there - between).mean(axis=0).max(initial=0.0))
    rounding = 1e-14 * float(np.abs(there).max(initial=0.0))
    return unseen > UNSEEN * allowed / stretch.lasts + rounding


def _felt(scene: Scene, forces: list[Force], stretch: Stretch, parts: Array) -> Array:
    """What the forces do (m/s^2, by components) after several parts of a step; a row each."""
    times, since = stretch.begin + parts * stretch.lasts, stretch.since
    return np.array(
        [
            [a for force in forces for a in force.accelerations(scene, time, state, since)]
            for time, state in zip(times.tolist(), stretch.states(parts), strict=True)
        ]
    )
