"""Derivatives by time in a derivation: `d(m*v)/dt`, `d/dt (m*v)` and `dp/dt`, read from its lines and worked out by the product rule."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from corollary.answers.answer import Equation
from corollary.formula.ast import (
    ONE,
    TWO,
    ZERO,
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
    substitute,
)
from corollary.formula.by_hand import by_hand
from corollary.formula.errors import ParseError
from corollary.formula.symbols import RUN
from corollary.formula.syntax import parse

MOST = 12  # derivatives in one derivation
STAND_IN = "D_t"  # a letter that is read like any other; the derivative's own name is none
BY_TIME = r"\s*/\s*(?:\(\s*d\s?t\s*\)|d\s?t(?![A-Za-z0-9_]))"
OPEN = re.compile(rf"(?<![A-Za-z0-9_])(?:\(?\(?\s*d\s*\)?{BY_TIME}\s*\)?\s*|d\s*)(?=[(\[])")
OF_LETTER = re.compile(
    rf"(?<![A-Za-z0-9_])(?:\(\s*d\s?(?P<wrapped>{RUN.pattern})\s*\)|d\s?(?P<plain>{RUN.pattern})){BY_TIME}"
    rf"|(?<![A-Za-z0-9_])\(?\(?\s*d\s*\)?{BY_TIME}\s*\)?\s*(?P<behind>{RUN.pattern})(?=\s*(?:[-+=,;)]|$))"
)
ENDS = re.compile(rf"\s*\)?{BY_TIME}")
DOTTED = re.compile(  # `\dot{\mu}`, `ṗ`, with the index behind it
    r"(?:\\dot\s*(?:\{\s*(?P<wrapped>\\?[^\W\d_]+)\s*\}|(?P<tex>\\[a-z]+|[^\W\d_]))|(?P<sign>[^\W\d_]\u0307|[ṀṁṖṗẊẋẎẏĖėŻżȦȧḂḃĊċḊḋḞḟĠġṘṙṠṡṪṫẆẇ]))"
    r"(?P<index>_\{\w+\}|_\w+|[0-9₀-₉]+)?"
)


@dataclass(frozen=True, slots=True)
class Lines:
    """The lines with a letter in the place of each derivative, and what each of these letters is the derivative of."""

    lines: tuple[tuple[int, str], ...]
    of: Mapping[str, Expr]


def with_stand_ins(lines: Sequence[tuple[int, str]], known: Collection[str]) -> Lines:
    """The lines as `steps_of` can read them. Where `dt` is a letter of the problem, `dp/dt` is a quotient; a derivative whose inside
    cannot be read stays as it is."""
    found: dict[str, Expr] = {}
    if "dt" in known or any(STAND_IN in line for _number, line in lines):
        return Lines(tuple(lines), found)
    return Lines(tuple((number, _in_line(line, known, found)) for number, line in lines), found)


def _in_line(line: str, known: Collection[str], found: dict[str, Expr]) -> str:
    if not re.search(r"[d∂]\s?t(?![A-Za-z0-9_])|\\dot|\u0307", unicodedata.normalize("NFD", line)):
        return line
    text = by_hand(DOTTED.sub(_without_dot, line)).replace("∂", "d")
    at = 0
    while len(found) < MOST and (place := _next(text, at)) is not None:
        start, end, inside = place
        tree = _read(inside, known)
        if tree is None:
            at = end
            continue
        letter = f"{STAND_IN}{len(found) + 1}"
        found[letter] = tree
        text, at = f"{text[:start]}{letter} {text[end:]}", start + len(letter)
    return text


def _without_dot(found: re.Match[str]) -> str:
    letter = found["wrapped"] or found["tex"] or unicodedata.normalize("NFD", found["sign"])[0]
    return f"(d {letter}{found['index'] or ''})/dt"


def _next(text: str, at: int) -> tuple[int, int, str] | None:
    """Where the next derivative begins and ends, and what stands in it."""
    single = OF_LETTER.search(text, at)
    for found in OPEN.finditer(text, at):
        if single is not None and single.start() < found.start():
            break
        closing = _closing(text, found.end())
        if closing is None:
            continue
        inside = text[found.end() + 1 : closing]
        if "/" in found[0]:
            return found.start(), closing + 1, inside
        if behind := ENDS.match(text, closing + 1):
            return _balanced(text, found.start(), behind.end(), inside)
    if single is None:
        return None
    inside = single["wrapped"] or single["plain"] or single["behind"]
    return _balanced(text, single.start(), single.end(), inside)


def _balanced(text: str, start: int, end: int, inside: str) -> tuple[int, int, str]:
    """The place without a bracket that closes what was opened before it, or with the one that it opens."""
    subject = text[start:end]
    lacking = subject.count(")") - subject.count("(")
    while lacking > 0 and start and text[start - 1] == "(":
        start, lacking = start - 1, lacking - 1
    while lacking < 0 and text[end : end + 1] == ")":
        end, lacking = end + 1, lacking + 1
    return start, end, inside


def _closing(text: str, opened: int) -> int | None:
    depth = 0
    for place in range(opened, len(text)):
        depth += (text[place] in "([") - (text[place] in ")]")
        if not depth:
            return place
    return None


def _read(inside: str, known: Collection[str]) -> Expr | None:
    """The formula whose derivative is meant; a problem's letter `dK` in it is no derivative of K."""
    if (run := RUN.fullmatch(inside.strip())) and f"d{run[0]}" in known:
        return None
    tree = parse(inside, known)
    if isinstance(tree, ParseError):
        tree = parse(inside, [*known, *(run for run in RUN.findall(inside) if len(run) < 3 or "_" in run)])
    if isinstance(tree, ParseError) or derivative(tree) is None:
        return None
    return tree


