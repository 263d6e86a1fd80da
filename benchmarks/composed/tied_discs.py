"""Families of discs and points on bars and strings, on slopes and beside walls; references enumerate modes."""

from __future__ import annotations

import math
from dataclasses import replace
from random import Random

from .both_ways import Setting, Vector, dot, known, maybe, sloping, swinging, turned
from .case import Case
from .discs import Composed, Cord, Disc, Plate, SoftContact

G = 9.8
NAIL = Disc(math.inf, (0.0, 0.0))


def within(draw: Random, size: float) -> Vector:
    """A vector with components up to this size."""
    return draw.uniform(-size, size), draw.uniform(-size, size)


def polar(distance: float, angle: float, origin: Vector = (0.0, 0.0)) -> Vector:
    return origin[0] + distance * math.cos(angle), origin[1] + distance * math.sin(angle)


def dumbbell_on_a_slope(draw: Random) -> Case:
    """Two discs on a bar or a string lie on, slide on or fall on a slope or a floor, rough or smooth; a third one may run into them."""
    return known(draw, "dumbbell on a slope", _dumbbell)


def _dumbbell(draw: Random) -> Setting | None:
    frame = sloping(draw.choice([0.0, draw.uniform(0.05, 0.7), -draw.uniform(0.05, 0.7)]))
    mu = draw.choice([0.0, draw.uniform(0.05, 0.4), draw.uniform(0.4, 0.9)])
    plate = Plate(frame.normal, 0.0, maybe(draw, 0.1, 0.75, 2), mu)
    points, on_string = draw.random() < 0.5, draw.random() < 0.35
    r = [0.0 if points else draw.uniform(0.03, 0.15) for _ in range(2)]
    length, angle = draw.uniform(0.4, 1), draw.uniform(-1.5, 1.5)
    x, y = polar(length, angle)
    lift = maybe(draw, 0.02, 0.4)
    base = max(r[0], r[1] - y) + lift
    slide, fall, turn = maybe(draw, -1.5, 1.5), 0.0, 0.0
    velocity = (slide, 0.0)
    if lift:
        fall, turn = maybe(draw, -1, 0), maybe(draw, -2, 2)
        velocity = (slide - turn * y + (draw.uniform(-1, 1) if on_string else 0.0), fall + turn * x)
    ends = [((0.0, base), (slide, fall)), ((x, base + y), velocity)]
    spins = [0.0 if points else maybe(draw, -10, 10) for _ in range(2)]
    discs = [
        Disc(draw.uniform(0.2, 2), frame.at(*place), frame.at(*speed), radius, spin)
        for (place, speed), radius, spin in zip(ends, r, spins, strict=True)
    ]
    contact, cords = None, ()
    if on_string:
        loose = draw.choice([1.0001, draw.uniform(1, 1.5)])
        cords = (Cord((0, 1), length * loose, maybe(draw, 0.1, 0.7, 2)),)
    if not points and (on_string or draw.random() < 0.3):
        damping, rubbing = maybe(draw, 0, 5), draw.choice([0.0, 0.3])
        contact = SoftContact(10 ** draw.uniform(3, 5), draw.choice([1.0, 1.5]), damping, rubbing)
    if contact and (not on_string or draw.random() < 0.3):
        radius = draw.uniform(0.03, 0.1)
        place = frame.at(draw.choice([-1, 1]) * draw.uniform(0.5, 1), radius + maybe(draw, 0, 0.8))
        if any(math.dist(place, each.place) < radius + each.radius + 0.01 for each in discs):
            return None
        discs.append(Disc(draw.uniform(0.2, 1), place, frame.at(draw.uniform(-2, 2), 0.0), radius))
    given = Composed(tuple(discs), G, (plate,), cords, () if on_string else ((0, 1),), contact)
    return Setting(given, draw.uniform(0.3, 1.6), ((0, 1),) if on_string and points else ())


def strings_that_jerk(draw: Random) -> Case:
    """Strings with restitution jerk taut: of one weight, in chains, two on one weight, or of discs that rub on each other."""
    kind = draw.choice([_on_one, _on_two_nails, _in_a_chain, _rubbing])
    return known(draw, "strings that jerk", kind)


def _restitution(draw: Random) -> float:
    return draw.choice([0.0, draw.uniform(0.1, 0.8), draw.uniform(0.1, 0.8)])


