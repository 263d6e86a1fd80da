"""Possible mistakes: those that a solution lists and slips of input; what each makes of a part, and where it shows first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice, product

from corollary.answers.expected import Values
from corollary.answers.tolerance import within
from corollary.derive.solution import ClosedForms, Rule, Solution, once
from corollary.derive.statements import Mistake
from corollary.formula.ast import Expr, cofunction, mapped, substitute
from corollary.formula.ball import RationalPi, Undefined, holds
from corollary.grading.key import Key, Truth
from corollary.grading.replay import BY_THE_RULES, WhatIf, ancestors, letters_of, replay, without_noise
from corollary.messages import catalogue
from corollary.problem.axes import axes
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant, chapter, first_broken
from corollary.units.unit import Dimension

_ = catalogue(__name__)

SPEED = Dimension(Fraction(0), Fraction(1), Fraction(-1))
USUAL_GRAVITY = (Fraction("9.8"), Fraction("9.81"))
SAME = 1e-9  # relative: doubles of one value by two ways
TRIED = (
    40  # draws besides the printed numbers: a mistake that shows on a tenth of them is missed once in seventy
)
CORNERS = 64  # of the grid, tried besides


@dataclass(frozen=True, slots=True)
class ListedMistake:
    """A mistake that the solution lists at the step `place`, and the step `at` that it is looked for in, which answers `part`."""

    place: int
    mistake: Mistake[Rule]
    part: str
    at: int

    @property
    def what_if(self) -> WhatIf:
        return WhatIf(rules={self.place: self.mistake.rule})

    def values(self, solution: Solution, givens: Mapping[str, RationalPi]) -> Values:
        """Raises Undefined."""
        return replay(solution, givens, self.what_if, self.at)[self.at]

    def formulas(self, solution: Solution) -> tuple[Expr, ...] | None:
        """In givens; None where a scene is run."""
        meaning: dict[str, Expr] = {}
        trees: tuple[Expr, ...] | None = None
        for here, find in enumerate(solution.unknowns[: self.at + 1]):
            if here == self.place or (here > self.place and self.place in ancestors(solution, here)):
                by = self.mistake.rule if here == self.place else find.local
                in_formulas = isinstance(by, ClosedForms)
                trees = tuple(substitute(tree, meaning) for tree in by.trees) if in_formulas else None
            else:
                trees = find.in_givens
            if trees is None:
                if here in (self.place, self.at) or here in ancestors(solution, self.at):
                    return None
                continue
            meaning |= zip(find.names, trees, strict=find.numbering is None)
        return trees


def own_mistakes(solution: Solution, place: int) -> list[ListedMistake]:
    """Those listed at a step, looked for in the step itself."""
    find = solution.unknowns[place]
    return [ListedMistake(place, mistake, find.part, place) for mistake in find.mistakes]


def listed_mistakes(solution: Solution, at: int) -> list[ListedMistake]:
    """Those that may change a step: at its own place, then at those before it that it is made of, from the last back."""
    part = solution.unknowns[at].part
    return [
        ListedMistake(place, mistake, part, at)
        for place in sorted(ancestors(solution, at) | {at}, reverse=True)
        for mistake in solution.unknowns[place].mistakes
    ]


def wrong_values(key: Key, truth: Truth, base: WhatIf = BY_THE_RULES) -> Iterator[tuple[Values, str]]:
    """What each listed mistake makes of a part, but for those at steps whose values are held; and what the student reads."""
    for each in listed_mistakes(key.solution, truth.place):
        if each.place not in base.held:
            what_if = WhatIf(base.held, {**base.rules, **each.what_if.rules})
            yield from _replayed(key, truth, what_if, key.variant.exact, each.mistake.text)


def wrong_formulas(key: Key, place: int) -> Iterator[tuple[tuple[Expr, ...], str]]:
    """What each listed mistake makes of the formulas of an unknown in givens."""
    for each in listed_mistakes(key.solution, place):
        if (trees := each.formulas(key.solution)) is not None:
            yield trees, each.mistake.text


def overlooked(key: Key, part: Part) -> dict[str, str]:
    """What those overlook who take a wrong option, by its letter on the sheet."""
    choice = key.solution.choices.get(part.id)
    return {} if choice is None else {part.letter_asked(each): text for each, text in choice.mistakes.items()}


def slips_of_input(key: Key, truth: Truth, base: WhatIf) -> Iterator[tuple[Values, str]]:
    """What slips in the numbers put in make of the part: g = 10, a unit not converted, sine for cosine."""
    givens, variant = key.variant.exact, key.variant
    if "g" in givens and givens["g"].ratio in USUAL_GRAVITY:
        changed = {**givens, "g": RationalPi(Fraction(10))}
        sentence = _("You calculated with g = 10 m/s²; the problem gives a closer value.")
        yield from _replayed(key, truth, base, changed, sentence)
    for given in variant.problem.givens:
        if not given.unit.bare:
            bare = RationalPi(variant.values[given.symbol])
            yield from _replayed(key, truth, base, {**givens, given.symbol: bare}, _unconverted(given))
    if any(_is_angle(variant, given.symbol) for given in variant.problem.givens):
        swapped: dict[int, Rule] = {
            place: _with_cofunctions(find.local)
            for place, find in enumerate(key.solution.unknowns)
            if isinstance(find.local, ClosedForms)
        }
        what_if = WhatIf(base.held, swapped | dict(base.rules))
        sentence = _("Sine and cosine are interchanged: check from where the angle is measured.")
        yield from _replayed(key, truth, what_if, givens, sentence)


def _with_cofunctions(rule: ClosedForms) -> ClosedForms:
    form = None if rule.form is None else mapped(rule.form, cofunction)
    return replace(rule, trees=tuple(mapped(tree, cofunction) for tree in rule.trees), form=form)


def _replayed(
    key: Key, truth: Truth, what_if: WhatIf, givens: Mapping[str, RationalPi], sentence: str
) -> Iterator[tuple[Values, str]]:
    try:
        yield without_noise(key.solution, givens, what_if, truth.place, truth.scale), sentence
    except Undefined:
        return


def _unconverted(given: Given) -> str:
    """What the student reads where the bare number of a given was put in."""
    if given.unit.pi and given.unit.dimension == Dimension():
        return _("Your calculator was set to radians, but the angle is given in degrees.")
    if given.unit.dimension == SPEED:
        return _("{symbol} was put in as if it were in m/s; convert km/h first.", symbol=given.symbol)
    return _("{symbol} was put in without converting its unit to SI.", symbol=given.symbol)


def _is_angle(variant: Variant, symbol: str) -> bool:
    unit = variant.problem.given(symbol).unit
    return (bool(unit.pi) and unit.dimension == Dimension()) or unit.text == "rad"


@once
def visible_mistakes(solution: Solution) -> list[ListedMistake]:
    """Each in the parts where it shows first, if it changes them; in the order of the steps, and of their mistakes."""
    own = (each for place in range(len(solution.unknowns)) for each in own_mistakes(solution, place))
    return [
        each for mistake in own for each in _parts_first_met(solution, mistake) if _differs(solution, each)
    ]


def hidden_mistakes(solution: Solution) -> Iterator[tuple[ListedMistake, list[ListedMistake]]]:
    """Those that change no part, each with itself in the parts where it would show first: no number is kept from being dealt
    for them."""
    visible = {(each.place, each.mistake.line, each.mistake.text) for each in visible_mistakes(solution)}
    for place in range(len(solution.unknowns)):
        for each in own_mistakes(solution, place):
            if (place, each.mistake.line, each.mistake.text) not in visible:
                yield each, _parts_first_met(solution, each)


def _parts_first_met(solution: Solution, own: ListedMistake) -> list[ListedMistake]:
    """A mistake in its own part, or in those that are made of its step without another part between."""
    if own.part:
        return [own]
    return [
        replace(own, part=other.part, at=at)
        for at, other in enumerate(solution.unknowns)
        if other.part and own.place in ancestors(solution, at) and _unasked_way(solution, own.place, at)
    ]


def _differs(solution: Solution, each: ListedMistake) -> bool:
    """True if the mistake changes the part for some numbers: the printed ones, where it may coincide, or those of other draws."""
    return each.place == each.at or any(
        _differs_for(solution, givens, each) for givens in numbers_tried(solution)
    )


def numbers_tried(solution: Solution) -> Iterator[Mapping[str, RationalPi]]:
    """The printed numbers first, which mostly decide; of a case, only numbers for which it holds."""
    own = chapter(solution.problem).exact
    if _in_case(solution, own):
        yield own
    yield from _other_numbers(solution)


@once
def _other_numbers(solution: Solution) -> list[dict[str, RationalPi]]:
    """Draws, then corners of the grid, where a mistake of a small effect shows most."""
    problem = solution.problem
    found = sample(problem, TRIED * (5 if solution.conditions else 1), salt="mistakes")
    fitting = [each.exact for each in found if _in_case(solution, each.exact)][:TRIED]
    every = axes(problem.givens)
    ends = [(0, axis[0].grid.count - 1) if axis[0].grid.count > 1 else (0,) for axis in every]
    for places in islice(product(*ends), CORNERS):
        values = {
            given.symbol: given.grid[at] for axis, at in zip(every, places, strict=True) for given in axis
        }
        variant = Variant(problem, values, None)
        if first_broken(variant) is None and _in_case(solution, variant.exact):
            fitting.append(variant.exact)
    return fitting


def _in_case(solution: Solution, givens: Mapping[str, RationalPi]) -> bool:
    try:
        return all(holds(each, givens) for each in solution.conditions)
    except Undefined:
        return False


def _differs_for(solution: Solution, givens: Mapping[str, RationalPi], each: ListedMistake) -> bool:
    try:
        truth = replay(solution, givens, until=each.at)[each.at]
        other = each.values(solution, givens)
    except Undefined:
        return False
    if not solution.problem.part(each.part).rows:
        return not _alike(other, truth)
    return not all(_alike((mine,), (theirs,)) for mine, theirs in zip(other, truth, strict=True))


def _alike(values: Values, truth: Values) -> bool:
    return within(values, truth, SAME, max(map(abs, truth), default=0.0) or 1.0)


def _unasked_way(solution: Solution, start: int, end: int) -> bool:
    """Whether a way of rules leads from one find to another over finds nobody is asked about."""
    names_of: Mapping[str, int] = {
        name: place for place, find in enumerate(solution.unknowns) for name in find.names
    }
    todo, seen = [end], set[int]()
    while todo:
        place = todo.pop()
        for name in letters_of(solution.unknowns[place].local):
            above = names_of.get(name)
            if above == start:
                return True
            if above is not None and above not in seen and not solution.unknowns[above].part:
                seen.add(above)
                todo.append(above)
    return False
