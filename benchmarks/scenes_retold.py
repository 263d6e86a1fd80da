"""Random scenes of one's own, each told twice: in other units, mirrored, moved, its bodies in another order, at another tolerance.

    python benchmarks/scenes_retold.py [--scenes 1000] [--seed 1] [--seconds 900]

No reference is needed: nature does not know how a scene is written down. Two answers that are farther apart than both state together
are a wrong one, and so is a scene that is refused one way and answered the other. Whatever is not agreed upon is printed with the number of
its scene (`--only`). A run with anything wrong ends with status 1.
"""

from __future__ import annotations

import argparse
import math
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from random import Random

from corollary.scenes.forces.absorption import Absorption
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.drag import Drag
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.inverse_square import InverseSquare
from corollary.scenes.forces.rod import Rod, String
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.thrust import Thrust
from corollary.scenes.forces.wall import HardWall, Shift
from corollary.scenes.forces.weight import Weight
from corollary.scenes.plan import play
from corollary.scenes.run import BadSetting, GuardFailed, Observable, Run, components
from corollary.scenes.scene import Body, Force, Scene

ALWAYS = {Observable.VELOCITIES, Observable.TRAJECTORY}
OF_CONTACTS = {Observable.LARGEST_OVERLAP, Observable.PEAK_FORCE, Observable.DURATION}
Vector = tuple[float, ...]


def composed(rng: Random) -> Scene:
    """One to four bodies and whatever may act on them, in one dimension or two."""
    axes, count = rng.choice([1, 2, 2]), rng.randint(1, 4)
    bodies: list[Body] = []
    while len(bodies) < count:
        place = tuple(rng.uniform(-2.0, 2.0) for _ in range(axes))
        # On a line points would pass each other, and a ball and a point that lie on a floor just touch.
        radius = rng.choice([0.0, rng.uniform(0.05, 0.3)]) if axes == 2 else rng.uniform(0.05, 0.3)
        if any(math.dist(place, other.place) < radius + other.radius + 0.05 for other in bodies):
            continue
        held = rng.random() < 0.15 and len(bodies) + 1 < count
        still = held or rng.random() < 0.3
        velocity = (0.0,) * axes if still else tuple(rng.uniform(-3.0, 3.0) for _ in range(axes))
        spin = rng.choice([0.0, rng.uniform(-9.0, 9.0)]) if axes == 2 and radius and not held else 0.0
        mass = math.inf if held else 10.0 ** rng.uniform(-1.0, 1.0)
        bodies.append(Body(mass, place, velocity, radius, spin=spin))
    loose = [i for i, body in enumerate(bodies) if not math.isinf(body.mass)]
    forces: list[Force] = [
        Contact(10.0 ** rng.uniform(2.0, 6.0), rng.choice([1.0, 1.5]), rng.choice([0.0, 2.0]))
    ]
    if axes == 2 and rng.random() < 0.3:
        forces[0] = replace(forces[0], mu=rng.uniform(0.05, 0.6))
    if rng.random() < 0.15:
        forces.append(_burning(rng, bodies, loose, axes))
    if rng.random() < 0.6:
        forces.append(Weight(9.8))
    if rng.random() < 0.6:
        forces += _walls(rng, axes)
    for _ in range(rng.randint(0, 3)):
        forces.append(
            _between(rng, bodies)
            if len(bodies) > 1 and rng.random() < 0.5
            else _on(rng, rng.choice(loose), axes)
        )
    return Scene(_agreeing(bodies, forces), tuple(forces), until=rng.uniform(0.2, 2.0))


def _agreeing(bodies: Sequence[Body], forces: Sequence[Force]) -> tuple[Body, ...]:
    """The bodies with velocities that their rods allow, one rod after the other until all agree."""
    found = list(bodies)
    rods = [force.ends for force in forces if isinstance(force, Rod)]
    for a, b in rods * 500:
        loose = [i for i in (a, b) if not math.isinf(found[i].mass)]
        apart = [x - y for x, y in zip(found[b].place, found[a].place, strict=True)]
        relative = [v - u for v, u in zip(found[b].velocity, found[a].velocity, strict=True)]
        share = sum(x * v for x, v in zip(apart, relative, strict=True)) / sum(x * x for x in apart)
        for i in loose:
            part = share / len(loose) * (1.0 if i == b else -1.0)
            moved = tuple(v - part * x for x, v in zip(apart, found[i].velocity, strict=True))
            found[i] = replace(found[i], velocity=moved)
    return tuple(found)


