"""Derivations judged: right ones written by hand and varied, ones with an error planted in a line, ones without a law.

python benchmarks/proofs.py [--each 6] [--json] [--write]

`tests/grading/derivations/CODE-PART.txt` holds the derivations, each under the name of its way.
"""

from __future__ import annotations

import argparse
import json
import random
import re
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from derivations import Written, varied, with_error, without_a_law

from corollary.answers.answer import Chain
from corollary.answers.proof.argument import standings
from corollary.answers.proof.judging import grounds_of
from corollary.answers.verdict import Mistaken, Right, Unmarked, Verdict, Wrong, word
from corollary.formula.ast import names
from corollary.formula.plain_text import text
from corollary.grading.expectations import expected_of
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge, read
from corollary.grading.key import Key, make_key
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.variant import chapter

ROOT = Path(__file__).resolve().parents[1]
CORPUS = ROOT / "tests" / "grading" / "derivations"
RESULTS = ROOT / "benchmarks" / "results" / "proofs.md"
SEED = 11


@dataclass(slots=True)
class Tally:
    """Verdicts by sort of derivation; what went otherwise than it should."""

    counts: dict[str, Counter[str]] = field(default_factory=dict[str, Counter[str]])
    by_part: dict[str, Counter[str]] = field(default_factory=dict[str, Counter[str]])
    failures: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    slowest: float = 0.0

    def add(
        self, sort: str, outcome: str, wanted: str, written: Written, lines: Sequence[str], verdict: Verdict
    ) -> None:
        self.counts.setdefault(sort, Counter())[outcome] += 1
        self.by_part.setdefault(f"{written.code} {written.part}", Counter())[f"{sort}: {outcome}"] += 1
        if outcome != wanted:
            self.failures.append(
                {
                    "code": written.code,
                    "way": written.way,
                    "sort": sort,
                    "outcome": outcome,
                    "lines": list(lines),
                    "verdict": reason(verdict),
                }
            )


def reason(verdict: Verdict) -> str:
    match verdict:
        case Mistaken(mistake):
            return mistake
        case Right(note):
            return note
        case Wrong(why) | Unmarked(why):
            return why
        case _:
            return word(verdict)


class Judge:
    """The chapter's three claims, and the verdict on a derivation of one, with its time."""

    def __init__(self) -> None:
        self.keys: dict[str, Key] = {}
        self.seconds = 0.0

    def key(self, code: str) -> Key:
        if code not in self.keys:
            place, problem = home(None, code)
            self.keys[code] = make_key(Solutions(place).of(problem), chapter(problem))
        return self.keys[code]

    def verdict(self, code: str, part: str, lines: Sequence[str]) -> Verdict:
        start = time.perf_counter()
        ((found,), _) = judge(self.key(code), {part: from_json(list(lines))})[part]
        self.seconds = max(self.seconds, time.perf_counter() - start)
        return found

    def corpus(self) -> Iterator[Written]:
        for path in sorted(CORPUS.glob("*.txt")):
            code, part = path.stem.rsplit("-", 1)
            for block in path.read_text(encoding="utf-8").strip().split("\n\n"):
                way, *lines = block.splitlines()
                yield self.written(code, part, way.strip("# "), lines)

    def written(self, code: str, part: str, way: str, lines: Sequence[str]) -> Written:
        asked = self.key(code).variant.problem.part(part)
        expected = expected_of(self.key(code), asked)
        answer = read(asked, from_json(list(lines)), expected, self.key(code).variant)
        assert isinstance(answer, Chain), (code, way, answer)
        assert expected.claim is not None
        grounds = grounds_of(expected.claim, expected.claim.points(), expected.question)
        steps = answer.steps
        own = {each.defines for each in steps}
        laws = [each for each in steps if each.defines or not own & names(each.relation)]
        movable = frozenset(
            text(each.relation)
            for each in laws
            if each.defines or standings((each,), grounds)[0].kind == "law"  # by itself, with nothing put in
        )
        return Written(code, part, way, tuple(lines), steps, standings(steps, grounds), movable)


