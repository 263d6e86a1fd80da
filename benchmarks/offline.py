"""The verdicts of the offline page held against the marker's: over all parts, on answers of every sort.

python benchmarks/offline.py [--bank FOLDER …] [--only X12.5,X12.7] [--figures 4] [--json] [--markdown FILE]

The page's side runs in a Python of its own with the standard library alone, from the very texts and data that the page carries.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from carried import collection, keys, worked_out
from honest_answers import asked
from students import written

from corollary.answers.answer_type import AnswerType
from corollary.answers.expected import Values
from corollary.answers.registry import answer_type
from corollary.answers.verdict import Unmarked, word
from corollary.derive.load import NotDerivable
from corollary.formula.ball import Undefined
from corollary.formula.plain_text import text
from corollary.formula.value import Items, Text, Value
from corollary.grading.expectations import expected_of
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.plain_key import judged, serialized
from corollary.grading.solutions import Solutions
from corollary.grading.verdict_text import sentence
from corollary.problem.bank import open_bank
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.variant import Variant, chapter, chosen
from corollary.render.practice_site import reading
from corollary.verify.expected_answers import samples

MECHANICS = Path(__file__).parents[1] / "examples/banks/corollary-mechanics/src/corollary_mechanics"
PLAYER = """
import json, sys
data = json.loads(sys.stdin.readline())
space = {}
exec(data["start"], space)
answered = space["begin"](json.dumps(data))
keys = json.loads(sys.stdin.readline())
for line in sys.stdin:
    key, part, answers = json.loads(line)
    print(answered("judge", keys[key], part, json.dumps(answers)))
"""
Answers = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Tried:
    """Answers to some parts of an exercise, of which that to `part` is looked at; `key` is the exercise's place."""

    sort: str
    key: int
    part: str
    answers: Answers


def tried(solutions: Solutions, problems: list[Problem], figures: int) -> tuple[list[Key], list[Tried]]:
    """Every exercise, and the answers to its parts."""
    found, made = list[Key](), list[Tried]()
    codes = {problem.code: problem for problem in problems}

    def add(key: Key, several: Iterator[tuple[str, str, Answers]]) -> None:
        found.append(key)
        made.extend(Tried(sort, len(found) - 1, part, answers) for sort, part, answers in several)

    for problem in problems:
        try:
            key = solutions.key(chapter(problem))
        except (NotDerivable, Undefined):
            continue
        add(key, _alone(key, figures))
    for question in asked():
        if question["code"] in codes:
            problem = codes[question["code"]]
            values = {name: Fraction(str(value)) for name, value in question["given"].items()}
            part = question["part"]
            sort = "as students write, honest" if question["honest"] else "as students write, wrong"
            add(
                solutions.key(_variant(problem, values)),
                ((sort, part, {part: answer}) for answer in question["answers"]),
            )
    cases = [case for case in collection() if case.code in codes]
    with_numbers = keys(solutions, (case.code for case in cases), 1)
    for case in cases:
        for key in with_numbers[case.code]:
            add(key, _carried(case, key, figures))
    return found, made


def _variant(problem: Problem, values: dict[str, Fraction]) -> Variant:
    in_units = {
        name: value / problem.given(name).unit.to_si(Fraction(1))[0] for name, value in values.items()
    }
    return chosen(problem, in_units)


def _alone(key: Key, figures: int) -> Iterator[tuple[str, str, Answers]]:
    for part in filter(judged, key.variant.problem.parts):
        for each in samples(key, part):
            yield "samples of its type", part.id, {part.id: each.answer}
        quantity = expected_of(key, part).quantity
        if quantity is None:
            continue
        formulas = [("formula, right", quantity.formulas)] if quantity.formulas else []
        formulas += [("formula, misconception", trees) for trees, _text in quantity.wrong_formulas()]
        its_type = answer_type(part.answer_type)
        for sort, trees in formulas:
            typed = [text(tree) for tree in trees or ()]
            for bent in ("{}", "2*({})", "-({})", "({})^2/({})", "1.0001*({})"):
                texts = [bent.replace("{}", each) for each in typed]
                yield (sort if bent == "{}" else f"{sort}, changed"), part.id, {part.id: texts if part.components else texts[0]}  # fmt: skip
        if not its_type.in_symbols:
            yield from _numbers(key, part, quantity.values, quantity, figures, its_type)


def _numbers(
    key: Key, part: Part, right: Values, quantity: Any, figures: int, its_type: AnswerType
) -> Iterator[tuple[str, str, Answers]]:
    sorts = [("right", right)]
    for way in quantity.routes():
        sorts += [
            ("misconception", values)
            for values, _text in (way.misconceptions() if way.misconceptions else ())
        ]
        sorts += [("slip", values) for values, _text in (way.slips() if way.slips else ())]
    sorts += [(f"times {by}", tuple(by * x for x in right)) for by in (-1, 2, 0.5, 10, 1.004, 1.03)]
    for sort, values in sorts:
        for many in (figures, 2, 3, 7):
            yield sort if sort.startswith("times") else f"{sort}, {many} figures", part.id, {part.id: _plain(written(part, values, many))}  # fmt: skip
        if not part.unit.offset and part.unit.text != "1" and not part.rows:
            bare = [f"{x / part.unit.si:.4g}" for x in values]
            yield f"{sort}, bare number", part.id, {part.id: bare if part.components else bare[0]}


