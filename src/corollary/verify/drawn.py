"""Draws of a problem as its author looks at them: the answers, what each mistake would give, why some are redrawn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from corollary.answers.expected import Values
from corollary.answers.option_names import option_named
from corollary.answers.registry import answer_type
from corollary.derive.solution import Solution
from corollary.formula.ball import Undefined
from corollary.formula.numerals import decimal_text
from corollary.formula.plain_text import text
from corollary.grading.assign import admitted
from corollary.grading.forces_on_body import as_answered, as_people_say, free_body
from corollary.grading.key import Key, make_key
from corollary.grading.mistakes import visible_mistakes
from corollary.grading.replay import without_noise
from corollary.problem.part import Part
from corollary.problem.sampling import spread
from corollary.problem.variant import Variant, chapter, first_broken
from corollary.units.unit import show
from corollary.verify.walk import HALF, TriedDraw, narrower

REDRAWN = 10  # are enough to see what it is
MOST_DRAWS = 2000  # a student's numbers are sought as long
FIGURES = 5  # more than any tolerance asks for: how near a mistake comes is seen


@dataclass(frozen=True, slots=True)
class Foreseen:
    """A mistake and what it gives: a number with its unit, an option's letter, or nothing where it has no value."""

    text: str
    gives: str


@dataclass(frozen=True, slots=True)
class KeyedPart:
    """What is right for a part; `tolerance` is relative, 0 for what is no quantity, `noise` what rounding the steps moves;
    `bare` is the answer without its unit."""

    part: Part
    answer: str
    bare: str
    formula: str
    tolerance: float
    noise: float
    mistakes: tuple[Foreseen, ...]


@dataclass(frozen=True, slots=True)
class Draw:
    """A variant that may be assigned, or the reason why it is redrawn; `key` is there whenever the answers exist."""

    variant: Variant
    key: Key | None
    reason: str


@dataclass(frozen=True, slots=True)
class PreviewDraws:
    """Draws that may be assigned, with the first few of those that are redrawn, how many are redrawn in all, and where more than
    half of those that keep all conditions are, what limit would leave fewer."""

    draws: list[Draw]
    redrawn: int
    advice: str


def drawn(solution: Solution, count: int) -> PreviewDraws:
    """The chapter's own numbers, then points of the grid as they come until so many may be assigned."""
    draws, redrawn, tried = [_draw(solution, chapter(solution.problem))], 0, list[TriedDraw]()
    for variant in spread(solution.problem, MOST_DRAWS, salt="preview"):
        broken = first_broken(variant) is not None
        if not broken:
            tried.append(TriedDraw(variant, admitted(solution, variant)[0] is not None))
        if broken or not tried[-1].admitted:
            redrawn += 1
            if redrawn > REDRAWN:
                continue
        draws.append(_draw(solution, variant))
        if len(draws) - 1 - min(redrawn, REDRAWN) == count:
            break
    refused = sum(not each.admitted for each in tried)
    return PreviewDraws(draws, redrawn, narrower(tried) if refused > HALF * len(tried) else "")


def _draw(solution: Solution, variant: Variant) -> Draw:
    if (broken := first_broken(variant)) is not None:
        reason = f"the condition `{broken.text}` does not hold"
    else:
        key, reason = admitted(solution, variant)
        if key is not None:
            return Draw(variant, key, "")
    try:
        return Draw(variant, make_key(solution, variant), reason)
    except Undefined:
        return Draw(variant, None, reason)


def keyed_parts(key: Key) -> Iterator[KeyedPart]:
    """Each part with its answer and the answers of its mistakes."""
    for part in key.variant.problem.parts:
        if part.id in key.choices:
            letter = option_named(part, key.choices[part.id]).strip("()")
            foreseen = (
                Foreseen(sentence, option_named(part, option).strip("()"))
                for option, sentence in key.solution.choices[part.id].mistakes.items()
            )
            yield KeyedPart(part, letter, letter, "", 0.0, 0.0, tuple(foreseen))
        elif (truth := key.truths.get(part.id)) is not None:
            trees = key.find(truth).in_givens or ()
            formula = ", ".join(map(text, trees)) if answer_type(part.answer_type).in_symbols else ""
            yield KeyedPart(
                part,
                formula if part.of else written_out(truth.values, part),
                formula if part.of else bare(truth.values, part),
                formula,
                0.0 if part.of else truth.tolerance,
                0.0 if part.of else truth.noise,
                tuple(_foreseen(key, part)),
            )
        elif part.id in key.solution.forces:
            body = free_body(key.solution.forces[part.id], key.variant)
            extra = (
                Foreseen(sentence, option_named(part, letter))
                for letter, sentence in body.misconceptions.items()
            )
            yield KeyedPart(
                part, as_people_say(body, part), as_answered(body, part), "", 0.0, 0.0, tuple(extra)
            )
        else:
            yield KeyedPart(part, "", "", "", 0.0, 0.0, ())


def _foreseen(key: Key, part: Part) -> Iterator[Foreseen]:
    solution = key.solution
    for each in visible_mistakes(solution):
        if each.part != part.id:
            continue
        if part.of:
            yield Foreseen(each.mistake.text, ", ".join(map(text, each.formulas(solution) or ())))
            continue
        try:
            scale = key.truths[part.id].scale
            values = without_noise(solution, key.variant.exact, each.what_if, each.at, scale)
        except Undefined:
            yield Foreseen(each.mistake.text, "")
        else:
            yield Foreseen(each.mistake.text, written_out(values, part))


def written_out(values: Values, part: Part) -> str:
    """Numbers in the part's unit as people read them."""
    if part.rows:
        pairs = zip(values, part.units_for(len(values)), strict=True)
        return "; ".join(written_out((value,), replace(part, rows=(), unit=unit)) for value, unit in pairs)
    unit = show(part.unit)
    return bare(values, part) + (f"\N{NO-BREAK SPACE}{unit}" if unit else "")


def bare(values: Values, part: Part) -> str:
    """The same without the unit."""
    if part.rows:
        pairs, width = list(zip(values, part.units, strict=True)), len(part.columns)
        rows = (pairs[place : place + width] for place in range(0, len(pairs), width))
        return "; ".join(
            ", ".join(bare((value,), replace(part, rows=(), unit=unit)) for value, unit in row)
            for row in rows
        )
    numbers = ", ".join(decimal_text(value / part.unit.si, FIGURES).replace("-", "−") for value in values)
    return f"({numbers})" if len(values) > 1 else numbers
