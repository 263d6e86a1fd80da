"""Rules that no solution lists: formulas one change away from a derivation's, in the words of a report and as a draft."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from corollary.derive.solution import AppliedLaw, ClosedForms, Solution, Unknown
from corollary.formula.ast import (
    TWO,
    Call,
    Expr,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    children,
    names,
    negated,
    replace_child,
    substitute,
    unsigned,
)
from corollary.formula.plain_text import text
from corollary.grading.replay import steps_to
from corollary.units.unit import PURE, Dimension

TRIGONOMETRIC = ("sin", "cos", "tan")
PI = Name("pi")
POWERS_OF_TEN = (-3, -2, 2, 3)
Letters = Mapping[str, Sequence[str]]
Build = Callable[[Expr], Expr]


@dataclass(frozen=True, slots=True)
class OneChange:
    """`words` say to an author what is changed, `message` to a student what to look at; `trees` are the formulas that come of it."""

    words: str
    message: str
    trees: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class UnlistedRule:
    """A rule `in words`, the formulas that it exchanges in the step of the unknowns `named`, and what it makes of the part:
    `trees`, in givens and in what other parts ask for. `draft` is a line for the solution, to be looked at by its author."""

    words: str
    formula: str
    message: str
    draft: str
    trees: tuple[Expr, ...]


def as_derived(solution: Solution, part: str) -> tuple[Expr, ...] | None:
    """The part by the derivation, in givens and in what other parts ask for; None where it is simulated."""
    asked = solution.answer(part)
    return (
        None if asked is None or not isinstance(asked.local, ClosedForms) else _composed(solution, asked, {})
    )


def rules_near(solution: Solution, part: str) -> list[UnlistedRule]:
    """First by a change in the steps that lead to the part from the parts before it, then by one in its formula in givens."""
    asked = solution.answer(part)
    if asked is None:
        return []
    found: list[UnlistedRule] = []
    parts = {find.part for find in solution.unknowns if find.part}
    for step in steps_to(solution, asked, parts):
        if isinstance(step.local, ClosedForms):
            for change in _changes_of_step(solution, step, step.local.trees):
                if (trees := _composed(solution, asked, {step.names: change.trees})) is not None:
                    found.append(_rule(step, change, trees))
    if asked.in_givens is not None:
        found += [
            _rule(asked, each, each.trees) for each in _changes_of_step(solution, asked, asked.in_givens)
        ]
    return found


def _composed(
    solution: Solution, asked: Unknown, instead: Mapping[tuple[str, ...], tuple[Expr, ...]]
) -> tuple[Expr, ...] | None:
    """The formulas of `asked`, those of steps that nobody asks for put in; some exchanged."""
    meaning: dict[str, Expr] = {}
    for find in solution.unknowns:
        local = find.local.trees if isinstance(find.local, ClosedForms) else None
        own = instead.get(find.names, local)
        if find is asked:
            return None if own is None else tuple(substitute(tree, meaning) for tree in own)
        if own is not None and not find.part:
            meaning |= zip(find.names, (substitute(tree, meaning) for tree in own), strict=True)
    return None


def _changes_of_step(solution: Solution, step: Unknown, trees: tuple[Expr, ...]) -> list[OneChange]:
    kinds: dict[str, tuple[Dimension, bool]] = {}
    for given in solution.problem.givens:
        if not given.words:
            kinds[given.symbol] = given.unit.dimension, bool(given.unit.pi)
    measured = [name for name, (dimension, _) in kinds.items() if dimension != PURE.dimension]
    for find in solution.unknowns:
        if find is step:
            break
        for name, dimension in zip(find.names, find.dimensions, strict=True):
            if dimension != PURE.dimension:
                kinds[name] = dimension, False
    used = names(*trees) & kinds.keys()
    alike = {
        name: [other for other in kinds if other != name and kinds[other] == kinds[name]] for name in used
    }
    return changes(trees, alike, measured)


def _rule(step: Unknown, change: OneChange, trees: tuple[Expr, ...]) -> UnlistedRule:
    equations = [f"{name} = {text(tree)}" for name, tree in zip(step.names, change.trees, strict=True)]
    stated = ", ".join(f"`{each}`" for each in equations)
    draft = f"- mistake: {change.message} {stated}{_instead(step.laws)}"
    words = f"{change.words} in {', '.join(step.names)}"
    return UnlistedRule(words, "; ".join(equations), change.message, draft, trees)


def _instead(laws: Sequence[AppliedLaw]) -> str:
    given = [f'"{law.name}"' for law in laws]
    return f" instead of {' and '.join(given)}" if len(given) > 1 else ""


def changes(trees: tuple[Expr, ...], alike: Letters, measured: Sequence[str]) -> list[OneChange]:
    """What one change makes of formulas, one for each component: in one of them, or the same change in all.

    `alike` are for each letter those of the same dimension; `measured` the letters whose unit may be taken for another power
    of ten.
    """
    found = [list(_changes(tree, alike, measured)) for tree in trees]
    if len(trees) == 1:
        return [OneChange(words, message, (tree,)) for words, message, tree in found[0]]
    by_words = [{words: (message, tree) for words, message, tree in one} for one in found]
    every = [
        OneChange(words, message, tuple(one[words][1] for one in by_words))
        for words, (message, _) in by_words[0].items()
        if all(words in one for one in by_words)
    ]
    single = [
        OneChange(f"{words}, in component {place + 1}", message, (*trees[:place], tree, *trees[place + 1 :]))
        for place, one in enumerate(found)
        for words, message, tree in one
    ]
    return every + single


def _changes(tree: Expr, alike: Letters, measured: Sequence[str]) -> Iterator[tuple[str, str, Expr]]:
    check = "Check the sign: the answer points the other way."
    yield "the sign of the whole turned", check, negated(tree)
    yield from _factors("the whole", tree, lambda part: part)
    for letter in sorted(names(tree)):
        for other in alike.get(letter, ()):
            words = f"{other} in the place of {letter}"
            yield (
                words,
                f"Check whether it is ${other}$ that belongs there.",
                _with(tree, letter, Name(other)),
            )
    for letter in sorted(names(tree) & set(measured)):
        for power in POWERS_OF_TEN:
            scaled = Product((Number(Fraction(10) ** power), Name(letter)))
            message = f"Check the unit of ${letter}$: it went in with another power of ten."
            yield f"{letter} taken 10^{power} times", message, _with(tree, letter, scaled)
    yield from _inside(tree, lambda part: part, alike)


def _with(tree: Expr, letter: str, other: Expr) -> Expr:
    return substitute(tree, {letter: other})


def _factors(what: str, tree: Expr, build: Build) -> Iterator[tuple[str, str, Expr]]:
    for name, in_tex, factor in (("2", "2", TWO), ("pi", r"\pi", PI)):
        message = f"Check the factors in your formula: ${in_tex}$ is there once too often or once too little."
        yield f"{what} times {name}", message, build(Product((factor, tree)))
        yield f"{what} divided by {name}", message, build(Quotient(tree, factor))


def _inside(tree: Expr, build: Build, alike: Letters) -> Iterator[tuple[str, str, Expr]]:
    """What one change at this node, or below it, makes of the whole, which `build` puts around it."""
    written = text(tree)
    match tree:
        case Sum(terms):
            for place, term in enumerate(terms):
                yield from _of_term(terms, place, term, build)
        case Call(function, (argument,)) if function in TRIGONOMETRIC:
            for other in TRIGONOMETRIC:
                if other != function:
                    message = (
                        "Check which of sine, cosine and tangent it is: from where is the angle measured?"
                    )
                    yield f"{other} for {written}", message, build(Call(other, (argument,)))
        case Call("sqrt", (argument,)):
            yield (
                f"the root of {text(argument)} not taken",
                "Is there still a root to be taken?",
                build(argument),
            )
        case Power(base, Number(value)) if value == 2:
            message = "Check the powers in your formula: something is to be squared."
            yield f"the square of {text(base)} forgotten", message, build(base)
        case Name(name) if name != "pi":
            message = f"Check the powers in your formula: is ${name}$ to be squared?"
            yield f"{name} squared", message, build(Power(tree, TWO))
            for other in alike.get(name, ()):
                words = f"{other} in one place of {name}"
                yield words, f"Check whether it is ${other}$ that belongs there.", build(Name(other))
        case _:
            pass
    for place, part in enumerate(children(tree)):
        if isinstance(tree, Power) and (place == 1 or isinstance(part, Name)):
            continue

        def around(inner: Expr, place: int = place) -> Expr:
            return build(replace_child(tree, place, inner))

        yield from _inside(part, around, alike)


def _of_term(
    terms: tuple[Expr, ...], place: int, term: Expr, build: Build
) -> Iterator[tuple[str, str, Expr]]:
    def instead(*other: Expr) -> Expr:
        left = (*terms[:place], *other, *terms[place + 1 :])
        return build(left[0] if len(left) == 1 else Sum(left))

    written = text(unsigned(term))
    signs = "Check the signs: one of the terms counts the other way."
    yield f"the sign of {written} turned", signs, instead(negated(term))
    yield f"{written} left out", "Something is missing: ask what else counts here.", instead()
    yield from _factors(written, term, instead)
