"""Records audited side by side, each within limits of time and memory; one that names a problem is held against its derivation."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction
from functools import partial
from queue import SimpleQueue

from corollary.answers.quantity import read_quantity
from corollary.answers.verdict import Mistaken, Right, Slip, Unread
from corollary.audit.examine import PublishedNumber, cannot_say, examine, most_broken
from corollary.audit.exercise import quantity
from corollary.audit.formula_key import derived_formula
from corollary.audit.mistaken import mistake_in
from corollary.audit.outcome import AuditedAnswer
from corollary.audit.readers.straight_line import shortened
from corollary.audit.record import AskedLetter, ExerciseRecord, StatedGiven
from corollary.derive.cache import solution_of
from corollary.derive.load import NotDerivable
from corollary.formula.errors import ParseError, Undefined, sentence
from corollary.formula.plain_text import text
from corollary.formula.value import Text
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key, named
from corollary.parallel import cores
from corollary.problem.bank import Bank, UnknownCode, find
from corollary.problem.diagnostic import Malformed
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.variant import OutOfRange, chosen, written_apart
from corollary.sandbox.limited import Limited, NotFinished
from corollary.units.unit import Dimension
from corollary.verify.printed import ABOUT

ELSEWHERE = 5  # variants at which a published formula is tried besides the record's own numbers


def examine_by_problem(record: ExerciseRecord, bank: Bank) -> tuple[AuditedAnswer, ...]:
    """What is found of each published answer."""
    try:
        problem = find(bank, record.problem)
        variant = chosen(problem, {each.symbol: _value(problem, each) for each in record.given})
        key = make_key(solution_of(bank, problem), variant)
    except (UnknownCode, OutOfRange, Malformed, NotDerivable, ValueError) as error:
        return cannot_say(record, str(error))
    except Undefined as error:
        return tuple(replace(each, finding="impossible") for each in cannot_say(record, str(error)))
    pairs = zip(record.asked, record.published, strict=True)
    return tuple(_outcome(key, record, asked, published) for asked, published in pairs)


def _value(problem: Problem, given: StatedGiven) -> Fraction:
    """The record's number in the unit of the problem's given. Raises ValueError."""
    own = next((each for each in problem.givens if each.symbol == given.symbol), None)
    if own is None:
        known = ", ".join(each.symbol for each in problem.givens)
        raise ValueError(f"{given.symbol} is not among the givens of {problem.code} ({known})")
    if not given.fixed or given.low is None:
        raise ValueError(f"{given.symbol} has a range; the record of a problem of a bank has numbers")
    return _converted(given, own, given.low)


def _converted(given: StatedGiven, own: Given, number: Fraction) -> Fraction:
    if given.unit.dimension != own.unit.dimension or given.unit.pi != own.unit.pi:
        raise ValueError(f"{given.symbol} = {given.text} is not in {own.unit.text}")
    return (given.unit.to_si(number)[0] - own.unit.offset) / own.unit.factor


def _outcome(key: Key, record: ExerciseRecord, asked: AskedLetter, published: str) -> AuditedAnswer:
    nothing = AuditedAnswer(record, asked.letter, published, "cannot say")
    part = next((each for each in key.variant.problem.parts if each.id == asked.letter), None)
    if part is None:
        return replace(nothing, why=f"{key.variant.problem.code} has no part {asked.letter}")
    if part.id in key.choices:
        derived = f"({key.choices[part.id]})"
        right = published.strip("() ").lower() == key.choices[part.id]
        return replace(nothing, finding="agrees" if right else "wrong", derived=derived)
    truth = key.truths.get(part.id)
    if truth is None or len(truth.values) != 1:
        return replace(nothing, why=f"part {part.id} does not ask for one quantity")
    read = read_quantity(published.strip().removeprefix(ABOUT).strip(), asked.unit or part.unit)
    if isinstance(read, ParseError):
        return _formula(key, part, nothing, sentence(read))
    number = PublishedNumber(published.strip(), read, asked.unit or part.unit, record.figures)
    (value,) = truth.values
    found = replace(nothing, derived=number.written(value), formula=_formula_of(key, part))
    match "differs" if read.fit == "wrong dimension" else number.agreement(value):
        case "agrees":
            return replace(found, finding="agrees")
        case "last figure":
            return replace(found, finding="last figure", why="it differs by one in the last figure")
        case _:
            return _wrong(key, part, number, found)


def _wrong(key: Key, part: Part, number: PublishedNumber, found: AuditedAnswer) -> AuditedAnswer:
    unknown = key.find(key.truths[part.id])
    known = dict(key.variant.exact) | named(key.solution, key.values)
    known[unknown.names[0]] = number.exact
    relations = [(law.name, each) for law in unknown.laws for each in law.here]
    broken = most_broken(
        relations, unknown.names[0], known, _dimensions(key), named(key.solution, key.values)
    )
    return replace(
        found,
        finding="wrong",
        why=number.reading.why,
        violates=broken.law if broken else "",
        sides=broken.written if broken else None,
        mistake=_mistake(key, part, found.published),
    )


def _mistake(key: Key, part: Part, published: str) -> str:
    """What the problem's author says of the mistake that gives this answer, or of the slip that everybody makes."""
    ((verdict, *_), _read) = judge(key, {part.id: Text(published)})[part.id]
    match verdict:
        case Mistaken(mistake):
            return mistake
        case Slip(slip):
            return slip
        case _:
            return ""


