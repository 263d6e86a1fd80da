"""Results of `corollary verify` as a page: derivations, how each obligation was settled, and the answers plotted."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from corollary.atomic import write_whole
from corollary.derive.load import NotDerivable
from corollary.figure.svg import alone, on_paper
from corollary.formula.ball import Undefined
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.problem.variant import chapter
from corollary.render.page import page
from corollary.verify.checked import Checked
from corollary.verify.extremes import push
from corollary.verify.over_the_grid import AnswerPlot, answer_plots

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
