"""heyoka's Taylor series on a problem: compiled for each draw and mode before it is timed, stopped at every event."""

from __future__ import annotations

import importlib
import importlib.util
from functools import cache
from typing import Any

import numpy as np

from .problem import Found, Mode, Problem, TooDear

MOST_EVENTS, MOST_STEPS = 60, 20_000


class Taylor:
    """One problem at one tolerance; calling it makes the run. Evaluations are derivatives taken: steps times the order."""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        self.problem, self.tolerance = problem, tolerance
        self.hy = importlib.import_module("heyoka")
        self.made: dict[Mode, Any] = {}

    def integrator(self, mode: Mode) -> Any:
        if mode not in self.made:
            hy, problem = self.hy, self.problem
            assert problem.series is not None
            y = hy.make_vars(*[f"y{i}" for i in range(problem.start.size)])
            system = [
                (name, 0.0 * y[0] + right) for name, right in zip(y, problem.series(hy, y, mode), strict=True)
            ]
            ways = {1: hy.event_direction.positive, -1: hy.event_direction.negative}
            events = [
                hy.t_event(event.value(y), direction=ways[event.direction]) for event in problem.events(mode)
            ]
            start = problem.start.tolist()
            self.made[mode] = hy.taylor_adaptive(
                system, state=start, tol=max(self.tolerance, 1e-15), t_events=events
            )
        return self.made[mode]

    def __call__(self) -> Found:
        hy, problem = self.hy, self.problem
        time, y, mode, spent = 0.0, problem.start.copy(), problem.mode, 0
        seen: list[np.ndarray] = []
        for _ in range(MOST_EVENTS):
            if mode == 0 and problem.family == "friction":
                seen += [y.copy() for t in problem.times if t > time]
                break
            follow = self.integrator(mode)
            if problem.events(mode):
                follow.reset_cooldowns()
            follow.time, follow.state[:] = time, y
            outcome, _, _, steps, output, *_ = follow.propagate_until(
                problem.until, c_output=True, max_steps=MOST_STEPS
            )
            last = follow.time
            seen += [np.array(output(t)) for t in problem.times if time < t <= last]
            time, y, spent = last, follow.state.copy(), spent + steps * follow.order
            if outcome == hy.taylor_outcome.time_limit:
                break
            if int(outcome) >= 0 or int(outcome) < -1000:
                raise ArithmeticError(str(outcome))
            y, mode = problem.events(mode)[-int(outcome) - 1].after(y, mode)
        else:
            raise TooDear(f"more than {MOST_EVENTS} events")
        return Found(problem.velocity(seen[-1]), np.array([problem.place(s) for s in seen]), spent)


@cache
def installed() -> bool:
    return importlib.util.find_spec("heyoka") is not None
