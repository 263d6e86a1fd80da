"""Composed scenes by the dozen against references found another way: what became of each family, and how far stated errors hold.

    python benchmarks/scenes_composed.py [--each 7] [--seed 1] [--tolerance 1e-10] [--family thrown_steeply]

right: the truth lies within the stated error, which is below 1e-6 of the value's size; honest: within a larger one; refused: named;
wrong: outside. A run with any wrong ends with status 1.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Sequence
from pathlib import Path
from random import Random

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent.parent))

from benchmarks.composed import exact, exact_planes, extremes, fields, lines, planes
from benchmarks.composed.case import Case, Verdict, drawn, judged

FAMILIES = (
    *lines.FAMILIES,
    *planes.FAMILIES,
    *extremes.FAMILIES,
    *fields.FAMILIES,
    *exact.FAMILIES,
    *exact_planes.FAMILIES,
)


def cases(each: int, seed: int, families: Sequence[Callable[[Random], Case]] = FAMILIES) -> list[Case]:
    """So many scenes of every family."""
    return list(drawn(families, each, seed))


def table(verdicts: list[tuple[Verdict, float]]) -> list[str]:
    """One line a family: outcomes, the worst true error in units of the stated one, the largest stated one, the longest time."""
    families: dict[str, list[tuple[Verdict, float]]] = defaultdict(list)
    for verdict, seconds in verdicts:
        families[verdict.case.family].append((verdict, seconds))
    rows = [
        "| family | right | honest | refused | wrong | worst true/stated | largest stated error | slowest, s |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for family, found in families.items():
        counts = Counter(verdict.outcome for verdict, _ in found)
        ratio, largest = max(v.ratio for v, _ in found), max(v.relative for v, _ in found)
        outcomes = " | ".join(str(counts[o]) for o in ("right", "honest", "refused", "wrong"))
        rows.append(
            f"| {family} | {outcomes} | {ratio:.2g} | {largest:.0e} | {max(s for _, s in found):.2f} |"
        )
    return rows


def main() -> int:
    """Play all, print the table and whatever was not right; status 1 if anything was wrong."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--each", type=int, default=7)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tolerance", type=float, default=1e-10)
    parser.add_argument("--family", help="this one of them alone")
    asked = parser.parse_args()
    families = [each for each in FAMILIES if asked.family in (None, each.__name__)]
    if not families:
        parser.error(f"there is no family {asked.family}.")
    verdicts: list[tuple[Verdict, float]] = []
    for case in cases(asked.each, asked.seed, families):
        begin = time.process_time()
        verdicts.append((judged(case, asked.tolerance), time.process_time() - begin))
    print("\n".join(table(verdicts)))
    for verdict, _ in verdicts:
        if verdict.outcome in ("refused", "wrong"):
            print(f"{verdict.case.family}: {verdict.outcome}: {verdict.why} ({verdict.ratio:.3g})")
    counts = Counter(verdict.outcome for verdict, _ in verdicts)
    inside = sum(v.ratio <= 1.0 for v, _ in verdicts) / len(verdicts)
    print(f"{len(verdicts)} scenes: {dict(counts)}; inside the stated error: {100 * inside:.2f} %")
    return 1 if counts["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
