"""Mutation scores of the chapter and of the example banks by problem, and predictions held against real runs of `verify`.

    python benchmarks/mutation.py --markdown benchmarks/results/mutation.md
    python benchmarks/mutation.py --against-verify 120 --markdown benchmarks/results/mutation_against_verify.md

The second takes bends at random, half of those that are said to be noticed and half of the others, puts each into the derivation
in the place of its law, verifies the problem with it, and compares whether `verify` complains.
"""

from __future__ import annotations

import argparse
import random
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, fields, is_dataclass, replace
from multiprocessing import get_context
from pathlib import Path
from typing import Any, cast

from corollary.derive import load as loading
from corollary.derive.cache import solution_of
from corollary.grading.key import make_key
from corollary.laws.law import Law
from corollary.problem.bank import Bank, chapter_bank
from corollary.problem.problem import Problem
from corollary.problem.variant import chapter
from corollary.verify.checked import Checked, Tally
from corollary.verify.mutation import score as scoring
from corollary.verify.side_by_side import verify_changed, verify_each
from corollary.verify.verify import verify
from corollary.verify.walk import check_scenes, walk

ROOT = Path(__file__).parents[1]
VARIANTS = 20  # of a real run: what complains of none of so many complains of few
SEED = 12


def banks() -> list[tuple[str, Bank]]:
    found = sorted((ROOT / "examples" / "banks").glob("*/src/*/problems"))
    return [("chapter", chapter_bank()), *((each.parent.name, Bank(each.parent)) for each in found)]


@dataclass(frozen=True, slots=True)
class Prediction:
    """A bend, told by the place of its law and its own among the bends, and the check that is said to notice it ("" for none)."""

    bank: str
    code: str
    law: int
    bend: int
    by: str
    text: str


def predictions(name: str, bank: Bank, problem: Problem) -> list[Prediction]:
    solution = solution_of(bank, problem)
    loaded = loading.load(bank, problem)
    own, tally = make_key(solution, chapter(problem)), Tally()
    walked = walk(bank, solution, tally, VARIANTS)
    played = [(key, check_scenes(loaded, key, tally)) for key in walked.first[: scoring.DRAWS]]
    if tally.complaints:
        return []
    laws = [id(law) for law, _ in scoring._laws(loaded)]  # pyright: ignore[reportPrivateUsage]
    counts = Counter[int]()
    found: list[Prediction] = []
    for each in scoring._tried(loaded, solution, scoring._checks(loaded, solution, own, played)):  # pyright: ignore[reportPrivateUsage]
        law = laws.index(id(each.law))
        found.append(Prediction(name, problem.code, law, counts[law], each.by, each.bend.text))
        counts[law] += 1
    return [each for each in found if each.by not in ("same", "undecided")]


def bent(loaded: loading.Loaded, law: int, bend: int) -> loading.Loaded:
    """The derivation with one law bent wherever it stands."""
    ((own, _),) = [pair for place, pair in enumerate(scoring._laws(loaded)) if place == law]  # pyright: ignore[reportPrivateUsage]
    other = [each for each in scoring.bends(own) if scoring.written(each) is not None][bend].law
    branches = exchanged(loaded.branches, own, other)
    return replace(loaded, branches=branches, derivation=branches[0].derivation)


def exchanged(value: Any, own: Law, other: Law) -> Any:
    """The value with one law in the place of another, told by identity."""
    if value is own:
        return other
    if isinstance(value, tuple):
        before = cast("tuple[Any, ...]", value)
        found = tuple(exchanged(each, own, other) for each in before)
        return before if all(a is b for a, b in zip(found, before, strict=True)) else found
    if is_dataclass(value) and not isinstance(value, (type, Law)):
        changed = {
            each.name: new
            for each in fields(value)
            if (new := exchanged(getattr(value, each.name), own, other)) is not getattr(value, each.name)
        }
        return replace(value, **changed) if changed else value
    return value


