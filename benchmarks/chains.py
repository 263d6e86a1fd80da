"""Wrong answers planted in every part that another is made of: how often what follows from them is judged to follow.

python benchmarks/chains.py [--variants 3] [--figures 3] [--only X12.5,X12.7] [--bank FOLDER] [--json] [--markdown FILE]

For each pair of parts, each way that leads from one to the other, and each plausible error: the earlier answer as it came out,
the later one worked out from it with all its digits, both written down rounded. Beside each chain stands one that is broken: the
later answer off by three tenths, which must not follow.
"""

from __future__ import annotations

import argparse
import json
import math
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from carried import keys
from students import written

from corollary.answers.evaluation import BITS, as_exact, balls, numbers
from corollary.answers.expected import Values
from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Right, word
from corollary.formula.ball import Undefined, precision_of
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.mistakes import wrong_values
from corollary.grading.replay import BY_THE_RULES, WhatIf, ancestors, replay
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_order, files, open_bank
from corollary.problem.part import Part
from corollary.problem.reader import read_problem

FACTORS = {"twice": 2.0, "half": 0.5, "sign": -1.0, "x 1.37": 1.37, "x 0.8": 0.8, "x 1.1": 1.1, "x 10": 10.0}
BROKEN = 0.3  # of what follows, or of the truth where that is nothing: so much is added, which no rounding explains
SEEN = 0.05  # relative: a chain shows only where the later answer is further from the truth, and from what else could be meant


@dataclass(frozen=True, slots=True)
class Chain:
    """An error in the part `first`, and what the part `later` is, worked out from it."""

    first: str
    later: str
    error: str
    wrong: Values
    follows: Values
    broken: Values


def chains(key: Key) -> Iterator[Chain]:
    """Every pair of parts, way and error of a problem's variant."""
    parts = [part.id for part in key.variant.problem.parts if part.id in key.truths and _in_numbers(part)]
    for at, first in enumerate(parts):
        for later in parts[at + 1 :]:
            for error, wrong in errors(key, first):
                several = list(consequences_of(key, first, wrong, later))
                seen = [key.truths[later].values]
                for found in several:
                    if all(_shows(found, each) for each in seen):
                        seen.append(found)
                        yield Chain(first, later, error, wrong, found, _broken(key, later, found, several))


def _broken(key: Key, part: str, follows: Values, several: Iterable[Values]) -> Values:
    """What follows, and something more, away from all else that could be meant."""
    truth = key.truths[part]
    size = math.hypot(*follows)
    step = BROKEN * (size if size > BROKEN * SEEN * truth.scale else truth.scale or 1.0)
    taken = [truth.values, *several]
    for times in range(1, 20):
        values = (follows[0] + times * step, *follows[1:])
        if all(_shows(values, each) for each in taken):
            return values
    raise AssertionError(f"{part}: everything is taken")


def _in_numbers(part: Part) -> bool:
    return not part.rows and not answer_type(part.answer_type).in_symbols


def errors(key: Key, part: str) -> Iterator[tuple[str, Values]]:
    """What may come out wrong: a factor, a component, a listed misconception."""
    truth = key.truths[part]
    found = [(name, tuple(factor * x for x in truth.values)) for name, factor in FACTORS.items()]
    if len(truth.values) > 1:
        found += [
            (f"component {place + 1} {name}", (*truth.values[:place], factor * x, *truth.values[place + 1 :]))
            for name, factor in (("sign", -1.0), ("x 1.37", 1.37))
            for place, x in enumerate(truth.values)
        ]
    found += [
        (f"mistake {place}", values)
        for place, (values, _text) in enumerate(wrong_values(key, truth, BY_THE_RULES))
    ]
    for name, values in found:
        if all(map(math.isfinite, values)) and any(values) and _shows(values, truth.values):
            yield name, values


def consequences_of(key: Key, first: str, wrong: Values, later: str) -> Iterator[Values]:
    """The later part by the author's steps from a wrong answer, and by the other ways of the derivation from it and right ones."""
    solution, givens = key.solution, key.variant.exact
    place, at = key.truths[later].place, key.truths[first].place
    if at in ancestors(solution, place):
        with suppress(Undefined):
            yield replay(solution, givens, WhatIf(held={at: wrong}), place)[place]
    for way in solution.paths.get(later, ()):
        if first in way.earlier:
            known = {part: truth.values for part, truth in key.truths.items()} | {first: wrong}
            own = {
                name: as_exact(value)
                for part in way.earlier
                for name, value in zip(
                    solution.unknowns[key.truths[part].place].names, known[part], strict=True
                )
            }
            with suppress(Undefined), precision_of(BITS):
                yield numbers(way.trees, balls(givens | own))


