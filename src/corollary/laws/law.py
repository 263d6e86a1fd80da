"""A law: the equation as the textbook has it, what its letters mean here, and when it holds."""

# pyright: reportUnknownArgumentType=false, reportUnknownVariableType=false

from __future__ import annotations

import re
import sys
from collections.abc import Generator, Iterable, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, cast

import sympy
from sympy.core.function import AppliedUndef

from corollary.formula.ast import Expr, Relation, names
from corollary.formula.authored import as_expression
from corollary.formula.errors import ParseError
from corollary.formula.operators import (
    VECTOR_OPERATORS,
    bound_letters,
    has_operators,
    is_vector,
    read_operators,
    scalar_part,
)
from corollary.formula.syntax import author_formula
from corollary.formula.to_sympy import expression
from corollary.units.unit import read_unit

MEASURED = re.compile(r"(?<![\w.])\d+(?:\.\d*)?(?:[eE][+-]?\d+)? *(?P<unit>°C|[A-Za-zµΩ°%]+(?:/[A-Za-z]+)?)")
TUPLE = re.compile(r"(?:^|=)\s*\([^()=]*(?:\([^()]*\)[^()=]*)*,")

Meaning = sympy.Expr | tuple[sympy.Expr, ...]


@dataclass(frozen=True, slots=True)
class Law:
    """`textbook` keeps the form of the book; `letters` say what each of its letters means in this problem.

    A letter that means a tuple makes the law a vector law: one equation for each component, scalars in all of them.
    """

    name: str
    textbook: Relation
    letters: Mapping[str, Meaning]
    source: str
    holds: str

    @property
    def components(self) -> int:
        """How many scalar equations the law states."""
        lengths = self.lengths
        return next(iter(lengths.values())) if is_vector(self.textbook, lengths) else 1

    @property
    def lengths(self) -> dict[str, int]:
        """How many components each letter has that stands for a vector here."""
        return {
            letter: len(meaning) for letter, meaning in self.letters.items() if isinstance(meaning, tuple)
        }

    @property
    def vectors(self) -> frozenset[str]:
        """The textbook letters that stand for vectors here."""
        return frozenset(self.lengths)


_OWN_LETTERS: ContextVar[dict[str, Meaning] | None] = ContextVar("_OWN_LETTERS", default=None)


_EXPLAINED: ContextVar[dict[str, str] | None] = ContextVar("_EXPLAINED", default=None)
_NUMBERED: ContextVar[bool] = ContextVar("_NUMBERED", default=True)
LIBRARY = __name__.rpartition(".")[0] + "."


@contextmanager
def own_letters(givens: Mapping[str, sympy.Symbol], *, numbered: bool = True) -> Generator[dict[str, str]]:
    """While a derivation is stated: its givens, and each unknown from where it is named, are known by their letters.

    Gives what those stand for whose author has said so, by letter, filled as they are named.
    `numbered`: whether the laws of the library have the numbers of the chapter's equations, which mean nothing elsewhere.
    """
    words: dict[str, str] = {}
    before, explained = _OWN_LETTERS.set(dict(givens)), _EXPLAINED.set(words)
    numbers = _NUMBERED.set(numbered)
    try:
        yield words
    finally:
        _OWN_LETTERS.reset(before)
        _EXPLAINED.reset(explained)
        _NUMBERED.reset(numbers)


def known_by_name(letter: str, meaning: Meaning, words: str = "") -> None:
    """A letter that laws may use from here on in the derivation that is being stated (anywhere else, none).

    `words` say to the reader of the worked solution what it stands for. Raises TypeError where they are no text.
    """
    if not isinstance(words, str):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise TypeError(f"what {letter} stands for is a text for the reader, not {words!r}")
    own, explained = _OWN_LETTERS.get(), _EXPLAINED.get()
    if own is not None:
        own[letter] = meaning
    if explained is not None and words:
        explained[letter] = words


def law(name: str, formula: str, *, source: str = "", holds: str = "", **letters: object) -> Law:
    """A law from its textbook formula, such as "J = dp"; `letters` say what those mean that are not the problem's own.

    A letter that is a given or an unknown of the problem means just that. Raises ValueError when a letter is neither and has
    no meaning, a meaning has no letter, or components do not match.
    """
    here = {letter: _meaning(value) for letter, value in letters.items()}
    title, name = name, name or "wrong"
    own = _OWN_LETTERS.get() or {}
    relation = _with_operators(formula, own | here)
    used = names(relation) - {"pi"}
    integrated = bound_letters(relation) - here.keys() - own.keys()
    here |= {letter: sympy.Symbol(letter, real=True) for letter in integrated}
    here |= {letter: own[letter] for letter in sorted(used - here.keys()) if letter in own}
    if missing := used - here.keys():
        raise ValueError(
            f"{name}: what does {', '.join(sorted(missing))} mean in {formula!r}? "
            f"It is neither a given nor an unknown ({', '.join(sorted(own)) or 'there are none yet'}); "
            f"say what it means: {sorted(missing)[0]} = …"
        )
    if extra := here.keys() - used:
        raise ValueError(f"{name}: {', '.join(sorted(extra))} does not occur in {formula!r}")
    if len({len(meaning) for meaning in here.values() if isinstance(meaning, tuple)}) > 1:
        raise ValueError(f"{name}: the vectors in {formula!r} have different numbers of components")
    if not _NUMBERED.get() and str(sys._getframe(1).f_globals.get("__name__")).startswith(LIBRARY):  # pyright: ignore[reportPrivateUsage]
        source = ""
    stated = Law(title, relation, here, source, holds)
    try:
        equations(stated)
    except ValueError as error:
        raise ValueError(f"{name}: {formula!r}: {error}") from None
    return stated


