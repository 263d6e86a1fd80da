"""The verdict on programs and figures: by what the student's functions return when called, and what the figures hold."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from itertools import chain
from typing import Any

from corollary.answers.answer import Numbers, Unclear
from corollary.answers.question import Question
from corollary.answers.vectors import vector
from corollary.answers.verdict import Mistaken, Right, Unmarked, Unread, Verdict, Wrong
from corollary.derive.load import called_later
from corollary.derive.solution import Solution
from corollary.derive.statements import Code, Doubt, Fault, Plot, Remark
from corollary.formula.value import Exact, Items, Nothing, Real, Value
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.convergence import Called
from corollary.grading.programs.formula_judges import code_judge, inputs_from, plot_judge
from corollary.grading.programs.work import TooMuchCompared, limited
from corollary.messages import catalogue
from corollary.problem.bank import bank_of
from corollary.problem.part import Part
from corollary.problem.sampling import digest
from corollary.problem.variant import Variant
from corollary.sandbox.job import Argument, Figure, FunctionCall
from corollary.units.unit import unit

_ = catalogue(__name__)

MOST_ELSEWHERE = (
    20  # figures of other cells, where the cell that was meant for one shows none, or not the right one
)


def code_of(solution: Solution, part: Part) -> Code | None:
    """The code entry of a part."""
    return next(
        (entry for entry in solution.entries if isinstance(entry, Code) and entry.statement.part == part.id),
        None,
    )


def plot_of(solution: Solution, part: Part) -> Plot | None:
    """The plot entry of a part."""
    return next(
        (entry for entry in solution.entries if isinstance(entry, Plot) and entry.statement.part == part.id),
        None,
    )


def asks(solution: Solution, variant: Variant, part: Part, secret: bytes, student: str) -> list[FunctionCall]:
    """The calls of a part's function, on inputs nobody knows beforehand."""
    code = code_of(solution, part)
    if code is None:
        return []
    return [
        FunctionCall(
            f"{variant.problem.answer_name(part)}/{place}",
            part.function,
            tuple((name, _argument(value)) for name, value in inputs.items()),
        )
        for place, inputs in enumerate(inputs_of(code, variant, part, secret, student))
    ]


def inputs_of(
    code: Code, variant: Variant, part: Part, secret: bytes, student: str
) -> Sequence[Mapping[str, object]]:
    """The same inputs each time for one student and part, and different for others. Raises NotDerivable where they fail."""
    count = iter(range(1 << 30))

    def draw(low: float, high: float) -> float:
        number = digest(secret, "call", variant.problem.code, part.id, student, str(next(count))) % (1 << 53)
        return low + (high - low) * number / (1 << 53)

    with _authors(variant, code, "the inputs fail"):
        return list(inputs_from(code)(variant.si, draw))


def verdicts_on_runs(
    solution: Solution, variant: Variant, part: Part, run: ProgramRun, secret: bytes, student: str
) -> dict[str, Callable[[], Verdict]]:
    """How a part's function and figures are judged, by answer type; empty where nothing was run."""
    if not run.ran:
        return {}
    return {
        "code": lambda: judge_code(solution, variant, part, run, secret, student),
        "plot": lambda: judge_plot(solution, variant, part, run, secret, student),
    }


def judge_code(
    solution: Solution, variant: Variant, part: Part, run: ProgramRun, secret: bytes, student: str
) -> Verdict:
    """Every call must have come back; then the solution's judge looks at all of them together."""
    code = code_of(solution, part)
    assert code is not None
    called = _called(code, variant, part, run, secret, student)
    if isinstance(called, Unread):
        return called
    with _authors(variant, code, "the judge fails"):
        verdict = _verdict(code_judge(code)(variant.si, called))
    if isinstance(verdict, Mistaken) and len(called) > 1 and _is_constant(called):
        return Wrong(_("{function} returns the same for all arguments.", function=part.function))
    return verdict


def _is_constant(called: Sequence[Called]) -> bool:
    """Whether a program returns the same for all calls, or one number for each body of however many: it makes no usual mistake."""
    returned = {each.returned for each in called}
    return len(returned) == 1 or len(set(chain.from_iterable(returned))) == 1


