"""The judge measured: honest work rejected, listed mistakes accepted, formulas compared, random answers, the time of a verdict.

python benchmarks/judging.py [--students 2000] [--only X12.5,X12.7] [--no-students] [--only-students] [--no-wild] [--json | --markdown]
                             [--keep FOLDER]

With --keep each problem's counts are written into the folder when it is done, and read from there when they are there already.
Those of one that is not done are written every ten students, so that what was stopped goes on from there.
"""

from __future__ import annotations

import argparse
import json
import runpy
import statistics
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import sympy
from rich.console import Console
from rich.table import Table
from students import FIXED, SORTS, Tallies, simulate, simulated, wild

from corollary.answers.equality import Different, Equal, Undecided, compare
from corollary.atomic import write_whole
from corollary.derive.load import NotDerivable
from corollary.derive.solution import Solution
from corollary.formula.ast import Expr, names
from corollary.formula.errors import ParseError
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula, parse
from corollary.formula.value import Real, Text, Value
from corollary.grading.expectations import expected_of
from corollary.grading.judge import read, verdict_on
from corollary.grading.key import Key
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_order, files, open_bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.reader import read_problem
from corollary.problem.variant import chapter, size
from corollary.units.unit import canonical

PAIRS = Path(__file__).resolve().parent.parent / "tests" / "answers" / "pairs.py"
TARGETS = {"symbolic": 2.0, "unit": 0.2, "number": 0.05}
REPEATS = 30
EVERY = 10  # students between two savings of a problem's counts


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument(
        "--students", type=int, default=2000, help="simulated students of each sort, for each problem"
    )
    options.add_argument("--only", default="", help="codes, parted by commas")
    options.add_argument("--no-students", action="store_true", help="leave out the simulated students")
    options.add_argument("--no-wild", action="store_true", help="leave out answers that are just anything")
    options.add_argument("--only-students", action="store_true", help="leave out formulas and times")
    options.add_argument("--json", action="store_true", help="one JSON document instead of tables")
    options.add_argument("--markdown", action="store_true", help="the students' tables of results/judging.md")
    options.add_argument("--keep", type=Path, help="folder with a file for each problem that is done")
    asked = options.parse_args()
    solutions = Solutions(open_bank(None))
    problems, left_out = _derivable(solutions, asked.only.split(",") if asked.only else [])
    result: dict[str, Any] = {"students": asked.students, "left_out": left_out}
    if not asked.only_students:
        result["pairs"], simplify = formula_pairs()
        result["times"] = times(solutions, problems, simplify)
    if not asked.no_students:
        numeric = [solutions.of(problem) for problem in problems if size(problem) > 1]
        numeric = [solution for solution in numeric if any(find.part for find in solution.unknowns)]
        tallies = {
            each.problem.code: _told(
                each.problem.code, lambda each=each: kept(each, asked.students, asked.keep)
            )
            for each in numeric
        }
        result["problems"] = {code: each.record() for code, each in tallies.items()}
        result["overall"] = Tallies.together(tallies.values()).record()
        if not asked.no_wild:
            result["wild"] = _told("wild answers", lambda: wild(numeric, asked.students))
    if asked.json:
        print(json.dumps(result))
    elif asked.markdown:
        print("\n".join(markdown(result["problems"], result["overall"], asked.students)))
    else:
        show(result)


def kept(solution: Solution, students: int, folder: Path | None) -> Tallies:
    """The tallies of a problem, from the folder where they are there for as many students."""
    if folder is None:
        return simulate(solution, students)
    file = folder / f"{solution.problem.code}-{students}.json"
    if file.exists():
        return Tallies.from_json(file.read_text(encoding="utf-8"))
    begun = file.with_suffix(".begun")
    tallies = so_far = Tallies.from_json(begun.read_text(encoding="utf-8")) if begun.exists() else Tallies()
    for tallies in simulated(solution, students, so_far):
        if tallies.drawn % EVERY == 0:
            write_whole(begun, tallies.to_json())
    write_whole(file, tallies.to_json())
    begun.unlink(missing_ok=True)
    return tallies


def _derivable(solutions: Solutions, wanted: Sequence[str]) -> tuple[list[Problem], list[str]]:
    problems, left_out = [], []
    for path in files(solutions.bank):
        try:
            problem = read_problem(path)
            if not wanted or problem.code in wanted:
                solutions.of(problem)
                problems.append(problem)
        except (Malformed, NotDerivable) as error:
            left_out.append(f"{path.name}: {error}")
    return sorted(problems, key=lambda problem: chapter_order(problem.code)), left_out