def measure(each: int, share: int = 1, note: Callable[[str], None] = lambda way: None) -> Tally:
    """Each derivation of the corpus, or one in `share`, with `each` variations of it, errors in it and laws missing from it."""
    judging, tally = Judge(), Tally()
    for written in list(judging.corpus())[::share]:
        note(f"{written.code}: {written.way}")
        dice = random.Random(f"{SEED} {written.code} {written.way}")
        for lines in (written.lines, *(varied(written, dice) for _again in range(each))):
            verdict = judging.verdict(written.code, written.part, lines)
            outcome = {"right": "accepted", "unmarked": "to a person"}.get(word(verdict), "refused")
            tally.add(
                "as written" if lines is written.lines else "varied",
                outcome,
                "accepted",
                written,
                lines,
                verdict,
            )
        for _again in range(each):
            if (planted := with_error(written, dice)) is not None:
                lines, line = planted
                verdict = judging.verdict(written.code, written.part, lines)
                tally.add("error planted", _located(verdict, line), "at its line", written, lines, verdict)
        for _again in range(each):
            if (left := without_a_law(written, dice)) is not None:
                verdict = judging.verdict(written.code, written.part, left)
                outcome = {"right": "accepted", "unmarked": "to a person"}.get(word(verdict), "wrong")
                tally.add("without a law", outcome, "to a person", written, left, verdict)
    tally.slowest = judging.seconds
    return tally


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("--each", type=int, default=6, help="variations and errors of each derivation")
    options.add_argument("--json", action="store_true", help="one JSON document")
    options.add_argument("--write", action="store_true", help="writes benchmarks/results/proofs.md")
    asked = options.parse_args()
    tally = measure(asked.each, note=lambda way: print(way, file=sys.stderr))
    if asked.json:
        print(json.dumps({"counts": tally.counts, "by_part": tally.by_part, "failures": tally.failures}))
        return
    if asked.write:
        RESULTS.write_text(report(tally, asked.each), encoding="utf-8")
    print(report(tally, asked.each))


def report(tally: Tally, each: int) -> str:
    """The shares as a table in Markdown, and every derivation that was not judged as it should be."""
    lines = [
        "# Derivations judged",
        "",
        f"`python benchmarks/proofs.py --each {each} --write`: the derivations of `tests/grading/derivations`, varied by a fixed seed; "
        "*varied* leaves lines out, moves laws forward, renames, turns sides round and adds reasons; *without a law* has only the lines "
        "that hold in a world where one law does not, and the claim.",
        "",
        "| derivations | number | outcome |",
        "|---|---|---|",
    ]
    for sort, counts in tally.counts.items():
        outcomes = ", ".join(
            f"{outcome} {count} ({count / counts.total():.1%})" for outcome, count in counts.most_common()
        )
        lines.append(f"| {sort} | {counts.total()} | {outcomes} |")
    lines += ["", "By part:", ""]
    lines += [
        f"- {part}: " + ", ".join(f"{what} {count}" for what, count in sorted(counts.items()))
        for part, counts in tally.by_part.items()
    ]
    lines += ["", "Not as it should be:", ""]
    for way, count in Counter(
        (each["code"], each["way"], each["sort"], each["outcome"]) for each in tally.failures
    ).items():
        lines.append(f"- {count} × {', '.join(way)}")
    return "\n".join(lines) + "\n"


def _located(verdict: Verdict, line: int) -> str:
    if isinstance(verdict, Right):
        return "accepted"
    if isinstance(verdict, Unmarked):
        return "to a person"
    return "at its line" if str(line) in re.findall(r"[Ll]ine (\d+)", reason(verdict)) else "elsewhere"


if __name__ == "__main__":
    main()
