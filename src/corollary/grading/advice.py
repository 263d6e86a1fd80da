"""Advice for a wrong answer: laws, quantities and a check, from the derivation, and nothing of the answer."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import islice

from corollary.answers.registry import answer_type
from corollary.derive.solution import AppliedLaw, ClosedForms, SolvedChoice, Unknown
from corollary.formula.ast import Expr, Name, names
from corollary.formula.ball import RationalPi, Undefined, certified
from corollary.grading.key import Key
from corollary.grading.replay import letters_of, steps_to
from corollary.messages import catalogue, spoken
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.translation import text_in_language
from corollary.units.unit import PURE, show

_ = catalogue(__name__)
_law_name = catalogue("corollary.laws")

MOST_LAWS = 3
OTHERS = (Fraction(101, 100), Fraction(9, 10), Fraction(2))
SAME = 1e-12
EQUATIONS = re.compile(r"[\d().,\s–-]+")  # numbers of equations; a source in words may be the formula itself
OF_CHAPTER, CHAPTER = re.compile(r"\(12\.\d+"), "Momentum, Impulse, and Collisions"
WITHOUT_ARTICLE = frozenset({"your", "its", "the", "a", "an", "how"})


def advice(key: Key, part: Part) -> tuple[str, ...]:
    """What is said to one wrong answer after the other: the laws that lead to this part, what its answer depends on, and a check
    that can be typed; as far as they are known."""
    solution = key.solution
    if part.id in solution.choices:
        return tuple(_of_choice(key, solution.choices[part.id]))
    asked = solution.answer(part.id)
    if asked is None:
        return ()
    steps = _steps(key, asked)
    laws = list(islice(_named(law for step in reversed(steps) for law in step.laws), MOST_LAWS))
    matters = _dependencies(key, asked)
    sentences = [_think_of(laws)] if laws else []
    if not matters and _is_constant(key, asked):
        sentences.append(_("The answer depends on none of the given numbers."))
    else:
        quantities = [_described(key, each) for each in _used(key, steps) if each in matters]
        quantities += [_("your answer in {part}", part=f"({earlier})") for earlier in _earlier(key, steps)]
        if quantities:
            sentences.append(_("The answer depends on: {quantities}.", quantities=_listed(quantities)))
    return (*sentences, *filter(None, (_check(key, part, asked, matters),)))


def _think_of(laws: list[str]) -> str:
    """The laws, and the book whose equation numbers stand behind their names."""
    if any(OF_CHAPTER.search(law) for law in laws):
        return _("Think of: {laws}, in “{book}”.", laws=_listed(laws), book=CHAPTER)
    return _("Think of: {laws}.", laws=_listed(laws))


def advice_for(key: Key, part: Part, wrong_before: int | None) -> str:
    """What is said to an answer after so many wrong ones: each time one thing more, so that nobody is told more than the next try needs.

    Where nobody counts them, all of it, in the same order. Marked work is read once, with all that one may want to think of: the law,
    what counts, and what can be typed into `check` before the next hand-in. `check` itself counts nothing: it knows no right from wrong.
    """
    sentences = advice(key, part)
    if wrong_before is None or not sentences:
        return " ".join(sentences)
    return sentences[min(wrong_before, len(sentences) - 1)]


def _steps(key: Key, asked: Unknown) -> list[Unknown]:
    """The step that answers the part, and before it those that lead to it and that the sheet does not ask for."""
    return steps_to(key.solution, asked, key.asked)


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


def _dependencies(key: Key, asked: Unknown) -> list[Given]:
    """The givens that the answer depends on: those in its formula that do not drop out of it; of a scene all that go in."""
    letters = _letters(key, asked)
    given = [each for each in key.variant.problem.givens if each.symbol in letters]
    return [each for each in given if asked.in_givens is None or _changes_with(key, asked.in_givens, each)]


def _letters(key: Key, asked: Unknown) -> frozenset[str]:
    if asked.in_givens is not None:
        return names(*asked.in_givens)
    return frozenset[str]().union(*(letters_of(step.local) for step in steps_to(key.solution, asked, set())))


def _changes_with(key: Key, trees: Sequence[Expr], given: Given) -> bool:
    """True if another value of a given changes what formulas of the givens come to, for the numbers of this key."""
    at = key.variant.exact
    try:
        values = [certified(tree, at).value for tree in trees]
    except Undefined:
        return True
    for other in OTHERS:
        moved = {
            **at,
            given.symbol: RationalPi(
                at[given.symbol].ratio * other + (other - 1 if not at[given.symbol].ratio else 0),
                at[given.symbol].pi,
            ),
        }
        try:
            found = [certified(tree, moved).value for tree in trees]
        except Undefined:
            continue
        if len(found) != len(values) or math.dist(found, values) > SAME * math.hypot(*values, *found):
            return True
    return False


def _is_constant(key: Key, asked: Unknown) -> bool:
    """True of a formula of which all givens drop out, where there are any."""
    return asked.in_givens is not None and bool(key.variant.problem.givens)


def _check(key: Key, part: Part, asked: Unknown, matters: Sequence[Given]) -> str:
    """Something to type that needs no key and may fail: half the step of a program, the answer as a formula, or at another value."""
    if not isinstance(asked.local, ClosedForms):
        return _(
            "A check: halve the step of your program and type the new result; its first three figures must not change."
        )
    if not matters:
        counted = part.id in key.truths and key.truths[part.id].counted
        going_in = _used(key, steps_to(key.solution, asked, set()))
        if not counted:  # who counts wrongly counts the same with other numbers
            going_in = going_in or key.variant.problem.givens
        if not going_in:
            return ""
        return _(
            "A check: calculate again with another value of `{letter}`; the answer must stay the same.",
            letter=going_in[0].symbol,
        )
    units_tell = any(
        each.unit.dimension != PURE.dimension for each in matters
    )  # plain numbers make any sum fit
    if answer_type(part.answer_type).in_symbols or not units_tell:
        return _(
            "A check: how must your answer change when {quantity} is doubled? Type your formula with `2*{letter}` in place of `{letter}`, and compare.",
            letter=matters[0].symbol,
            quantity=_described(key, matters[0]),
        )
    letters = ", ".join(f"`{each.symbol}`" for each in matters)
    unit = show(part.unit)
    if not unit or part.rows or part.unit.dimension == PURE.dimension:
        return _(
            "A check: type your answer as a formula of {letters}; you are told if its units do not match.",
            letters=letters,
        )
    return _(
        "A check: type your answer as a formula of {letters}; you are told if its unit is not {unit}.",
        letters=letters,
        unit=unit,
    )


def _of_choice(key: Key, choice: SolvedChoice) -> Iterator[str]:
    yield _("For each option, ask which law it would violate.")
    conditions = [each for ways in choice.options.values() for way in ways for each in way]
    letters = names(*conditions)
    used = [_described(key, each) for each in key.variant.problem.givens if each.symbol in letters]
    if used:
        yield _("The answer depends on: {quantities}.", quantities=_listed(used))
