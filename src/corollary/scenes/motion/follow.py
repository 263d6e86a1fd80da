"""The one loop: scipy's steps in a mode until something happens, which is met exactly, and what holds after it."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from dataclasses import replace
from itertools import combinations

import numpy as np

from corollary.scenes.body import Constraint, State
from corollary.scenes.motion.conserved import energy, keeps_energy, kinetic, never_meets, used_up
from corollary.scenes.motion.equations_of_motion import Mode, Slope, System
from corollary.scenes.motion.modes import Guards, Moment, drifted
from corollary.scenes.motion.own_forces import overlooked
from corollary.scenes.motion.path import Happening, Stretch, Trajectory
from corollary.scenes.motion.sizes import FINEST_OVERLAP, Sizes, least_squeeze, sizes_of
from corollary.scenes.motion.stepper import Stepper
from corollary.scenes.progress import tell
from corollary.scenes.run import BadSetting, GuardFailed, NoForce
from corollary.scenes.scene import Conserves, Scene, overlap, start_of

# Forces on what is lighter (kg) are below the numbers that have all their digits.
LIGHTEST = 1e-305
# A speed along a rod that is such a part of those of its ends is what rounding leaves: it is taken out.
PARTING = 1e-6
# Rods that hold the same motion are told by singular values.
DEPENDENT = 1e-9


def refuse_bad_start(system: System, start: State, sizes: Sizes) -> None:
    """Raises BadSetting where places cannot show what happens, or something is where it cannot be."""
    name = system.scene.name
    if system.contacts and sizes.deep < FINEST_OVERLAP * math.ulp(sizes.long):
        raise BadSetting(
            f"{name}: bodies squeeze each other by about {sizes.deep:.1g} m, which places of {sizes.long:.1g} m do not show. "
            "Make contacts softer, or bodies less unequal, or move them nearer to the origin."
        )
    if light := [body.mass for body in system.scene.bodies if body.mass < LIGHTEST]:
        raise BadSetting(
            f"{name}: of forces on a body of {min(light):.3g} kg a computer holds too few digits; {LIGHTEST:g} kg or more is right."
        )
    for constraint in system.constraints:
        gap = constraint.gap(0.0, start)
        if gap < -sizes.gap or (constraint.two_sided and gap > 1e-9 * sizes.long):
            raise BadSetting(
                f"{name}: {constraint.name} starts {abs(gap):.3g} m where it cannot be; move it."
            )
        if constraint.two_sided:
            _refuse_parting(system, start, sizes, constraint)
    _refuse_locked(system, start)


def _refuse_parting(system: System, start: State, sizes: Sizes, rod: Constraint) -> None:
    """Raises BadSetting where the ends of a rod leave or near each other by more than rounding of what moves them."""
    scene, axes = system.scene, system.scene.axes
    gained = system.gains(0.0, start, start)
    fast = sum(math.hypot(*scene.bodies[i].velocity) for i in rod.bodies)
    pulled = max(abs(gained[axes * i + axis]) for i in rod.bodies for axis in range(axes))
    long = max(
        math.dist(scene.bodies[a].place, scene.bodies[b].place) for a, b in combinations(rod.bodies, 2)
    )
    rate = system.rate(0.0, start, rod)
    if abs(rate) > PARTING * (fast + math.sqrt(pulled * long)) + sizes.speed:
        raise BadSetting(
            f"{scene.name}: the ends of {rod.name} {'part' if rate > 0.0 else 'near each other'} with {abs(rate):.3g} m/s at the start, "
            "which it cannot let them do; give them velocities that agree along it."
        )


def _refuse_locked(system: System, start: State) -> None:
    """Raises BadSetting where rods hold one motion twice: how they share their forces rigid bodies leave open."""
    rods = [c for c in system.constraints if c.two_sided]
    movable = system.inverse(0.0) > 0.0
    if len(rods) < 2 or not movable.any():
        return
    rows = np.array([c.row(0.0, start) for c in rods])[:, movable]
    if np.linalg.matrix_rank(rows, DEPENDENT * float(np.abs(rows).max())) < len(rods):
        names = ", ".join(c.name for c in rods)
        raise BadSetting(
            f"{system.scene.name}: {names} hold the same motion more than once, and what each of them takes is open; take one away."
        )


def hit_in_doubt(system: System, path: Trajectory, mode: Mode, slow: float) -> bool:
    """Whether a hit is so near before or after the end that errors decide if velocities are those of before or after it."""
    time, y = path.time, path.state
    return any(
        status == "off" and abs(c.gap(time, y)) < path.near and abs(system.rate(time, y, c)) > slow
        for c, status in zip(system.constraints, mode.held, strict=True)
    )


# What moves by errors of so many steps is at rest.
NO_SPEED = 30.0
# So many happenings at one moment are no physics: forces that call each other out.
MOST_AT_ONCE = 50
# A kick bends the polynomials of a dozen steps, what is stiff those of all: after so many a bent one is no sign of a kick.
MOST_AGAIN = 100


class Follower:
    """A scene followed from its start to `until`, or until nothing touches and nothing will. See `follow`."""

    def __init__(self, scene: Scene, tolerance: float, share: float = 1.0, less: float = 0.0) -> None:
        self.scene, self.tolerance = scene, tolerance
        self.system = System(scene)
        if scene.until is None and not (scene.contacts == scene.forces and len(scene.bodies) > 1):
            raise BadSetting(
                f"{scene.name}: only contacts between bodies come to an end by themselves; say until when to watch, until=…."
            )
        self.path = Trajectory(self.system.count, state=start_of(scene))
        self.at_once, self.again = 0, 0
        self.sizes = sizes_of(self.system, tolerance)
        if less and Conserves.ENERGY not in scene.conserves:
            # Where energy is conserved nothing forgets how it began, and hits stay as they are.
            self.system.constraints = [replace(c, less=less) for c in self.system.constraints]
        self.path.allowed, self.path.near = tolerance * self.sizes.place, self.sizes.doubt
        self.path.fast, self.path.long = self.sizes.fast, self.sizes.long
        self.path.deep = self.sizes.deep if self.system.contacts else math.inf
        self.path.shallow = least_squeeze(self.system, self.sizes.fast)
        self.steps = Stepper(self.system, self.sizes, tolerance, share)
        refuse_bad_start(self.system, self.path.state, self.sizes)
        self.energy: float | None = None

    def run(self) -> Trajectory:
        """The whole path. Raises GuardFailed when it cannot be followed, or something impossible happens on the way."""
        scene, path = self.scene, self.path
        mode = self._begin()
        while not self._over():
            before, mode = path.time, self._phase(mode)
            self.at_once = self.at_once + 1 if path.time - before <= 1e-14 * max(path.time, 1e-300) else 0
            if self.at_once > MOST_AT_ONCE:
                raise GuardFailed(
                    f"{scene.name}: at {path.time:.6g} s things happen without end and no time passes.",
                    finer=True,
                )
        path.mode, path.evaluations, path.fades = mode, self.system.evaluations, self.steps.fades
        if hit_in_doubt(self.system, path, mode, self.sizes.speed):
            path.graze(path.time)
        return path

    def _begin(self) -> Mode:
        y = self.path.state
        touching = tuple(self._touches_at_start(a, b) for _, a, b in self.system.contacts)
        slope = self.system.gains(0.0, y, y)
        sides: list[float] = []
        for event in self.system.events:
            value = event.value(y)
            if value == 0.0:
                count, h = self.system.count, 1e-8 * self.sizes.long / self.sizes.fast
                ahead = [x + h * v for x, v in zip(y[:count], y[count:], strict=False)]
                value = event.value([*ahead, *(v + h * a for v, a in zip(y[count:], slope, strict=True))])
            sides.append(math.copysign(1.0, value))
        return self._decide(Moment(self.system, 0.0, list(y), self.sizes), touching, tuple(sides))

    def _touches_at_start(self, a: int, b: int) -> bool:
        depth, growing = overlap(self.scene, self.path.state, a, b)
        return depth > self.sizes.gap or (abs(depth) <= self.sizes.gap and growing > 0.0)

    def _decide(self, moment: Moment, touching: tuple[bool, ...], sides: tuple[float, ...]) -> Mode:
        path = self.path
        try:
            mode = moment.decided(touching, sides)
        except GuardFailed as error:
            raise GuardFailed(f"{self.scene.name}: {error}") from None
        path.state = moment.y
        if moment.dropped:
            path.rests.append(ends := path.time + moment.lasts)
            path.dropped = max(path.dropped, moment.dropped * (ends > (self.scene.until or math.inf)))
        # What is watched is each stretch between hits: these may cost energy.
        self.energy = energy(self.scene, path.time, path.state) if keeps_energy(self.scene, mode) else None
        return mode

    def _left(self) -> float:
        return math.inf if self.scene.until is None else self.scene.until - self.path.time

    def _over(self) -> bool:
        if self.scene.until is not None:
            return self._left() <= 1e-15 * self.scene.until
        slow = NO_SPEED * self.tolerance * self.sizes.fast if self.path.stretches else 0.0
        if not never_meets(self.scene, self.path.state, slow):
            return self._asleep()
        if not never_meets(self.scene, self.path.state):  # it would take for ever, and is taken for rest
            self.path.dropped = max(self.path.dropped, 2.0 * slow)
        return True

    def _asleep(self) -> bool:
        """Whether damped contacts have used up what they had: bodies touch, but nothing moves or pushes any more."""
        path = self.path
        if not path.stretches or keeps_energy(self.scene, path.stretches[-1].mode):
            return False
        path.settled = used_up(self.scene, path.time, path.state, self.tolerance, self.sizes.fast)
        return path.settled

    def _phase(self, mode: Mode) -> Mode:
        """Steps in one mode until something happens; the mode after it."""
        path, system = self.path, self.system
        begun, since = path.time, list(path.state)
        guards, slope = Guards(system, mode, since, begun, self.sizes), system.slope(mode, since, begun)
        solver = self.steps.solver(
            slope, since, self._left(), self.steps.first_step(mode, begun, since, slope), mode
        )
        before = since
        while True:
            self.steps.advance(solver, begun)
            stretch = Stretch.made(solver, begun, before, mode, since)
            if overlooked(self.scene, stretch, self.sizes.fast, self.tolerance, self.again < MOST_AGAIN):
                self.again += 1
                self.steps.at_most = 0.5 * stretch.lasts
                return mode
            met = self.steps.first_event(guards, stretch)
            if self.steps.nearest[0] < path.near:
                path.graze(stretch.begin + self.steps.nearest[1] * stretch.lasts)
            if met is not None:
                return self._met(guards, stretch, slope, *met)
            self._add(stretch)
            before = path.state
            if solver.status == "finished":
                path.time = self.scene.until if self.scene.until is not None else path.time
                return mode
            over = self.scene.until is None and self._over()
            if over or self.steps.too_slow(self._left(), stretch):
                return mode
            if drifted(system, path.time, path.state, mode, self.sizes, 0.1 * self.tolerance):
                now = Moment(system, path.time, list(path.state), self.sizes, mode)
                return self._decide(now, mode.touching, mode.sides)

    def _met(self, guards: Guards, stretch: Stretch, slope: Slope, index: int, part: float) -> Mode:
        """Go to where a guard falls, exactly: the step is taken again to end there; then what follows from it."""
        one, guard = guards.one(index), guards.names[index]
        if guards.undecided(guard, stretch):
            raise GuardFailed(
                f"{self.scene.name}: from {stretch.begin:.6g} s on bodies stay where a force jumps (both ends of a spring at one place, a body "
                "on the edge of a well): which way it acts is not decided. Give the bodies radii, or let them pass."
            )
        lasts = self.steps.landing(guards.landing(index), stretch, slope, part)
        pieces = self.steps.pieces(stretch, slope, lasts)
        if guard.kind == "event" or (guard.kind == "break" and not pieces):
            # The law beyond is to be met by the next step: no event is left on its own edge, and what a force that sets in abruptly
            # breaks loose is to feel it.
            ahead = 1e-16 * max(stretch.lasts, 1e-300)
            while ahead < 1e-3 * stretch.lasts:
                end = pieces[-1] if pieces else stretch
                state = end.after if pieces else stretch.before
                if one(stretch.begin + lasts, state) < 0.0:
                    break
                lasts, ahead = lasts + ahead, 4.0 * ahead
                pieces = self.steps.pieces(stretch, slope, lasts)
        for piece in pieces:
            self._add(piece)
        speed, near = self.steps.falling(one, stretch, part), self.tolerance * self.sizes.place
        slack = (near + 16.0 * math.ulp(self.sizes.long)) / speed if speed else 0.0
        self.steps.begin_anew()
        what, glued = f"{guard.kind} {guard.number}", guards.together(guard, [self.path.state])
        self.path.happenings.append(Happening(what, self.path.time, len(self.path.stretches), slack, glued))
        return self._after(guards, index)

    def _after(self, guards: Guards, index: int) -> Mode:
        """What follows when a guard has fallen. Raises GuardFailed or BadSetting for what is impossible."""
        path, mode, guard = self.path, guards.mode, guards.names[index]
        touching, sides = list(mode.touching), list(mode.sides)
        moment = Moment(self.system, path.time, list(path.state), self.sizes, mode)
        match guard.kind:
            case "touch":
                touching[guard.number] = not touching[guard.number]
            case "soft":
                raise BadSetting(
                    "The spheres are so soft that they pass through each other; raise k, or lower the speed."
                )
            case "overlap":
                raise GuardFailed(
                    f"{self.scene.name}: at {path.time:.6g} s {guard.name} begin to overlap and no contact acts between them. "
                    "Give them one, or radius zero, or name them in passes=…"
                )
            case "event":
                event, axes = self.system.events[guard.number], self.scene.axes
                if event.turn is None:
                    sides[guard.number] = -sides[guard.number]
                else:
                    start = self.system.count + axes * event.body
                    moment.y[start : start + axes] = event.turn(moment.y)
            case "release":
                moment.barred = frozenset({guard.number})
            case "break":
                moment.broken = guards.broken(guard.number, path.time, path.state)
            case "stop":
                moment.stopped = frozenset({guard.number})
            case "hit":
                pass
        return self._decide(moment, tuple(touching), tuple(sides))

    def _add(self, stretch: Stretch) -> None:
        path = self.path
        path.stretches.append(stretch)
        path.state, path.time = stretch.after, stretch.begin + stretch.lasts
        if self.scene.until is not None:
            tell(min(path.time / self.scene.until, 1.0))
        if self.energy is None:
            return
        now = energy(self.scene, path.time, path.state)
        light = min((b.mass for b in self.scene.bodies if not math.isinf(b.mass)), default=0.0)
        size = max(abs(self.energy), kinetic(self.scene, path.time, path.state), light * self.sizes.fast**2)
        allowed = 1e4 * self.tolerance * max(1.0, self.sizes.place / self.sizes.deep)
        allowed += 1e-13 * len(path.stretches)
        if abs(now - self.energy) > allowed * size:
            raise GuardFailed(
                f"{self.scene.name}: the energy changed by {(now - self.energy) / size:.1e} of itself; {allowed:.1e} is allowed."
                + " Or is a potential not that of its function?"
                * any(f.may_be_brief for f in self.scene.forces),
                finer=True,
            )


def follow(scene: Scene, tolerance: float, share: float = 1.0, less: float = 0.0) -> Trajectory:
    """The scene from its start to `until`, or until nothing touches and nothing will.

    Hits give back up to a part `less` less.
    `tolerance` is the error allowed to a step, relative to the size of velocities and places (or overlaps); a `share` of all steps is allowed.
    With an `until` each step tells how far it has got (`corollary.scenes.progress`).
    Raises BadSetting for a start that is impossible, GuardFailed when energy is lost, bodies overlap without a force, no forces of
    rigid bodies are consistent, or the end is not reached.
    """
    try:
        return Follower(scene, tolerance, share, less).run()
    except NoForce as error:
        raise GuardFailed(str(error)) from error
    except (OverflowError, ZeroDivisionError, ValueError, np.linalg.LinAlgError) as error:
        if isinstance(error, BadSetting):
            raise
        raise GuardFailed(
            f"{scene.name}: numbers leave the range of a computer on the way; choose milder masses, forces or speeds."
        ) from None
