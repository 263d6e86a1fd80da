"""The real roots of laws in a region, each enclosed and proven, and whether there are others: by intervals, at numbers."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from corollary.audit.contractor import (
    Box,
    Contractor,
    NoContractor,
    contractor,
    periodic_arguments,
    values_of,
)
from corollary.formula.ast import Relation, names
from corollary.formula.ball import RationalPi, precision_of
from corollary.formula.enclosure import (
    INFINITY,
    Empty,
    Enclosure,
    add,
    hull,
    meet,
    multiply,
    subtract,
)

SECONDS = 1.5
MOST_BOXES = 4000
MOST_ROOTS = 100
FEW_ROOTS = 8  # of those that go on for ever
MOST_TURNS = 200.0  # rad that a sine's argument may span, for its roots to be counted
SWEEPS = 30
GAIN = 0.9  # a sweep that leaves more of every side than this is the last
NARROW = 1e-13  # relative: a box so small is divided no more
BITS = 64
STEPS = 20
POSSIBLE = Enclosure(-1e100, 1e100)  # in SI: no quantity of an exercise is beyond
INFLATIONS = 5


@dataclass(frozen=True, slots=True)
class EnclosedRoots:
    """Proven roots of the region by their letters, and those that may lie on its edge; `complete`: proven to be all."""

    roots: tuple[Mapping[str, Enclosure], ...]
    edge: tuple[Mapping[str, Enclosure], ...]
    complete: bool

    @property
    def none(self) -> bool:
        """Whether it is proven that the region has no root."""
        return self.complete and not self.roots and not self.edge


def enclosed_roots(
    equations: Sequence[Relation],
    conditions: Sequence[Relation],
    unknowns: Sequence[str],
    known: Mapping[str, RationalPi],
    within: Mapping[str, Enclosure] | None = None,
    turns: float = INFINITY,
) -> EnclosedRoots:
    """The roots of as many equations as there are unknowns where the conditions hold; `within` bounds some of the unknowns.

    Nothing is sought where the argument of a sine may span more than `turns` (in rad), for its roots go on and on. Raises
    NoContractor where a law has a function without intervals, or there are more or fewer equations.
    """
    live = [each for each in equations if names(each) & set(unknowns)]
    if len(live) != len(unknowns):
        raise NoContractor(f"{len(live)} equations for {len(unknowns)} unknowns")
    with precision_of(BITS):
        laws = [contractor(each, unknowns, known) for each in live]
        bounds = _bounds(conditions, unknowns, known)
        region = [(within or {}).get(name, POSSIBLE) for name in unknowns]
        box = list(region)
        try:
            _swept([*laws, *bounds], box)
            arguments = [part for each in live for part in periodic_arguments(each, unknowns)]
            spans = [values_of(each, unknowns, known, box).width for each in arguments]
        except Empty:
            return EnclosedRoots((), (), complete=True)
        span = max(spans, default=0.0)
        if span > turns:
            return EnclosedRoots((), (), complete=False)
        most = MOST_ROOTS if span <= MOST_TURNS else FEW_ROOTS
        return _Search(laws, bounds, list(unknowns), time.process_time() + SECONDS, region, most).run(box)


def _bounds(
    conditions: Sequence[Relation], unknowns: Sequence[str], known: Mapping[str, RationalPi]
) -> list[Contractor]:
    return [
        contractor(each, unknowns, known)
        for each in conditions
        if each.sign != "!=" and names(each) & set(unknowns)
    ]


def _swept(constraints: Sequence[Contractor], box: Box) -> None:
    """Contracts until hardly anything is gained. Raises Empty."""
    for _ in range(SWEEPS):
        before = list(box)
        for each in constraints:
            each.contract(box)
        if not any(_gained(old, new) for old, new in zip(before, box, strict=True)):
            return


def _gained(old: Enclosure, new: Enclosure) -> bool:
    if old == new:
        return False
    if not old.finite:
        return True
    return new.width < GAIN * old.width


@dataclass(slots=True)
class _Search:
    laws: Sequence[Contractor]
    bounds: Sequence[Contractor]
    unknowns: list[str]
    until: float
    region: Box
    most: int
    roots: list[Box] = field(default_factory=list[Box])
    edge: list[Box] = field(default_factory=list[Box])
    searched: list[Box] = field(default_factory=list[Box])
    open: bool = False

    def run(self, box: Box) -> EnclosedRoots:
        """The roots of a box, which holds all of the region."""
        waiting, boxes = deque([box]), 0
        while waiting:
            boxes += 1
            if boxes > MOST_BOXES or len(self.roots) > self.most or time.process_time() > self.until:
                break
            box = waiting.popleft()
            try:
                _swept([*self.laws, *self.bounds], box)
                if self._known(box) or (self._settled(box, boxes % 4 == 1) or self._known(box)):
                    continue
            except Empty:
                continue
            if (halves := _halves(box)) is None:
                self.open = True
            else:
                waiting.extend(halves)
        complete = not waiting and not self.open
        return EnclosedRoots(self._named(self.roots), self._named(self.edge), complete)

    def _named(self, roots: Sequence[Box]) -> tuple[Mapping[str, Enclosure], ...]:
        return tuple(dict(zip(self.unknowns, self._narrow(each), strict=True)) for each in roots)

    def _known(self, box: Box) -> bool:
        """Whether the box is within one in which there is a single root, which is known."""
        return any(_inside(box, each) for each in self.searched)

    def _settled(self, box: Box, look: bool) -> bool:
        """Whether all roots of the box are known now; where they are not, the box may have become smaller. Raises Empty."""
        if look:
            self._look(box)
        if not all(each.finite for each in box):
            return False
        if self._newton(box) is not None:
            self._keep(box)
            return True
        around = self._inflated(box)
        if around is None:
            return False
        self._keep(around)
        self.searched.append(around)
        return True

    def _newton(self, box: Box) -> Box | None:
        """Contracts the box by Newton's method; a box in which there is just one root, once that is proven. Raises Empty."""
        image = self._image(box)
        if image is None:
            return None
        proven = all(map(_within, image, box))
        box[:] = map(meet, box, image)
        return list(box) if proven else None

    def _inflated(self, box: Box) -> Box | None:
        """A box around this one with a single root, where one is proven: also of a root on the edge. Raises Empty."""
        around = list(box)
        for _ in range(INFLATIONS):
            around = [_more(each) for each in around]
            image = self._image(around)
            if image is None:
                return None
            if all(map(_within, image, around)):
                return around
            if not all(each.finite for each in image):
                return None
            around = [hull((one, other)) for one, other in zip(box, image, strict=True)]
        return None

    def _image(self, box: Box) -> Box | None:
        """All roots of the box are in here (Krawczyk's operator); None where the derivatives are unbounded. Raises Empty."""
        if not all(each.finite for each in box):
            return None
        slopes = self._slopes(box)
        inverse = _inverse([[middle(each) for each in row] for row in slopes]) if slopes is not None else None
        if slopes is None or inverse is None:
            return None
        centre = [middle(each) for each in box]
        at_middle = [each.forward([Enclosure(m, m) for m in centre]) for each in self.laws]
        found: Box = []
        for i, row in enumerate(inverse):
            image = subtract(Enclosure(centre[i], centre[i]), _dot(row, at_middle))
            for j, each in enumerate(box):
                left = subtract(
                    Enclosure(float(i == j), float(i == j)), _dot(row, [line[j] for line in slopes])
                )
                image = add(image, multiply(left, subtract(each, Enclosure(centre[j], centre[j]))))
            found.append(image)
        return found

    def _slopes(self, box: Box) -> list[list[Enclosure]] | None:
        rows: list[list[Enclosure]] = []
        for each in self.laws:
            gradient = each.gradient(box)
            row = [gradient.get(place, Enclosure(0.0, 0.0)) for place in range(len(box))]
            if not all(entry.finite for entry in row):
                return None
            rows.append(row)
        return rows

    def _look(self, box: Box) -> None:
        """Newton's method from the middle of a box: what it comes to is kept where a root is proven there."""
        point = [middle(each) for each in box]
        for _ in range(STEPS):
            at = [Enclosure(each, each) for each in point]
            try:
                slopes = self._slopes(at)
                values = [middle(each.forward(at)) for each in self.laws]
            except Empty:
                return
            inverse = (
                _inverse([[middle(each) for each in row] for row in slopes]) if slopes is not None else None
            )
            if inverse is None:
                return
            step = [sum(a * b for a, b in zip(row, values, strict=True)) for row in inverse]
            point = [each - by for each, by in zip(point, step, strict=True)]
            if not all(abs(each) < 1e300 for each in point):
                return
            if all(abs(by) <= 1e-13 * abs(each) for by, each in zip(step, point, strict=True)):
                break
        try:
            around = self._inflated([Enclosure(each, each) for each in point])
        except Empty:
            return
        if around is not None:
            self._keep(around)
            self.searched.append(around)

    def _keep(self, unique: Box) -> None:
        """Keeps a proven root that is in the region, or may be, and is not known yet."""
        narrow = self._narrow(unique)
        if any(_touches(narrow, self._narrow(each)) for each in (*self.roots, *self.edge)):
            return
        pairs = list(zip(narrow, self.region, strict=True))
        if not all(each.low <= whole.high and whole.low <= each.high for each, whole in pairs):
            return
        whole = all(whole.low <= each.low and each.high <= whole.high for each, whole in pairs)
        fulfilled = self._fulfils(narrow)
        if fulfilled is not False:
            (self.roots if whole and fulfilled else self.edge).append(unique)

    def _fulfils(self, box: Box) -> bool | None:
        """Whether the conditions hold at a root; None where that is too near to tell."""
        found: bool | None = True
        for each in self.bounds:
            try:
                value = each.forward(box)
            except Empty:
                return False
            if value.low > each.target.high or value.high < each.target.low:
                return False
            if each.strict and not (each.target.low <= value.low and value.high <= each.target.high):
                found = None
        return found

    def _narrow(self, unique: Box) -> Box:
        box = list(unique)
        for _ in range(STEPS):
            before = list(box)
            self._newton(box)
            if box == before:
                break
        return box


