"""One problem verified: laws, dimensions, mistakes, samples, printed values, simulations, over many variants."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from corollary.derive.load import NotDerivable, place_in
from corollary.derive.solve import solved_derivation
from corollary.figure.svg import NotADrawing, safe_svg
from corollary.formula.ball import Undefined
from corollary.grading.key import make_key
from corollary.problem.bank import Bank
from corollary.problem.count import variants
from corollary.problem.diagnostic import Malformed, name_in_bank
from corollary.problem.figure import BadFigure, drawn
from corollary.problem.problem import Problem
from corollary.problem.variant import at, chapter, size
from corollary.sandbox.runner import Runner
from corollary.verify.checked import Checked, Tally
from corollary.verify.expected_answers import check_claims, check_expected, check_samples
from corollary.verify.laws import check_cases, check_dimensions, check_laws, check_obligations
from corollary.verify.mutation.score import DRAWS, Played, score
from corollary.verify.printed import check_printed
from corollary.verify.program_checks import check_programs
from corollary.verify.question_text import check_options, check_question
from corollary.verify.remarks import check_hidden_mistakes, remark
from corollary.verify.walk import LEAST, Walked, check_scenes, walk
from corollary.verify.words.check_words import check_solution_words, check_translations, check_words, unread

SLOW = ("laws put back", "obligations", "variants", "scenes", "bent laws", "programs")
"""The stages that take most of the time, in their order."""


def verify(bank: Bank, problem: Problem, count: int = LEAST, runner: Runner | None = None) -> Checked:
    """Everything that can be checked of a problem; `runner` runs its programs, or one of their own does.

    Never raises for what an author did wrong; it is a complaint.
    """
    whole = Verification(bank, problem, count, runner)
    for _ in whole.stages():
        pass
    return whole.checked()


def not_verified(problem: Problem, complaint: str) -> Checked:
    """What is said of a problem of which nothing could be checked."""
    return Checked(problem.code, *variants(problem), 0.0, (), {}, (complaint,))


class Verification:
    """The checks of one problem in stages, the quick ones first; `tally` has at any time what was found so far."""

    def __init__(self, bank: Bank, problem: Problem, count: int = LEAST, runner: Runner | None = None):
        self.bank, self.problem, self.count, self.runner = bank, problem, count, runner
        self.tally, self.walked = Tally(), Walked(0.0, Counter(), ())

    def stages(self) -> Iterator[str]:
        """The name of each stage before it begins; those in SLOW take most of the time. Never raises for what an author did wrong."""
        bank, problem, tally = self.bank, self.problem, self.tally
        yield "derivation"
        check_figure(problem, tally)
        check_words(problem, tally)
        try:
            solved = solved_derivation(bank, problem)
            solution = solved.solution
            tally.count("parts", len(problem.parts))
            tally.count("mistakes", sum(len(find.mistakes) for find in solution.unknowns))
            check_dimensions(bank, solution, tally)
            check_cases(bank, solution, tally)
            check_translations(problem, solution, tally)
            check_solution_words(bank, solution, tally)
            own = make_key(solution, chapter(problem))
            played: Played = []
            yield "samples"
            check_samples(own, tally)
            check_printed(bank, solution, tally)
            check_expected(own, tally)
            check_options(problem, tally)
            remark(bank, solution, own, tally)
            check_hidden_mistakes(bank, solution, tally)
            for stage in SLOW:
                yield stage
                match stage:
                    case "laws put back":
                        check_laws(solved, tally)
                        check_claims(own, tally)
                    case "obligations":
                        check_obligations(bank, solution, tally, self.count)
                    case "variants":
                        self.walked = walk(bank, solution, tally, self.count)
                        check_question(solution, own, tally)
                    case "scenes":
                        played = [(key, check_scenes(solved.loaded, key, tally)) for key in self.walked.first]
                    case "bent laws":
                        if not tally.complaints:  # of a key that is wrong already no bend says anything
                            tally.mutation = score(solved.loaded, solution, own, played[:DRAWS])
                            tally.count("bent laws", tally.mutation.bends)
                    case _:
                        check_programs(bank, own, tally, self.runner)
        except NotDerivable as error:
            tally.complain(str(error))
        except Malformed as error:
            for each in error.complaints:
                tally.complain(str(each))
        except Undefined as error:
            line = problem.givens[0].line if problem.givens else 1
            tally.complain(f"{problem.path.name}:{line}: the chapter's own numbers have no answer: {error}")
        except (
            Exception
        ) as error:  # of a library, an author's judge or scene, or ours: it costs this problem, and no other
            path, line = place_in(error, bank.solution(problem))
            tally.complain(
                f"{name_in_bank(path)}:{line or 1}: it cannot be verified: {type(error).__name__}: {error}"
            )

    def checked(self) -> Checked:
        """What was found by the stages that are done."""
        number, exact = variants(self.problem)
        common = sorted(self.walked.reasons.items(), key=lambda item: -item[1])[:3]
        tally = self.tally
        return Checked(
            self.problem.code,
            number,
            exact,
            self.walked.refused,
            tuple(common),
            tally.counts,
            tuple(tally.complaints),
            tuple(tally.notes),
            tuple(tally.obligations),
            unread(self.problem),
            tally.mutation,
        )


def check_figure(problem: Problem, tally: Tally) -> None:
    """Whether the figure can be drawn and shown, with the chapter's numbers and at the corners of the grid."""
    if not problem.figure:
        return
    corners = (0, size(problem) - 1)
    try:
        for variant in (chapter(problem), *(at(problem, index) for index in corners)):
            safe_svg(drawn(variant).svg)
    except (NotADrawing, BadFigure) as error:
        line = problem.figure_line + (error.line + 1 if isinstance(error, BadFigure) else 0)
        tally.complain(f"{problem.path.name}:{line}: the figure cannot be shown: {error}")
    tally.count("figures")