def _formula(key: Key, part: Part, nothing: AuditedAnswer, unread: str) -> AuditedAnswer:
    """A published formula, judged at the record's numbers and at others."""
    found = replace(nothing, derived=_formula_of(key, part), formula=_formula_of(key, part))
    for each in _keys(key):
        ((verdict, *_), _read) = judge(each, {part.id: Text(nothing.published)})[part.id]
        if isinstance(verdict, Unread):
            return replace(
                nothing, why=f"the published answer {nothing.published!r} cannot be read: {unread}"
            )
        if not isinstance(verdict, Right) or verdict.leniently:
            given = written_apart(each.variant)
            derived = quantity(each.truths[part.id].values[0], part.unit)
            return replace(
                found,
                finding="wrong",
                counterexample={**given, "derived": derived},
                mistake=verdict.mistake if isinstance(verdict, Mistaken) else "",
            )
    return replace(found, finding="agrees")


def _keys(key: Key) -> Iterator[Key]:
    yield key
    for variant in sample(key.solution.problem, ELSEWHERE, salt="audit"):
        yield make_key(key.solution, variant)


def _formula_of(key: Key, part: Part) -> str:
    trees = key.find(key.truths[part.id]).in_givens
    return text(trees[0]) if trees else ""


def _dimensions(key: Key) -> dict[str, Dimension]:
    found = {given.symbol: given.unit.dimension for given in key.variant.problem.givens}
    for unknown in key.solution.unknowns:
        found |= dict(zip(unknown.names, unknown.dimensions, strict=True))
    return found


SECONDS = 10.0  # of the processor for a record: the slowest of the examples takes 5
SECONDS_FOR_INTERVALS = 5.0
SECONDS_FOR_MISTAKES = 20.0
SECONDS_FOR_FORMULA = 5.0


@contextmanager
def audit_each(
    records: Sequence[ExerciseRecord], bank: Bank, formulas: bool = False
) -> Generator[Iterator[tuple[AuditedAnswer, ...]]]:
    """What is found of each record, in their order, as soon as it is found; with `formulas` also the derived formulas, where they are found in time."""
    places = SimpleQueue[Limited]()
    interpreters = [Limited() for _ in range(max(1, min(cores(), len(records))))]
    for each in interpreters:
        places.put(each)

    def one(record: ExerciseRecord) -> tuple[AuditedAnswer, ...]:
        interpreter = places.get()
        try:
            return _audited(record, bank, interpreter, formulas)
        finally:
            places.put(interpreter)

    pool = ThreadPoolExecutor(len(interpreters))
    try:
        yield pool.map(one, records)
    finally:
        pool.shutdown(cancel_futures=True)
        for each in interpreters:
            each.stop()


def _audited(
    record: ExerciseRecord, bank: Bank, interpreter: Limited, formulas: bool
) -> tuple[AuditedAnswer, ...]:
    if record.unread:
        return cannot_say(record, record.unread)
    try:
        if record.problem:
            return examine_by_problem(record, bank)
        found = _examined(record, interpreter)
    except Exception as error:  # whatever somebody wrote into a record costs this one alone
        return cannot_say(record, shortened(f"it could not be examined ({type(error).__name__}: {error})"))
    found = tuple(_with_mistake(each, interpreter) for each in found)
    return tuple(_with_formula(each, interpreter) for each in found) if formulas else found


def _examined(record: ExerciseRecord, interpreter: Limited) -> tuple[AuditedAnswer, ...]:
    """By algebra, and where that takes too long by intervals alone."""
    for by_algebra, seconds in ((True, SECONDS), (False, SECONDS_FOR_INTERVALS)):
        try:
            return interpreter.call(partial(examine, record, by_algebra), seconds)
        except NotFinished:
            continue
    seconds = SECONDS + SECONDS_FOR_INTERVALS
    return cannot_say(
        record, f"it was not solved within {seconds:.0f} s of the processor; state simpler laws"
    )


def _with_mistake(outcome: AuditedAnswer, interpreter: Limited) -> AuditedAnswer:
    """A mistake that gives the published answer also says which law is broken, where it replaces one."""
    if outcome.finding != "wrong" or not (outcome.violates or outcome.counterexample):
        return outcome
    try:
        mistake, law = interpreter.call(partial(mistake_in, outcome), SECONDS_FOR_MISTAKES)
    except (
        Exception
    ):  # not finished, or beyond the algebra: the finding stands, and what led to it is not known
        return outcome
    if law and law != outcome.violates:
        return replace(outcome, mistake=mistake, violates=law, sides=None)
    return replace(outcome, mistake=mistake)


def _with_formula(outcome: AuditedAnswer, interpreter: Limited) -> AuditedAnswer:
    if outcome.formula or not outcome.values:
        return outcome
    try:
        return replace(
            outcome, formula=interpreter.call(partial(derived_formula, outcome), SECONDS_FOR_FORMULA)
        )
    except Exception:  # not finished, or beyond the algebra: the finding stands without its formula
        return outcome
