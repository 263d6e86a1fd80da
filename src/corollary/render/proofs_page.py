"""Results of `corollary verify` as a page: derivations, how each obligation was settled, and the answers plotted."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.figure.paper import on_paper
from corollary.figure.svg import alone
from corollary.problem.problem import Problem
from corollary.render.page import page
from corollary.verify.checked import Checked
from corollary.verify.over_the_grid import AnswerPlot

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