def _thrown(draw: Random, place: Vector, speed: float) -> Disc:
    """A point."""
    return Disc(draw.uniform(0.2, 2), place, within(draw, speed))


def _on_one(draw: Random) -> Setting:
    length = draw.uniform(0.5, 1.2)
    place = polar(draw.uniform(0.2, 0.98) * length, draw.uniform(0, 2 * math.pi))
    given = Composed((NAIL, _thrown(draw, place, 2.0)), G, cords=(Cord((0, 1), length, _restitution(draw)),))
    return Setting(given, draw.uniform(0.3, 1.5), ((0, 1),))


def _on_two_nails(draw: Random) -> Setting | None:
    lengths, far = [draw.uniform(0.6, 1.2) for _ in range(2)], (draw.uniform(0.2, 0.9), 0.0)
    place = (draw.uniform(-0.5, 1.5), draw.uniform(-1.2, 0.5))
    if not 0.1 < math.hypot(*place) < 0.98 * lengths[0] or math.dist(place, far) > 0.98 * lengths[1]:
        return None
    cords = tuple(Cord((i, 2), lengths[i], _restitution(draw)) for i in range(2))
    discs = (NAIL, Disc(math.inf, far), _thrown(draw, place, 1.5))
    return Setting(Composed(discs, G, cords=cords), draw.uniform(0.3, 1.5))


def _in_a_chain(draw: Random) -> Setting:
    discs, cords = [NAIL], list[Cord]()
    for i in range(draw.choice([2, 3])):
        length = draw.uniform(0.3, 1)
        angle = draw.uniform(-math.pi, 0) + draw.uniform(-0.5, 0.5)
        place = polar(draw.uniform(0.3, 0.99) * length, angle, discs[-1].place)
        discs.append(_thrown(draw, place, 1.5))
        cords.append(Cord((i, i + 1), length, _restitution(draw)))
    if draw.random() < 0.3:  # without the nail
        discs, cords = discs[1:], [replace(each, ends=(i, i + 1)) for i, each in enumerate(cords[1:])]
    return Setting(Composed(tuple(discs), G, cords=tuple(cords)), draw.uniform(0.3, 1.5))


def _rubbing(draw: Random) -> Setting | None:
    """A disc on a string, and another one, which may be on a string, too, thrown at it."""
    length, angle = draw.uniform(0.4, 1), -math.pi / 2 + draw.uniform(-0.7, 0.7)
    r = [draw.uniform(0.05, 0.12) for _ in range(2)]
    place, towards = polar(draw.uniform(0.7, 0.999) * length, angle), draw.uniform(0, 2 * math.pi)
    other = polar(sum(r) + draw.uniform(0.005, 0.3), towards, place)
    if math.hypot(*other) < r[1] + 0.01:
        return None
    velocity = within(draw, 1.0)
    back = towards + math.pi + draw.uniform(-0.3, 0.3)
    speeds = velocity, polar(draw.uniform(0.5, 2.5), back, velocity)
    discs = [NAIL] + [
        Disc(draw.uniform(0.2, 2), at, speed, radius, maybe(draw, -20, 20))
        for at, speed, radius in zip((place, other), speeds, r, strict=True)
    ]
    cords, passes = [Cord((0, 1), length, _restitution(draw))], [(0, 1), (0, 2)]
    if draw.random() < 0.5:
        nail = (draw.uniform(-0.3, 0.3), draw.uniform(-0.1, 0.1))
        discs.append(Disc(math.inf, nail))
        cords.append(Cord((3, 2), math.dist(nail, other) * draw.uniform(1, 1.3), _restitution(draw)))
        passes += [(1, 3), (2, 3)]
    contact = SoftContact(
        10 ** draw.uniform(3, 5.5),
        draw.choice([1.0, 1.5]),
        maybe(draw, 0, 20),
        draw.uniform(0.05, 0.5),
        ((1, 2),),
    )
    given = Composed(tuple(discs), draw.choice([G, 0.0]), cords=tuple(cords), contact=contact)
    return Setting(given, draw.uniform(0.3, 1.5), tuple(passes))


def hit_beside_what_holds(draw: Random) -> Case:
    """Something is hit that is held already, by a taut string or a plate with restitution; that is not hit itself, or only if it must be."""
    kind = draw.choice([_string_and_wall, _string_and_string, _plate_and_wall, _plate_and_string])
    return known(draw, "hit beside what holds", kind)