def middle(x: Enclosure) -> float:
    """A number inside: halfway, where both ends are finite."""
    if x.finite:
        return x.low / 2 + x.high / 2
    if x.low == -INFINITY and x.high == INFINITY:
        return 0.0
    return max(1.0, 2 * x.low) if x.high == INFINITY else min(-1.0, 2 * x.high)


def _halves(box: Box) -> tuple[Box, Box] | None:
    """The box divided where it is widest, as a share of its numbers; None where it is too small to be divided."""
    spans = [_span(each) for each in box]
    widest = max(range(len(box)), key=lambda place: spans[place])
    if spans[widest] <= NARROW:
        return None
    whole = box[widest]
    cut = _cut(whole)
    if not whole.low < cut < whole.high:
        return None
    low, high = list(box), list(box)
    low[widest], high[widest] = Enclosure(whole.low, cut), Enclosure(cut, whole.high)
    return low, high


def _span(x: Enclosure) -> float:
    size = max(abs(x.low), abs(x.high))
    if not x.finite:
        return 10.0
    return x.width / size if size > 1e-250 else 0.0


def _cut(x: Enclosure) -> float:
    """Where to divide: by magnitude where the ends are of different ones."""
    if x.low < 0 < x.high:
        return 0.0 if not x.finite or x.high > 1e3 * -x.low or -x.low > 1e3 * x.high else middle(x) or 0.0
    if x.low < 0:
        return -_cut(Enclosure(-x.high, -x.low))
    if x.high == INFINITY:
        return max(1.0, 1e3 * x.low)
    if x.low == 0:
        return x.high * (1e-3 if x.high > 1e3 or x.high < 1e-3 else 0.4)
    return (x.low**0.5) * (x.high**0.5) if x.high > 16 * x.low else middle(x)


