"""The ready-made scenes by name, and one door through which they are run."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping

from corollary.scenes.definition import SceneDefinition
from corollary.scenes.library.absorbed_drop import ABSORBED_DROP
from corollary.scenes.library.atom import ATOM
from corollary.scenes.library.ball_on_floor import BALL_ON_FLOOR
from corollary.scenes.library.ballistic_pendulum import BALLISTIC_PENDULUM
from corollary.scenes.library.bouncing_ball import BOUNCING_BALL
from corollary.scenes.library.bullet_block import BULLET_BLOCK
from corollary.scenes.library.chain import CHAIN
from corollary.scenes.library.cradle import CRADLE
from corollary.scenes.library.growing_drop import GROWING_DROP
from corollary.scenes.library.ions import IONS
from corollary.scenes.library.kick import KICK
from corollary.scenes.library.pendulum_block import PENDULUM_BLOCK
from corollary.scenes.library.railway_car import RAILWAY_CAR
from corollary.scenes.library.rocket import ROCKET
from corollary.scenes.library.snowball import SNOWBALL
from corollary.scenes.library.spheres import SPHERES
from corollary.scenes.library.super_ball import SUPER_BALL
from corollary.scenes.library.touching_spheres import TOUCHING_SPHERES
from corollary.scenes.library.two_blocks import TWO_BLOCKS
from corollary.scenes.library.wall import WALL
from corollary.scenes.run import BadSetting, Run
from corollary.scenes.setting import settle

READY = (
    CRADLE,
    BALL_ON_FLOOR,
    SPHERES,
    ATOM,
    CHAIN,
    ROCKET,
    KICK,
    WALL,
    SNOWBALL,
    BULLET_BLOCK,
    TWO_BLOCKS,
    SUPER_BALL,
    BOUNCING_BALL,
    PENDULUM_BLOCK,
    BALLISTIC_PENDULUM,
    RAILWAY_CAR,
    IONS,
    TOUCHING_SPHERES,
    ABSORBED_DROP,
    GROWING_DROP,
)
SCENES: dict[str, SceneDefinition] = {scene.name: scene for scene in READY}


def run(name: str, settings: Mapping[str, object], tolerance: float = 1e-12) -> Run:
    """Play a ready-made scene with the least model that answers.

    Settings are in SI; those not given take the chapter's values. `tolerance` is relative to the scene's natural scale.
    Raises BadSetting when a setting is unknown or unphysical, GuardFailed when momentum or energy is not kept.
    """
    if name not in SCENES:
        raise BadSetting(f"There is no scene {name!r}; there are {', '.join(SCENES)}.")
    if not (math.isfinite(tolerance) and 1e-15 <= tolerance <= 0.1):
        raise BadSetting(
            f"{name}: a tolerance of {tolerance:g} cannot be kept; ask for one between 1e-15 and 0.1."
        )
    ready = SCENES[name]
    settled = settle(name, ready.settings, settings)
    begin = time.perf_counter()
    try:
        played = ready.play(settled, tolerance)
    except (OverflowError, ZeroDivisionError):
        raise BadSetting(
            f"{name}: with these settings numbers leave the range of a computer; choose milder ones."
        ) from None
    seconds = time.perf_counter() - begin
    return Run(
        name,
        settled,
        played.observed,
        played.errors,
        played.model,
        played.why,
        played.evaluations,
        seconds,
        played.outcome,
    )
