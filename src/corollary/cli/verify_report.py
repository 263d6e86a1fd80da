"""`corollary verify --report FILE`: what was found, as a page."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from corollary.atomic import write_whole
from corollary.derive.load import NotDerivable
from corollary.formula.ball import Undefined
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.problem.variant import chapter
from corollary.render.proofs_page import VerifiedProblem, proofs_page
from corollary.verify.checked import Checked
from corollary.verify.extremes import push
from corollary.verify.over_the_grid import answer_plots


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