def _walls(rng: Random, axes: int) -> list[Force]:
    up = (0.0,) * (axes - 1) + (1.0,)
    mu = rng.choice([0.0, rng.uniform(0.05, 0.7)]) if axes == 2 else 0.0
    static = rng.choice([None, 1.3 * mu])
    plate = _plate(rng) if rng.random() < 0.2 else None
    back = rng.choice([0.0, 0.5, rng.uniform(0.1, 1.0), 1.0])
    walls: list[Force] = [HardWall(up, -2.5, back, mu, static, moves=plate)]
    if rng.random() < 0.4:
        angle = rng.uniform(2.0, 4.3)
        normal = (math.cos(angle), math.sin(angle)) if axes == 2 else (-1.0,)
        walls.append(
            HardWall(normal, -4.0, rng.uniform(0.1, 1.0), velocity=rng.choice([0.0, rng.uniform(-0.5, 0.5)]))
        )
    return walls


def _plate(rng: Random) -> Shift:
    """A floor that swings, or jumps up once."""
    high, pace, lasts, when = (
        rng.uniform(0.01, 0.2),
        rng.uniform(3.0, 60.0),
        10.0 ** rng.uniform(-2.5, -0.5),
        rng.uniform(0.1, 1.0),
    )
    if rng.random() < 0.5:

        def swings(t: float) -> tuple[float, float, float]:
            s, c = math.sin(pace * t), math.cos(pace * t)
            return -2.5 + high * s, high * pace * c, -high * pace * pace * s

        return swings
    high *= min(1.0, 10.0 * lasts)

    def jumps(t: float) -> tuple[float, float, float]:
        s = (t - when) / lasts
        now = high * math.exp(-s * s)
        return -2.5 + now, -2.0 * s / lasts * now, (4.0 * s * s - 2.0) / lasts**2 * now

    return jumps


def _burning(rng: Random, bodies: Sequence[Body], loose: Sequence[int], axes: int) -> Force:
    i = rng.choice(loose)
    way, rate = tuple(rng.uniform(-9.0, 9.0) for _ in range(axes)), bodies[i].mass * rng.uniform(0.05, 0.3)
    return Thrust(i, way, rate) if rng.random() < 0.5 else Absorption(i, way, rate)


def _between(rng: Random, bodies: Sequence[Body]) -> Force:
    a, b = rng.sample(range(len(bodies)), 2)
    apart = math.dist(bodies[a].place, bodies[b].place)
    at_rest = math.isinf(bodies[a].mass) and math.isinf(bodies[b].mass)
    match rng.choice(["spring", "string", "rod", "attraction"]):
        case "string" if not at_rest:
            return String(
                (a, b), apart * rng.uniform(1.0, 1.5), rng.choice([0.0, 0.0, rng.uniform(0.1, 1.0)])
            )
        case "rod" if not at_rest and len(bodies[a].place) == 2:
            return Rod((a, b))
        case "attraction":
            return InverseSquare((a, b), rng.uniform(-5.0, 5.0))
        case _:
            return Spring(
                (a, b), 10.0 ** rng.uniform(0.0, 3.0), apart * rng.uniform(0.5, 1.5), rng.choice([0.0, 0.5])
            )


def _on(rng: Random, i: int, axes: int) -> Force:
    wind = tuple(rng.uniform(-1.0, 1.0) for _ in range(axes))
    match rng.choice(["drag", "friction", "function"]):
        case "drag":
            return Drag(i, rng.choice([0.0, 0.3]), rng.choice([0.0, 0.2]), rng.choice([(), wind]))
        case "friction":
            mu = rng.uniform(0.05, 0.8)
            return Friction(i, mu, static=rng.choice([None, 1.3 * mu]), belt=rng.choice([(), wind]))
        case _ if rng.random() < 0.3:
            push, when, lasts = rng.uniform(-3.0, 3.0), rng.uniform(0.0, 1.0), 10.0 ** rng.uniform(-2.5, -1.0)
            return ForceFunction(
                i, lambda t, x, v: tuple(push / lasts * math.exp(-(((t - when) / lasts) ** 2)) for _ in x)
            )
        case _:
            size, pace, stiff = rng.uniform(-9.0, 9.0), rng.uniform(1.0, 20.0), rng.uniform(0.0, 5.0)
            return ForceFunction(
                i, lambda t, x, v: tuple(size * math.sin(pace * t + j) - stiff * c for j, c in enumerate(x))
            )


