"""heyoka's Taylor integrator on the scenes it can follow: compiled once for each set of contacts, stopped at every switch.

Its evaluations are derivatives taken: steps times the order of the series.
"""

from __future__ import annotations

import importlib
import importlib.util
import math
from collections.abc import Callable
from typing import Any

from corollary.scenes.definition import one
from corollary.scenes.models.pair import Parting, after_parting, meet

from . import cradles, spheres
from .case import ONCE, Answer, Case, Route

MOST_EVENTS, MOST_STEPS = 100, 10_000


class NoSeries(ValueError):
    """Why heyoka cannot follow a scene."""


def route(case: Case) -> Route:
    """One run of the case at heyoka's own tolerance. Raises NoSeries without heyoka, or where the force has no series."""
    if importlib.util.find_spec("heyoka") is None:
        raise NoSeries("heyoka is not installed (pip install heyoka)")
    hy, settings = importlib.import_module("heyoka"), case.settings
    if case.ready == "cradle" and settings["q"] in (1.0, 2.0, 3.0):
        run = _cradle(hy, case, round(one(settings, "q")))
    elif case.ready == "spheres":
        run = _spheres(hy, one(settings, "eta"))
    elif case.ready == "atom":
        raise NoSeries("not written out for heyoka: its integrals are closed up to a quadrature")
    else:
        raise NoSeries(
            "a force with a broken power of the overlap has no Taylor series where the contact begins"
        )
    return Route("tolerance", ONCE, lambda _: run())


def _cradle(hy: Any, case: Case, q: int) -> Callable[[], Answer]:
    """In time, from one opening or closing to the next."""
    count, made = len(case.program.x), {}

    def integrator(touching: tuple[bool, ...]) -> Any:
        if touching not in made:
            x, v = (hy.make_vars(*[f"{letter}{i}" for i in range(count)]) for letter in "xv")
            gained = [0.0 * x[0]] * count
            for j, on in enumerate(touching):
                push = cradles.STIFFNESS / cradles.MASS * _power(x[j] - x[j + 1], q)
                if on:
                    gained[j], gained[j + 1] = gained[j] - push, gained[j + 1] + push
            system = [*zip(x, v, strict=True), *zip(v, gained, strict=True)]
            way = {True: hy.event_direction.negative, False: hy.event_direction.positive}
            events = [hy.t_event(x[j] - x[j + 1], direction=way[on]) for j, on in enumerate(touching)]
            made[touching] = hy.taylor_adaptive(system, state=[0.0] * (2 * count), t_events=events)
        return made[touching]

    def run() -> Answer:
        time, state, touching, steps = 0.0, [*case.program.x, *case.program.v], (True,) * (count - 1), 0
        for _ in range(MOST_EVENTS):
            follow = integrator(touching)
            follow.reset_cooldowns()
            follow.time, follow.state[:] = time, state
            outcome, _, _, done, *_ = follow.propagate_until(case.program.until, max_steps=MOST_STEPS)
            time, state, steps = follow.time, follow.state.copy(), steps + done * follow.order
            if outcome == hy.taylor_outcome.time_limit:
                break
            fired = -int(outcome) - 1
            touching = tuple(on != (j == fired) for j, on in enumerate(touching))
        return Answer(tuple(map(float, state[count:])), steps)

    return run


def _spheres(hy: Any, eta: float) -> Callable[[], Answer]:
    """On the regularised equations, where overlap = w^2 and dt = 2 w ds; it ends where w is zero again."""
    w, rate, spin, time, turn = hy.make_vars("w", "rate", "spin", "time", "turn")
    both = spheres.pair(eta)
    met = meet(both)
    assert met is not None
    r, drag = both.reach - w * w, eta / both.mass
    push = both.contact.k / both.mass * _power(w, 3) + drag * rate + spin**2 / r**3
    system = [
        (w, rate),
        (rate, -2.0 * w * push),
        (spin, -2.0 * drag * w * spin),
        (time, 2.0 * w),
        (turn, 2.0 * w * spin / r**2),
    ]
    start = [0.0, met.inward, met.spin, 0.0, 0.0]
    follow = hy.taylor_adaptive(
        system, state=start, t_events=[hy.t_event(w, direction=hy.event_direction.negative)]
    )

    def run() -> Answer:
        follow.reset_cooldowns()
        follow.time, follow.state[:] = 0.0, start
        _, _, _, steps, *_ = follow.propagate_until(10.0, max_steps=MOST_STEPS)
        _, outward, left, lasted, turned = map(float, follow.state)
        u, v = after_parting(
            both, met, Parting(turned, -outward, left, lasted, math.nan, math.nan, False, steps)
        )
        return Answer((0.5 - 0.5 * u, -0.5 * v, 0.5 + 0.5 * u, 0.5 * v), steps * follow.order)

    return run


def _power(base: Any, whole: int) -> Any:
    """By multiplications: heyoka's own power divides by its base, which is zero where a contact begins."""
    result = base
    for _ in range(whole - 1):
        result = result * base
    return result
