"""Families of discs on rough plates: in corners, leaning, on plates that swing; references enumerate modes."""

from __future__ import annotations

import math
from dataclasses import replace
from random import Random

import numpy as np

from .both_ways import Setting, dot, known, maybe, sloping, swinging
from .case import Case
from .discs import Composed, Disc, Plate, SoftContact
from .enumerated import Course, Fineness

G = 9.8


def disc_in_a_rough_corner(draw: Random) -> Case:
    """A disc or two fall, slide and roll into a corner of two walls of other friction and restitution; one of them may swing."""
    return known(draw, "disc in a rough corner", _corner)


def _corner(draw: Random) -> Setting | None:
    opening, tilt = draw.choice([math.pi / 2, draw.uniform(0.6, 2.6)]), draw.uniform(-0.6, 0.6)
    left, right = (math.pi / 2 + tilt + side * opening / 2 for side in (-1, 1))
    normals = (-math.sin(left), math.cos(left)), (math.sin(right), -math.cos(right))
    e = maybe(draw, 0.1, 0.75, 2)
    e = (e, draw.choice([e, 0.0, draw.uniform(0.1, 0.75)]))
    mu = draw.choice([draw.uniform(0.05, 0.3), draw.uniform(0.3, 1.0)])
    mu = (mu, draw.choice([mu, draw.uniform(0, 0.3), draw.uniform(0.3, 1.0)]))
    plates = [Plate(normals[i], 0.0, e[i], mu[i]) for i in range(2)]
    r, discs = draw.uniform(0.05, 0.2), list[Disc]()
    for _ in range(draw.choice([1, 1, 1, 1, 2])):
        place = (draw.uniform(-1.2, 1.2), draw.uniform(-0.2, 1.5))
        velocity = (draw.uniform(-2, 2), draw.uniform(-2, 1))
        gaps = [dot(normal, place) - r for normal in normals]
        if not 0.01 < min(gaps) < 0.8:
            return None
        if draw.random() < 0.5:  # on one of them
            i = draw.randrange(2)
            (nx, ny), away = normals[i], dot(normals[i], velocity)
            place = (place[0] - gaps[i] * nx, place[1] - gaps[i] * ny)
            velocity = (velocity[0] - away * nx, velocity[1] - away * ny)
            if dot(normals[1 - i], place) < r:
                return None
        if any(math.dist(place, each.place) < 2 * r + 0.02 for each in discs):
            return None
        spin, inertia = maybe(draw, -30, 30), draw.choice([None, draw.uniform(0.1, 1) * r * r])
        discs.append(Disc(draw.uniform(0.2, 2), place, velocity, r, spin, inertia))
    contact = None
    if len(discs) > 1:
        contact = SoftContact(
            10 ** draw.uniform(3, 5), draw.choice([1.0, 1.5]), maybe(draw, 0, 10), draw.choice([0.0, 0.3])
        )
    elif draw.random() < 0.3:
        rate = draw.uniform(4, 15)
        moves = swinging(draw.uniform(0.1, 0.8) * G / rate**2, rate, draw.uniform(0, 2 * math.pi))
        plates[0] = replace(plates[0], moves=moves)
    return Setting(Composed(tuple(discs), G, tuple(plates), contact=contact), draw.uniform(0.4, 2))


def leaning_disc(draw: Random) -> Case:
    """A disc leans and rubs on a wall while it bounces to rest on a floor, which may be smooth or swing; seen shortly after its last bounces."""
    return known(draw, "leaning disc", _leaning)


def _leaning(draw: Random) -> Setting | None:
    back, floor = draw.uniform(0.05, 0.5), draw.uniform(-0.3, 0.3)
    wall, up = (-math.cos(back), math.sin(back)), (math.sin(floor), math.cos(floor))
    r, height = draw.uniform(0.03, 0.1), draw.uniform(0.001, 0.05)
    moves = None
    if draw.random() < 0.5:
        rate = draw.uniform(4, 12)
        moves = swinging(draw.uniform(0.1, 0.6) * G / rate**2, rate, draw.uniform(0, 2 * math.pi))
    plates = (
        Plate(up, 0.0, draw.uniform(0.15, 0.5), draw.choice([0.0, 0.0, 0.2]), moves=moves),
        Plate(wall, 0.0, 0.0, draw.uniform(0.1, 0.5)),
    )
    x, y = np.linalg.solve([wall, up], [r, r + height]).tolist()
    disc = Disc(draw.uniform(0.3, 2), (x, y), radius=r, spin=draw.uniform(-40, 40))
    given = Composed((disc,), G, plates)
    course = Course(given, Fineness(bounce=1e-6))
    course.follow([0.6])
    bounces = [t for t, which in course.met if which == 0]
    return Setting(given, bounces[-1] + draw.choice([0.003, 0.02, 0.1])) if len(bounces) >= 5 else None


def balls_on_a_swinging_plate(draw: Random) -> Case:
    """Balls lie side by side or fall in a loose stack on a plate that swings, or moves steadily; they may be thrown off it, and meet a wall."""
    return known(draw, "balls on a swinging plate", _balls)


def _balls(draw: Random) -> Setting | None:
    n, rate = draw.choice([1, 2, 2, 3]), draw.uniform(5, 25)
    amplitude = draw.choice([draw.uniform(0.2, 0.95), draw.uniform(1.02, 2.5)]) * G / rate**2
    frame = sloping(maybe(draw, -0.4, 0.4, 2))
    moves = None
    if draw.random() < 0.75:
        moves = swinging(amplitude, rate, draw.uniform(0, 2 * math.pi))
    speed = 0.0 if moves else draw.uniform(-0.5, 0.5)
    plate = Plate(frame.normal, 0.0, maybe(draw, 0.1, 0.6, 2), maybe(draw, 0.05, 0.8), speed, moves)
    radii, discs, x, y = [draw.uniform(0.05, 0.12) for _ in range(n)], list[Disc](), 0.0, 0.0
    side_by_side = draw.random() < 1 / 3
    for i, r in enumerate(radii):
        if side_by_side:
            x += radii[i - 1] + r + draw.uniform(0.002, 0.2) if i else 0.0
            place, velocity = (x, r), (draw.uniform(-1, 1), plate.motion(0.0)[1])
        else:
            y += r + draw.uniform(0.005, 0.2)
            place = (draw.uniform(-0.03, 0.03) if i else 0.0, y)
            velocity = (draw.uniform(-0.3, 0.3), draw.uniform(-0.5, 0.5))
            y += r + 0.005
        spin = maybe(draw, -10, 10)
        discs.append(Disc(draw.uniform(0.2, 2), frame.at(*place), frame.at(*velocity), r, spin))
    contact, plates = None, [plate]
    if n > 1:
        contact = SoftContact(
            10 ** draw.uniform(3, 4.7), draw.choice([1.0, 1.5]), maybe(draw, 0, 20), maybe(draw, 0.1, 0.5)
        )
    if draw.random() < 0.25:
        offset = -draw.uniform(0.2, 0.6)
        plates.append(Plate(frame.along, offset, draw.choice([0.0, 0.5]), draw.choice([0.0, 0.3])))
    return Setting(Composed(tuple(discs), G, tuple(plates), contact=contact), draw.uniform(0.2, 0.9))


FAMILIES = (disc_in_a_rough_corner, leaning_disc, balls_on_a_swinging_plate)
