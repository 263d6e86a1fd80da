"""heyoka's Taylor integrator on the scenes it can follow: compiled once for each set of contacts, stopped at every switch."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from corollary.scene.model.pair import Parting, after_parting, meet
from corollary.scene.trade import cradles, spheres
from corollary.scene.trade.case import Answer, Case

MOST_EVENTS = 100


def taylor_of(case: Case) -> Callable[[], Answer]:
    """One run of the case. Raises ImportError without heyoka, NotImplementedError where the force has no Taylor series."""
    import heyoka as hy

    if case.ready == "cradle":
        q = float(case.settings["q"])  # pyright: ignore[reportArgumentType]
        if q != round(q):
            raise NotImplementedError("overlap^q has no Taylor series where a contact begins")
        return _cradle(hy, case, round(q))
    return _spheres(hy, float(case.settings["eta"]))  # pyright: ignore[reportArgumentType]


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
            outcome, _, _, done, *_ = follow.propagate_until(case.program.until)
            time, state, steps = follow.time, follow.state.copy(), steps + done
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
        (w, rate), (rate, -2.0 * w * push), (spin, -2.0 * drag * w * spin), (time, 2.0 * w), (turn, 2.0 * w * spin / r**2),
    ]  # fmt: skip
    start = [0.0, met.inward, met.spin, 0.0, 0.0]
    follow = hy.taylor_adaptive(system, state=start, t_events=[hy.t_event(w, direction=hy.event_direction.negative)])

    def run() -> Answer:
        follow.reset_cooldowns()
        follow.time, follow.state[:] = 0.0, start
        _, _, _, steps, *_ = follow.propagate_until(10.0)
        _, outward, left, lasted, turned = map(float, follow.state)
        u, v = after_parting(both, met, Parting(turned, -outward, left, lasted, math.nan, math.nan, False, steps))
        return Answer((0.5 - 0.5 * u, -0.5 * v, 0.5 + 0.5 * u, 0.5 * v), steps)

    return run


def _power(base: Any, whole: int) -> Any:
    """By multiplications: heyoka's own power divides by its base, which is zero where a contact begins."""
    result = base
    for _ in range(whole - 1):
        result = result * base
    return result