def rate(letter: str) -> Name:
    """The derivative of a letter by time, as a letter."""
    return Name(f"d{letter}/dt")


def letter_of(name: str) -> str:
    """The letter that a letter made by `rate` is the derivative of; "" for any other."""
    return name[1:-3] if name.endswith("/dt") else ""


def derivative(tree: Expr) -> Expr | None:
    """The derivative by time, in the letters and their derivatives; None where there is no rule for it here."""
    match tree:
        case Number() | Name("pi"):
            return ZERO
        case Name(name):
            return rate(name)
        case Negative(term):
            return None if (moved := derivative(term)) is None else Negative(moved)
        case Sum(terms):
            each = [derivative(term) for term in terms]
            return Sum(tuple(term for term in each if term is not None)) if None not in each else None
        case Product(factors):
            return _of_product(factors)
        case Quotient(top, bottom):
            above, below = derivative(top), derivative(bottom)
            if above is None or below is None:
                return None
            if below == ZERO:
                return Quotient(above, bottom)
            return Sum(
                (
                    Quotient(above, bottom),
                    Negative(Quotient(Product((top, below)), Power(bottom, TWO))),
                )
            )
        case Power(base, Number(power)):
            moved = derivative(base)
            if moved is None:
                return None
            less = ONE if power == 1 else Power(base, Number(power - 1))
            return Product((Number(power), less, moved))
        case Call("sqrt", (inside,)):
            moved = derivative(inside)
            return None if moved is None else Quotient(moved, Product((TWO, tree)))
        case _:
            return None


def _of_product(factors: Sequence[Expr]) -> Expr | None:
    terms: list[Expr] = []
    for place, factor in enumerate(factors):
        moved = derivative(factor)
        if moved is None:
            return None
        if moved != ZERO:
            terms.append(Product((*factors[:place], moved, *factors[place + 1 :])))
    return Sum(tuple(terms)) if len(terms) > 1 else terms[0] if terms else ZERO


def worked_out(steps: Sequence[Equation], of: Mapping[str, Expr]) -> list[Equation]:
    """The steps with derivatives in the place of the letters that stood for them."""
    moved = {letter: each for letter, tree in of.items() if (each := derivative(tree)) is not None}
    return [_replaced(step, moved) for step in steps]


def with_known_rates(
    steps: Sequence[Equation], rates: Mapping[str, Expr], constants: Collection[str]
) -> list[Equation]:
    """The steps with what is known of derivatives put in: `rates` of letters that change, and 0 for the `constants`. A letter of the
    student's own changes as its meaning does."""
    meanings = {step.defines: step.meaning for step in steps if step.defines and not letter_of(step.defines)}
    found = [_replaced(step, {}) for step in steps]
    for _again in range(len(meanings) + 1):
        known: dict[str, Expr] = {}
        for name in names(*(step.relation for step in found)):
            letter = letter_of(name)
            moved = (
                rates.get(letter)
                or (ZERO if letter in constants else None)
                or (derivative(meanings[letter]) if letter in meanings else None)
            )
            if letter and moved is not None:
                known[name] = moved
        if not known:
            break
        found = [_replaced(step, known) for step in found]
    return found


def _replaced(step: Equation, meaning: Mapping[str, Expr]) -> Equation:
    otherwise = None if step.otherwise is None else substitute(step.otherwise, meaning)
    return replace(
        step, relation=substitute(step.relation, meaning), otherwise=otherwise, defines="", undefined=""
    )
