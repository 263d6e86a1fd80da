"""One text's reading and verdict as plain data: the line that a student, an author and a test can ask for."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from dataclasses import asdict, replace
from typing import Any, cast

from corollary.answers import trace
from corollary.answers.answer import Answer, Numbers, Unclear
from corollary.answers.direction import on_usual_axes, with_direction
from corollary.answers.formula import formula_in, with_remark
from corollary.answers.machine_number import sure
from corollary.answers.numbers import scalar
from corollary.answers.quantity import Reading, in_si, read_quantity
from corollary.answers.question import Question
from corollary.formula.ast import Expr, Relation
from corollary.formula.ast import names as letters_of
from corollary.formula.errors import ParseError, sentence
from corollary.formula.plain_text import text as formula_text
from corollary.formula.symbols import RUN
from corollary.formula.syntax import author_formula
from corollary.formula.value import Text, Value
from corollary.units.unit import Dimension, Unit, canonical, kind, read_unit, show
from corollary.units.unit import unit as author_unit

FIELDS = ("quantity", "expression", "unit")


class BadCase(ValueError):
    """The question itself is wrong; one sentence says what and what to do."""


def read_case(case: Any, *, explain: bool = False) -> dict[str, Any]:
    """One case {"text", "field", "unit", "equals", "names", "domain"} of the contract. Raises BadCase.

    `explain` adds the stages of the reading: what each took, and what it left.
    """
    asked = case
    if not isinstance(case, Mapping) or not isinstance(asked.get("text"), str):
        raise BadCase('a case is an object with a "text", such as {"text": "8,6 Ns", "unit": "kg m/s"}')
    field: str = asked.get("field") or (
        "expression" if asked.get("equals") or asked.get("names") else "quantity"
    )
    if field not in FIELDS:
        raise BadCase(f'"field": {field!r} is not known; it is one of {", ".join(FIELDS)}')
    start = time.perf_counter()
    reader = {"quantity": _quantity, "expression": _expression, "unit": _unit}[field]
    if explain:
        with trace.recorded() as stages:
            found = reader(asked)
        found["stages"] = [asdict(each) for each in stages]
    else:
        found = reader(asked)
    return {
        "text": case["text"],
        "field": field,
        **found,
        "ms": round((time.perf_counter() - start) * 1e3, 4),
    }


def _quantity(case: Mapping[str, Any]) -> dict[str, Any]:
    expected = _expected(case)
    with trace.silent():
        in_words = _in_words(case["text"], expected) if expected is not None else None
    if in_words is None:
        found = read_quantity(case["text"], expected)
    else:
        found, beside = in_words
        trace.took("apply_direction", _words_beside(case["text"], beside), beside)
        read_quantity(beside, expected)  # for its stages
    if isinstance(found, ParseError):
        return _trouble(found)
    assert isinstance(found, Reading)
    fits = found.fit == "fits"
    unit = found.unit or (expected if fits else None)
    value = (
        float(found.value) if found.fit == "unit missing" else _float(found)
    )  # without the unit it needs it is a plain number
    verdict = None if expected is None else "compatible" if fits else "wrong dimension"
    return {
        "status": "ok",
        "read": found.as_read,
        "value": value,
        "unit": canonical(unit) if unit else "1",
        "figures": sure(found.least, found.figures),
        "dimension": powers(unit.dimension if unit else Dimension()),
        "verdict": verdict,
        "why": found.why if expected else "",
    }


def _in_words(text: str, expected: Unit) -> tuple[Reading | ParseError, str] | None:
    """The quantity beside words on its direction, or on gain and loss, as an answer with them is read: `85.3 J lost`.

    None where the text has no such words.
    """
    question, beside = Question("", "", ("value",), expected), list[str]()

    def number(value: Value) -> Answer:
        beside.append(value.text if isinstance(value, Text) else "")
        return scalar(value, question)

    answer = on_usual_axes(Text(text), question, lambda own: with_direction(own, question, number))
    if beside[-1] == text:
        return None
    if isinstance(answer, Unclear) and answer.readings:
        return ParseError("asked", answer.why), beside[-1]
    found = read_quantity(beside[-1], expected)
    if not isinstance(answer, Numbers) or isinstance(found, ParseError):
        return None
    sign = -1 if (answer.values[0] < 0) != (found.value < 0) else 1
    turned = replace(
        found, value=sign * found.value, si=(sign * found.si[0], found.si[1]), as_read=answer.as_read
    )
    return turned, beside[-1]


def _words_beside(text: str, beside: str) -> str:
    """What stands in a text before and behind the number that was read of it."""
    start = text.find(beside)
    return text if start < 0 else f"{text[:start]} {text[start + len(beside) :]}".strip()


def _unit(case: Mapping[str, Any]) -> dict[str, Any]:
    expected = _expected(case)
    found = read_unit(case["text"])
    if isinstance(found, ParseError):
        return _trouble(found)
    fits = expected is None or found.measures(expected)
    why = (
        ""
        if fits or expected is None
        else f"{kind(expected)} is expected, for example in {show(expected) or '1'}; {show(found)} is {kind(found)}"
    )
    return {
        "status": "ok",
        "read": show(found) or "1",
        "value": found.si,
        "unit": canonical(found),
        "figures": None,
        "dimension": powers(found.dimension),
        "verdict": None if expected is None else "compatible" if fits else "wrong dimension",
        "why": why,
    }


def _expression(case: Mapping[str, Any]) -> dict[str, Any]:
    truth = _truth(case)
    names: Any = case.get("names") or (sorted(letters_of(truth) - {"pi"}) if truth is not None else None)
    given = cast("list[object]", names) if isinstance(names, list) else []
    letters = [name.strip() for name in given if isinstance(name, str) and RUN.fullmatch(name.strip())]
    if not given or len(letters) != len(given):
        raise BadCase('the letters of the formula must be named: "names": ["m", "v"] (or --names m,v)')
    tree = formula_in(case["text"], letters, _expected(case))
    if isinstance(tree, ParseError):
        return _trouble(tree)
    trace.took("parse_formula", case["text"], "")
    result = {
        "status": "ok",
        "read": with_remark(formula_text(tree), case["text"]),
        "value": None,
        "unit": None,
        "figures": None,
        "dimension": None,
        "verdict": None,
        "why": "",
    }
    if truth is None:
        return result
    from corollary.answers.equality import Different, Equal, Undecided, compare, hint

    match compare(tree, truth, _domain(case)):
        case Equal():
            return result | {"verdict": "equal"}
        case Different(point, _) as different:
            return result | {"verdict": "different", "counterexample": dict(point), "why": hint(different)}
        case Undecided(why):
            return result | {"verdict": "undecided", "why": why}


def powers(dimension: Dimension) -> dict[str, int | float]:
    """A dimension as {"kg": 1, "m": 1, "s": -1}; powers of zero are left out."""
    return {
        name: int(power) if power.denominator == 1 else float(power)
        for name, power in dimension.powers().items()
    }


def _trouble(found: ParseError) -> dict[str, Any]:
    return {
        "status": found.status,
        "read": None,
        "value": None,
        "unit": None,
        "figures": None,
        "dimension": None,
        "verdict": None,
        "why": sentence(found),
        "position": found.position,
        "suggestion": found.suggestion,
        "choices": list(found.choices),
    }


def _expected(case: Mapping[str, Any]) -> Unit | None:
    wanted = case.get("unit")
    if wanted is None or wanted == "":
        return None
    if not isinstance(wanted, str):
        raise BadCase('"unit" must be text, such as "kg m/s"')
    try:
        return author_unit(wanted)
    except ValueError:
        found = read_unit(wanted)
        if isinstance(found, ParseError):
            raise BadCase(f"the unit {wanted!r}: {sentence(found)}") from None
        return found


def _truth(case: Mapping[str, Any]) -> Expr | None:
    wanted = case.get("equals")
    if wanted is None:
        return None
    if not isinstance(wanted, str):
        raise BadCase('"equals" must be a formula as text')
    try:
        truth = author_formula(wanted)
    except ValueError as error:
        raise BadCase(f"equals {wanted!r}: {error}") from None
    if isinstance(truth, Relation):
        raise BadCase(f'"equals": {wanted!r} compares two sides; give one formula')
    return truth


def _domain(case: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    domain: Any = case.get("domain") or {}
    try:
        bounds: dict[str, tuple[float, float]] = {
            name: (float(low), float(high)) for name, (low, high) in domain.items()
        }
    except (AttributeError, TypeError, ValueError, OverflowError):
        raise BadCase('"domain" must give each letter its bounds: {"v": [-10, 10]}') from None
    for name, (low, high) in bounds.items():
        if not -math.inf < low < high < math.inf:
            raise BadCase(
                f'"domain" of {name}: from {low:g} to {high:g} there are no numbers; the lower bound comes first'
            )
    return bounds


def _float(found: Reading) -> float | str:
    try:
        return in_si(found)
    except OverflowError:
        return "inf" if found.si[0] > 0 else "-inf"
