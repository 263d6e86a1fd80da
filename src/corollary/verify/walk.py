"""Walk over the variants of a problem: draws, redraws, and where in the ranges they are refused."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Right, word
from corollary.derive.load import Loaded
from corollary.derive.ready_scenes import run
from corollary.derive.simulation import Seen, Simulation, simulations_of
from corollary.derive.solution import Solution
from corollary.formula.numerals import decimal_text
from corollary.formula.plain_text import text
from corollary.formula.value import Items, Real, Text, Value
from corollary.grading.assign import admitted, collisions
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.neglect import neglected_in, neglects
from corollary.problem.axes import tables
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.given import Given
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant, chapter, first_broken, number, row_in_words, size
from corollary.scenes.plan import followed
from corollary.scenes.run import BadSetting, GuardFailed, Run, components
from corollary.units.unit import show
from corollary.verify.cases_walked import CasesWalked
from corollary.verify.checked import Tally
from corollary.verify.rows_walked import keys_of_rows
from corollary.verify.words.asked_sign import magnitudes_asked, negative_magnitudes

ENOUGH = 8  # draws on either side of a limit, and a tenth of all: of fewer, none is a share
FEWER = 0.2  # by so much the share refused must fall, or the limit is no help

CANDIDATES = 40  # values that a limit is tried at: of a fine grid not each
A_CONDITION = 0.5  # of a range: that is changed more easily than a condition is added


@dataclass(frozen=True, slots=True)
class TriedDraw:
    """A draw that keeps all conditions, and whether it may be assigned."""

    variant: Variant
    admitted: bool


@dataclass(frozen=True, slots=True)
class RangeLimit:
    """A limit on the draws: what to write, and what shares are refused within it and beyond."""

    words: str
    within: float
    beyond: float
    weight: float


def narrower(tried: Sequence[TriedDraw]) -> str:
    """The one limit within which most draws may be assigned, as a sentence's end; "" where none tells them apart."""
    if not tried:
        return ""
    givens = [
        each
        for each in tried[0].variant.problem.givens
        if each.grid.count > 1 and not each.words and not each.table
    ]
    best = max(
        (*_of_ranges(givens, tried), *_of_ratios(givens, tried), *_of_rows(tried)),
        key=lambda each: each.weight,
        default=None,
    )
    if best is None:
        return ""
    return f"with {best.words} it would be {100 * best.within:.0f} % of them; beyond that it is {100 * best.beyond:.0f} %"


def _of_ranges(givens: Sequence[Given], tried: Sequence[TriedDraw]) -> Iterator[RangeLimit]:
    for given in givens:
        unit = f" {show(given.unit)}" if show(given.unit) else ""

        def words(least: bool, value: Fraction, given: Given = given, unit: str = unit) -> str:
            return f"{given.symbol} {'from' if least else 'to'}: {number(given, value)}{unit}"

        pairs = [(each.variant.values[given.symbol], each.admitted) for each in tried]
        yield from _limits(pairs, sorted({value for value, _admitted in pairs}), words, 1.0)


def _of_rows(tried: Sequence[TriedDraw]) -> Iterator[RangeLimit]:
    """Each row of a table, left out."""
    for columns in tables(tried[0].variant.problem):
        for place in range(columns[0].grid.count):
            row = {given.symbol: given.grid[place] for given in columns}
            own = [each.admitted for each in tried if row.items() <= each.variant.values.items()]
            others = [each.admitted for each in tried if not row.items() <= each.variant.values.items()]
            if min(len(own), len(others)) < ENOUGH:
                continue
            inside, outside = (1 - sum(each) / len(each) for each in (others, own))
            if outside - inside >= FEWER:
                words = f"the row ({row_in_words(columns, place)}) left out"
                weight = len(own) * len(others) * (outside - inside) ** 2
                yield RangeLimit(words, inside, outside, weight)


def _of_ratios(givens: Sequence[Given], tried: Sequence[TriedDraw]) -> Iterator[RangeLimit]:
    """Two givens that measure the same, none of which can be zero or less."""
    for one, other in combinations([each for each in givens if each.sign > 0], 2):
        if one.unit.dimension != other.unit.dimension:
            continue

        def words(least: bool, value: Fraction, one: Given = one, other: Given = other) -> str:
            return f"{one.symbol} {'>=' if least else '<='} {decimal_text(float(value), 2)}*{other.symbol} (under where:)"

        ratios = [
            (each.variant.exact[one.symbol].ratio / each.variant.exact[other.symbol].ratio, each.admitted)
            for each in tried
        ]
        neat = {Fraction(decimal_text(float(value), 2)) for value, _admitted in ratios}
        yield from _limits(ratios, sorted(neat), words, A_CONDITION)


