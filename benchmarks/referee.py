"""Claims called proven or refuted, against enumeration of their grids by other code; writes benchmarks/results/referee.md.

    python benchmarks/referee.py [--claims 6000] [--laws 4000]

The claims, the grids and the code that enumerates them are those of tests/verify/referee.py, of which `make test` has fewer.
"""

from __future__ import annotations

import argparse
import importlib.util
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "benchmarks" / "results" / "referee.md"
FIRST = 10_000  # seeds that `make test` does not have


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--claims", type=int, default=6000)
    parser.add_argument("--laws", type=int, default=4000)
    asked = parser.parse_args()
    referee, begin = _referee(), time.process_time()
    kinds = (("a clause", referee.claim_judged, asked.claims), ("one root", referee.root_judged, asked.laws))
    outcomes, faults = dict[str, Counter[str]](), list[str]()
    with tempfile.TemporaryDirectory() as folder:
        for name, judged, count in kinds:
            outcomes[name] = Counter[str]()
            for seed in range(FIRST, FIRST + count):
                outcome, fault = judged(Random(seed), Path(folder))
                outcomes[name][outcome] += 1
                faults += [f"{name}, seed {seed}: {fault}"] if fault else []
    RESULTS.write_text(
        "\n".join(lines(outcomes, faults, asked, time.process_time() - begin)) + "\n", encoding="utf-8"
    )
    print(RESULTS.read_text(encoding="utf-8"))
    return 1 if faults else 0


def lines(
    outcomes: dict[str, Counter[str]], faults: list[str], asked: argparse.Namespace, seconds: float
) -> Iterator[str]:
    every = sum(outcomes.values(), Counter[str]())
    proven, refuted = (
        sum(count for outcome, count in every.items() if outcome.startswith(which))
        for which in (
            ("proven", "partial: algebra", "partial: subdivision", "partial: enumeration", "partial: z3"),
            "counter-example",
        )
    )
    yield "# Claims against enumeration"
    yield ""
    yield (
        f"`python benchmarks/referee.py --claims {asked.claims} --laws {asked.laws}` ({seconds:.0f} s of one processor): random claims and "
        "laws on random small grids, with conditions, zero and negative numbers, factors that cancel, roots, powers, logarithms, sines. "
        "*partial* is a clause that must hold wherever it has a value, as of other roots."
    )
    yield ""
    yield f"**{proven} proven, {refuted} refuted with numbers; {len(faults)} contradicted.**"
    yield ""
    yield "| claim | outcome | number |"
    yield "|---|---|---:|"
    for name, counts in outcomes.items():
        for outcome, count in sorted(counts.items()):
            yield f"| {name} | {outcome} | {count} |"
    if faults:
        yield ""
        yield from (f"- {each}" for each in faults)


def _referee() -> Any:
    spec = importlib.util.spec_from_file_location("referee", ROOT / "tests" / "verify" / "referee.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["referee"] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


if __name__ == "__main__":
    sys.exit(main())
