"""A bullet gets stuck in a hanging block, which swings up (example 12.5.1)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scene.collision import CLOSED
from corollary.scene.model.flow import Mover, faded_time, under_dashpot
from corollary.scene.ready.scenery import Played, Ready
from corollary.scene.ready.setting import Setting, one
from corollary.scene.run import BadSetting, Observed

SETTINGS = (
    Setting("mA", "mass of the bullet", "kg", 0.01, above=0.0),
    Setting("mB", "mass of the block", "kg", 1.0, above=0.0),
    Setting("v", "velocity of the bullet", "m/s", 245.0, above=0.0),
    Setting("L", "length of the rope", "m", 1.0, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("dt", "time the bullet takes to get stuck", "s", 1e-5, above=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Played:
    """Common velocity, height and greatest angle of the swing, energy lost in the hit (J; negative).

    The bullet is braked by a dashpot; while it gets stuck the block swings by less than the way made in dt, and that is what the
    error bounds.
    """
    bullet_mass, block_mass, v, length, g, dt = (one(settings, name) for name in ("mA", "mB", "v", "L", "g", "dt"))
    grip = faded_time(bullet_mass, block_mass, 1.0) / dt
    bullet, block = under_dashpot(Mover(0.0, v), Mover(0.0, 0.0), bullet_mass, block_mass, grip, dt)
    height = block.v**2 / (2.0 * g)
    if height > length:
        raise BadSetting(f"ballistic_pendulum: the block would rise {height:g} m, above the rope's fixing; lower v.")
    observed: dict[str, Observed] = {
        "velocities": (bullet.v, block.v),
        "height": height,
        "angle": math.acos(1.0 - height / length),
        "energy_change": 0.5 * bullet_mass * (bullet.v**2 - v**2) + 0.5 * block_mass * block.v**2,
    }
    risen = 0.5 * block.x**2 / length / height
    errors = dict.fromkeys(observed, 4.0 * CLOSED + risen)
    why = "a dashpot in closed form, then energy for the swing"
    return Played(observed, errors, "piecewise exact", why, 0, "sticks")


BALLISTIC_PENDULUM = Ready("ballistic_pendulum", "a bullet gets stuck in a hanging block", SETTINGS, play)