def really(prediction: Prediction) -> tuple[Prediction, str]:
    """The first complaint of `verify` about the bent derivation; "" for none."""
    bank = dict(banks())[prediction.bank]
    problem, plain = bank[prediction.code], loading._loaded  # pyright: ignore[reportPrivateUsage]

    def bent_when_loaded(problem: Problem, path: Path) -> loading.Loaded:
        found = plain(problem, path)
        return bent(found, prediction.law, prediction.bend) if problem.code == prediction.code else found

    loading._loaded = bent_when_loaded  # pyright: ignore[reportPrivateUsage]
    try:
        complaints = verify(bank, problem, VARIANTS).complaints
    finally:
        loading._loaded = plain  # pyright: ignore[reportPrivateUsage]
    return prediction, complaints[0] if complaints else ""


def against_verify(count: int, jobs: int) -> Iterator[str]:
    every: list[Prediction] = []
    for name, bank in banks():
        for problem in bank:
            every += predictions(name, bank, problem)
    draw = random.Random(SEED)
    noticed = [each for each in every if each.by]
    missed = [each for each in every if not each.by]
    kinds = sorted({each.by for each in noticed})
    chosen: list[Prediction] = []
    for kind in kinds:  # of every check as many, for most bends are noticed by few of them
        own = [each for each in noticed if each.by == kind]
        chosen += draw.sample(own, min(len(own), max(1, count // 2 // len(kinds))))
    chosen += draw.sample(missed, min(len(missed), count - len(chosen)))
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        results = list(pool.map(really, chosen))
    yield "| said to be noticed by | bends | `verify` complains | agree |"
    yield "|---|---|---|---|"
    agree = 0
    for kind in [*kinds, ""]:
        own = [(each, said) for each, said in results if each.by == kind]
        if own:
            complained = sum(bool(said) for _, said in own)
            right = complained if kind else len(own) - complained
            agree += right
            yield f"| {kind or 'nothing'} | {len(own)} | {complained} | {right / len(own):.0%} |"
    yield f"| all | {len(results)} | {sum(bool(said) for _, said in results)} | {agree / len(results):.0%} |"
    yield ""
    for each, said in results:
        if bool(said) != bool(each.by):
            yield f"- {each.code}: `{each.text}`, said to be noticed by {each.by or 'nothing'}: {said or 'no complaint'}"


def scores() -> Iterator[str]:
    for name, bank in banks():
        todo = [(bank, problem) for problem in bank]
        with verify_changed(todo, 100, verify_each) as verified:
            found: list[Checked] = list(verified)
        total = [each.mutation for each in found if each.mutation is not None]
        bends, noticed = sum(each.bends for each in total), sum(each.noticed for each in total)
        share = f"{noticed / bends:.1%}" if bends else "-"
        yield f"## {name}: {noticed:,} of {bends:,} bends noticed ({share})"
        yield ""
        yield "| problem | bends | noticed | share | undecided | by |"
        yield "|---|---|---|---|---|---|"
        for each in found:
            one = each.mutation
            if one is None:
                yield f"| {each.code} | - | - | - | - | not verified |"
            elif one.bends or one.undecided:
                by = ", ".join(f"{check} {count}" for check, count in one.by.items())
                part = f"{one.noticed / one.bends:.0%}" if one.bends else "-"
                yield f"| {each.code} | {one.bends} | {one.noticed} | {part} | {one.undecided or ''} | {by} |"
        yield ""


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--against-verify", type=int, default=0, metavar="BENDS")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--markdown", type=Path)
    asked = parser.parse_args()
    if asked.against_verify:
        title = "Bends predicted, against real runs of verify"
        lines = list(against_verify(asked.against_verify, asked.jobs))
        command = f"python benchmarks/mutation.py --against-verify {asked.against_verify}"
    else:
        title, lines, command = "Mutation scores", list(scores()), "python benchmarks/mutation.py"
    text = "\n".join([f"# {title}", "", f"Made by `{command} --markdown {asked.markdown}`.", "", *lines, ""])
    print(text)
    if asked.markdown:
        asked.markdown.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
