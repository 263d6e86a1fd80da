"""Judges of functions and figures that a solution in text states by a formula, and the programs that are right by them."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Iterable, Mapping
from types import MappingProxyType
from typing import cast

import sympy
from sympy.printing.numpy import NumPyPrinter

from corollary.answers.quantity import read_quantity
from corollary.derive.formula_text import parted
from corollary.derive.item_clauses import QUOTED, first_item, formula_and_words, formula_of
from corollary.derive.markdown_items import MarkdownError, Section, at_line
from corollary.derive.statements import (
    Code,
    CurveFormula,
    DrawnArgument,
    FunctionFormula,
    LineFormula,
    Plot,
    Statement,
)
from corollary.formula.ast import Expr, Relation, names
from corollary.formula.errors import ParseError
from corollary.formula.syntax import author_formula
from corollary.formula.to_sympy import expression


class WithArrays(NumPyPrinter):
    """Python with numpy as np, in which numbers stand beside arrays."""

    def _print_Min(self, expr: sympy.Min) -> str:
        return self._pairwise("minimum", expr)

    def _print_Max(self, expr: sympy.Max) -> str:
        return self._pairwise("maximum", expr)

    def _pairwise(self, name: str, expr: sympy.Expr) -> str:
        first, *others = (str(self._print(each)) for each in expr.args)
        for each in others:
            first = f"numpy.{name}({first}, {each})"
        return first


SIGNATURE = re.compile(r"(?P<name>[A-Za-z_]\w*)\((?P<arguments>[^()]*)\)\s*=\s*(?P<formula>.+)")
DRAWN = re.compile(r"`(\w+)` from `([^`]+)` to `([^`]+)`(?P<whole>,? whole)?")
CURVE = re.compile(r"`([^`]+)` against `(\w+)` from `([^`]+)` to `([^`]+)`")
FIT = re.compile(r"slope `([^`]+)`(?:,? (?:and )?intercept `([^`]+)`)?")
SHARE = re.compile(r"(\d+(?:\.\d+)?)\s*%")
FIVE_PER_CENT = 0.05
PLACES = 400  # of a curve as its example draws it


def function_by_formula(section: Section, statement: Statement, givens: Collection[str]) -> Code:
    """``returns: `place(v, t) = v*t` `` with `drawn`, `corner`, `within` and `mistake`. Raises MarkdownError."""
    item = first_item(section, "returns")
    with at_line(item.line):
        found = SIGNATURE.fullmatch(formula_of(item))
        if not found:
            raise ValueError("write the function as it is called, and what it returns: `place(v, t) = v*t`")
        order = [each.strip() for each in found["arguments"].split(",") if each.strip()]
        formula = _formula(found["formula"], {*givens, *order})
    drawn: dict[str, DrawnArgument] = {}
    corners: list[tuple[tuple[str, float], ...]] = []
    for each in section.items:
        with at_line(each.line):
            if each.key == "drawn":
                between = DRAWN.fullmatch(each.text)
                if not between:
                    raise ValueError("write from where to where, as in `v` from `10 m/s` to `40 m/s`")
                low, high = _si(between[2]), _si(between[3])
                if not low < high:
                    raise ValueError(
                        f"{between[2]} is not below {between[3]}; the smaller number comes first"
                    )
                drawn[_argument(between[1], order)] = DrawnArgument(
                    between[1], low, high, bool(between["whole"])
                )
            elif each.key == "corner":
                pairs = [pair.partition("=") for pair in parted(formula_of(each))]
                corners.append(
                    tuple((_argument(name.strip(), order), _si(value)) for name, _, value in pairs)
                )
    with at_line(item.line):
        if missing := [name for name in order if name not in drawn]:
            raise ValueError(
                f"say from where to where {missing[0]} is drawn: drawn: `{missing[0]}` from `1 s` to `5 s`"
            )
        if not order:
            raise ValueError("the function has no argument; ask for a number instead")
    judge = FunctionFormula(
        found["name"],
        tuple(drawn[name] for name in order),
        formula,
        tuple(corners),
        _share(section, 1e-6),
        tuple(_mistakes(section, {*givens, *order})),
    )
    values = "".join(f"    {line}\n" for line in _numbers_of({*givens} - {*order}, formula))
    body = f"def {judge.name}({', '.join(order)}):\n{values}    return {_python(formula)}\n"
    return Code(statement, None, judge, body)


def curve_by_formula(section: Section, statement: Statement, givens: Collection[str]) -> Plot:
    """``curve: `v - a*t` against `t` from `0` to `v/a` `` with `axes` and `mistake`. Raises MarkdownError."""
    item = first_item(section, "curve")
    with at_line(item.line):
        found = CURVE.fullmatch(item.text)
        if not found:
            raise ValueError("write it as in `v - a*t` against `t` from `0` to `v/a`")
        letter = found[2]
        formula = _formula(found[1], {*givens, letter})
        low, high = (_formula(each, givens) for each in (found[3], found[4]))
    labels = _labels(section)
    judge = CurveFormula(formula, letter, (low, high), labels, tuple(_mistakes(section, {*givens, letter})))
    lines = [
        *_numbers_of({*givens} - {letter}, low, high, formula),
        f"{letter} = np.linspace({_python(low)}, {_python(high)}, {PLACES})",
        f"plt.plot({letter}, {_python(formula)} + 0*{letter})",
        *_drawn_labels(labels),
    ]
    return Plot(statement, judge, "\n".join(lines))


def line_by_formula(section: Section, statement: Statement, givens: Collection[str]) -> Plot:
    """``fit: slope `g/2`, intercept `0` `` with `axes` and `within`. Raises MarkdownError."""
    item = first_item(section, "fit")
    with at_line(item.line):
        found = FIT.fullmatch(item.text)
        if not found:
            raise ValueError("write it as in slope `g/2`, intercept `0`")
        slope = _formula(found[1], givens)
        intercept = _formula(found[2], givens) if found[2] else None
    labels = _labels(section)
    judge = LineFormula(slope, intercept, labels, _share(section, FIVE_PER_CENT))
    lines = [
        *_numbers_of(givens, slope, *([intercept] if intercept is not None else [])),
        "x = np.linspace(0, 1, 2)",
        f"plt.plot(x, ({_python(slope)})*x + {_python(intercept) if intercept is not None else 0})",
        *_drawn_labels(labels),
    ]
    return Plot(statement, judge, "\n".join(lines))


def _formula(text: str, letters: Collection[str]) -> Expr:
    tree = author_formula(text)
    if isinstance(tree, Relation):
        raise ValueError(f"{text!r} is a relation where a formula belongs")
    if strange := sorted(names(tree) - {*letters} - {"pi"}):
        raise ValueError(
            f"what does {strange[0]} mean in {text!r}? A judge knows the givens and the letters here: {', '.join(sorted(letters))}"
        )
    return tree


def _argument(name: str, order: Collection[str]) -> str:
    if name not in order:
        raise ValueError(f"{name} is no argument of the function; its arguments are {', '.join(order)}")
    return name


def _si(text: str) -> float:
    read = read_quantity(text.strip(), None)
    if isinstance(read, ParseError):
        raise ValueError(f"{text.strip()!r} is no quantity: {read.why}")
    ratio, pi = read.si
    return float(ratio) * math.pi**pi


def _share(section: Section, usual: float) -> float:
    for item in section.items:
        if item.key == "within":
            found = SHARE.fullmatch(item.text.strip("`"))
            if not found or not 0 < float(found[1]) < 50:
                raise MarkdownError(item.line, "write a share in per cent, such as within: 2 %")
            return float(found[1]) / 100
    return usual


def _mistakes(section: Section, letters: Collection[str]) -> Iterable[tuple[Expr, str]]:
    for item in section.items:
        if item.key == "mistake":
            with at_line(item.line):
                formula, words = formula_and_words(item)
                if not words:
                    raise ValueError("say what the student reads who made this mistake, before the formula")
                yield _formula(formula, letters), words


def _labels(section: Section) -> tuple[str, str]:
    item = next((each for each in section.items if each.key == "axes"), None)
    quoted = QUOTED.findall(item.text) if item is not None else []
    if item is None or len(quoted) != 2:
        line = item.line if item is not None else section.line
        raise MarkdownError(line, "say what each axis shows, with its SI unit: axes: `t [s]`, `v [m/s]`")
    return quoted[0], quoted[1]


def _drawn_labels(labels: tuple[str, str]) -> list[str]:
    return [f"plt.xlabel({labels[0]!r})", f"plt.ylabel({labels[1]!r})", "plt.show()"]


def _python(tree: Expr) -> str:
    """The formula in Python, with numpy as np."""
    letters = {name: sympy.Symbol(name, real=True) for name in names(tree)}
    written = cast("str", WithArrays().doprint(expression(tree, letters)))
    return written.replace("numpy.", "np.")


def _numbers_of(letters: Collection[str], *formulas: Expr) -> list[str]:
    """A line for each given in some formulas, with a hole for the student's number."""
    return [f"{name} = {{{name}}}" for name in sorted(names(*formulas) & {*letters})]


BY_FORMULA: Mapping[str, Callable[[Section, Statement, Collection[str]], Code | Plot]] = MappingProxyType(
    {"returns": function_by_formula, "curve": curve_by_formula, "fit": line_by_formula}
)
"""By the item that such a section begins with."""