def _more(x: Enclosure) -> Enclosure:
    more = x.width / 5 + 1e-14 * max(abs(x.low), abs(x.high)) + 1e-300
    return Enclosure(x.low - more, x.high + more)


def _within(x: Enclosure, other: Enclosure) -> bool:
    return other.low < x.low and x.high < other.high


def _inside(box: Box, other: Box) -> bool:
    return all(b.low <= a.low and a.high <= b.high for a, b in zip(box, other, strict=True))


def _touches(box: Box, other: Box) -> bool:
    return all(a.low <= b.high and b.low <= a.high for a, b in zip(box, other, strict=True))


def _dot(row: Sequence[float], column: Sequence[Enclosure]) -> Enclosure:
    total = Enclosure(0.0, 0.0)
    for a, b in zip(row, column, strict=True):
        if a:
            total = add(total, multiply(Enclosure(a, a), b))
    return total


def _inverse(rows: list[list[float]]) -> list[list[float]] | None:
    """About the inverse of a matrix: of anything near it a proof may make use."""
    size = len(rows)
    scale = [max(map(abs, row)) for row in rows]
    if not all(0 < each < INFINITY for each in scale):
        return None
    work = [
        [each / scale[i] for each in row] + [float(i == j) / scale[i] for j in range(size)]
        for i, row in enumerate(rows)
    ]
    for i in range(size):
        best = max(range(i, size), key=lambda row: abs(work[row][i]))
        if work[best][i] == 0:
            return None
        work[i], work[best] = work[best], work[i]
        pivot = work[i][i]
        work[i] = [each / pivot for each in work[i]]
        for row in range(size):
            if row != i and work[row][i]:
                factor = work[row][i]
                work[row] = [a - factor * b for a, b in zip(work[row], work[i], strict=True)]
    found = [row[size:] for row in work]
    return found if all(abs(each) < INFINITY for row in found for each in row) else None