def _plain(value: Value) -> Any:
    match value:
        case Items(items):
            return [_plain(each) for each in items]
        case Text(typed):
            return typed
        case _:
            raise TypeError(f"{value} was not typed")


def _carried(case: Any, key: Key, figures: int) -> Iterator[tuple[str, str, Answers]]:
    try:
        earlier, later = worked_out(case, key, figures)
    except (ValueError, ZeroDivisionError):
        return
    part = case.later[0]
    problem = key.variant.problem
    before = [each.id for each in problem.parts]
    others = {
        each: truth.values
        for each, truth in key.truths.items()
        if before.index(each) < before.index(part) and judged(problem.part(each))
    }
    if not judged(problem.part(part)):
        return
    for sort, answers in (("carried, alone", earlier), ("carried, among right ones", others | earlier)):
        typed = {
            name: _plain(written(problem.part(name), values, figures))
            for name, values in (answers | {part: later}).items()
        }
        yield sort, part, typed


def measure(bank: Path | None, only: set[str], figures: int) -> dict[str, Any]:
    """By sort of answer, how many are judged the same, how many the page leaves open, and those judged otherwise."""
    solutions = Solutions(open_bank(bank))
    problems = [each for each in solutions.bank if not only or each.code in only]
    found, made = tried(solutions, problems, figures)
    lines = [json.dumps(reading()), json.dumps([json.dumps(serialized(key)) for key in found])]
    lines += [json.dumps([each.key, each.part, each.answers]) for each in made]
    done = subprocess.run(
        [sys.executable, "-S", "-I", "-c", PLAYER],
        input="\n".join(lines),
        capture_output=True,
        text=True,
        check=True,
    )
    counts: dict[str, Counter[str]] = {}
    otherwise = list[dict[str, Any]]()
    for each, line in zip(made, done.stdout.splitlines(), strict=True):
        got = json.loads(line)
        key = found[each.key]
        verdict = judge(key, {part: from_json(answer) for part, answer in each.answers.items()})[each.part][
            0
        ][0]
        ours = {"word": word(verdict), "text": sentence(verdict)}
        same = {name: got[name] for name in ours} == ours
        left = got["word"] == "unmarked" and not isinstance(verdict, Unmarked)
        outcome = "same" if same else "left open" if left else "other"
        counts.setdefault(each.sort, Counter())[outcome] += 1
        if not same:
            one = {"code": key.variant.problem.code, "outcome": outcome, "part": each.part, "sort": each.sort}
            otherwise.append({**one, "answers": each.answers, "marker": ours, "page": got})
    parts = {
        (key.variant.problem.code, part.id): judged(part)
        for key in found
        for part in key.variant.problem.parts
    }
    return {
        "parts": len(parts),
        "judged": sum(parts.values()),
        "answers": len(made),
        "sorts": counts,
        "otherwise": otherwise,
    }


def together(results: list[dict[str, Any]]) -> dict[str, Any]:
    """The sums over several banks."""
    sorts: dict[str, Counter[str]] = {}
    for result in results:
        for sort, count in result["sorts"].items():
            sorts.setdefault(sort, Counter()).update(count)
    counted = {name: sum(each[name] for each in results) for name in ("parts", "judged", "answers")}
    return {
        **counted,
        "sorts": {sort: dict(count) for sort, count in sorts.items()},
        "total": dict(sum(sorts.values(), Counter[str]())),
        "otherwise": [each for result in results for each in result["otherwise"]],
    }


def table(result: dict[str, Any]) -> str:
    """In Markdown."""
    lines = [
        f"{result['judged']} of {result['parts']} parts are judged offline; {result['answers']} answers to them:",
        "",
        "| answers | same verdict and sentence | left open | other |",
        "|---|---|---|---|",
    ]
    rows = Counter[str](), dict[str, Counter[str]]()
    for sort, count in result["sorts"].items():
        rows[1].setdefault(sort.partition(",")[0] if sort.startswith("times") else sort, Counter()).update(
            count
        )
    for sort, count in (*sorted(rows[1].items()), ("**all**", result["total"])):
        lines.append(
            f"| {sort} | {count.get('same', 0)} | {count.get('left open', 0)} | {count.get('other', 0)} |"
        )
    return "\n".join(lines)


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument(
        "--bank",
        type=Path,
        action="append",
        help="a bank; the chapter's and the example of another when left out",
    )
    options.add_argument("--only", default="", help="codes, parted by commas")
    options.add_argument("--figures", type=int, default=4, help="figures that students write down")
    options.add_argument("--json", action="store_true", help="one JSON document instead of text")
    options.add_argument("--markdown", type=Path, help="a file for the table")
    given: Any = options.parse_args()
    only = {code for code in str(given.only).split(",") if code}
    result = together([measure(bank, only, given.figures) for bank in given.bank or (None, MECHANICS)])
    if given.markdown:
        given.markdown.write_text(table(result) + "\n", encoding="utf-8")
    print(json.dumps(result, indent=1) if given.json else table(result))


if __name__ == "__main__":
    main()
