"""One constant typed in every part: what share of each problem's points it earns, where it is not the answer.

python benchmarks/constants.py [--variants 12] [--only X12.5,X12.7] [--json] [--markdown FILE]
"""

from __future__ import annotations

import argparse
import json
from collections import defaultdict
from pathlib import Path
from typing import Any

from carried import keys

from corollary.answers.verdict import Right
from corollary.formula.value import Items, Real, Text, Value
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.points import grade
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_order, files, open_bank
from corollary.problem.part import Part
from corollary.problem.reader import read_problem

NUMBERS = [
    "0",
    "1",
    "-1",
    "2",
    "5",
    "10",
    "1e1",
    "1e2",
    "100",
    "1e3",
    "1000",
    "0.1",
    "0.5",
    "9.81",
    "3.14",
    "42",
    "-10",
    "1.0",
    "10.0",
    "0.0",
]
MACHINE = [0.0, 1.0, 10.0, 100.0, 9.81]
LETTERS = ["a", "b", "c", "d"]


def earned(key: Key, constant: str | float) -> tuple[float, float]:
    """Points, and out of how many: of the parts that it could be typed in and whose answer it is not."""
    parts = [part for part in key.variant.problem.parts if _takes(key, part, constant)]
    judged = judge(key, {part.id: _typed(part, constant) for part in parts})
    points = out_of = 0.0
    for each in grade(key, judged).parts:
        if each.part not in parts or (each.points and _right_alone(key, each.part, constant)):
            continue
        points, out_of = points + each.points, out_of + each.out_of
    return points, out_of


def _right_alone(key: Key, part: Part, constant: str | float) -> bool:
    """Whether the constant is the answer to this part, if to the two figures that it is written with."""
    return isinstance(judge(key, {part.id: _typed(part, constant)})[part.id][0][0], Right)


def _takes(key: Key, part: Part, constant: str | float) -> bool:
    if constant in LETTERS:
        return part.id in key.choices
    return part.id in key.truths and part.answer_type != "expression"


def _typed(part: Part, constant: str | float) -> Value:
    one = Text(constant) if isinstance(constant, str) else Real(constant)
    return Items((one,) * len(part.components), (len(part.components),)) if part.components else one


def measure(variants: int, only: list[str]) -> dict[str, Any]:
    """The share of each constant in each problem, in per cent of all that was asked over the variants."""
    solutions = Solutions(open_bank(None))
    codes = sorted(
        (
            problem.code
            for problem in map(read_problem, files(solutions.bank))
            if not only or problem.code in only
        ),
        key=chapter_order,
    )
    shares: dict[str, dict[str, float]] = {}
    totals: dict[str, list[float]] = defaultdict(lambda: [0.0, 0.0])
    for code, with_numbers in keys(solutions, codes, variants).items():
        found: dict[str, float] = {}
        for constant in [*NUMBERS, *MACHINE, *LETTERS]:
            points = [earned(key, constant) for key in with_numbers]
            got, out_of = sum(each for each, _ in points), sum(each for _, each in points)
            name = repr(constant) if isinstance(constant, float) else constant
            if out_of:
                found[name] = 100 * got / out_of
                totals[name][0] += got
                totals[name][1] += out_of
        if found:
            shares[code] = found
    return {
        "variants": variants,
        "problems": shares,
        "constants": {name: 100 * got / out_of for name, (got, out_of) in totals.items()},
        "worst": max(max(found.values()) for found in shares.values()),
    }


def table(result: dict[str, Any]) -> str:
    """In Markdown: of each problem the mean over the constants, and the constant that earns most."""
    lines = ["| problem | mean | most | by |", "|---|---|---|---|"]
    for code, found in result["problems"].items():
        best = max(found, key=lambda name: found[name])
        mean = sum(found.values()) / len(found)
        lines.append(
            f"| {code} | {mean:.2f} % | {found[best]:.2f} % | {f'`{best}`' if found[best] else ''} |"
        )
    return "\n".join(lines)


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--variants", type=int, default=12, help="variants of each problem")
    options.add_argument("--only", default="", help="codes, parted by commas")
    options.add_argument("--json", action="store_true", help="one JSON document instead of a table")
    options.add_argument("--markdown", type=Path, help="a file for the table")
    asked = options.parse_args()
    result = measure(asked.variants, asked.only.split(",") if asked.only else [])
    if asked.markdown:
        asked.markdown.write_text(table(result) + "\n", encoding="utf-8")
    print(json.dumps(result, indent=1) if asked.json else table(result))
    if not asked.json:
        print(
            "\nover all problems: "
            + ", ".join(f"{name} {share:.2f} %" for name, share in result["constants"].items())
        )


if __name__ == "__main__":
    main()
