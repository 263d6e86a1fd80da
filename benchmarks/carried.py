"""Errors that students carry on: how many of a collection made by hand are judged to follow.

python benchmarks/carried.py [--variants 5] [--figures 4] [--only X12.5,X12.7] [--json] [--markdown FILE]
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import CodeType
from typing import Any

from students import written

from corollary.answers.expected import Values
from corollary.answers.tolerance import within
from corollary.answers.verdict import Follows, Right, word
from corollary.formula.value import Value
from corollary.grading.assign import admitted
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.solutions import Solutions
from corollary.problem.bank import files, open_bank
from corollary.problem.reader import read_problem
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter

COLLECTION = Path(__file__).resolve().parent.parent / "tests" / "grading" / "carried_errors.txt"
TRIES = 40  # draws looked at for each variant wanted
KNOWN: dict[str, Any] = {
    name: getattr(math, name)
    for name in [
        "sqrt",
        "sin",
        "cos",
        "tan",
        "asin",
        "acos",
        "atan",
        "atan2",
        "exp",
        "log",
        "hypot",
        "pi",
        "fabs",
    ]
}
Formula = tuple[str, CodeType]


@dataclass(frozen=True, slots=True)
class Carried:
    """A line of the collection: earlier answers that came out wrong, and a later one worked out from them."""

    line: int
    code: str
    bent: tuple[Formula, ...]
    later: Formula
    text: str


def collection(path: Path = COLLECTION) -> list[Carried]:
    """Every line of the file that is no remark."""
    found: list[Carried] = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("#") or not line.strip():
            continue
        code, bent, later = (cell.strip() for cell in line.split("|"))
        found.append(Carried(number, code, tuple(map(_formula, bent.split(";"))), _formula(later), line))
    return found


def _formula(text: str) -> Formula:
    part, formula = (side.strip() for side in text.split("=", 1))
    return part, compile(formula, text, "eval")


def value(formula: CodeType, letters: Mapping[str, Any]) -> Values:
    """What a formula of the collection comes to; raises ValueError or ZeroDivisionError where it has no value."""
    result = eval(formula, {"__builtins__": {}}, {**KNOWN, **letters})  # a file of our own
    return tuple(map(float, result)) if isinstance(result, list) else (float(result),)


def worked_out(case: Carried, key: Key, figures: int) -> tuple[dict[str, Values], Values]:
    """The earlier answers as the student writes them down, and the later one, from these."""
    letters: dict[str, Any] = dict(key.variant.si)
    earlier: dict[str, Values] = {}
    for part, formula in case.bent:
        earlier[part] = tuple(_rounded(each, figures) for each in value(formula, letters))
        letters |= named(part, earlier[part], letters)
    return earlier, tuple(_rounded(each, figures) for each in value(case.later[1], letters))


def named(part: str, values: Values, letters: Mapping[str, Any]) -> dict[str, Any]:
    """An answer under the name that the collection has for it."""
    return {f"{part}_" if part in letters else part: values[0] if len(values) == 1 else values}


def _rounded(number: float, figures: int) -> float:
    return float(f"{number:.{figures - 1}e}")


def verdicts(case: Carried, key: Key, figures: int) -> Iterator[tuple[str, Any]]:
    """The verdict on the later answer: with the earlier ones alone, and with all else asked before it answered rightly.

    None where there is nothing to carry: an earlier answer or the later one comes out right.
    """
    try:
        earlier, later = worked_out(case, key, figures)
    except (ValueError, ZeroDivisionError):
        return
    part = case.later[0]
    if any(_right(key, each, values) for each, values in (earlier | {part: later}).items()):
        return
    before = [each.id for each in key.variant.problem.parts]
    others = {
        each: truth.values for each, truth in key.truths.items() if before.index(each) < before.index(part)
    }
    for name, answers in (("alone", earlier), ("among right ones", others | earlier)):
        judged = judge(key, _as_typed(key, answers | {part: later}, figures))
        yield name, judged[part][0][0]


def _right(key: Key, part: str, values: Values) -> bool:
    truth = key.truths[part]
    return within(values, truth.values, truth.tolerance, truth.scale)


def _as_typed(key: Key, answers: Mapping[str, Values], figures: int) -> dict[str, Value]:
    problem = key.variant.problem
    return {part: written(problem.part(part), values, figures) for part, values in answers.items()}


def keys(solutions: Solutions, codes: Iterable[str], count: int) -> dict[str, list[Key]]:
    """The chapter's numbers of each problem and some more that would be given out."""
    found: dict[str, list[Key]] = {}
    problems = {problem.code: problem for problem in map(read_problem, files(solutions.bank))}
    for code in dict.fromkeys(codes):
        solution = solutions.of(problems[code])
        found[code] = [solutions.key(chapter(problems[code]))]
        for variant in sample(problems[code], TRIES * count, salt="carried"):
            if len(found[code]) >= count:
                break
            key, _ = admitted(solution, variant)
            if key is not None:
                found[code].append(key)
    return found