def _string_and_wall(draw: Random) -> Setting:
    """What swings on a taut string hits a wall."""
    length, angle = draw.uniform(0.4, 1), -math.pi / 2 + draw.uniform(-0.8, 0.8)
    turn, r = draw.uniform(-3, 3), draw.choice([0.0, 0.05])
    place, forth = polar(length, angle), (-math.sin(angle), math.cos(angle))
    velocity = (length * turn * forth[0], length * turn * forth[1])
    normal = turned(forth, draw.uniform(-0.6, 0.6) + (math.pi if turn > 0 else 0.0))
    wall = Plate(
        normal,
        dot(normal, place) - r - draw.uniform(0.01, 0.2),
        maybe(draw, 0.2, 1),
        draw.choice([0.0, 0.3]) if r else 0.0,
        only=(1,),
    )
    cord = Cord((0, 1), length, draw.uniform(0.1, 0.8))
    given = Composed((NAIL, Disc(1.0, place, velocity, r)), G, (wall,), (cord,))
    return Setting(given, draw.uniform(0.15, 0.5), ((0, 1),))


def _string_and_string(draw: Random) -> Setting:
    """On what swings on a taut string another one jerks."""
    lengths, angle = (draw.uniform(0.5, 1), draw.uniform(0.4, 0.9)), -math.pi / 2 + draw.uniform(-0.6, 0.6)
    turn, place = draw.uniform(-2, 2), polar(lengths[0], angle)
    other = polar(draw.uniform(0.3, 0.9) * lengths[1], draw.uniform(0, 2 * math.pi), place)
    discs = (
        NAIL,
        Disc(draw.uniform(0.3, 2), place, (-turn * place[1], turn * place[0])),
        Disc(draw.uniform(0.3, 2), other, within(draw, 2.0)),
    )
    cords = Cord((0, 1), lengths[0], draw.uniform(0.05, 0.8)), Cord((1, 2), lengths[1], draw.uniform(0, 0.8))
    return Setting(Composed(discs, G, cords=cords), draw.uniform(0.3, 0.6))


def _on_a_plate(draw: Random) -> tuple[Plate, Disc, float]:
    """A plate, which may swing, a disc that slides on it, and how fast that is."""
    frame = sloping(maybe(draw, -0.4, 0.4))
    plate = Plate(frame.normal, 0.0, draw.uniform(0.1, 0.7), maybe(draw, 0.05, 0.6))
    if draw.random() < 0.6:
        rate = draw.uniform(3, 12)
        moves = swinging(draw.uniform(0.2, 0.9) * G / rate**2, rate, draw.uniform(0, 2 * math.pi))
        plate = replace(plate, moves=moves)
    r, slide = draw.uniform(0.05, 0.1), draw.uniform(-2, 2)
    velocity = frame.at(slide, plate.motion(0.0)[1])
    return plate, Disc(draw.uniform(0.3, 2), frame.at(0.0, r), velocity, r, draw.uniform(-20, 20)), slide


def _plate_and_wall(draw: Random) -> Setting:
    plate, disc, slide = _on_a_plate(draw)
    forth = turned(plate.normal, -math.pi / 2)
    normal = turned(forth, draw.uniform(-0.7, 0.7) + (math.pi if slide > 0 else 0.0))
    offset = dot(normal, disc.place) - disc.radius - draw.uniform(0.01, 0.3)
    wall = Plate(normal, offset, maybe(draw, 0.2, 0.8), maybe(draw, 0.05, 0.6))
    return Setting(Composed((disc,), G, (plate, wall)), draw.uniform(0.2, 0.6))


def _plate_and_string(draw: Random) -> Setting | None:
    """A string to what was thrown jerks at a disc on a plate."""
    plate, disc, _ = _on_a_plate(draw)
    length = draw.uniform(0.3, 0.8)
    place = polar(draw.uniform(0.3, 0.9) * length, draw.uniform(0.1, 3.04), disc.place)
    if dot(plate.normal, place) < 0.15:
        return None
    thrown = Disc(draw.uniform(0.3, 2), place, (draw.uniform(-4, 4), draw.uniform(-2, 4)))
    cord = Cord((0, 1), length, maybe(draw, 0.1, 0.8))
    given = Composed((disc, thrown), G, (replace(plate, only=(0,)),), (cord,))
    return Setting(given, draw.uniform(0.2, 0.6), ((0, 1),))


FAMILIES = (dumbbell_on_a_slope, strings_that_jerk, hit_beside_what_holds)
