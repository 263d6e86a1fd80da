"""Steps in one mode, and the moment within one when something happens: found on its polynomial, met by a step that ends there."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable

import numpy as np
from scipy.integrate import DOP853, Radau

from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.motion.equations_of_motion import Mode, Slope, System
from corollary.scenes.motion.modes import Guards
from corollary.scenes.motion.own_forces import refuse_failing
from corollary.scenes.motion.path import (
    POINTS,
    Stretch,
    bracketed,
    certainly_positive,
    coefficients,
    first_fall,
    root_of,
)
from corollary.scenes.motion.sizes import Sizes
from corollary.scenes.run import FINER, GuardFailed

# About a minute's, for all three runs together; and so many of those that follow a happening within as many steps, which cost more.
MOST_STEPS, MOST_HURRIED, SOON = 60_000, 20_000, 10
# After so many steps without an event it is asked whether they lead anywhere; where those before them were long enough, only after more:
# a short kick is over by then.
STEADY, PATIENT = 250, 2000
REMEDY = (
    "Watch for a shorter time, or let what swings or fades fastest do so more slowly (soften what is stiff); a force that jumps with the "
    "velocity, as dry friction does, is a Friction, a rough wall, or a Force with events."
)
# From this product of step and rate on, what fades decides how long an explicit step may be: beyond 6.1 it would grow (E. Hairer,
# S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, and the program DOP853), which the method's own estimate of its
# error takes too lightly. What fades is remembered from a smaller product on: soon it is too small to be seen in the slopes, and would
# still grow. So many steps at the edge call for an implicit method.
SEEN, FADES, EDGE, STIFF_STEPS = 1.0, 3.0, 5.0, 15
# An implicit step costs more than an explicit one: for so few it is not worth it. What fades may have become slow meanwhile (a slip that
# began): after so many of them, and twice as many each time that was in vain, explicit ones are tried again.
FEW_LEFT, TRY_AGAIN = 40, 20
# The golden ratio: multiplied by ten as often as one likes two first steps come nowhere near each other. And so many times what slips takes to stop.
APART, BRIEFEST = 0.618, 1e4
# No step is a larger part of the whole time, at a tolerance of 1e-6, and less at a finer one, as the order of eight has it: a run of a
# handful of steps may be off by more than its estimates say, and one that is asked for less has to be nearer.
WHOLE = 0.4
# scipy's own least.
LEAST_RELATIVE = 2.3e-14
One = Callable[[float, list[float]], float]


class Stepper:
    """Makes scipy's steps for one scene at one tolerance, and counts them: a `share` of the most is allowed."""

    def __init__(self, system: System, sizes: Sizes, tolerance: float, share: float = 1.0) -> None:
        self.system, self.scene, self.sizes, self.tolerance = system, system.scene, sizes, tolerance
        self.most = round(share * MOST_STEPS)
        self.steps, self.hurried, self.fades = 0, 0, False
        self.lately: deque[float] = deque(maxlen=STEADY)
        self.begin_anew()
        self.nearest = (math.inf, 0.0)
        self.longest = min(
            100.0 * sizes.long / sizes.fast if system.contacts else math.inf,
            WHOLE * (tolerance / 1e-6) ** 0.125 * (self.scene.until or math.inf),
        )
        self.falls = all(
            isinstance(force, Weight) for force in self.scene.forces if force not in self.scene.contacts
        )
        """Whether bodies that nothing touches fly along parabolas, which steps of any length follow exactly."""
        self.drags = [force for force in self.scene.forces if isinstance(force, Drag)]
        self.at_most = math.inf
        """How long (s) the next phase's first step may be."""

    def begin_anew(self) -> None:
        """Something has happened: nothing is known of how fast things fade now."""
        self.steady, self.held_down, self.rate, self.stiff = 0, 0, 0.0, False
        self.implicit, self.patience = 0, TRY_AGAIN
        self.seen = [0.0] * 3
        self.lately.clear()

    def solver(self, slope: Slope, y: list[float], lasts: float, first: float, mode: Mode) -> DOP853 | Radau:
        """scipy's stepper from a state on, for at most so long (s), with a first step; of any length where all fly freely, or fall."""
        free = self.falls and not any(mode.touching)
        count, spins = self.system.count, len(y) - 2 * self.system.count
        radius = max((b.radius for b in self.scene.bodies), default=0.0) or self.sizes.long
        # Not less than rounding makes of a place.
        near = max(self.tolerance * self.sizes.place, 8.0 * math.ulp(self.sizes.long))
        allowed = [near] * count + [self.tolerance * self.sizes.fast] * count
        allowed += [self.tolerance * self.sizes.fast / radius] * spins
        kind = Radau if self.stiff else DOP853
        return kind(
            slope,
            0.0,
            np.array(y),
            lasts,
            max_step=math.inf if free else self.longest,
            # Motion that grows is known to a part of what it has become; what squeezes is resolved as finely wherever it has got to.
            rtol=LEAST_RELATIVE if self.system.contacts else max(self.tolerance, LEAST_RELATIVE),
            atol=np.array(allowed),  # pyright: ignore[reportArgumentType]
            first_step=min(first, lasts),
        )

    def first_step(self, mode: Mode, time: float, y: list[float], slope: Slope) -> float:
        """A step (s) to begin with: a hard contact would throw a stage of too long a one so far out that it felt nothing."""
        if any(mode.touching):
            # The first step leaves a root behind, which its estimate of its error takes too lightly, and a run of another tolerance would
            # repeat: what it is off, of order 5/2 in its length with q = 3/2, is to be a part of what is allowed.
            part = min(1.0, (self.tolerance / 1e-8) ** 0.4)
            return 0.02 * part * self.sizes.deep / self.sizes.fast
        gained = max((abs(a) for a in self.system.gains(time, y, y, mode.touching)), default=0.0)
        if not math.isfinite(gained):
            refuse_failing(self.scene, time, y)
            raise GuardFailed(f"{self.scene.name}: at {time:.6g} s a force is not a finite number.")
        calm = self.sizes.fast / gained if gained else math.inf
        # Where nothing has happened, another method goes on from where the last one had got to.
        known = min(10.0 * self.lately[-1] if self.lately else math.inf, self.at_most)
        self.at_most = math.inf
        # Steps grow tenfold as long as their errors allow it: two runs that began alike would take the same ones, and share their errors.
        own = 0.01 * APART ** (math.log(self.tolerance) / math.log(FINER) % 2.0)
        brakes = max(map(abs, slope(0.0, np.array(y))[self.system.count : 2 * self.system.count]))
        stops = BRIEFEST / brakes * self.sizes.fast if brakes > 0.0 else math.inf
        return min(own * calm, own * self.sizes.long / self.sizes.fast, known, stops)

    def advance(self, solver: DOP853 | Radau, begun: float) -> None:
        """One step. Raises GuardFailed when there have been too many, or none is short enough."""
        self.steps += 1
        self.steady += 1
        self.hurried += self.steady <= SOON
        began, before = solver.t, solver.y
        if self.steps > self.most or self.hurried > MOST_HURRIED:
            raise GuardFailed(
                f"{self.scene.name}: the end was not reached within {self.steps - 1} steps, only {begun + solver.t:.6g} s. "
                + REMEDY
            )
        if isinstance(solver, DOP853) and (self.rate or self.drags):
            solver.max_step = min(self.longest, self._edge(), self._smooth_for(solver))
        try:
            solver.step()
        except (OverflowError, ZeroDivisionError):
            solver.status = "failed"
        self.lately.append(solver.t - began)
        if isinstance(solver, DOP853) and solver.status != "failed":
            self._hold_down(solver)
        if solver.status == "failed" or not np.isfinite(solver.y).all():
            refuse_failing(self.scene, begun + began, before.tolist())
            raise GuardFailed(
                f"{self.scene.name}: at {begun + solver.t:.6g} s a force grows without end; no step is short enough."
            )

    def _edge(self) -> float:
        """How long (s) a step may be for what fades."""
        return EDGE / self.rate if self.rate else math.inf

    def _smooth_for(self, solver: DOP853) -> float:
        """How long (s) drag is smooth; what passes the wind's velocity as near as steps resolve passes through it."""
        if not self.drags:
            return math.inf
        state, slope = solver.y.tolist(), solver.f.tolist()
        gained = max(map(abs, slope[self.system.count : 2 * self.system.count]))
        shortest = self.tolerance ** (1.0 / 3.0) * self.sizes.fast / gained if gained else math.inf
        return max(min(drag.smooth_for(self.scene, state, slope) for drag in self.drags), shortest)

    def _hold_down(self, solver: DOP853) -> None:
        """Learn from a step how fast things fade, as far as the last few have shown it, and whether that holds steps down."""
        # In motion that swings a single step may look the same.
        self.seen = [*self.seen[1:], fading(solver)]
        rate, lasted = min(self.seen), solver.t - (solver.t_old or 0.0)
        self.rate = max(0.9 * self.rate, rate if rate * lasted > SEEN else 0.0)
        if self.rate * lasted > FADES:
            self.fades = True
        if self.rate:
            self.held_down = max(self.held_down + (1 if solver.h_abs > self._edge() else -1), 0)

    def too_slow(self, left: float, stretch: Stretch) -> bool:
        """Whether to begin anew with another method, with so much time (s) left after a step.

        What fades fast and then only follows slowly is stiff: an implicit method takes over, until something happens. Raises
        GuardFailed when steps as short as the last ones, one after the other without anything happening, lead nowhere.
        """
        if self.held_down >= STIFF_STEPS and not self.stiff and left > FEW_LEFT * stretch.lasts:
            self.stiff, self.steady, self.held_down = True, 0, 0
            return True
        self.implicit += self.stiff
        if self.implicit == self.patience:
            self.stiff, self.implicit, self.patience = False, 0, 2 * self.patience
            self.held_down, self.rate, self.seen = 0, 0.0, [0.0] * 3
            return True
        if self.steady < STEADY or math.isinf(left):
            return False
        # Where a comet passes its star steps are short for a while.
        last = max(stretch.lasts, sum(self.lately) / len(self.lately))
        if left < self.left * last:
            return False
        done = (self.scene.until or 0.0) - left
        if self.steady < PATIENT and left * self.steps < self.left * done:
            return False
        raise GuardFailed(
            f"{self.scene.name}: with steps of {last:.2g} s the end, {left:.3g} s ahead, is out of reach. "
            + REMEDY
        )

    @property
    def left(self) -> int:
        """How many steps may still be made."""
        return self.most - self.steps

    def first_event(self, guards: Guards, stretch: Stretch) -> tuple[int, float] | None:
        """Which guard falls first within a step, and after which part of it."""
        if not guards.names:
            return None
        begin, lasts = stretch.begin, stretch.lasts
        states = stretch.sampled()
        values = np.array(
            [guards.values(begin + x * lasts, y) for x, y in zip(POINTS.tolist(), states, strict=True)]
        ).T
        self.nearest = guards.nearest(values, states)
        first: tuple[int, float] | None = None
        for i in np.flatnonzero(~certainly_positive(coefficients(values))).tolist():
            one = guards.one(i)
            # Beyond what has been found to come first nothing matters, and forces may not be smooth there.
            ahead = 1.0 if first is None else first[1]
            if ahead == 0.0:
                break
            within = lambda x, one=one, ahead=ahead: one(begin + ahead * x * lasts, stretch.at(ahead * x))  # noqa: E731
            several = lambda x, one=one, ahead=ahead: np.array(  # noqa: E731
                [
                    one(begin + part * lasts, y)
                    for part, y in zip((ahead * x).tolist(), stretch.states(ahead * x), strict=True)
                ]
            )
            found = first_fall(several, values[i] if ahead == 1.0 else several(POINTS))
            if found is None:
                continue
            left, right = bracketed(within, *found)
            part = left
            if left < right:
                above, below = within(left), within(right)
                if above > 0.0 >= below:
                    part = root_of(within, left, right)
                elif below > 0.0:
                    continue
            if first is None or part < 1.0:
                first = i, ahead * part
        return first

    def landing(self, one: One, stretch: Stretch, slope: Slope, part: float) -> float:
        """How long (s) the step lasts until the guard is zero, by Newton's method on steps that end there."""
        lasts, falling = part * stretch.lasts, self.falling(one, stretch, part)
        for _ in range(3):
            if lasts <= 0.0 or not falling:
                return max(lasts, 0.0)
            pieces = self.pieces(stretch, slope, lasts)
            off = one(stretch.begin + lasts, pieces[-1].after)
            change = off / falling
            if abs(change) > 0.01 * stretch.lasts:
                return lasts
            lasts = min(max(lasts + change, 0.0), stretch.lasts)
            if abs(change) <= 1e-15 * stretch.lasts:
                break
        return lasts

    def falling(self, one: One, stretch: Stretch, part: float) -> float:
        """How fast a guard falls there (per s)."""
        left, right = max(part - 1e-5, 0.0), min(part + 1e-5, 1.0)
        values = [one(stretch.begin + x * stretch.lasts, stretch.at(x)) for x in (left, right)]
        return max((values[0] - values[1]) / ((right - left) * stretch.lasts), 0.0)

    def pieces(self, stretch: Stretch, slope: Slope, lasts: float) -> list[Stretch]:
        """The step taken again, to end after `lasts` (s): one shorter step, or several where that is too long a one."""
        if lasts <= 0.0:
            return []
        offset = stretch.offset
        solver = self.solver(lambda t, y: slope(offset + t, y), stretch.before, lasts, lasts, stretch.mode)
        pieces: list[Stretch] = []
        before = stretch.before
        while solver.status == "running":
            self.advance(solver, stretch.begin)
            pieces.append(Stretch.made(solver, stretch.begin, before, stretch.mode, stretch.since))
            before = pieces[-1].after
        return pieces


def fading(solver: DOP853) -> float:
    """The rate (per s) of what fades fastest, from the two slopes at the end of a step."""
    if solver.t_old is None:
        return 0.0
    h, slopes = solver.t - solver.t_old, solver.K
    other = solver.y_old + h * (solver.A[-1, : len(slopes) - 2] @ slopes[:-2])
    allowed = np.asarray(solver.atol)
    apart = float(np.linalg.norm((solver.y - other) / allowed))
    return float(np.linalg.norm((slopes[-1] - slopes[-2]) / allowed)) / apart if apart else 0.0
