"""The marking scheme for one student's numbers: answers and tolerances, what is carried, what mistakes earn."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from corollary.answers.expected import Values
from corollary.answers.verdict import Follows, Mistaken, Slip
from corollary.derive.solution import ClosedForms
from corollary.derive.worked_solution import model_answer
from corollary.formula.ast import Expr, names, substitute
from corollary.grading.follow_through import same_as
from corollary.grading.key import Key, Truth
from corollary.grading.mistakes import overlooked, wrong_formulas, wrong_values
from corollary.grading.points import share
from corollary.problem.part import Part
from corollary.problem.problem_set import Scheme

INSIDE = 1 - 1e-9  # at the very end of the tolerance the last bit of a double would decide
MOST_WAYS = 2  # beside the author's own, which is the first: each is a line to read


@dataclass(frozen=True, slots=True)
class CarriedAnswer:
    """What a part becomes by the student's own answers to the parts `earlier`: formulas in their letters and in givens."""

    earlier: tuple[str, ...]
    trees: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class KnownMistake:
    """What a known misconception gives: values in SI, or the letter of an option, or formulas; what is said of it, and the points it
    earns."""

    values: Values
    letter: str
    sentence: str
    points: float
    formulas: tuple[Expr, ...] = ()


@dataclass(frozen=True, slots=True)
class AcceptedRange:
    """Between which numbers (in the part's unit) an answer is right, rounded to the inside at the place 10**`place`; `reach` is how
    far a vector may end from the right one."""

    low: Fraction
    high: Fraction
    reach: Fraction
    place: int


@dataclass(frozen=True, slots=True)
class PartScheme:
    """How one part is marked. `truth` of a quantity, or `letter` of the right option, or an `answer` in Markdown, which a person
    compares with (of an option: why it is the one). `carried` earns `follows`, a slip `slip` points."""

    part: Part
    out_of: float
    truth: Truth | None
    letter: str
    answer: str
    carried: tuple[CarriedAnswer, ...]
    mistakes: tuple[KnownMistake, ...]
    follows: float
    slip: float

    @property
    def accepted(self) -> AcceptedRange | None:
        """What the tolerance allows a quantity; of one with components `low` and `high` are those of the first. None for other
        parts, for a table, and where there is no tolerance."""
        if self.truth is None or self.truth.scales:
            return None
        reach = INSIDE * self.truth.tolerance * self.truth.scale / self.part.unit.si
        if not reach or not math.isfinite(reach):
            return None
        place = math.floor(math.log10(reach)) - 1
        step, exact = Fraction(10) ** place, Fraction(reach)
        value = Fraction(self.part.unit.from_si(self.truth.values[0]))
        return AcceptedRange(
            math.ceil((value - exact) / step) * step,
            math.floor((value + exact) / step) * step,
            math.floor(exact / step) * step,
            place,
        )


def marking_scheme(key: Key, scheme: Scheme, weight: float = 1.0) -> tuple[PartScheme, ...]:
    """How each part of a variant is marked; `weight` multiplies the points, as in the set."""
    return tuple(_part(key, part, scheme, part.points * weight) for part in key.variant.problem.parts)


def _part(key: Key, part: Part, scheme: Scheme, out_of: float) -> PartScheme:
    truth = key.truths.get(part.id)
    if truth is not None:
        mistakes = tuple(_mistakes(key, part, truth, scheme, out_of))
    else:
        points = out_of * share(Mistaken(""), scheme, part.answer_type)
        mistakes = tuple(KnownMistake((), *each, points) for each in overlooked(key, part).items())
    return PartScheme(
        part,
        out_of,
        truth,
        key.choices.get(part.id, ""),
        "" if truth is not None else model_answer(key.solution, part, {}, key.variant),
        tuple(_carried(key, truth)) if truth is not None else (),
        mistakes,
        out_of * share(Follows(()), scheme),
        out_of * share(Slip(""), scheme),
    )


def _mistakes(key: Key, part: Part, truth: Truth, scheme: Scheme, out_of: float) -> Iterator[KnownMistake]:
    """Each value that a misconception gives, once, unless it cannot be told from the truth."""
    if part.of:
        for trees, sentence in wrong_formulas(key, truth.place):
            points = out_of * share(Mistaken(sentence), scheme, part.answer_type)
            yield KnownMistake((), "", sentence, points, trees)
        return
    seen: list[Values] = []
    for values, sentence in wrong_values(key, truth):
        if any(replace(truth, values=other).is_met_by(values) for other in (truth.values, *seen)):
            continue
        seen.append(values)
        verdict = Mistaken(sentence, nothing=not any(values))
        yield KnownMistake(values, "", sentence, out_of * share(verdict, scheme, part.answer_type))


def _carried(key: Key, truth: Truth) -> Iterator[CarriedAnswer]:
    """By the author's way and by others, each in the letters of what was asked before."""
    solution, parts = key.solution, key.asked
    if same_as(solution, truth.place) in parts:
        return  # written down again it earns nothing
    ways = [*_authors_way(key, truth)]
    for way in solution.paths.get(key.find(truth).part, ()):
        if (
            way.earlier
            and parts.issuperset(way.earlier)
            and len(ways) <= MOST_WAYS
            and all(way.trees != other.trees for other in ways)
        ):
            ways.append(CarriedAnswer(way.earlier, way.trees))
    yield from ways


def _authors_way(key: Key, truth: Truth) -> Iterator[CarriedAnswer]:
    """What the sheet does not ask about is put in; what is simulated stays a letter, whose value is known."""
    parts = key.asked
    meaning: dict[str, Expr] = {}
    asked: dict[str, str] = {}
    for place, find in enumerate(key.solution.unknowns[: truth.place + 1]):
        if not isinstance(find.local, ClosedForms):
            continue
        trees = tuple(substitute(tree, meaning) for tree in find.local.trees)
        if place == truth.place:
            letters = names(*trees)
            earlier = tuple(dict.fromkeys(part for name, part in asked.items() if name in letters))
            if earlier:
                yield CarriedAnswer(earlier, trees)
        elif find.part in parts:
            asked |= dict.fromkeys(find.names, find.part)
        else:
            meaning |= dict(zip(find.names, trees, strict=True))
