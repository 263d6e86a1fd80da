"""`corollary read`: how an answer is read, and what would be decided."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from corollary.answers.read_case import BadCase, read_case
from corollary.cli.ending import FAILS, HOLDS, answer, refuse
from corollary.cli.given_values import read_cases


def run(
    text: str | None,
    unit: str | None,
    equals: str | None,
    names: str | None,
    domain: list[str],
    cases: Path | None,
    explain: bool,
    as_json: bool,
) -> int:
    if (text is None) == (cases is None):
        refuse("give an answer to read, or --cases FILE with a list of them")
    if cases is not None:
        found = [_listed(case, explain) for case in read_cases(cases)]
        answer(found)
        return HOLDS
    case: dict[str, Any] = {
        "text": text,
        "unit": unit,
        "equals": equals,
        "names": names.split(",") if names else None,
        "domain": _domain(domain),
    }
    if equals is not None or names is not None:
        case["field"] = "expression"
    try:
        found = read_case(case, explain=explain)
    except BadCase as error:
        refuse(str(error))
    if as_json:
        answer(found)
    else:
        _show(found)
    return HOLDS if found["status"] == "ok" and found["verdict"] in (None, "compatible", "equal") else FAILS


def _listed(case: Any, explain: bool) -> dict[str, Any]:
    try:
        return read_case(case, explain=explain)
    except BadCase as error:
        return {"error": str(error)}


def _domain(options: list[str]) -> dict[str, list[float]]:
    """`v=-10..10` for each letter."""
    domain: dict[str, list[float]] = {}
    for option in options:
        name, _, bounds = option.partition("=")
        low, mark, high = bounds.partition("..")
        try:
            domain[name.strip()] = [float(low), float(high)]
        except ValueError:
            mark = ""
        if not mark:
            refuse(f"--domain {option}: write it as v=-10..10")
    return domain


def _show(found: dict[str, Any]) -> None:
    stages: list[dict[str, str]] = found.get("stages") or []
    for stage in stages:
        left = f", left {stage['left']!r}" if stage["left"] else ""
        print(f"{stage['stage']}: took {stage['took']!r}{left}")
    if found["status"] != "ok":
        print(f"{found['status']}: {found['why']}")
        return
    print(f"read as {found['read']}")
    if found["verdict"] is not None:
        print(f"{found['verdict']}{': ' + found['why'] if found['why'] else ''}")
    counterexample: dict[str, float] = found.get("counterexample") or {}
    for name, value in counterexample.items():
        print(f"  for example at {name} = {value:g}")