def _called(
    code: Code, variant: Variant, part: Part, run: ProgramRun, secret: bytes, student: str
) -> list[Called] | Unread:
    """What all calls of the part's function returned; or the first that did not return numbers."""
    called: list[Called] = []
    for place, inputs in enumerate(inputs_of(code, variant, part, secret, student)):
        answered = run.calls.get(f"{variant.problem.answer_name(part)}/{place}")
        if answered is None:
            return Unread(_("There is no function {signature} to call.", signature=part.signature))
        if answered.trouble:
            return Unread(
                _("Calling {function}: {trouble}", function=part.function, trouble=answered.trouble)
            )
        if isinstance(answered.value, Nothing):
            return Unread(_("{function} returns nothing yet.", function=part.function), blank=True)
        returned = _numbers(answered.value)
        if isinstance(returned, str):
            return Unread(
                _(
                    "{function} returns something that is not a list of numbers: {returned}.",
                    function=part.function,
                    returned=returned,
                )
            )
        called.append(Called(inputs, returned))
    return called


def judge_plot(
    solution: Solution, variant: Variant, part: Part, run: ProgramRun, secret: bytes, student: str
) -> Verdict:
    """The figures of the plot cell, axes by axes; where they are not what is asked for, those of each other cell.

    Where all of them together are more than is compared for one part, a person looks.
    """
    try:
        with limited():
            return _judge_plot(solution, variant, part, run, secret, student)
    except TooMuchCompared:
        return Unmarked(
            _("There are more curves than the program compares for one part, so your teacher will mark it.")
        )


def _judge_plot(
    solution: Solution, variant: Variant, part: Part, run: ProgramRun, secret: bytes, student: str
) -> Verdict:
    plot, code = plot_of(solution, part), code_of(solution, part)
    assert plot is not None
    called: tuple[Sequence[Called], ...] = ()
    if plot.with_calls:
        returned = [] if code is None else _called(code, variant, part, run, secret, student)
        called = ([] if isinstance(returned, Unread) else returned,)

    blank = Unread(_("No figure was drawn."), blank=True)

    def verdict_on(figures: Sequence[Figure]) -> Verdict:
        axes = [each for figure in figures for each in figure.axes]
        if not axes:
            return blank
        with _authors(variant, plot, "the judge of figures fails"):
            return _verdict(plot_judge(plot)(variant.si, axes, *called))

    own = verdict_on(run.figures)
    if isinstance(own, Right | Unmarked):
        return own
    others = run.elsewhere[:MOST_ELSEWHERE] + run.of_others[:MOST_ELSEWHERE]
    cells = dict.fromkeys(figure.cell for figure in others)
    right = any(
        isinstance(verdict_on([figure for figure in others if figure.cell == cell]), Right) for cell in cells
    )
    if right and own is blank:
        return Right(_("Right. (The figure was drawn in another cell, not in the one of this part.)"))
    if right or (own is blank and run.elsewhere):
        return Unmarked(_("The figure may come from another cell, so your teacher will mark it."))
    return own


def _authors(variant: Variant, entry: Code | Plot, fails: str) -> AbstractContextManager[None]:
    """Around a call of what an entry brings."""
    problem = variant.problem
    return called_later(bank_of(problem), problem, fails, entry.statement.line, (TooMuchCompared,))


def _verdict(finding: Fault | Remark | Doubt | None) -> Verdict:
    match finding:
        case None:
            return Right()
        case Remark(sentence):
            return Right(sentence)
        case Doubt(sentence):
            return Unmarked(sentence)
        case Fault(sentence, known):
            return Mistaken(sentence) if known else Wrong(sentence)
        case _:  # of an author's own making
            raise TypeError(f"a judge answers None, or a Fault, a Remark or a Doubt, and not {finding!r}")


def _argument(value: Any) -> Argument:
    several = value
    if isinstance(value, (int, float, str)):
        return value
    if isinstance(value, (tuple, list)):
        return tuple(map(float, several))
    raise TypeError(f"a function cannot be called with {value!r}")


def _numbers(value: Value) -> tuple[float, ...] | str:
    if isinstance(value, (Real, Exact)):
        value = Items((value,), (1,))
    count = len(value.items) if isinstance(value, Items) else 1
    components = tuple(f"value{place}" for place in range(1, count + 1))
    found = vector(value, Question("", "", ("vector",), unit("1"), components=components))
    if isinstance(found, Numbers):
        return found.misfit or found.values
    return found.why if isinstance(found, Unclear) else found.as_read