@dataclass(frozen=True, slots=True)
class Telling:
    """Units as shares of the SI's; the first axis mirrored or not; moved by `shift` (m) before; which body comes first, second, …"""

    length: float
    time: float
    mass: float
    mirrored: bool
    shift: Vector
    order: tuple[int, ...]

    @property
    def force(self) -> float:
        return self.mass * self.length / self.time**2

    @property
    def speed(self) -> float:
        return self.length / self.time

    def turned(self, vector: Sequence[float], unit: float = 1.0) -> Vector:
        """A vector that is no place."""
        sign = -1.0 if self.mirrored else 1.0
        return tuple(unit * (sign * c if axis == 0 else c) for axis, c in enumerate(vector))

    def placed(self, place: Sequence[float]) -> Vector:
        return self.turned([x + s for x, s in zip(place, self.shift, strict=True)], self.length)

    def place_before(self, told: Sequence[float]) -> Vector:
        return tuple(x / self.length - s for x, s in zip(self.turned(told), self.shift, strict=True))

    def number(self, i: int) -> int:
        return self.order.index(i)

    def body(self, body: Body) -> Body:
        hand = -1.0 if self.mirrored and len(body.place) == 2 else 1.0
        return Body(
            body.mass * self.mass,
            self.placed(body.place),
            self.turned(body.velocity, self.speed),
            body.radius * self.length,
            spin=hand * body.spin / self.time,
        )

    def told(self, force: Force) -> Force:
        drag, stiff = self.mass / self.time, self.mass / self.time**2
        match force:
            case Contact():
                return replace(force, k=force.k * self.force / self.length**force.q, eta=force.eta * drag)
            case Weight(g):
                return Weight(g * self.length / self.time**2)
            case HardWall():
                normal = self.turned(force.normal)
                farther = sum(n * s for n, s in zip(force.normal, self.shift, strict=True))
                moves = force.moves

                def plate(t: float) -> tuple[float, float, float]:
                    assert moves
                    place, speed, gained = moves(t / self.time)
                    return (
                        (place + farther) * self.length,
                        speed * self.speed,
                        gained * self.speed / self.time,
                    )

                return replace(
                    force,
                    normal=normal,
                    offset=(force.offset + farther) * self.length,
                    velocity=force.velocity * self.speed,
                    moves=plate if moves else None,
                )
            case Spring():
                ends = self.number(force.ends[0]), self.number(force.ends[1])
                return Spring(ends, force.k * stiff, force.length * self.length, force.damping * drag)
            case Rod() | String():
                length = None if force.length is None else force.length * self.length
                return replace(
                    force, ends=(self.number(force.ends[0]), self.number(force.ends[1])), length=length
                )
            case InverseSquare(ends, strength):
                return InverseSquare(
                    (self.number(ends[0]), self.number(ends[1])), strength * self.force * self.length**2
                )
            case Drag(i, linear, quadratic, wind):
                quadratic *= self.mass / self.length
                return Drag(self.number(i), linear * drag, quadratic, self.turned(wind, self.speed))
            case Thrust(i, relative, burn):
                return Thrust(self.number(i), self.turned(relative, self.speed), burn * drag)
            case Absorption(i, velocity, rate):
                return Absorption(self.number(i), self.turned(velocity, self.speed), rate * drag)
            case Friction():
                g, belt = force.g * self.length / self.time**2, self.turned(force.belt, self.speed)
                return replace(force, body=self.number(force.body), g=g, belt=belt)
            case ForceFunction(i, function):

                def pushed(t: float, x: Sequence[float], v: Sequence[float]) -> Vector:
                    return self.turned(function(t / self.time, self.place_before(x), v), self.force)

                return ForceFunction(self.number(i), pushed)
            case _:
                raise TypeError(force)

    def scene(self, scene: Scene) -> Scene:
        bodies = tuple(self.body(scene.bodies[i]) for i in self.order)
        until = None if scene.until is None else scene.until * self.time
        return Scene(bodies, tuple(self.told(force) for force in scene.forces), until)

    def values(self, scene: Scene, what: Observable, values: Sequence[float]) -> list[float]:
        """What was observed of the scene as it was, as it is to be observed of the one told."""
        axes, count = scene.axes, len(scene.bodies)
        if what in ALWAYS:
            whole = [values[i : i + axes] for i in range(0, len(values), axes)]
            many = [whole[i : i + count] for i in range(0, len(whole), count)]
            change = self.placed if what is Observable.TRAJECTORY else lambda v: self.turned(v, self.speed)
            return [x for each in many for i in self.order for x in change(each[i])]
        unit = {
            Observable.LARGEST_OVERLAP: self.length,
            Observable.PEAK_FORCE: self.force,
            Observable.DURATION: self.time,
        }
        return [unit[what] * x for x in values]

    def errors(self, scene: Scene, what: Observable, errors: Sequence[float]) -> list[float]:
        still = replace(self, mirrored=False, shift=(0.0,) * scene.axes)
        return still.values(scene, what, errors)