def _limits(
    pairs: Sequence[tuple[Fraction, bool]],
    values: Sequence[Fraction],
    words: Callable[[bool, Fraction], str],
    worth: float,
) -> Iterator[RangeLimit]:
    """From each value on, and up to it, where that tells what is refused from what is not."""
    for value in values[:: 1 + len(values) // CANDIDATES]:
        for least in (True, False):
            within = [admitted for each, admitted in pairs if (each >= value if least else each <= value)]
            beyond = [admitted for each, admitted in pairs if not (each >= value if least else each <= value)]
            if min(len(within), len(beyond)) < max(ENOUGH, len(pairs) / 10):
                continue
            inside, outside = (1 - sum(each) / len(each) for each in (within, beyond))
            if outside - inside >= FEWER:
                weight = worth * len(within) * len(beyond) * (outside - inside) ** 2
                yield RangeLimit(words(least, value), inside, outside, weight)


LEAST = 100  # variants
SIMULATED = 8  # of them: a simulation takes a second where algebra takes a millisecond
TOO_MANY = 0.8  # of the draws refused: then few numbers are left, and much alike
HALF = 0.5  # of them: a student waits no longer for it, but what is left may be less than the ranges promise
MANY = 50  # variants: an option that is right in all of these is right for all numbers
AGREE = 1e-9  # relative


@dataclass(frozen=True, slots=True)
class Walked:
    """The share of draws refused and why, and the keys of the first variants, to be simulated."""

    refused: float
    reasons: Counter[str]
    first: tuple[Key, ...]


def walk(bank: Bank, solution: Solution, tally: Tally, count: int = LEAST) -> Walked:
    """Draws until `count` variants are admitted (or all are seen)."""
    problem, reasons, met = solution.problem, Counter[str](), 0
    tried, first = list[TriedDraw](), list[Key]()
    right: dict[str, Counter[str]] = {part: Counter() for part in solution.choices}
    magnitudes, cases = magnitudes_asked(problem), CasesWalked(solution)
    for variant in sample(problem, 20 * count):
        key, reason = admitted(solution, variant)
        tried.append(TriedDraw(variant, key is not None))
        cases.count(variant, reason)
        if key is None:
            reasons[reason] += 1
            continue
        met += 1
        tally.count("variants walked")
        for part, letter in key.choices.items():
            right[part][letter] += 1
        for part, sentence in negative_magnitudes(magnitudes, key):
            tally.complain(sentence)
            del magnitudes[part]
        check_right(key, tally)
        check_neglected(bank, key, tally)
        if met <= SIMULATED:
            first.append(key)
        if met == count:
            break
    for key in keys_of_rows(solution, tally):
        check_right(key, tally)
        check_neglected(bank, key, tally)
        first.insert(0, key)
    refused = sum(reasons.values())
    share = refused / len(tried) if tried else 0.0
    ranges = f"{problem.path.name}:{problem.givens[0].line if problem.givens else 1}"
    if share > HALF:
        say = tally.complain if share > TOO_MANY else tally.note
        why, how = (
            reasons.most_common(1)[0][0],
            _all_refused(reasons)
            if share == 1
            else narrower(tried) or "change the ranges, or ask for the formula",
        )
        if "honest rounding" in why:
            how += '; or give the part a tolerance="5 %" (up to 20 %), with its because="…"'
        say(f"{ranges}: {100 * share:.0f} % of the draws may not be assigned ({why}); {how}")
    elif size(problem) > 1 and not met:
        tally.complain(f"{ranges}: no variant keeps all the conditions; widen the ranges, or drop one")
    for line, sentence in cases.never_dealt(len(tried) == size(problem)):
        tally.complain(f"{name_in_bank(bank.solution(problem))}:{line}: {sentence}")
    for part, letters in right.items():
        for letter in sorted(solution.choices[part].mistakes.keys() & letters):
            if letters[letter] == met >= MANY:
                tally.complain(
                    f"{name_in_bank(bank.solution(problem))}:{solution.choices[part].statement.line}: option {letter} of part {part} is right "
                    f"for all of {met} variants, and has a mistake; which of both is meant?"
                )
    own, reason = admitted(solution, chapter(problem))
    tally.count("chapter's own numbers")
    if own is None and reason.startswith("an answer does not exist"):
        tally.complain(f"{ranges}: the chapter's own numbers: {reason}")
    if (broken := first_broken(chapter(problem), hard_only=True)) is not None:
        tally.complain(f"{problem.path.name}:{broken.line}: the chapter's own numbers break {broken.text}")
    return Walked(share, reasons, tuple(first[:SIMULATED]))


def _all_refused(reasons: Counter[str]) -> str:
    """What is likeliest where no draw at all may be assigned."""
    if all("the mistake" in reason for reason in reasons):
        return "your law may be the mistake: compare it with the one that the mistake is made of"
    return "change the ranges, or ask for the formula"


def check_right(key: Key, tally: Tally) -> None:
    """The key's own answers are judged right, and every mistake stands apart."""
    problem = key.variant.problem
    answers = {part: own_answer(key, part) for part in key.truths}
    judged = judge(key, answers)
    for part in key.truths:
        (verdict,), _ = judged[part]
        if not tally.check(isinstance(verdict, Right), "right answers"):
            tally.complain(
                f"{problem.path.name}:{problem.part(part).line}: part {part} of {key.variant.label}: "
                f"the key's own answer is judged {word(verdict)}"
            )
    tally.count("mistakes apart", sum(len(find.mistakes) for find in key.solution.unknowns))
    for part, slip in collisions(key):
        where = f"{problem.path.name}:{problem.part(part).line}: part {part} of {key.variant.label}"
        tally.complain(f"{where}: {slip!r} cannot be told from the truth")


def check_neglected(bank: Bank, key: Key, tally: Tally) -> None:
    """What an answer leaves out changes it by less than it may be off."""
    path = bank.solution(key.variant.problem)
    for each in neglects(key):
        allowed = key.truths[each.part].tolerance
        if not tally.check(each.left.asked or each.share <= allowed, "neglected effects"):
            tally.complain(
                f"{name_in_bank(path)}:{each.left.statement.line}: part {each.part} of {key.variant.label} "
                f"neglects {each.left.what}, which may change the answer by {each.share:.2%}, "
                f"more than the {allowed:.2%} it may be off; narrow the ranges, or count it in"
            )


def check_scenes(loaded: Loaded, key: Key, tally: Tally) -> list[tuple[Simulation, Run]]:
    """Newton's second law, simulated, meets the algebra within the run's own error and what the scene neglects. Each run that there was."""
    found: list[tuple[Simulation, Run]] = []
    answers: dict[str, Seen] = {
        part: truth.values[0] if len(truth.values) == 1 else truth.values
        for part, truth in key.truths.items()
    }
    for wanted in simulations_of(loaded, key.variant, answers, neglected_in(key)):
        run_of = check_scene(
            wanted,
            f"{name_in_bank(loaded.path)}:{wanted.line}: scene {wanted.name} on {key.variant.label}",
            tally,
        )
        if run_of is not None:
            found.append((wanted, run_of))
    return found


def check_scene(wanted: Simulation, about: str, tally: Tally) -> Run | None:
    """One scene, run and held against what it must show; None where it cannot be run."""
    try:
        found = (
            run(wanted.scene, wanted.settings, tolerance=1e-10, second_way=True, bank=wanted.bank)
            if isinstance(wanted.scene, str)
            else followed(wanted.scene, wanted.expect.keys(), tolerance=1e-10)
        )
    except (BadSetting, GuardFailed) as error:
        tally.complain(f"{about}: {error}")
        return None
    for name, expected in wanted.expect.items():
        if name not in found.observed:
            tally.complain(f"{about} does not observe {name}; it observes {', '.join(found.observed)}")
            continue
        mine, theirs = _list(expected), _list(found.observed[name])
        if not tally.check(meets(wanted, found, name), "simulations met"):
            tally.complain(f"{about}: {name} is {theirs} where the algebra says {mine}")
    return found


def meets(wanted: Simulation, found: Run, name: str) -> bool:
    """Whether a run shows what is wanted, within its errors and what the scene neglects."""
    if name not in found.observed:
        return False
    mine, theirs = _list(wanted.expect[name]), _list(found.observed[name])
    allowed = (AGREE + wanted.neglected) * max(map(abs, (*mine, *theirs)))
    allowed += 3 * math.hypot(*components(found.errors[name]))
    return len(mine) == len(theirs) and math.dist(mine, theirs) <= allowed


def own_answer(key: Key, part: str) -> Value:
    """The key's answer as a student would hand it in: numbers in the part's unit, or the formula where that is asked for."""
    question, truth = key.variant.problem.part(part), key.truths[part]
    in_givens = key.find(truth).in_givens
    if answer_type(question.answer_type).in_symbols and in_givens is not None:
        texts = tuple(Text(text(tree)) for tree in in_givens)
        return texts[0] if len(texts) == 1 else Items(texts, (len(texts),))
    pairs = zip(truth.values, question.units_for(len(truth.values)), strict=True)
    return machine_numbers(tuple(unit.from_si(value) for value, unit in pairs))


def machine_numbers(values: tuple[float, ...]) -> Value:
    """Numbers as a student's process would hand them out."""
    return Real(values[0]) if len(values) == 1 else Items(tuple(map(Real, values)), (len(values),))


def _list(seen: Seen) -> tuple[float, ...]:
    return seen if isinstance(seen, tuple) else (seen,)
