"""Conditions as authors write them: chains, numbers with units, and sides that measure the same."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from fractions import Fraction

from corollary.formula.arithmetics import as_formula, constant
from corollary.formula.ast import (
    Call,
    Expr,
    Name,
    Negative,
    Product,
    Relation,
    Sum,
    names,
    substitute,
    walk,
)
from corollary.formula.errors import ParseError
from corollary.formula.plain_text import text as written
from corollary.formula.rational_pi import RationalPi
from corollary.formula.syntax import author_formula
from corollary.messages import did_you_mean
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, Dimension, Unit, read_unit, show, si_unit, unit

COMPARED = re.compile(r"\s*(<=|>=|!=|==|<|>|=|≤|≥|≠)\s*")
NUMBER = r"(?<![\w.])(?P<number>\d+(?:\.\d*)?(?:[eE][+-]?\d+)?)"
SYMBOL = r"(?:(?:Δ|delta )?[°º]\s?[CF]?|[A-Za-zµμΩΩÅ]+|%)(?:\^(?:-?[\d.]+|\(-?[\d./]+\))|[⁻⁰¹²³⁴-⁹]+)?"
FACTORS = rf"{SYMBOL}(?: +{SYMBOL})*"
BELOW = rf"/(?:\({FACTORS}\)|{SYMBOL})"
QUANTITY = rf"{NUMBER} ?(?P<unit>{FACTORS}(?:{BELOW})?|(?<= )1{BELOW})"


def relations(text: str, units: Mapping[str, Unit]) -> list[tuple[Relation, str]]:
    """The relations that a condition states, numbers in SI, each with its own text: two for `0 < F < M`.

    `units` are those of the givens. Raises ValueError with a sentence, for what compares nothing, names an unknown letter, or
    compares what cannot be compared.
    """
    pieces = COMPARED.split(text)
    if len(pieces) > 3:
        signs = {sign[0].translate(str.maketrans("≤≥", "<>")) for sign in pieces[1::2]}
        if len(signs) > 1 or signs - {"<", ">"}:
            raise ValueError("a chain has all its signs one way, such as 0 < F < M")
    found = [
        _relation(f"{left} {sign} {right}" if len(pieces) > 3 else text, units)
        for left, sign, right in zip(pieces[:-2:2], pieces[1::2], pieces[2::2], strict=True)
    ]
    if not found:
        author_formula(text)  # what is wrong with it is said first
        raise ValueError("it is not a comparison; write a relation with <, <=, >, >= or !=")
    return found


def _relation(text: str, units: Mapping[str, Unit]) -> tuple[Relation, str]:
    quantities: dict[str, tuple[RationalPi, Unit]] = {}

    def named(found: re.Match[str]) -> str:
        name = f"quantity_{len(quantities)}"
        its_unit = _unit(found["unit"], found["number"], units)
        quantities[name] = RationalPi(*its_unit.to_si(Fraction(found["number"]))), its_unit
        return name

    tree = author_formula(re.sub(QUANTITY, named, text))
    assert isinstance(tree, Relation)  # it has a sign, and no brackets around it
    if unknown := sorted(names(tree) - units.keys() - quantities.keys() - {"pi"}):
        raise ValueError(
            f"{unknown[0]} is not among the givens{did_you_mean(unknown[0], units)} ({', '.join(sorted(units))})"
        )
    if not names(tree) & units.keys():
        raise ValueError("it contains none of the givens; leave it out")
    measured = {name: its_unit.dimension for name, its_unit in units.items()}
    measured |= {name: its_unit.dimension for name, (_value, its_unit) in quantities.items()}
    if isinstance(misfit := dimension_of(tree, measured), ParseError):
        raise ValueError(misfit.why + _remedy(tree, measured))
    for side, other in ((tree.left, tree.right), (tree.right, tree.left)):
        number = constant(side)
        if number and not names(side) and (angle := angle_measured(other, units)):
            raise ValueError(f"{angle} is an angle; write {written(side)} deg, or {written(side)} rad")
    scales = {name: show(its_unit) for name, (_value, its_unit) in quantities.items() if its_unit.offset}
    if scale := scales.get(_misused_temperature(tree, scales)):
        raise ValueError(
            f"a number in {scale} is a temperature, and here a difference belongs: write it in K, or in Δ{scale}"
        )
    found = {name: as_formula(value) for name, (value, _unit) in quantities.items()}
    return substitute(tree, found), text


def _misused_temperature(tree: Relation, temperatures: Collection[str]) -> str:
    """The temperature that a difference is compared with, or that is added to another one; "" for none."""
    for side, other in ((tree.left, tree.right), (tree.right, tree.left)):
        if isinstance(side, Name) and side.name in temperatures and _is_difference(other):
            return side.name
    for node in walk(tree):
        added = (
            [each for each in node.terms if not isinstance(each, Negative)] if isinstance(node, Sum) else []
        )
        for each in added if len(added) > 1 else ():
            if isinstance(each, Name) and each.name in temperatures:
                return each.name
    return ""


def _is_difference(tree: Expr) -> bool:
    """Whether as much is taken away as there is: `T2 - T1`, `abs(T2 - T1)`."""
    match tree:
        case Call("abs", (inner,)) | Negative(inner):
            return _is_difference(inner)
        case Sum(terms):
            return 2 * sum(isinstance(each, Negative) for each in terms) == len(terms)
        case _:
            return False


def _unit(text: str, number: str, givens: Mapping[str, Unit]) -> Unit:
    """The unit behind a number. Raises ValueError where it is none, or a given could be meant below the slash."""
    below = text.partition("/")[2].strip("()")
    if below in givens and not text.startswith("1/"):
        raise ValueError(
            f"{below} may be the unit or the given: write ({number} …)/{below}, or {number} …/({below})"
        )
    found = read_unit(text)
    if isinstance(found, ParseError) and text.split("/")[0] in givens:
        raise ValueError(f"{number} {text}: write * for every product")
    return unit(text)


def _remedy(tree: Relation, measured: Mapping[str, Dimension]) -> str:
    """The bare number with the unit that it has been read in so far, SI: `600 kg`."""
    for side, other in ((tree.left, tree.right), (tree.right, tree.left)):
        if constant(side) is not None and not names(side):
            found = dimension_of(other, measured)
            if not isinstance(found, ParseError) and found != ONE:
                return f"; a bare number has no unit, so write {written(side)} {show(si_unit(found))} (or in another unit)"
    return ""


def angle_measured(tree: Expr, units: Mapping[str, Unit]) -> str:
    """The given in degrees that a side measures, as `theta`, `abs(theta - phi)` or `2*theta` do; "" for none."""
    match tree:
        case Name(name):
            return name if name in units and units[name].pi and units[name].dimension == ONE else ""
        case Negative(term):
            return angle_measured(term, units)
        case Sum(parts) | Product(parts) | Call("abs" | "min" | "max", parts):
            return next(filter(None, (angle_measured(part, units) for part in parts)), "")
        case _:
            return ""