def formula_pairs() -> tuple[dict[str, Any], list[float]]:
    """Every pair decided by the judge's comparison and by sympy; and the times sympy took, in ms."""
    pairs = runpy.run_path(str(PAIRS))["pairs"]()
    ours: Counter[str] = Counter()
    theirs: Counter[str] = Counter()
    taken: list[float] = []
    slow: list[float] = []
    for student, truth, letters, domain, same in pairs:
        left, right = parse(student, letters), author_formula(truth, letters)
        assert not isinstance(left, ParseError), student
        start = time.perf_counter()
        verdict = compare(left, right, domain)
        taken.append(1e3 * (time.perf_counter() - start))
        match verdict:
            case Equal():
                ours["right" if same else "false equal"] += 1
            case Different():
                ours["false different" if same else "right"] += 1
            case Undecided():
                ours["undecided"] += 1
        a, b = (_for_sympy(tree, domain, names(left) | names(right)) for tree in (left, right))
        start = time.perf_counter()
        equal = sympy.simplify(a - b) == 0
        slow.append(1e3 * (time.perf_counter() - start))
        theirs["right" if equal == same else "false equal" if equal else "false different"] += 1
    counted: dict[str, Any] = {"pairs": len(pairs), "equal": sum(same for *_, same in pairs)}
    for name, counts, each in (("corollary", ours, taken), ("sympy.simplify", theirs, slow)):
        outcome = {what: counts[what] for what in ("right", "false equal", "false different", "undecided")}
        counted[name] = outcome | {
            "median_ms": round(statistics.median(each), 4),
            "worst_ms": round(max(each), 3),
        }
    return counted, slow


def _for_sympy(tree: Expr, domain: dict[str, tuple[float, float]], letters: frozenset[str]) -> sympy.Expr:
    """The same formula with the assumptions that help sympy most."""
    known: dict[str, Any] = {
        "ln": sympy.log,
        "log10": lambda x: sympy.log(x, 10),
        "min": sympy.Min,
        "max": sympy.Max,
    }
    for name in letters - {"pi"}:
        real = domain.get(name, (1.0, 1.0))[0] < 0
        known[name] = sympy.Symbol(name, real=True) if real else sympy.Symbol(name, positive=True)
    return sympy.parse_expr(text(tree).replace("^", "**"), local_dict=known)


def times(solutions: Solutions, problems: Sequence[Problem], simplify: list[float]) -> dict[str, Any]:
    """Median time of one verdict, from the value handed in to what is said of it, over all parts, warm."""
    taken: dict[str, list[float]] = {
        "symbolic": [],
        "unit": [],
        "number": [],
        "symbolic, wrong": [],
        "number, wrong": [],
    }
    for problem in problems:
        key = solutions.key(chapter(problem))
        for part in problem.parts:
            for sort, answer in answers(key, part):
                taken[sort].append(
                    _median(lambda key=key, part=part, answer=answer: one_verdict(key, part, answer))
                )
    middle = {sort: statistics.median(each) for sort, each in taken.items() if each}
    sympy_ms = statistics.median(simplify)
    return {
        sort: {
            "verdicts": len(taken[sort]),
            "median_ms": ms,
            "target_ms": TARGETS.get(sort),
            "of_simplify": ms / sympy_ms,
        }
        for sort, ms in middle.items()
    }


def answers(key: Key, part: Part) -> list[tuple[str, Value]]:
    """Answers of each sort to a part with one quantity."""
    truth = key.truths.get(part.id)
    if truth is None or part.components or part.answer_type != "value":
        return []
    value, closed = (
        truth.values[0] / part.unit.si,
        key.find(truth).in_givens,
    )
    found: list[tuple[str, Value]] = [
        ("number", Real(value)),
        ("number, wrong", Real(1.3719 * value + 0.7717)),
    ]
    if part.unit.text != "1":
        found.append(("unit", Text(f"{value:.4g} {canonical(part.unit)}")))
    if closed is not None and names(closed[0]) - {"pi"}:
        found += [
            ("symbolic", Text(f"({text(closed[0])})*3/3")),
            ("symbolic, wrong", Text(f"({text(closed[0])})*1.7")),
        ]
    return found


def one_verdict(key: Key, part: Part, answer: Value) -> object:
    """Reading and judging, without the other parts."""
    expected = expected_of(key, part)
    return verdict_on(part.answer_type, read(part, answer, expected, key.variant), expected)


def _median(run: Callable[[], object]) -> float:
    run()
    taken = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        run()
        taken.append(1e3 * (time.perf_counter() - start))
    return statistics.median(taken)


