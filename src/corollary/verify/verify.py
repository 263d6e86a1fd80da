"""One problem verified: laws, dimensions, mistakes, samples, printed values, simulations, over many variants."""

from __future__ import annotations

from corollary.derive.load import NotDerivable
from corollary.derive.solve import solve
from corollary.figure.svg import NotADrawing, safe_svg
from corollary.formula.ball import Undefined
from corollary.grading.key import make_key
from corollary.problem.bank import Bank
from corollary.problem.count import variants
from corollary.problem.problem import Problem
from corollary.problem.statement import filled
from corollary.problem.variant import chapter
from corollary.sandbox.runner import Runner
from corollary.verify.checked import Checked, Tally
from corollary.verify.laws import check_dimensions, check_laws
from corollary.verify.programs import check_programs
from corollary.verify.samples import check_claims, check_printed, check_samples
from corollary.verify.walk import LEAST, walk


def verify(bank: Bank, problem: Problem, count: int = LEAST, runner: Runner | None = None) -> Checked:
    """Everything that can be checked of a problem; `runner` runs its programs, or one of their own does.

    Never raises for what an author did wrong; it is a complaint.
    """
    tally, share, reasons = Tally(), 0.0, dict[str, int]()
    number, exact = variants(problem)
    check_figure(problem, tally)
    try:
        solution = solve(bank, problem)
        tally.count("parts", len(problem.parts))
        tally.count("mistakes", sum(len(find.mistakes) for find in solution.unknowns))
        check_laws(bank, solution, tally)
        check_dimensions(bank, solution, tally)
        own = make_key(solution, chapter(problem))
        check_claims(own, tally)
        check_samples(own, tally)
        check_programs(bank, own, tally, runner)
        check_printed(bank, solution, tally)
        share, reasons = walk(bank, solution, tally, count)
    except NotDerivable as error:
        tally.complain(str(error))
    except Undefined as error:
        line = problem.givens[0].line if problem.givens else 1
        tally.complain(f"{problem.path.name}:{line}: the chapter's own numbers have no answer: {error}")
    common = sorted(reasons.items(), key=lambda item: -item[1])[:3]
    return Checked(problem.code, number, exact, share, tuple(common), tally.counts, tuple(tally.complaints))


def check_figure(problem: Problem, tally: Tally) -> None:
    """Whether the chapter's own figure can be shown."""
    if not problem.figure:
        return
    try:
        safe_svg(filled(problem.figure, chapter(problem)))
    except NotADrawing as error:
        tally.complain(f"{problem.path.name}:{problem.figure_line}: the figure cannot be shown: {error}")
    tally.count("figures")
