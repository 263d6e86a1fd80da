"""`corollary judge`: plain answers marked."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from corollary.api import UnknownPart, judge, solve
from corollary.cli.chosen_variant import chosen_problem
from corollary.cli.ending import HOLDS, answer, unforeseen
from corollary.cli.given_values import read_cases
from corollary.cli.terminal import hanging
from corollary.derive.solution import Solution
from corollary.formula.ball import Undefined
from corollary.grading.mark_record import grade_record
from corollary.problem.variant import OutOfRange


def run(code: str, bank: Path | None, course: Path | None, cases: Path, reveal: bool, as_json: bool) -> int:
    solution = solve(chosen_problem(bank, course, code)[1])
    records = [_case(solution, case, reveal) for case in read_cases(cases)]
    if as_json:
        answer(records)
    else:
        for record in records:
            _show(record)
    return HOLDS


def _case(solution: Solution, case: Any, reveal: bool) -> dict[str, Any]:
    match case:
        case {"answers": dict(), **others} if isinstance(others.get("given", {}), dict):
            answers: dict[str, Any] = case["answers"]
            try:
                given: dict[str, Any] = others.get("given") or {}
                record = grade_record(judge(solution, answers, given, reveal=reveal))
                left_out = [
                    each.symbol
                    for each in solution.problem.givens
                    if each.symbol not in given and not each.source
                ]
                return record | {"defaulted": left_out}
            except (UnknownPart, OutOfRange, Undefined) as error:
                return {"error": str(error)}
            except Exception as error:  # a fault of ours loses its own case, and none of the others
                return {"error": unforeseen(error)}
        case _:
            return {"error": 'a case is an object {"given": {…}, "answers": {…}}'}


def _show(record: dict[str, Any]) -> None:
    if "error" in record:
        print(record["error"])
        return
    print(f"{record['code']}: {record['points']:g} of {record['out_of']:g} points")
    for part, entry in record["parts"].items():
        opening = f"  ({part}) {entry['verdict']:9} {entry['points']:g}/{entry['out_of']:g}  "
        print(hanging(opening, entry["feedback"]))
