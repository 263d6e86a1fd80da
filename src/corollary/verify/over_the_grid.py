"""An answer over the grid: each given moved along its values while the others stay."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from corollary.derive.solution import Solution
from corollary.figure.plots import Curve, lines
from corollary.formula.ball import Undefined, certified
from corollary.problem.part import Part
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant, chapter, first_broken
from corollary.units.unit import show

POINTS = 25  # of a curve
LEAST = 3  # fewer make no curve


@dataclass(frozen=True, slots=True)
class AnswerPlot:
    """The plot of one part, as SVG, and what it shows in words."""

    part: str
    svg: str
    alt: str


def answer_plots(solution: Solution) -> Iterator[AnswerPlot]:
    """One plot for each number that is asked for and has a closed form."""
    printed = chapter(solution.problem)
    if first_broken(printed) is None:
        own, which = printed, "as printed"
    else:  # the printed numbers need not be among those that are drawn
        own = next(sample(solution.problem, 1), printed)
        which = f"as in {own.label}"
    solution = solution.at(own.exact)
    for find in solution.unknowns:
        if not find.part or find.in_givens is None or len(find.in_givens) != 1:
            continue
        part = solution.problem.part(find.part)
        curves = [
            each for given in solution.problem.givens if (each := _curve(solution, own, given.symbol, part))
        ]
        if curves:
            alt = f"The answer to part {part.id} of {solution.problem.code}, one given moved over its range, the others {which}"
            axis = f"part {part.id}" + (f" [{show(part.unit)}]" if show(part.unit) else "")
            yield AnswerPlot(
                part.id,
                lines(curves, x_label="place of the given in its range [%]", y_label=axis, alt=alt),
                alt,
            )


def _curve(solution: Solution, own: Variant, symbol: str, part: Part) -> Curve | None:
    """Where the conditions admit it; None where too few points do, or where nothing changes."""
    grid = solution.problem.given(symbol).grid
    find = next(each for each in solution.unknowns if each.part == part.id)
    places = sorted({(grid.count - 1) * step // (POINTS - 1) for step in range(POINTS)})
    x, y = list[float](), list[float]()
    for place in places:
        variant = Variant(own.problem, {**own.values, symbol: grid[place]}, None)
        if first_broken(variant) is not None or find.in_givens is None:
            continue
        try:
            value = certified(find.in_givens[0], variant.exact).value
        except Undefined:
            continue
        x.append(100 * place / max(1, grid.count - 1))
        y.append(part.unit.from_si(value))
    moved = len(y) >= LEAST and max(y) - min(y) > 1e-9 * max(map(abs, y))
    return Curve(symbol, tuple(x), tuple(y)) if moved else None
