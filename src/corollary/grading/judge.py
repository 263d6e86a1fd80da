"""One problem of one student judged, part by part, in the order asked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from corollary.answers.answer import Answer, Blank, Chain, Formulas, Letter, Numbers, Prose, Unclear
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.derive.statements import Explain
from corollary.formula.value import Nothing, Value
from corollary.grading.examples import judge_example
from corollary.grading.formulas import judge_formulas, values_of
from corollary.grading.key import Key
from corollary.grading.numbers import judge_numbers
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.judge import code_of, judge_code, judge_plot, plot_of
from corollary.grading.proof import judge_proof
from corollary.grading.replay import Values
from corollary.problem.part import Part

NOTHING_RAN = ProgramRun()


def judge(
    key: Key,
    answers: Mapping[str, Value],
    shown: Mapping[str, ProgramRun] | None = None,
    *,
    secret: bytes = b"",
    student: str = "",
) -> dict[str, tuple[tuple[Verdict, ...], str]]:
    """The verdicts of each part, and how the answer was read. A part of two kinds (code and plot) has two verdicts."""
    earlier: dict[str, Values] = {}
    told: set[str] = set()
    result = {}
    problem = key.variant.problem
    for part in problem.parts:
        its_type = answer_type(part.kind)
        if its_type.found_in in ("function", "figure"):
            result[part.id] = (
                _programs(key, part, (shown or {}).get(part.id, NOTHING_RAN), secret, student),
                part.signature,
            )
            continue
        answer = its_type.read(answers.get(part.id, Nothing()), question_of(problem, part))
        verdict = _once(verdict_on(key, part, answer, earlier), told)
        if part.id in key.truths:
            values = (
                answer.values
                if isinstance(answer, Numbers)
                else values_of(key, answer)
                if isinstance(answer, Formulas)
                else None
            )
            if values is not None:
                earlier[part.id] = values
        result[part.id] = (verdict,), answer.shown
    return result


def verdict_on(key: Key, part: Part, answer: Answer, earlier: Mapping[str, Values]) -> Verdict:
    """One part on its own; `earlier` are the student's values of earlier parts, in SI."""
    match answer:
        case Blank():
            return Unread("No answer was given.", blank=True)
        case Unclear(why, _, readings):
            if any(isinstance(verdict_on(key, part, meant, earlier), Right | Follows) for meant in readings):
                return Unmarked(
                    f"This can be read in two ways, and one of them is right: a person will decide. ({why[0].upper()}{why[1:]}.)"
                )
            return Unread(f"This could not be read: {why}{'' if why.endswith(('.', '?')) else '.'}")
        case Numbers() if part.id in key.solution.examples:
            return judge_example(key, part, answer)
        case Numbers():
            return judge_numbers(key, part, answer, earlier)
        case Formulas():
            return judge_formulas(key, part, answer, earlier)
        case Letter(letter, _):
            if letter == key.choices[part.id]:
                return Right()
            said = key.solution.choices[part.id].mistakes.get(letter)
            return Mistaken(said) if said else Wrong("Another option is the right one.")
        case Chain():
            return judge_proof(key, part, answer)
        case Prose():
            return Unmarked("A person will read this.", rubric(key, part))
        case _:
            assert_never(answer)


def _programs(key: Key, part: Part, shown: ProgramRun, secret: bytes, student: str) -> tuple[Verdict, ...]:
    if not shown.ran:
        return tuple(Unread("Nothing was run for this part.", blank=True) for _ in part.kinds)
    verdicts: list[Verdict] = []
    if code_of(key.solution, part) is not None:
        verdicts.append(judge_code(key.solution, key.variant, part, shown, secret, student))
    if plot_of(key.solution, part) is not None:
        verdicts.append(judge_plot(key.solution, key.variant, part, shown))
    return tuple(verdicts)


def _once(verdict: Verdict, told: set[str]) -> Verdict:
    """The same generic slip costs once: met again, it is pointed out and forgiven."""
    match verdict:
        case Slip(said) if said in told:
            return Right(f"{said} (The same slip as before; it costs only once.)")
        case Slip(said):
            told.add(said)
            return verdict
        case _:
            return verdict


def rubric(key: Key, part: Part) -> tuple[str, ...]:
    """What earns credit in a part that a person marks."""
    return next(
        (
            entry.rubric
            for entry in key.solution.entries
            if isinstance(entry, Explain) and entry.statement.part == part.id
        ),
        (),
    )
