"""What a student may think about whose answer is wrong: laws, quantities and a check, from the derivation, and nothing of the answer."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Set
from itertools import islice

from corollary.derive.solution import AppliedLaw, ClosedForms, Solution, Unknown
from corollary.derive.statements import Choice
from corollary.formula.ast import Name, Relation, names
from corollary.grading.key import Key
from corollary.grading.replay import letters_of
from corollary.messages import catalogue, spoken
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.translation import text_in_language
from corollary.units.unit import PURE, show

_ = catalogue(__name__)
_law_name = catalogue("corollary.laws")

MOST_LAWS = 3
MOST_QUANTITIES = 5
EQUATIONS = re.compile(r"[\d().,\s–-]+")  # numbers of equations; a source in words may be the formula itself
WITHOUT_ARTICLE = frozenset({"your", "its", "the", "a", "an", "how"})


def advice(key: Key, part: Part) -> str:
    """Which laws lead to the answer of this part, which quantities they connect it with, and a check; "" where nothing is known."""
    solution = key.solution
    if part.id in solution.choices:
        return _of_choice(key, solution.choices[part.id])
    asked = solution.answer(part.id)
    if asked is None:
        return ""
    steps = _steps(key, asked)
    laws = list(islice(_named(law for step in reversed(steps) for law in step.laws), MOST_LAWS))
    used = _used(key, steps)
    quantities = [_described(key, each) for each in used[:MOST_QUANTITIES]]
    quantities += [_("your answer in {part}", part=f"({earlier})") for earlier in _earlier(key, steps)]
    sentences: list[str] = []
    if laws:
        sentences.append(_("Think of: {laws}.", laws=_listed(laws)))
    if quantities:
        sentences.append(_("What counts here: {quantities}.", quantities=_listed(quantities)))
    return " ".join([*sentences, _check(key, part, asked, used)])


def _steps(key: Key, asked: Unknown) -> list[Unknown]:
    """The step that answers the part, and before it those that lead to it and that the sheet does not ask for."""
    return steps_to(key.solution, asked, key.asked)


def steps_to(solution: Solution, asked: Unknown, known: Set[str]) -> list[Unknown]:
    """The step that answers the part, and those that lead to it from the givens and from the parts that are `known`; from the
    last back."""
    homes = {name: find for find in solution.unknowns for name in find.names}
    found, left = list[Unknown](), [asked]
    while left:
        step = left.pop()
        if all(step is not each for each in found):
            found.append(step)
            before = (homes[name] for name in sorted(letters_of(step.local)) if name in homes)
            left += [each for each in before if each.part not in known]
    return found


def _used(key: Key, steps: Iterable[Unknown]) -> list[Given]:
    letters = frozenset[str]().union(*(letters_of(step.local) for step in steps))
    return [given for given in key.variant.problem.givens if given.symbol in letters]


def _earlier(key: Key, steps: Iterable[Unknown]) -> list[str]:
    """The parts whose answers are used."""
    letters = frozenset[str]().union(*(letters_of(step.local) for step in steps))
    asked = {find.part for find in key.solution.unknowns if find.part and letters & set(find.names)}
    return [part.heading_letter for part in key.variant.problem.parts if part.id in asked]


def _named(laws: Iterable[AppliedLaw]) -> Iterator[str]:
    """Each law by its name, once; one without a source that only says that two things are the same is none."""
    seen = set[str]()
    for law in laws:
        sides = law.textbook.left, law.textbook.right
        if law.name not in seen and (law.source or not all(isinstance(side, Name) for side in sides)):
            seen.add(law.name)
            yield _law_name(law.name) + (f" {law.source}" if EQUATIONS.fullmatch(law.source) else "")


def _described(key: Key, given: Given) -> str:
    """What a given means, with its article: `the mass of the ball`, `your mass`; a translation has its own."""
    theirs = text_in_language(key.variant.problem, given.meaning)
    if theirs != given.meaning or spoken() != "en":  # the variant may be of a translated problem already
        return theirs
    first = given.meaning.partition(" ")[0]
    return given.meaning if first[:1].isupper() or first in WITHOUT_ARTICLE else f"the {given.meaning}"


def _listed(words: list[str]) -> str:
    return "; ".join(words)


def _check(key: Key, part: Part, asked: Unknown, used: list[Given]) -> str:
    """Something to try that needs no key: the step of a program, a size, a limiting case, the units."""
    if not isinstance(asked.local, ClosedForms):
        return _("A check: does the number stay when you halve the step of your program?")
    alike = next((given for given in used if given.unit.dimension == part.unit.dimension), None)
    if alike is not None and part.unit.dimension != PURE.dimension and not part.components:
        return _(
            "A check: must it be larger or smaller than {quantity}, and why?", quantity=_described(key, alike)
        )
    if used:
        return _(
            "A check: what should become of it if {quantity} were very small, and does it in your way of solving?",
            quantity=_described(key, used[0]),
        )
    if unit := show(part.unit):
        return _("A check: do the units of all that you used come to {unit}?", unit=unit)
    return _("A check: say in words why it must be so, without any formula.")


def _of_choice(key: Key, choice: Choice[Relation | bool]) -> str:
    conditions = [each for each in choice.options.values() if isinstance(each, Relation)]
    letters = frozenset[str]().union(*(names(each.left) | names(each.right) for each in conditions))
    used = [_described(key, each) for each in key.variant.problem.givens if each.symbol in letters]
    if used:
        return _("What counts here: {quantities}.", quantities=_listed(used))
    return _("For each option ask which law would have to be broken if it were true.")