def _told(what: str, run: Callable[[], Any]) -> Any:
    start = time.perf_counter()
    found = run()
    print(f"{what}: {time.perf_counter() - start:.0f} s", file=sys.stderr)
    return found


def show(result: dict[str, Any]) -> None:
    """The tables for people."""
    console = Console(width=150)
    for left in result["left_out"]:
        console.print(f"left out: {left}", style="dim")
    if "problems" in result:
        rows = result["problems"] | {"all": result["overall"]}
        for sort in SORTS:
            honest = {code: record["honest"][sort] for code, record in rows.items()}
            _shares(console, f"Honest work rejected, %: {sort}", honest, "rejected_percent")
        mistakes = {code: record["mistakes"] for code, record in rows.items()}
        _shares(console, "Listed mistakes accepted, %", mistakes, "accepted_percent")
        title = f"Draws passed over; mistakes called by their name ({result['students']} students of each sort a problem)"
        table = _table(title, "problem", "redrawn, %", "named, %", "to look at")
        for code, record in rows.items():
            shares = (record["redrawn_percent"], mistakes[code]["named_percent"])
            table.add_row(code, *map(_number, shares), "; ".join(record["worst"][:2]))
        console.print(table)
        verdicts = ("right", "follows", "mistaken", "slip", "wrong")
        table = _table("Answers that are just anything: judged as, %", "scatter", "answers", *verdicts)
        for name, record in result.get("wild", {}).items():
            table.add_row(name, *(str(each) for each in record.values()))
        console.print(table)
    if "pairs" not in result:
        return
    counted = result["pairs"]
    headings = ("decided by", "right", "false equal", "false different", "undecided", "median ms", "worst ms")
    table = _table(f"{counted['pairs']} pairs of formulas, {counted['equal']} of them equal", *headings)
    for name in ("corollary", "sympy.simplify"):
        table.add_row(name, *(str(each) for each in counted[name].values()))
    console.print(table)
    table = _table(
        "One verdict, once warm", "answer", "parts", "median ms", "target ms", "of sympy.simplify(a - b) == 0"
    )
    for sort, record in result["times"].items():
        share = f"1/{1 / record['of_simplify']:.0f}"
        table.add_row(
            sort, str(record["verdicts"]), f"{record['median_ms']:.4f}", str(record["target_ms"] or ""), share
        )
    console.print(table)


def markdown(problems: dict[str, Any], overall: dict[str, Any], students: int) -> Iterator[str]:
    """The shares of all problems together, and a row for each."""
    yield f"| {len(problems)} problems, {students} students each | answers | rejected |\n|---|---|---|"
    for sort in SORTS:
        record = overall["honest"][sort]
        yield f"| honest, {sort} | {record['answers']} | {record['rejected_percent']:.3f} % |"
    mistakes = overall["mistakes"]
    yield f"| listed mistakes: accepted | {mistakes['answers']} | {mistakes['accepted_percent']:.4f} % |"
    yield f"| listed mistakes: called by their name | {mistakes['answers']} | {mistakes['named_percent']:.2f} % |"
    headings = ("problem", "draws refused", "honest answers", "rejected, 3 figures at each step")
    yield f"\n| {' | '.join((*headings, 'at every operation', 'mistakes', 'accepted', 'named'))} |\n{'|---' * 8}|"
    for code, record in problems.items():
        step, operation = (record["honest"][f"3 figures each {where}"] for where in ("step", "operation"))
        mistakes = record["mistakes"]
        yield (
            f"| {code} | {record['redrawn_percent']:.0f} % | {step['answers']} | {step['rejected_percent']:.2f} % "
            f"| {operation['rejected_percent']:.2f} % | {mistakes['answers']} | {mistakes['accepted_percent']:.3f} % "
            f"| {mistakes['named_percent']:.2f} % |"
        )


def _shares(console: Console, title: str, rows: dict[str, Any], share: str) -> None:
    table = _table(title, "problem", "answers", "corollary", *(f"fixed {limit:.0%}" for limit in FIXED))
    for code, each in rows.items():
        if each["answers"]:
            table.add_row(
                code,
                str(each["answers"]),
                _number(each[share]),
                *(_number(fixed) for fixed in each["fixed"].values()),
            )
    console.print(table)


def _table(title: str, *headings: str) -> Table:
    table = Table(title=title, title_justify="left")
    for place, heading in enumerate(headings):
        table.add_column(heading, justify="left" if not place or heading == "to look at" else "right")
    return table


def _number(share: float | None) -> str:
    return "" if share is None else f"{share:.2f}"


if __name__ == "__main__":
    main()
