"""Records audited side by side, each within limits of time and memory, for an equation can take for ever to solve."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from queue import SimpleQueue

from corollary.audit.by_problem import examine_by_problem
from corollary.audit.examine import cannot_say, examine
from corollary.audit.formula_key import derived_formula
from corollary.audit.mistaken import mistake_in
from corollary.audit.outcome import AuditedAnswer
from corollary.audit.readers.straight_line import shortened
from corollary.audit.record import ExerciseRecord
from corollary.parallel import cores
from corollary.problem.bank import Bank
from corollary.sandbox.limited import Limited, NotFinished

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