def measure(cases: Iterable[Carried], variants: int, figures: int) -> dict[str, Any]:
    """How often each line of the collection is judged to follow, of how many variants where there is something to carry."""
    cases = list(cases)
    with_numbers = keys(Solutions(open_bank(None)), (case.code for case in cases), variants)
    lines: list[dict[str, Any]] = []
    for case in cases:
        tries, follows, instead = 0, 0, dict[str, int]()
        for key in with_numbers[case.code]:
            for name, verdict in verdicts(case, key, figures):
                tries += 1
                follows += isinstance(verdict, (Follows, Right))
                if not isinstance(verdict, (Follows, Right)):
                    sort = f"{word(verdict)}, {name}"
                    instead[sort] = instead.get(sort, 0) + 1
        lines.append(
            {"line": case.line, "text": case.text, "tries": tries, "follows": follows, "instead": instead}
        )
    tried = [each for each in lines if each["tries"]]
    return {
        "variants": variants,
        "figures": figures,
        "errors": len(lines),
        "tries": sum(each["tries"] for each in tried),
        "follow_percent": round(
            100 * sum(each["follows"] for each in tried) / max(1, sum(each["tries"] for each in tried)), 2
        ),
        "always_percent": round(
            100 * sum(each["follows"] == each["tries"] for each in tried) / max(1, len(tried)), 2
        ),
        "missed": [each for each in lines if each["follows"] < each["tries"] or not each["tries"]],
    }


def table(result: dict[str, Any]) -> str:
    """In Markdown: the shares, and what is missed."""
    lines = [
        f"{result['errors']} errors, each with {result['variants']} variants, written down with {result['figures']} figures, alone and among right answers: "
        f"{result['tries']} answers, of which {result['follow_percent']} % follow. {result['always_percent']} % of the errors are followed in every variant.",
        "",
        "| missed | times | of | judged instead |",
        "|---|---|---|---|",
    ]
    for each in result["missed"]:
        if each["tries"]:
            instead = ", ".join(f"{sort} {count}" for sort, count in each["instead"].items())
            text = each["text"].replace("|", "→")
            lines.append(f"| `{text}` | {each['tries'] - each['follows']} | {each['tries']} | {instead} |")
    return "\n".join(lines)


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--variants", type=int, default=5, help="variants of each problem")
    options.add_argument("--figures", type=int, default=4, help="figures that students write down")
    options.add_argument("--only", default="", help="codes, parted by commas")
    options.add_argument("--json", action="store_true", help="one JSON document instead of text")
    options.add_argument("--markdown", type=Path, help="a file for the table")
    asked = options.parse_args()
    cases = [case for case in collection() if not asked.only or case.code in asked.only.split(",")]
    result = measure(cases, asked.variants, asked.figures)
    if asked.markdown:
        asked.markdown.write_text(table(result) + "\n", encoding="utf-8")
    print(json.dumps(result, indent=1) if asked.json else table(result))


if __name__ == "__main__":
    main()