def wrong(formula: str, **letters: object) -> Law:
    """What a misconception makes of a law: `wrong("K = m*v^2")`. It has the name of the law whose place it takes.

    Raises what `law` raises.
    """
    return law("", formula, source="", holds="", **letters)


def only_laws(stated: Iterable[Law]) -> tuple[Law, ...]:
    """What an author states as laws. Raises TypeError where something else is among them."""
    found = tuple(stated)
    for each in found:
        if not isinstance(each, Law):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise TypeError(f'{each!r} is not a law; state one, such as law("Momentum", "p = m*v")')
    return found


def sides(stated: Law) -> list[tuple[sympy.Expr, sympy.Expr]]:
    """Left and right side of each scalar equation, in the letters of the problem."""
    return [
        (expression(equation.left, letters), expression(equation.right, letters))
        for equation, letters in equations(stated)
    ]


def equations(stated: Law) -> list[tuple[Relation, dict[str, sympy.Expr]]]:
    """Each scalar equation in the textbook's letters, and what they mean in it.

    Products of vectors are written out; `r[1]` in them is the second component of r.
    """
    products = has_operators(stated.textbook, VECTOR_OPERATORS)
    found: list[tuple[Relation, dict[str, sympy.Expr]]] = []
    for index in range(stated.components):
        left, right = (
            scalar_part(side, index, stated.lengths) for side in (stated.textbook.left, stated.textbook.right)
        )
        letters = component(stated, index)
        if products:
            letters |= {
                f"{letter}[{place}]": part
                for letter, meaning in stated.letters.items()
                if isinstance(meaning, tuple)
                for place, part in enumerate(meaning)
            }
        found.append((Relation("=", left, right), letters))
    return found


def component(stated: Law, index: int) -> dict[str, sympy.Expr]:
    """What the letters mean in one scalar equation of the law."""
    return {
        letter: meaning[index] if isinstance(meaning, tuple) else meaning
        for letter, meaning in stated.letters.items()
    }


def symbols(stated: Law) -> frozenset[sympy.Symbol]:
    """Every symbol of the problem that the law speaks of."""
    found: set[sympy.Symbol] = set()
    for meaning in stated.letters.values():
        for part in meaning if isinstance(meaning, tuple) else (meaning,):
            found |= {symbol for symbol in part.free_symbols if isinstance(symbol, sympy.Symbol)}
    integrated = {sympy.Symbol(letter, real=True) for letter in bound_letters(stated.textbook)}
    return frozenset(found - integrated)


def by_name(meaning: sympy.Expr) -> sympy.Expr:
    """A meaning as it is written: a function by its name alone."""
    called = {
        each: sympy.Symbol(str(each.func), real=True) for each in cast(Any, meaning).atoms(AppliedUndef)
    }
    return cast(Any, meaning).xreplace(called) if called else meaning


def is_function(meaning: object) -> bool:
    """Whether a letter stands for a function, such as v(t)."""
    return isinstance(meaning, AppliedUndef)


def substitute(expression: Any, values: Mapping[Any, sympy.Expr]) -> Any:
    """The expression (or relation) with letters, or whole parts, replaced, all at once; simplified only as sympy does by itself."""
    return expression.subs(dict(values)) if values else expression


def _meaning(value: object) -> Meaning:
    if isinstance(value, (tuple, list)):
        return tuple(as_expression(part) for part in value)
    return as_expression(value)  # authors' own Python objects only: numbers and sympy expressions


def _with_operators(formula: str, letters: Mapping[str, Meaning]) -> Relation:
    """The law with its derivatives and the like, by what its letters mean."""
    relation = _relation(formula)
    called = {
        letter
        for letter, meaning in letters.items()
        if is_function(meaning) or (isinstance(meaning, tuple) and all(map(is_function, meaning)))
    }
    try:
        read = read_operators(relation, letters.keys(), called)
    except ValueError as error:
        raise ValueError(f"formula {formula!r}: {error}") from None
    assert isinstance(read, Relation)
    return read


def _remedy(formula: str) -> str:
    """What to do where a number has a unit, or a side is a tuple: neither is there in the text of a law."""
    for found in MEASURED.finditer(formula):
        if not isinstance(read_unit(found["unit"]), ParseError):
            return f"; a law has letters in place of what has a unit: make {found[0]} a given of the problem"
    if TUPLE.search(formula):
        return '; state one law for each component, or say what a letter means: law(…, "u = w", w=(…, …))'
    return ""


@lru_cache(maxsize=512)
def _relation(formula: str) -> Relation:
    try:
        tree: Expr = author_formula(formula, operators=True)
    except ValueError as error:
        raise ValueError(f"{error}{_remedy(formula)}") from None
    if not isinstance(tree, Relation) or tree.sign != "=":
        raise ValueError(f"a law is an equation; {formula!r} has no = sign")
    return tree
