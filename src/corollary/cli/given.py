"""Givens as they come from a command line or a file of cases."""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from corollary.answers.quantity import read_quantity
from corollary.cli.failure import refuse
from corollary.formula.errors import ParseError, sentence
from corollary.problem.front_matter import exact
from corollary.problem.problem import Problem
from corollary.problem.variant import OutOfRange, Variant, chosen
from corollary.units.unit import show


def from_options(problem: Problem, sets: list[str]) -> Variant:
    """Givens as `m=0.43` (SI) or `v=72 km/h`. Refuses what cannot be read; raises OutOfRange against the physics."""
    values: dict[str, Fraction] = {}
    for option in sets:
        name, mark, text = option.partition("=")
        if not mark or not name.strip():
            refuse(f'--set {option}: write it as name=value, such as m=0.43 or v="72 km/h"')
        values[name.strip()] = _value(problem, name.strip(), text)
    return chosen(problem, values)


def from_case(problem: Problem, given: Mapping[str, Any]) -> Variant:
    """Givens from JSON: numbers in SI (as decimals, exactly), or texts with a unit."""
    values = {}
    for name, value in given.items():
        if isinstance(value, bool) or not isinstance(value, (int, Fraction, str)):
            raise OutOfRange(f"{name}: {json.dumps(value, default=str)} is no number")
        values[name] = (
            _value(problem, name, value)
            if isinstance(value, str)
            else _in_own_unit(problem, name, Fraction(value))
        )
    return chosen(problem, values)


def read_cases(path: Path) -> list[Any]:
    """A JSON list; its numbers are kept as exact decimals."""
    try:
        cases = json.loads(path.read_text(encoding="utf-8"), parse_float=_decimal, parse_constant=_no_number)
    except OSError as error:
        refuse(f"{path} cannot be read: {error.strerror}")
    except (ValueError, RecursionError) as error:
        refuse(f"{path} is not JSON: {error}")
    if not isinstance(cases, list):
        refuse(f"{path} must hold a JSON list")
    return cases


def _decimal(text: str) -> Fraction | str:
    number = exact(text)
    return number if number is not None else text


def _no_number(text: str) -> str:
    return text


def _value(problem: Problem, name: str, text: str) -> Fraction:
    number = exact(text)
    if number is not None:
        return _in_own_unit(problem, name, number)
    given = _given(problem, name)
    found = read_quantity(text, given.unit)
    if isinstance(found, ParseError):
        raise OutOfRange(f"{name}={text}: {sentence(found)}")
    if found.fit != "fits":
        raise OutOfRange(f"{name}={text}: {found.why}")
    ratio, pi = found.si
    if pi != given.unit.pi and ratio:
        return _over_pi(ratio, pi - given.unit.pi, given.unit.factor)
    return ratio / given.unit.factor


def _in_own_unit(problem: Problem, name: str, si: Fraction) -> Fraction:
    """A number in SI, in the unit in which the given is kept."""
    given = _given(problem, name)
    return _over_pi(si, -given.unit.pi, given.unit.factor) if given.unit.pi else si / given.unit.factor


def _over_pi(ratio: Fraction, power: int, factor: Fraction) -> Fraction:
    """Radians kept in degrees: pi to 60 figures, far beyond what a double can tell."""
    pi = Fraction(314159265358979323846264338327950288419716939937510582097494, 10**59)
    return ratio * pi**power / factor


def _given(problem: Problem, name: str):
    for given in problem.givens:
        if given.symbol == name:
            return given
    known = ", ".join(f"{given.symbol} [{show(given.unit) or '1'}]" for given in problem.givens)
    raise OutOfRange(f"{name} is not among the givens of {problem.code}: {known}")
