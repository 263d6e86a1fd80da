"""Givens as they come from a command line, and files of cases."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

from corollary.cli.ending import refuse


def from_options(sets: list[str], form: str = 'name=value, such as m=0.43 or v="72 km/h"') -> dict[str, str]:
    """Givens as `m=0.43` (SI) or `v=72 km/h`, by symbol; `form` is how they are written. Refuses one that is given twice."""
    values: dict[str, str] = {}
    for option in sets:
        name, mark, text = option.partition("=")
        if not mark or not name.strip():
            refuse(f"--set {option}: write it as {form}")
        if name.strip() in values:
            refuse(f"--set {option}: {name.strip()} is set twice; give it once")
        values[name.strip()] = text
    return values


def read_cases(path: Path) -> list[Any]:
    """A JSON list; its numbers are kept as exact decimals."""
    try:
        found: Any = json.loads(
            path.read_text(encoding="utf-8"), parse_float=_decimal, parse_constant=_no_number
        )
    except OSError as error:
        refuse(f"{path} cannot be read: {error.strerror}")
    except (ValueError, RecursionError) as error:
        refuse(f"{path} is not JSON: {error}")
    if not isinstance(found, list):
        refuse(f"{path} must hold a JSON list")
    return _listed(found)


def _listed(cases: Any) -> list[Any]:
    return list(cases)


def _decimal(text: str) -> Fraction | str:
    from corollary.problem.front_matter import exact  # with YAML

    number = exact(text)
    return number if number is not None else text


def _no_number(text: str) -> str:
    return text