def _shows(values: Values, others: Values) -> bool:
    return math.dist(values, others) > SEEN * max(math.hypot(*values), math.hypot(*others))


def judged(key: Key, chain: Chain, figures: int) -> tuple[Any, Any]:
    """The verdicts on the later answer, and on one that is broken, with all between answered rightly."""
    problem = key.variant.problem
    before = [part.id for part in problem.parts]
    right = {
        part: key.truths[part].values
        for part in before[: before.index(chain.later)]
        if part in key.truths and _in_numbers(problem.part(part))
    }
    found: list[Any] = []
    for later in (chain.follows, chain.broken):
        answers = right | {chain.first: chain.wrong, chain.later: later}
        typed = {part: written(problem.part(part), values, figures) for part, values in answers.items()}
        found.append(judge(key, typed)[chain.later][0][0])
    return found[0], found[1]


def measure(variants: int, figures: int, only: Iterable[str], bank: Path | None = None) -> dict[str, Any]:
    """How many chains are carried, of which sort those are that are not, and how many broken ones follow."""
    solutions = Solutions(open_bank(bank))
    codes = sorted({problem.code for problem in map(read_problem, files(solutions.bank))}, key=chapter_order)
    wanted = list(only) or codes
    missed: dict[str, Counter[str]] = {}
    total = carried = broken = 0
    by_code: dict[str, list[int]] = {}
    for code, with_numbers in keys(solutions, [code for code in codes if code in wanted], variants).items():
        for key in with_numbers:
            for chain in chains(key):
                verdict, other = judged(key, chain, figures)
                follows = isinstance(verdict, Follows | Right)
                total, carried = total + 1, carried + follows
                broken += isinstance(other, Follows | Right)
                own = by_code.setdefault(code, [0, 0])
                own[0], own[1] = own[0] + follows, own[1] + 1
                if not follows:
                    name = f"{code} {chain.first} to {chain.later}"
                    missed.setdefault(name, Counter())[f"{chain.error}: {word(verdict)}"] += 1
                if isinstance(other, Follows | Right):
                    name = f"{code} {chain.first} to {chain.later}, broken"
                    missed.setdefault(name, Counter())[f"{chain.error}: {word(other)}"] += 1
    return {
        "variants": variants,
        "figures": figures,
        "chains": total,
        "carried_percent": round(100 * carried / max(1, total), 2),
        "broken_carried": broken,
        "problems": {code: f"{got}/{of}" for code, (got, of) in by_code.items()},
        "missed": {name: dict(counts) for name, counts in missed.items()},
    }


def table(result: dict[str, Any]) -> str:
    """In Markdown: the shares, and what is missed."""
    lines = [
        f"{result['chains']} chains of {len(result['problems'])} problems, {result['variants']} variants each, written with {result['figures']} figures: "
        f"{result['carried_percent']} % are carried. Of as many broken ones {result['broken_carried']} are.",
        "",
        "| missed | times |",
        "|---|---|",
    ]
    for name, counts in result["missed"].items():
        lines.append(f"| {name} | {'; '.join(f'{sort} {count}' for sort, count in counts.items())} |")
    return "\n".join(lines)


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--variants", type=int, default=3, help="variants of each problem")
    options.add_argument("--figures", type=int, default=3, help="figures that students write down")
    options.add_argument("--only", default="", help="codes, parted by commas")
    options.add_argument("--bank", type=Path, help="another bank than the chapter's")
    options.add_argument("--json", action="store_true", help="one JSON document instead of text")
    options.add_argument("--markdown", type=Path, help="a file for the table")
    asked = options.parse_args()
    result = measure(asked.variants, asked.figures, filter(None, asked.only.split(",")), asked.bank)
    if asked.markdown:
        asked.markdown.write_text(table(result) + "\n", encoding="utf-8")
    print(json.dumps(result, indent=1) if asked.json else table(result))


if __name__ == "__main__":
    main()
