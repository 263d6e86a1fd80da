"""Formulas that are one change away from a given one: what somebody may have calculated who nearly had it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from corollary.formula.ast import (
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    children,
    names,
    rebuilt,
    substitute,
)
from corollary.formula.plain_text import text

TRIGONOMETRIC = ("sin", "cos", "tan")
TWO, PI = Number(Fraction(2)), Name("pi")
POWERS_OF_TEN = (-3, -2, 2, 3)
Letters = Mapping[str, Sequence[str]]
Build = Callable[[Expr], Expr]


@dataclass(frozen=True, slots=True)
class OneChange:
    """`words` say to an author what is changed, `message` to a student what to look at; `trees` are the formulas that come of it."""

    words: str
    message: str
    trees: tuple[Expr, ...]


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
    yield "the sign of the whole turned", check, _negated(tree)
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


def _negated(tree: Expr) -> Expr:
    return tree.term if isinstance(tree, Negative) else Negative(tree)


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
    below = children(tree)
    for place, part in enumerate(below):
        if isinstance(tree, Power) and (place == 1 or isinstance(part, Name)):
            continue

        def around(inner: Expr, place: int = place) -> Expr:
            return build(rebuilt(tree, (*below[:place], inner, *below[place + 1 :])))

        yield from _inside(part, around, alike)


def _of_term(
    terms: tuple[Expr, ...], place: int, term: Expr, build: Build
) -> Iterator[tuple[str, str, Expr]]:
    def instead(*other: Expr) -> Expr:
        left = (*terms[:place], *other, *terms[place + 1 :])
        return build(left[0] if len(left) == 1 else Sum(left))

    written = text(term.term if isinstance(term, Negative) else term)
    signs = "Check the signs: one of the terms counts the other way."
    yield f"the sign of {written} turned", signs, instead(_negated(term))
    yield f"{written} left out", "Something is missing: ask what else counts here.", instead()
    yield from _factors(written, term, instead)
