"""Steps in one mode, and the moment within one when something happens: found on its polynomial, met by a step that ends there."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.integrate import DOP853, Radau

from corollary.scenes.motion.guards import Guards
from corollary.scenes.motion.isolation import POINTS, certainly_positive, coefficients, first_fall, root_of
from corollary.scenes.motion.path import Stretch
from corollary.scenes.motion.sizes import Sizes
from corollary.scenes.motion.system import Mode, Slope, System
from corollary.scenes.run import GuardFailed

MOST_STEPS = 20_000
# After so many steps without an event it is asked whether they lead anywhere.
STEADY = 250
# scipy's own least.
LEAST_RELATIVE = 2.3e-14
One = Callable[[float, list[float]], float]


class Stepper:
    """Makes scipy's steps for one scene at one tolerance, and counts them."""

    def __init__(self, system: System, sizes: Sizes, tolerance: float) -> None:
        self.system, self.scene, self.sizes, self.tolerance = system, system.scene, sizes, tolerance
        self.steps, self.steady, self.stiff = 0, 0, False
        self.nearest = math.inf

    def solver(self, slope: Slope, y: list[float], lasts: float, first: float) -> DOP853 | Radau:
        """scipy's stepper from a state on, for at most so long (s), with a first step."""
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
            max_step=100.0 * self.sizes.long / self.sizes.fast if self.system.contacts else math.inf,
            # Motion that grows is known to a part of what it has become; what squeezes is resolved as finely wherever it has got to.
            rtol=LEAST_RELATIVE if self.system.contacts else max(self.tolerance, LEAST_RELATIVE),
            atol=np.array(allowed),  # pyright: ignore[reportArgumentType]
            first_step=min(first, lasts),
        )

    def first_step(self, mode: Mode, time: float, y: list[float]) -> float:
        """A step (s) to begin with: a hard contact would throw a stage of too long a one so far out that it felt nothing."""
        if any(mode.touching):
            return 0.02 * self.sizes.deep / self.sizes.fast
        gained = max((abs(a) for a in self.system.gains(time, y, y, mode.touching)), default=0.0)
        calm = self.sizes.fast / gained if gained else math.inf
        return 0.01 * min(calm, self.sizes.long / self.sizes.fast)

    def advance(self, solver: DOP853 | Radau, begun: float) -> None:
        """One step. Raises GuardFailed when there have been too many, or none is short enough."""
        self.steps += 1
        self.steady += 1
        if self.steps > MOST_STEPS:
            raise GuardFailed(
                f"{self.scene.name}: the end was not reached within {MOST_STEPS} steps, only {begun + solver.t:.6g} s. "
                "Watch for a shorter time, or soften what is stiff."
            )
        try:
            solver.step()
        except (OverflowError, ZeroDivisionError):
            solver.status = "failed"
        if solver.status == "failed" or not np.isfinite(solver.y).all():
            raise GuardFailed(
                f"{self.scene.name}: at {begun + solver.t:.6g} s a force grows without end; no step is short enough."
            )

    def too_slow(self, left: float, last: float) -> bool:
        """Whether steps as short as the last, one after the other without anything happening, lead nowhere in the time left (s).

        True once, for an implicit method to take over: what fades fast and then only follows slowly is stiff. Raises GuardFailed when
        that, too, is too slow.
        """
        if self.steady < STEADY or math.isinf(left) or left < (MOST_STEPS - self.steps) * last:
            return False
        self.steady = 0
        if not self.stiff:
            self.stiff = True
            return True
        raise GuardFailed(
            f"{self.scene.name}: with steps of {last:.2g} s the end, {left:.3g} s ahead, is out of reach. "
            "Watch for a shorter time, or soften what is stiff."
        )

    def first_event(self, guards: Guards, stretch: Stretch) -> tuple[int, float] | None:
        """Which guard falls first within a step, and after which part of it."""
        if not guards.names:
            return None
        begin, lasts = stretch.begin, stretch.lasts
        values = np.array(
            [
                guards.values(begin + x * lasts, y)
                for x, y in zip(POINTS.tolist(), stretch.sampled(), strict=True)
            ]
        ).T
        self.nearest = guards.nearest(values)
        first: tuple[int, float] | None = None
        for i in np.flatnonzero(~certainly_positive(coefficients(values))).tolist():
            one = guards.one(i)
            # Beyond what has been found to come first nothing matters, and forces may not be smooth there.
            ahead = 1.0 if first is None else first[1]
            if ahead == 0.0:
                break
            within = lambda x, one=one, ahead=ahead: one(begin + ahead * x * lasts, stretch.at(ahead * x))  # noqa: E731
            sampled = values[i] if ahead == 1.0 else np.array([within(x) for x in POINTS.tolist()])
            found = first_fall(within, sampled)
            if found is None:
                continue
            left, right = found
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
        solver = self.solver(lambda t, y: slope(offset + t, y), stretch.before, lasts, lasts)
        pieces: list[Stretch] = []
        before, last = stretch.before, 0.0
        while solver.status == "running":
            self.advance(solver, stretch.begin)
            pieces.append(
                Stretch(
                    stretch.begin + last,
                    float(solver.t) - last,
                    before,
                    solver.y.tolist(),
                    stretch.mode,
                    stretch.since,
                    solver.dense_output(),
                    last,
                )
            )
            before, last = pieces[-1].after, float(solver.t)
        return pieces