def told(rng: Random, scene: Scene) -> Telling:
    order = list(range(len(scene.bodies)))
    rng.shuffle(order)
    shift = tuple(rng.choice([0.0, rng.uniform(-3.0, 3.0)]) for _ in range(scene.axes))
    length, time_unit, mass = (10.0 ** rng.uniform(-12.0, 12.0) for _ in range(3))
    mirrored = scene.axes == 2 and rng.random() < 0.5
    # On a line weight knows up from down.
    return Telling(length, time_unit, mass, mirrored, shift, tuple(order))


def apart(scene: Scene, telling: Telling, first: Run, second: Run) -> tuple[float, str]:
    """How far two answers differ in units of what both state together, at worst; and where."""
    worst, where = 0.0, ""
    for what in [each for each in Observable if each.value in first.measured]:
        a, b = first.measured[what.value], second.measured[what.value]
        values = telling.values(scene, what, components(a.value))
        stated = telling.errors(scene, what, components(a.error))
        size = b.size or max(map(abs, components(b.value)), default=0.0)
        for x, y, e, f in zip(values, components(b.value), stated, components(b.error), strict=True):
            off = abs(x - y) if x != y else 0.0
            off = max(off - 1e-14 * max(abs(x), abs(y), size), 0.0)
            here = off / (e + f) if e + f else (math.inf if off else 0.0)
            if not here <= worst:
                worst, where = here, f"{what.value}: {x!r} ± {e:.1e} and {y!r} ± {f:.1e}"
    return worst, where


def compared(number: int, seed: int) -> tuple[str, str]:
    """What became of a scene, and why."""
    rng = Random(f"{seed} {number}")
    scene = composed(rng)
    telling, tolerance = told(rng, scene), 10.0 ** rng.uniform(-12.0, -8.0)
    observe = ALWAYS | (OF_CONTACTS if any(body.radius for body in scene.bodies) else set[Observable]())
    found: list[Run | str] = []
    for each, how_fine in ((scene, 1e-10), (telling.scene(scene), tolerance)):
        end = each.until or 0.0
        try:
            found.append(play(each, observe, how_fine, (end, 0.37 * end)))
        except (BadSetting, GuardFailed) as refused:
            found.append(str(refused))
    first, second = found
    if isinstance(first, str) and isinstance(second, str):
        return "refused", first
    if isinstance(first, str) or isinstance(second, str):
        return "refused one way", str(first if isinstance(first, str) else second)
    ratio, where = apart(scene, telling, first, second)
    if not ratio <= 1.0:
        return "wrong", f"{ratio:.3g} times what is stated: {where}"
    sharp = max(each.relative_error for each in (*first.measured.values(), *second.measured.values()))
    return ("agreed" if sharp <= 1e-6 else "agreed, with large errors"), ""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=math.inf)
    parser.add_argument("--only", type=int, help="the number of a scene")
    asked = parser.parse_args()
    counts, end = Counter[str](), time.monotonic() + asked.seconds
    for number in range(asked.scenes) if asked.only is None else [asked.only]:
        outcome, why = compared(number, asked.seed)
        counts[outcome] += 1
        if not outcome.startswith("agreed"):
            print(f"{number}: {outcome}: {why}", flush=True)
        if time.monotonic() > end:
            break
    print(f"{sum(counts.values())} scenes: {dict(counts)}")
    return 1 if counts["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
