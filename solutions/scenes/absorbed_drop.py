"""A body takes up a small drop, perhaps while a force pushes it (section 12.7)."""

from __future__ import annotations

from second_way import second_run, state_after

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.film import AGAIN, Film, film
from corollary.scenes.forces.bonds import FADING, catching
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.run import Run
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("m", "mass of the body", "kg", 2.0, above=0.0),
    Setting("dm", "mass of the drop", "kg", 0.4, above=0.0),
    Setting("v", "velocity of the body before", "m/s", 6.0),
    Setting("u", "velocity of the drop before", "m/s", -3.0),
    Setting("F", "force on the body from outside", "N", 0.0),
    Setting("t", "time for which they are watched, from the first touch on", "s", 1.0, above=0.0),
    Setting("dt", "time the drop takes to get caught", "s", 1e-9, above=0.0),
)


def _evaluated(m: Ball, dm: Ball, v: Ball, u: Ball, force: Ball, t: Ball, dt: Ball) -> Evaluated:
    """Velocities (body, drop) after the time t, the change of their total momentum, and the largest pull between them.

    The drop is dragged along by a dashpot. The relative velocity w obeys w' = F/m - (grip/mu) w, so it fades to F mu/(m grip): the
    force goes on to act on the body alone, and the drop lags behind by that much. The centre of mass gains F t/(m + dm).
    """
    total, rate = m + dm, FADING / dt
    lag = force / (m * rate)
    left = lag + (v - u - lag) * (-rate * t).exp()
    centre = (m * v + dm * u + force * t) / total
    grip = rate * m * dm / total
    values = {
        "velocities": (centre + dm / total * left, centre - m / total * left),
        "momentum_change": force * t,
        # The relative velocity only goes from the one to the other: the pull is largest at an end.
        "peak_force": grip * abs(v - u).max(abs(left)),
    }
    why = "a dashpot under a constant force moves both in closed form"
    return Evaluated("sticks", values, "piecewise exact", why)


def second_way(settings: Settings, tolerance: float) -> Run:
    m, dm, v, u, force, t, dt = numbers(settings, "m", "dm", "v", "u", "F", "t", "dt")
    # The dashpot's fading is followed only as long as it lasts; then they move as one.
    way = 10.0 * (abs(v) + abs(u) + abs(force) / m * t) * max(t, dt) + 1.0
    short = min(t, dt)
    a, b = Body(m, (0.0,), (v,)), Body(dm, (way,), (u,))
    push = ForceFunction(0, lambda at, x, w: (force,), smooth=True)
    pushed = (push,) if force else ()
    (body, drop), _, error = state_after((a, b), (catching(m, dm, dt), *pushed), short, tolerance)
    if t > short:
        # They go on as one, the drop as far behind as it is then.
        both = Body(m + dm, (0.0,), (body,))
        (later,), _, more = state_after((both,), (push,), t - short, tolerance)
        body, drop, error = later, drop + (later - body), max(error, more)
    change = m * (body - v) + dm * (drop - u)
    fastest = max(abs(body), abs(v), abs(drop), abs(u))
    scales = {"velocities": fastest, "momentum_change": (m + dm) * fastest}
    return second_run({"velocities": (body, drop), "momentum_change": change}, error, scales=scales)


def filmed(settings: Settings) -> Film | None:
    m, drop, v, u = numbers(settings, "m", "dm", "v", "u")
    if v <= u:
        return None
    dt = 0.01
    bodies = Body(m, (0.0,), (v,), name="A"), Body(drop, (v - u,), (u,), name="B")
    radii = (0.12 * (v - u), 0.07 * (v - u))
    touch = 1.0 - (radii[0] + radii[1]) / (v - u)
    return film(bodies, [((), touch), ((catching(m, drop, dt),), dt), ((), AGAIN)], radii=radii)


SCENE = by_formulas("a body takes up a small drop", SETTINGS, _evaluated, second_way=second_way, film=filmed)
