"""The figure held against the numbers: lengths and arrows labelled with another letter, arrows against the sign of their value."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence

from corollary.problem.figure import FigureLine, is_svg, read_lines
from corollary.problem.given import Given
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.statement import HOLE
from corollary.problem.variant import Variant, chapter
from corollary.units.unit import ONE
from corollary.verify.words.typed_givens import is_angle, same_letter

DRAWS = 6
SAME = 1e-9  # relative
LONE = re.compile(r"^\$?\s*(?P<letter>\\?[A-Za-z][A-Za-z0-9]*(?:_\{?[A-Za-z0-9]+\}?)?)\s*\$?$")
Values = Mapping[str, float]


def misdrawn(problem: Problem) -> Iterator[str]:
    """A sentence with its place for each line of the figure that contradicts the numbers it is labelled with."""
    if is_svg(problem.figure):
        return
    lines, complaints = read_lines(
        problem.figure, tuple((given.symbol, given.unit.dimension) for given in problem.givens)
    )
    if complaints:
        return
    # the printed numbers may coincide; of draws they hardly do
    variants = [chapter(problem), *sample(problem, DRAWS, salt="figure")]
    numbers = [_values(each) for each in variants]
    givens = {given.symbol: given for given in problem.givens if not given.words}
    axes = _axes(lines)
    first = problem.figure_line + 1
    for line in lines:
        given = _labelled(line, givens)
        if given is None or line.over is not None:
            continue
        try:
            why = _of_length(line, given, givens, numbers) or _of_arrow(line, given, givens, numbers, axes)
        except (ArithmeticError, ValueError):
            continue  # which is complained of where the figure is drawn
        if why:
            text = (problem.figure.splitlines()[line.line]).strip()
            yield f"{problem.path.name}:{first + line.line}: figure, `{text}`: {why}"


def _labelled(line: FigureLine, givens: Mapping[str, Given]) -> Given | None:
    """The given that a label is about: `"h = {{h}}"`, `"{{h}}"`, `"h"`; None where it is not one given."""
    if len(line.texts) != 1:
        return None
    holes = [each["formula"].strip() for each in HOLE.finditer(line.texts[0])]
    if len(holes) == 1 and holes[0] in givens:
        return givens[holes[0]]
    lone = LONE.match(line.texts[0])
    if not holes and lone is not None:
        return next((each for each in givens.values() if same_letter(lone["letter"], each.symbol)), None)
    return None


def _of_length(line: FigureLine, given: Given, givens: Mapping[str, Given], numbers: Sequence[Values]) -> str:
    """Of what is drawn as long as another given: a length, a string, an arrow, a radius, an angle."""
    for what, sizes in _sizes(line, numbers):
        other = _equal_to(sizes, givens, numbers, angle=what == "angle")
        if other is None or other.symbol == given.symbol:
            continue
        measuring = what in (
            "length",
            "angle",
        )  # an arrow or a ball may be drawn to the scale of something else
        if other.unit.dimension != given.unit.dimension and not measuring:
            continue
        own = [abs(each[given.symbol]) for each in numbers]
        if _alike(own, sizes):
            continue
        return (
            f"the {what} is drawn as {other.symbol} ({other.meaning}) and labelled with {given.symbol} ({given.meaning}): "
            f"draw {given.symbol}, or write {other.symbol}"
        )
    return ""


def _sizes(line: FigureLine, numbers: Sequence[Values]) -> Iterator[tuple[str, list[float]]]:
    if "by" in line.numbers:
        yield "arrow", [math.hypot(*(each(values) for each in line.numbers["by"])) for values in numbers]
    ends = [line.places[word][0] for word in ("from", "to") if word in line.places]
    if len(ends) == 2 and not any(isinstance(each, str) for each in ends):
        one, other = ([(x(v), y(v)) for v in numbers] for x, y in (e for e in ends if not isinstance(e, str)))
        yield line.kind, [math.dist(a, b) for a, b in zip(one, other, strict=True)]
    if "between" in line.numbers:
        start, end = line.numbers["between"]
        yield "angle", [abs(end(values) - start(values)) for values in numbers]
    for word in ("radius", "length"):
        if word in line.numbers and not ends:
            yield f"{word} of the {line.kind}", [abs(line.numbers[word][0](values)) for values in numbers]


def _equal_to(
    sizes: Sequence[float], givens: Mapping[str, Given], numbers: Sequence[Values], angle: bool
) -> Given | None:
    if (
        len({f"{size:.9e}" for size in sizes}) < 2
        or angle != any(is_angle(each.unit) for each in givens.values()) & angle
    ):
        return None
    return next(
        (
            each
            for each in givens.values()
            if (each.unit.dimension != ONE or is_angle(each.unit) == angle)
            and _alike([abs(values[each.symbol]) for values in numbers], sizes)
        ),
        None,
    )


def _alike(one: Sequence[float], other: Sequence[float]) -> bool:
    return all(abs(a - b) <= SAME * max(abs(a), abs(b)) for a, b in zip(one, other, strict=True))


def _axes(lines: Sequence[FigureLine]) -> tuple[bool, bool]:
    """Whether axes are drawn that point to the right, and up."""
    drawn = [line for line in lines if line.kind == "axes"]
    right = any("above" not in line.flags for line in drawn)
    return right, any("above" in line.flags or len(line.texts) > 1 for line in drawn)


def _of_arrow(
    line: FigureLine,
    given: Given,
    givens: Mapping[str, Given],
    numbers: Sequence[Values],
    axes: tuple[bool, bool],
) -> str:
    """Of an arrow that is labelled with a signed value: it turns with the sign, and with axes drawn it points against them below 0."""
    if line.kind != "arrow" or "by" not in line.numbers:
        return ""
    low, high = _range(given)
    if low >= 0:
        return ""  # a size: the arrow says the direction
    # at the ends of the range, so that each sign is met; other givens as printed
    tried = [{**numbers[0], given.symbol: end} for end in (low, high) if end]
    drawn = [tuple(each(values) for each in line.numbers["by"]) for values in tried]
    ways = [_way(vector) for vector in drawn]
    if not all(ways):
        return ""
    if len(tried) == 2 and low < 0 < high and ways[0] == ways[1]:
        return (
            f"the arrow points the same way whatever the sign of {given.symbol}, which is from {_in_unit_of(given, low)} to "
            f"{_in_unit_of(given, high)}: draw by={given.symbol},0, or by=0,{given.symbol}"
        )
    against = [values for values, way in zip(tried, ways, strict=True) if way * values[given.symbol] < 0]
    if against and axes[0 if drawn[0][0] else 1]:
        value = against[0][given.symbol]
        return (
            f"the arrow points {'along' if value < 0 else 'against'} the axes where {given.symbol} is {_in_unit_of(given, value)}: "
            "an arrow with a label that has a sign points the way the value says"
        )
    return ""


def _range(given: Given) -> tuple[float, float]:
    ends = [_si(given, each) for each in (given.grid.first, given.grid.last)]
    return min(ends), max(ends)


def _si(given: Given, value: object) -> float:
    ratio, pi = given.unit.to_si(value)  # type: ignore[arg-type]
    return float(ratio) * math.pi**pi


def _in_unit_of(given: Given, si: float) -> str:
    return f"{given.unit.from_si(si):g}".replace("-", "\N{MINUS SIGN}")


def _way(vector: tuple[float, ...]) -> int:
    """1 to the right or up, -1 to the left or down; 0 for an oblique arrow or none."""
    dx, dy = vector
    if dx and dy:
        return 0
    return (dx > 0) - (dx < 0) or (dy > 0) - (dy < 0)


def _values(variant: Variant) -> dict[str, float]:
    return {given.symbol: _si(given, variant.values[given.symbol]) for given in variant.problem.givens}
