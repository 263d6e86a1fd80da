"""A bullet gets stuck in a block, which then slides over a rough table until it stops (exercise 12.10)."""

from __future__ import annotations

from second_way import second_run, state_after

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.film import BLOCK, Act, Film, film
from corollary.scenes.forces.bonds import FADING, catching
from corollary.scenes.forces.contact import Friction
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.run import (
    Observed,
    Run,
)
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("m", "mass of the bullet", "kg", 0.1, above=0.0),
    Setting("M", "mass of the block", "kg", 2.0, above=0.0),
    Setting("v", "velocity of the bullet", "m/s", 20.0, above=0.0),
    Setting("mu", "coefficient of kinetic friction", "1", 0.5, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("dt", "time the bullet takes to get stuck", "s", 1e-4, above=0.0),
)


def _evaluated(m: Ball, block: Ball, v: Ball, mu: Ball, g: Ball, dt: Ball) -> Evaluated:
    """`distance` is how far the block slides on the rough region, `energy_change` that of the collision (J).

    The bullet is braked by a dashpot for the time dt, and then held fast; only then does the rough region begin, as in the exercise.
    """
    both = m + block
    common = m * v / both
    values = {
        "velocities": (common, common),
        "energy_change": -v * v * m * block / (2 * both),
        "distance": common * common / (2 * mu * g),
        "duration": common / (mu * g),
        "depth": v * (1 - Ball(-FADING).exp()) * dt / FADING,
        "peak_force": FADING * m * block / both * v / dt,
    }
    why = "a dashpot, then constant friction: each moves the bodies in closed form"
    return Evaluated("sticks", values, "piecewise exact", why)


def second_way(settings: Settings, tolerance: float) -> Run:
    m, block, v, mu, g, dt = numbers(settings, "m", "M", "v", "mu", "g", "dt")
    a, b = Body(m, (0.0,), (v,)), Body(block, (10.0 * v * dt + 1.0,), (0.0,))
    (bullet, stuck), _, error = state_after((a, b), (catching(m, block, dt),), dt, tolerance)
    sliding = Body(m + block, (0.0,), (stuck,))
    _, (way,), more = state_after((sliding,), (Friction(0, mu, g),), 2.0 * stuck / (mu * g), tolerance)
    lost = 0.5 * m * (bullet * bullet - v * v) + 0.5 * block * stuck * stuck
    observed: dict[str, Observed] = {"velocities": (bullet, stuck), "energy_change": lost, "distance": way}
    scales = {"velocities": v, "energy_change": m * v * v, "distance": 2.0 * way * v / stuck}
    return second_run(observed, 2.0 * max(error, more), scales=scales)


def filmed(settings: Settings) -> Film:
    m, block, v, mu, g, dt = numbers(settings, "m", "M", "v", "mu", "g", "dt")
    common = m * v / (m + block)
    slides = common / (mu * g) if mu else 1.0
    way = common * slides
    bodies = Body(m, (-way,), (v,), name="A"), Body(block, (0.0,), (0.0,), name=BLOCK)
    stops: Act = ((Friction(0, mu, g), Friction(1, mu, g)) if mu else (), 1.05 * slides)
    acts: list[Act] = [((), way / v), ((catching(m, block, dt),), dt), stops]
    return film(bodies, acts, radii=(0.04 * way, 0.16 * way))


SCENE = by_formulas(
    "a bullet gets stuck in a block that slides to rest",
    SETTINGS,
    _evaluated,
    second_way=second_way,
    film=filmed,
)
