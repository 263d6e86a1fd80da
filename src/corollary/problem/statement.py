"""A statement with a variant's numbers in its holes, and what may stand in a hole: a given, or arithmetic of givens."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from corollary.formula.arithmetics import exactly
from corollary.formula.ast import Expr, Name, Relation, names
from corollary.formula.errors import ParseError, Undefined
from corollary.formula.numerals import decimal_text
from corollary.formula.syntax import author_formula
from corollary.messages import did_you_mean, in_convention
from corollary.problem.conditions import angle_measured
from corollary.problem.given import Given, decimal_places
from corollary.problem.variant import Variant, decimals, in_print, number, with_unit
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, PURE, Unit, si_unit, unit

FORMULA = re.compile(r"\$\$.*?\$\$|\$.*?\$", re.DOTALL)
HOLE = re.compile(
    r"\{\{(?P<formula>[^{}|]+?)(?:\s+in\s+(?P<unit>[^{}|]+?))?\s*(?:\|\s*(?P<style>\w+)\s*)?\}\}"
)
LETTER = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
STYLES = ("number", "svg")
FIGURES = 4  # of what no decimal number writes exactly
MOST_PLACES = 6  # decimals: what has more is written with so many figures
MOST_FIGURES = 15


@dataclass(frozen=True, slots=True)
class Hole:
    """What is to be written: a formula of givens (often a letter alone), the unit asked for ("": the usual one), the style;
    and the line it stands on (counted from 0)."""

    formula: str
    unit: str
    style: str
    line: int

    @property
    def letters(self) -> frozenset[str]:
        """The givens that are named in it; all of it, where it is no formula."""
        try:
            return frozenset(names(author_formula(self.formula)) - {"pi"})
        except ValueError:
            return frozenset({self.formula})

    @property
    def text(self) -> str:
        """As it is written, without its brackets."""
        return (
            self.formula
            + (f" in {self.unit}" if self.unit else "")
            + (f"|{self.style}" if self.style else "")
        )


def holes(text: str) -> list[Hole]:
    """Every hole of a text."""
    return [_hole(found, text.count("\n", 0, found.start())) for found in HOLE.finditer(text)]


def _hole(found: re.Match[str], line: int = 0) -> Hole:
    return Hole(found["formula"].strip(), (found["unit"] or "").strip(), found["style"] or "", line)


def misfit(hole: Hole, givens: Mapping[str, Given]) -> str:
    """What is wrong with a hole, in a sentence; "" when it can be filled."""
    try:
        tree = author_formula(hole.formula)
    except ValueError as error:
        return f"{{{{{hole.text}}}}}: {error}"
    if isinstance(tree, Relation):
        return f"{{{{{hole.text}}}}} compares; a hole holds a given, or arithmetic of givens"
    if unknown := sorted(names(tree) - givens.keys() - {"pi"}):
        return f"{{{{{unknown[0]}}}}} is not among the givens{did_you_mean(unknown[0], givens)} ({', '.join(sorted(givens))})"
    if hole.style and hole.style not in STYLES and not _figures(hole):
        return (
            f"{{{{{hole.text}}}}}: the styles are number and svg, or how many figures (1 to {MOST_FIGURES})"
        )
    if isinstance(tree, Name):
        word = bool(givens[tree.name].words) if tree.name in givens else False
        if word and (hole.unit or _figures(hole)):
            return f"{{{{{hole.text}}}}}: {hole.formula} is a word, which has no unit and no figures"
    elif worded := [name for name in sorted(names(tree)) if name in givens and givens[name].words]:
        return f"{{{{{hole.text}}}}}: {worded[0]} is a word, with which nothing can be worked out"
    dimension = dimension_of(tree, {symbol: given.unit.dimension for symbol, given in givens.items()})
    if isinstance(dimension, ParseError):
        return f"{{{{{hole.text}}}}}: {dimension.why}"
    if hole.unit:
        try:
            asked = unit(hole.unit)
        except ValueError as error:
            return f"{{{{{hole.text}}}}}: {error}"
        if asked.dimension != dimension:
            return f"{{{{{hole.text}}}}}: {hole.formula} is not in {hole.unit}, it measures something else"
    return ""


def filled(text: str, variant: Variant) -> str:
    """The text with each `{{m}}` replaced by number and unit, each `{{m|number}}` by the bare number, each `{{m|svg}}` by the
    number as attributes of a drawing have it (in the given's unit, with a hyphen for minus). `{{2*m in g}}` is worked out
    exactly; `{{m*v|3}}` is written with three figures. Raises Undefined where a formula has no value."""

    def fill(found: re.Match[str]) -> str:
        in_formula = text.count("$", 0, found.start()) % 2 == 1
        return _written(_hole(found), variant, in_formula)

    return HOLE.sub(fill, text)


def formulas_in_convention(text: str) -> str:
    """Markdown with the numbers in its formulas as readers of the spoken language write them; programs stay as they are."""
    pieces = re.split(r"(```.*?```)", text, flags=re.DOTALL)
    pieces[::2] = [FORMULA.sub(lambda found: in_convention(found[0], "{,}"), piece) for piece in pieces[::2]]
    return "".join(pieces)


def renamed(text: str, now: Mapping[str, str]) -> str:
    """The text with other letters in its holes."""

    def other(found: re.Match[str]) -> str:
        formula = LETTER.sub(lambda letter: now.get(letter[0], letter[0]), found["formula"])
        start, end = (place - found.start() for place in found.span("formula"))
        return found[0][:start] + formula + found[0][end:]

    return HOLE.sub(other, text)


def _written(hole: Hole, variant: Variant, in_formula: bool) -> str:
    """Numbers as readers of the language spoken write them; in a formula a decimal comma has no gap behind it."""
    comma = "{,}" if in_formula else ","
    if hole.formula in variant.values and not hole.unit and not _figures(hole):
        given, value = variant.problem.given(hole.formula), variant.values[hole.formula]
        bare = number(given, value)
        whole = bare if given.words else with_unit(bare, given.unit)
    else:
        tree = author_formula(hole.formula)
        its_unit, places = (unit(hole.unit), 0) if hole.unit else _usual_unit(tree, variant)
        bare = _number(tree, its_unit, places, _figures(hole), variant)
        whole = with_unit(bare, its_unit)
    if hole.style == "svg":
        return bare.replace("−", "-")
    if hole.style == "number" and not in_formula:  # it may stand in a line of a program
        return in_convention(bare, comma)
    return in_convention(in_print(bare if hole.style == "number" else whole, in_formula), comma)


def _figures(hole: Hole) -> int:
    return int(hole.style) if hole.style.isdecimal() and int(hole.style) <= MOST_FIGURES else 0


def _number(tree: Expr, its_unit: Unit, places: int, figures: int, variant: Variant) -> str:
    """The value in a unit: exactly, with at least so many `places`, where few decimals write it and no figures are asked for."""
    exact = exactly(tree, variant.exact)
    if exact is not None and not figures and (exact.pi == its_unit.pi or not exact.ratio):
        value = (exact.ratio - its_unit.offset) / its_unit.factor
        if decimal_places(value) <= MOST_PLACES:
            return decimals(value, places)
    from corollary.formula.ball import certified  # only here: most statements need no such arithmetic

    found = its_unit.from_si(certified(tree, variant.exact).value)
    return decimal_text(found, figures or FIGURES).replace("-", "−" if found < 0 else "-", 1)


def _usual_unit(tree: Expr, variant: Variant) -> tuple[Unit, int]:
    """The unit of a given in it that measures the same, with the decimals that it has; else that of the SI."""
    givens = {given.symbol: given for given in variant.problem.givens}
    dimension = dimension_of(tree, {symbol: each.unit.dimension for symbol, each in givens.items()})
    if isinstance(dimension, ParseError):
        raise Undefined(dimension.why)
    if dimension == ONE:
        angle = angle_measured(tree, {symbol: each.unit for symbol, each in givens.items()})
        return (givens[angle].unit, givens[angle].decimals_of(variant.values[angle])) if angle else (PURE, 0)
    for name in sorted(names(tree) & givens.keys()):
        if givens[name].unit.dimension == dimension:
            return givens[name].unit, givens[name].decimals_of(variant.values[name])
    return si_unit(dimension), 0
