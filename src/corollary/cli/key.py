"""`corollary key`: the answers to a problem for given numbers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from corollary.api import solve, variant
from corollary.cli.chosen_variant import chosen_problem, chosen_variant
from corollary.cli.ending import HOLDS, answer, refuse, unforeseen
from corollary.cli.given_values import from_options, read_cases
from corollary.derive.solution import Solution
from corollary.formula.ast import Name
from corollary.grading.key_record import decimal, key_record
from corollary.problem.variant import OutOfRange, Variant
from corollary.verify.certificate.on_record import on_record


def run(
    code: str,
    bank: Path | None,
    givens: list[str],
    student: str | None,
    course: Path | None,
    cases: Path | None,
    as_json: bool,
) -> int:
    place, problem = chosen_problem(bank, course, code)
    named = [
        ("--set", bool(givens)),
        ("--student", student is not None),
        ("--cases", cases is not None),
    ]
    chosen = [option for option, given in named if given]
    if len(chosen) > 1:
        refuse(f"{' and '.join(chosen)} both choose the numbers; give one of them")
    if cases is not None:
        solution = solve(problem)
        answer([_case(solution, case) for case in read_cases(cases)])
        return HOLDS
    numbers = (
        variant(problem, from_options(givens)) if givens else chosen_variant(place, problem, student, course)
    )
    record = key_record(solve(problem), numbers)
    if certificate := on_record(place, problem):
        record["certificate"] = certificate
    if as_json:
        answer(record)
        return HOLDS
    given = ", ".join(
        f"{name} = {_in_decimal(name, value, numbers)}"
        for name, value in record["given"].items()
        if not problem.given(name).words
    )
    print(f"{problem.code}  {problem.title}\n  given (SI): {given}")
    for part, entry in record["parts"].items():
        print(f"  ({problem.part(part).id_and_letter}) {_line(entry)}")
    if certificate:
        print(f"  proof script {certificate['sha256'][:16]}…, accepted by {certificate['checker']}")
    return HOLDS


def _in_decimal(name: str, value: float | str, numbers: Variant) -> str:
    """A given in SI; one that no double holds (`inf`, or 0 for what is not) in as many digits as it needs, seventeen at most."""
    if isinstance(value, float) and (value or not numbers.values[name]):
        return f"{value:g}"
    digits, _, power = decimal(Name(name), numbers).partition("e")
    return f"{digits.rstrip('0').rstrip('.')}e{power}" if power else digits


def _case(solution: Solution, case: Any) -> dict[str, Any]:
    given = case
    if not isinstance(case, dict):
        return {"error": 'a case is an object of givens, such as {"m": 0.43}'}
    try:
        record = key_record(solution, variant(solution.problem, given))
    except OutOfRange as error:
        return {"error": str(error)}
    except Exception as error:  # a fault of ours loses its own case, and none of the others
        return {"error": unforeseen(error)}
    return record | {
        "defaulted": [
            each.symbol for each in solution.problem.givens if each.symbol not in given and not each.source
        ]
    }


def _line(entry: dict[str, Any]) -> str:
    if "value" in entry:
        found = entry.get("decimal", entry["value"])
        values: list[Any] = found if isinstance(entry["value"], list) else [found]
        numbers = ", ".join(f"{value:.10g}" if isinstance(value, float) else str(value) for value in values)
        unit = "" if entry["unit"] == "1" else f" {entry['unit']}"
        how = (
            "certified"
            if entry["certified"]
            else f"± {entry['error']:.1g}"
            if "error" in entry
            else "rounded"
        )
        formula = _together(entry.get("expression", ""), ", ")
        formula = formula and f"   = {formula}"
        return f"{numbers if len(values) == 1 else f'({numbers})'}{unit}   [{how}]{formula}"
    if "domain" in entry:
        unit = "" if entry["unit"] == "1" else f" in {entry['unit']}"
        return f"{_together(entry['expression'], ', ')}   [a formula of {', '.join(entry['domain'])}{unit}]"
    if "word" in entry:
        return entry["word"]
    if "choice" in entry:
        return f"option ({entry['choice']})"
    return "; ".join(f"{name}: {_together(value, '; ')}" for name, value in entry.items())


def _together(value: Any, mark: str) -> str:
    several = value
    return mark.join(several) if isinstance(value, list) else str(value)
