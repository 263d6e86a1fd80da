"""Results of `corollary verify` as a page: derivations, how each obligation was settled, and the answers over the grid."""

from __future__ import annotations

import base64
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from corollary.atomic import write_whole
from corollary.derive.load import NotDerivable
from corollary.derive.numbered_list import solution_for
from corollary.derive.solution import Solution
from corollary.figure.plots import Curve, lines
from corollary.figure.svg import alone, on_paper
from corollary.formula.ball import Undefined, certified
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant, chapter, first_broken
from corollary.render.page import page
from corollary.units.unit import show
from corollary.verify.checked import Checked
from corollary.verify.extremes import push

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
    solution = solution_for(solution, own.exact)
    for find in solution.unknowns:
        if not find.part or find.in_givens is None or len(find.in_givens) != 1:
            continue
        part = solution.problem.part(find.part)
        curves = [
            each
            for given in solution.problem.givens
            if not given.table and (each := _curve(solution, own, given.symbol, part))
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


OUTCOMES = ("counter-example", "undecided", "sampled", "proven")
"""What an instructor reads first comes first."""


@dataclass(frozen=True, slots=True)
class VerifiedProblem:
    """One problem on the page. `worked` is its worked solution in Markdown, "" where it has none; `worst` the largest error of a
    replay in doubles at the ends of the range, in last places, met at `where`."""

    problem: Problem
    checked: Checked
    worked: str
    plots: tuple[AnswerPlot, ...]
    worst: float
    where: str

    def address(self, plot: AnswerPlot) -> str:
        """The plot as a data URI, readable on any background."""
        svg = on_paper(alone(plot.svg))
        return "data:image/svg+xml;base64," + base64.b64encode(svg.encode()).decode()


def proofs_page(problems: Sequence[VerifiedProblem]) -> str:
    """One file with everything in it."""
    every = [one for each in problems for one in each.checked.obligations]
    kinds = dict.fromkeys(one.kind for one in every)
    table = {
        kind: [sum(one.kind == kind and one.outcome == outcome for one in every) for outcome in OUTCOMES]
        for kind in kinds
    }
    return page(
        "proofs.html",
        title="Problems verified",
        style="report.css",
        problems=problems,
        outcomes=OUTCOMES,
        table=table,
        totals=[sum(column) for column in zip(*table.values(), strict=True)] or [0] * len(OUTCOMES),
        ok=all(each.checked.ok for each in problems),
    )


def write_report(file: Path, todo: Sequence[tuple[Bank, Problem]], found: Sequence[Checked]) -> None:
    """One page for all problems, in their order."""
    pages = [
        _of_problem(bank, problem, checked) for (bank, problem), checked in zip(todo, found, strict=True)
    ]
    write_whole(file, proofs_page(pages).encode())


def _of_problem(bank: Bank, problem: Problem, checked: Checked) -> VerifiedProblem:
    try:
        solutions = Solutions(bank)
        solution = solutions.of(problem)
        worst = push(solution)
        worked = solutions.worked_solution(chapter(problem))
        return VerifiedProblem(
            problem, checked, worked, tuple(answer_plots(solution)), worst.worst, worst.where
        )
    except (NotDerivable, Undefined):  # the complaints say why
        return VerifiedProblem(problem, checked, "", (), 0.0, "")
