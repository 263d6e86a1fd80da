"""`corollary judge`: plain answers marked."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

from corollary.cli.failure import FAILS, HOLDS, answer
from corollary.cli.given import from_case, read_cases
from corollary.formula.ball import Undefined
from corollary.grading.from_json import plainly
from corollary.grading.judge import judge
from corollary.grading.points import grade
from corollary.grading.record import grade_record
from corollary.grading.run_programs import run_programs
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.problem import Problem
from corollary.problem.variant import OutOfRange


def run(code: str, bank: Path | None, cases: Path, reveal: bool, as_json: bool) -> int:
    place, problem = home(bank, code)
    solutions = Solutions(place)
    solutions.of(problem)
    records = [_case(solutions, problem, case, reveal) for case in read_cases(cases)]
    if as_json:
        answer(records)
    else:
        for record in records:
            _show(record)
    return FAILS if any("error" in record for record in records) else HOLDS


def _case(solutions: Solutions, problem: Problem, case: Any, reveal: bool) -> dict[str, Any]:
    if (
        not isinstance(case, dict)
        or not isinstance(case.get("answers"), dict)
        or not isinstance(case.get("given", {}), dict)
    ):
        return {"error": 'a case is an object {"given": {…}, "answers": {…}}'}
    ids = [part.id for part in problem.parts]
    if strange := [name for name in case["answers"] if name not in ids]:
        return {"error": f"{problem.code} has no part {', '.join(strange)}; its parts are {', '.join(ids)}"}
    try:
        key = solutions.key(from_case(problem, case.get("given", {})))
    except (OutOfRange, Undefined) as error:
        return {"error": str(error)}
    answers = {part: plainly(_floated(given)) for part, given in case["answers"].items()}
    shown = run_programs(key, answers)
    return grade_record(grade(key, judge(key, answers, shown), reveal=reveal))


def _floated(given: Any) -> Any:
    """Exact decimals of the file, as the machine numbers a student's process would hold."""
    match given:
        case Fraction():
            try:
                return float(given)
            except OverflowError:
                return given
        case list():
            return [_floated(each) for each in given]
        case _:
            return given


def _show(record: dict[str, Any]) -> None:
    if "error" in record:
        print(record["error"])
        return
    print(f"{record['code']}: {record['points']:g} of {record['out_of']:g} points")
    for part, entry in record["parts"].items():
        print(f"  ({part}) {entry['verdict']:9} {entry['points']:g}/{entry['out_of']:g}  {entry['feedback']}")
