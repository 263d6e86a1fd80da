"""The motion of an exercise to watch: a drawing that a script moves, a picture of it that stands still, and its words."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from markupsafe import Markup

from corollary.messages import catalogue, in_convention
from corollary.render.page import environment
from corollary.scenes.film import BLOCK, NAIL, Film, Point

_ = catalogue(__name__)

WIDTH, MOST_HIGH, LEAST_HIGH = 640.0, 440.0, 96.0
MARGIN, LONGEST_ARROW = 34.0, 84.0  # room at the sides where nothing points at them, and where something does
STILLS = 5
AT_REST = 1e-6  # of the fastest there is
TONES = ("follows", "mistaken", "right", "slip", "unmarked")


@dataclass(frozen=True, slots=True)
class Stage:
    """Where on the drawing a place (m) is."""

    scale: float
    left: float
    top: float
    height: float

    def at(self, point: Point) -> Point:
        return (point[0] - self.left) * self.scale, (self.top - point[1]) * self.scale


@dataclass(frozen=True, slots=True)
class Actor:
    """One body as it is drawn: `trail` is its way, `ghosts` where it is at moments equally far apart; sizes in units of the drawing."""

    index: int
    name: str
    tone: str
    size: float
    block: bool
    trail: str
    ghosts: tuple[Point, ...]
    mass: str


def animation(film: Film) -> str:
    """A figure with its controls, its bars and its words; `animation.js` plays it."""
    stage = _stage(film)
    cast = [_actor(film, stage, i) for i, body in enumerate(film.bodies) if body.name != NAIL]
    cast.sort(key=lambda each: not each.block)  # what gets into a block is seen in it
    template = environment().get_template("animation.html")
    return template.render(
        width=WIDTH,
        height=round(stage.height, 1),
        actors=cast,
        lines=[(stage.at(a), stage.at(b)) for a, b in film.lines],
        ropes=[(stage.at(film.places[0][a]), stage.at(film.places[0][b])) for a, b in film.ropes],
        film=Markup(json.dumps(_played(film, stage, cast), separators=(",", ":")).replace("<", "\\u003c")),
        words=_words(film, cast),
        flat=_flat(film),
        stored=_stores(film),
    )


def _stage(film: Film) -> Stage:
    """All that moves, with room for arrows; the same scale across and up."""
    spots = [
        (x + dx * r, y + dy * r)
        for places in film.places
        for (x, y), r in zip(places, film.radii, strict=True)
        for dx, dy in ((-1, -1), (1, 1))
    ]
    left, right = min(x for x, _y in spots), max(x for x, _y in spots)
    low, high = min(y for _x, y in spots), max(y for _x, y in spots)
    across, up = max(right - left, 1e-12), max(high - low, 1e-12)
    beside = MARGIN if _flat(film) == "y" else LONGEST_ARROW
    above = MARGIN if _flat(film) == "x" else LONGEST_ARROW
    scale = min((WIDTH - 2 * beside) / across, (MOST_HIGH - 2 * above) / up)
    height = max(up * scale + 2 * above, LEAST_HIGH)
    middle = (left + right) / 2, (low + high) / 2
    return Stage(scale, middle[0] - WIDTH / scale / 2, middle[1] + height / scale / 2, height)


def _actor(film: Film, stage: Stage, i: int) -> Actor:
    body, way = film.bodies[i], [stage.at(places[i]) for places in film.places]
    trail = [point for point, _same in groupby((round(x, 1), round(y, 1)) for x, y in way)]
    last = film.times[-1]
    ghosts = [_between(film, stage, i, last * k / (STILLS - 1)) for k in range(STILLS)]
    heavy = i not in film.loose
    return Actor(
        i,
        body.name[:1].upper() if body.name != BLOCK else "B",
        TONES[i % len(TONES)],
        max(film.radii[i] * stage.scale, 4.0),
        body.name == BLOCK,
        " ".join(f"{x:g},{y:g}" for x, y in trail),
        tuple(ghosts),
        _("very heavy") if heavy else f"{number(body.mass)} kg",
    )


def _between(film: Film, stage: Stage, i: int, time: float) -> Point:
    """Where a body is drawn at a time."""
    after = next((k for k, each in enumerate(film.times) if each >= time), len(film.times) - 1)
    before = max(after - 1, 0)
    span = film.times[after] - film.times[before]
    part = (time - film.times[before]) / span if span else 0.0
    (a, b), (c, d) = film.places[before][i], film.places[after][i]
    return stage.at((a + part * (c - a), b + part * (d - b)))


def _played(film: Film, stage: Stage, cast: Sequence[Actor]) -> dict[str, object]:
    """What the script needs: places in units of the drawing, velocities, masses and energies in SI."""
    fastest = max(math.hypot(*v) for row in film.velocities for v in row) or 1.0
    pushes = [film.bodies[i].mass * math.hypot(*row[i]) for row in film.velocities for i in film.loose]
    base = min(film.stored)
    return {
        "t": [_short(each) for each in film.times],
        "scale": _short(stage.scale),
        "bodies": [
            {
                "p": [[_short(x), _short(y)] for x, y in (stage.at(row[each.index]) for row in film.places)],
                "v": [[_short(x), _short(y)] for x, y in (row[each.index] for row in film.velocities)],
                "m": film.bodies[each.index].mass if each.index in film.loose else None,
            }
            for each in cast
        ],
        "ropes": [
            [_short(x) for x in stage.at(film.places[0][a])]
            + [next(k for k, c in enumerate(cast) if c.index == b)]
            for a, b in film.ropes
        ],
        "stored": [_short(each - base) for each in film.stored] if _stores(film) else None,
        "perV": _short(LONGEST_ARROW / fastest),
        "perP": _short(LONGEST_ARROW / (max(pushes, default=0.0) or 1.0)),
        "mostP": _short(max(max(map(abs, film.momentum(k))) for k in range(len(film.times))) or 1.0),
        "mostE": _short(max(film.kinetic(k) + each - base for k, each in enumerate(film.stored)) or 1.0),
        "flat": _flat(film),
    }


def _flat(film: Film) -> str:
    """ "x" or "y" where everything moves along one line, else nothing."""
    fastest = max(math.hypot(*v) for row in film.velocities for v in row) or 1.0
    moves = [any(abs(v[axis]) > AT_REST * fastest for row in film.velocities for v in row) for axis in (0, 1)]
    return "" if all(moves) else "y" if moves[1] else "x"


def _stores(film: Film) -> bool:
    """Whether there is potential energy to speak of."""
    most = max(film.kinetic(k) for k in range(len(film.times)))
    return max(film.stored) - min(film.stored) > 1e-3 * most


def _short(value: float) -> float:
    return float(f"{value:.6g}")


def _words(film: Film, cast: Sequence[Actor]) -> list[str]:
    """The motion in sentences: each body at the beginning and at the end, and the totals."""
    return [*(_of_body(film, each) for each in cast), *_of_totals(film)]


def _of_body(film: Film, actor: Actor) -> str:
    return _(
        "{name} ({mass}): at the beginning {before}, at the end {after}.",
        name=actor.name,
        mass=actor.mass,
        before=_going(film, film.velocities[0][actor.index]),
        after=_going(film, film.velocities[-1][actor.index]),
    )


def _going(film: Film, velocity: Point) -> str:
    fastest = max(math.hypot(*v) for row in film.velocities for v in row) or 1.0
    x, y = (each if abs(each) > AT_REST * fastest else 0.0 for each in velocity)
    if x == 0.0 and y == 0.0:
        return _("at rest")
    across = _("to the right") if x > 0.0 else _("to the left")
    up = _("upward") if y > 0.0 else _("downward")
    where = ", ".join(word for word, part in ((across, x), (up, y)) if part)
    return _("{speed} m/s {where}", speed=number(math.hypot(x, y)), where=where)


def _of_totals(film: Film) -> list[str]:
    sums = [film.momentum(0), film.momentum(-1)]
    flat = _flat(film)
    written = [
        number(p[1] if flat == "y" else p[0]) if flat else f"({number(p[0])}; {number(p[1])})" for p in sums
    ]
    base = min(film.stored)
    before, after = (film.kinetic(k) + film.stored[k] - base for k in (0, -1))
    return [
        _("Total momentum: {before} kg m/s, then {after} kg m/s.", before=written[0], after=written[1]),
        _(
            "Total kinetic and potential energy: {before} J, then {after} J.",
            before=number(before),
            after=number(after),
        )
        if _stores(film)
        else _(
            "Total kinetic energy: {before} J, then {after} J.", before=number(before), after=number(after)
        ),
        _("It lasts {time} s.", time=number(film.times[-1])),
    ]


def number(value: float) -> str:
    """Three figures, as readers of the language write them."""
    text = f"{value:.3g}" if value and not 1e-3 <= abs(value) < 1e5 else f"{float(f'{value:.3g}'):g}"
    mantissa, mark, exponent = text.partition("e")
    text = f"{mantissa}·10^{int(exponent)}" if mark else text
    return in_convention(text.replace("-", "−"))
