"""A bullet gets stuck in a hanging block, which swings up (example 12.5.1)."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from falls_and_swings import swung
from scipy.integrate import DOP853

from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers
from corollary.scenes.film import BLOCK, NAIL, Act, Film, film
from corollary.scenes.forces.bonds import Rod, catching
from corollary.scenes.forces.fields import Weight
from corollary.scenes.line_collision import SAFE
from corollary.scenes.progress import part, tell
from corollary.scenes.run import (
    ROUNDING,
    BadSetting,
    GuardFailed,
    Observed,
    Run,
    by_relative_errors,
    two_runs,
)
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("mA", "mass of the bullet", "kg", 0.01, above=0.0),
    Setting("mB", "mass of the block", "kg", 1.0, above=0.0),
    Setting("v", "velocity of the bullet", "m/s", 245.0, above=0.0),
    Setting("L", "length of the rope", "m", 1.0, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("dt", "time the bullet takes to get stuck", "s", 1e-5, above=0.0),
)
# scipy's own least: what is left of the bullet's motion is known absolutely.
LEAST_RELATIVE = 2.3e-14
# Those that a fading motion remembers.
LAST_STEPS = 2.0
# So far (rad) a light block may swing under a heavy bullet while it brakes it: some twenty evaluations each, twenty minutes in all.
MOST_SWUNG = 1e7
BRAKED = "a block that swings while a dashpot brakes the bullet in it: step by step"


@np.errstate(all="ignore")  # what leaves the range of a computer is found in the values
def play(settings: Settings, tolerance: float, *, in_steps: bool = False) -> Run:
    """Velocities (bullet, block) when the bullet is stuck, height and greatest angle of the swing, energy lost in the hit (J; negative).

    The block swings already while the bullet is braked; after dt it is held fast. From then on the rope does no work: energy gives
    the height, counted from where the block hung. `in_steps` follows that, too, until it turns.
    """
    bullet, block, v, length, g, dt = numbers(settings, "mA", "mB", "v", "L", "g", "dt")
    both = bullet + block
    common = bullet / both * v
    if common**2 / (2.0 * g) > length:
        raise BadSetting(
            f"ballistic_pendulum: the block would rise {common**2 / (2.0 * g):g} m, above the rope's fixing; lower v."
        )
    if dt > 0.1 * math.sqrt(length / g):
        raise BadSetting(
            f"ballistic_pendulum: in dt = {dt:g} s the block swings up before the bullet is stuck; shorten dt."
        )
    if dt * math.sqrt(g / length * (1.0 + bullet / block)) > MOST_SWUNG:
        raise BadSetting(
            "ballistic_pendulum: the block is so light that it swings to and fro under the bullet's weight for as long as it brakes it; "
            "raise mB, or shorten dt."
        )
    allowed = two_runs(tolerance, least=(1e-13, 1e-14))
    with part(0.0, 0.4):
        rough = _held_fast(settings, allowed[0])
    with part(0.4, 1.0):
        finer = _held_fast(settings, allowed[1])
    (way, speed, spent), angle = finer, finer[0] / length
    risen = 2.0 * length * math.sin(0.5 * angle) ** 2
    hot = 0.5 * both * speed**2 + both * g * risen
    if in_steps:
        turned, apart = _turned(rough, finer, length, g, tolerance)
        height, why = 2.0 * length * math.sin(0.5 * turned) ** 2, f"{BRAKED}; and so the rest of the swing"
    else:
        height, apart = risen + speed**2 / (2.0 * g), 0.0
        turned = 2.0 * math.asin(min(1.0, math.sqrt(0.5 * height / length)))
        why = f"{BRAKED}; then energy for the rest of the swing"
    observed: dict[str, Observed] = {
        "velocities": (speed, speed),
        "height": height,
        "angle": turned,
        "energy_change": hot - 0.5 * bullet * v**2,
    }
    # The height keeps what the way is off by, too, which the speed forgets; of two runs either may be right by chance, and what fades
    # forgets all but the last steps, each off by what it may be.
    off = abs(rough[1] - finer[1]) / common + LAST_STEPS * allowed[1]
    raised = off + math.sin(angle) * abs(rough[0] - way) / height + apart
    errors = dict.fromkeys(observed, 4.0 * ROUNDING + 2.0 * raised) | {
        "velocities": 4.0 * ROUNDING + 2.0 * off
    }
    scales = {"energy_change": 0.5 * bullet * v**2}
    return by_relative_errors(observed, errors, "integration", why, rough[2] + spent, "sticks", scales)


def _turned(
    rough: tuple[float, float, int],
    finer: tuple[float, float, int],
    length: float,
    g: float,
    tolerance: float,
) -> tuple[float, float]:
    """The angle (rad) at which the block turns, in steps from two runs, and how far they are apart, relatively."""
    unit, allowed = math.sqrt(g * length), two_runs(tolerance)
    coarse, turned = (
        swung(way / length, speed / unit, each)[0]
        for (way, speed, _), each in zip((rough, finer), allowed, strict=True)
    )
    return turned, SAFE * abs(coarse / turned - 1.0) + LAST_STEPS * allowed[1]


def _held_fast(settings: Settings, tolerance: float) -> tuple[float, float, int]:
    """Way and velocity of the block along its arc once the bullet is stuck, and the evaluations.

    The block hangs on two ropes and does not turn; the bullet moves level in it, braked by a dashpot: Newton's second law along the
    way of the bullet, and for both along the arc, where the ropes do not pull. What little is left of the bullet's motion in the block
    after dt it shares with it.
    """
    bullet, block, v, length, g, dt = numbers(settings, "mA", "mB", "v", "L", "g", "dt")
    both = bullet + block
    grip = catching(bullet, block, dt).damping

    def slope(_: float, state: Sequence[float]) -> list[float]:
        way, _, speed, inside = state
        s, c = math.sin(way / length), math.cos(way / length)
        brake, turning = grip * inside, s * speed**2 / length
        gained = (c * brake - bullet * c * turning - both * g * s) / (block + bullet * s**2)
        return [speed, inside, gained, turning - c * gained - brake / bullet]

    common = bullet / both * v
    scale = [tolerance * size for size in (common * dt, v * dt, common, v)]
    start = [0.0, 0.0, 0.0, v]
    solver = DOP853(
        slope,
        0.0,
        start,
        dt,
        rtol=LEAST_RELATIVE,
        atol=np.array(scale),  # pyright: ignore[reportArgumentType]
        first_step=1e-3 * dt,
    )
    while solver.status == "running":
        solver.step()
        tell(solver.t / dt)
    if solver.status == "failed":
        raise GuardFailed(
            "ballistic_pendulum: the bullet was not followed to its stop. Choose milder settings."
        )
    way, _, speed, left = solver.y.tolist()
    return way, speed + bullet / both * math.cos(way / length) * left, int(solver.nfev)


def second_way(settings: Settings, tolerance: float) -> Run:
    return play(settings, tolerance, in_steps=True)


def filmed(settings: Settings) -> Film:
    bullet, block, v, length, g, dt = numbers(settings, "mA", "mB", "v", "L", "g", "dt")
    start = 0.6 * length
    bodies = (
        Body(bullet, (-start, 0.0), (v, 0.0), name="A"),
        Body(block, (0.0, 0.0), (0.0, 0.0), name=BLOCK),
        Body(math.inf, (0.0, length), (0.0, 0.0), name=NAIL),
    )
    entry = 0.9 * start
    swing = math.pi * math.sqrt(length / g)
    acts: list[Act] = [
        ((), entry / v),
        ((catching(bullet, block, dt),), dt),
        ((Rod((2, 0)), Rod((2, 1)), Weight(g)), swing),
    ]
    return film(bodies, acts, radii=(0.02 * length, 0.1 * length, 0.0), ropes=((2, 1),))


SCENE = SceneDefinition(
    "a bullet gets stuck in a hanging block", SETTINGS, play, second_way=second_way, film=filmed
)
