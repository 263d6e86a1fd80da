"""Faults planted in problems that hold, and the check that finds each: `python benchmarks/planted_faults.py` writes `results/planted_faults.md`.

The same faults are a test (`tests/content/test_planted_faults.py`); here what each check says is written down.
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from pathlib import Path

HOME = Path(__file__).parents[1]
RESULT = HOME / "benchmarks/results/planted_faults.md"
HEAD = """\
# Planted faults

`python benchmarks/planted_faults.py`: each fault is one change in one of {bases} small problems that hold. It counts as found
when the check named for it says so, whatever else complains.

{found} of {all} found, by: {checks}.

| fault | problem | change | check | what it says |
|---|---|---|---|---|
"""


def main() -> None:
    sys.path.insert(0, str(HOME))
    from tests.content.planted_faults import BASES, PLANTED, evidence

    rows, found = list[str](), Counter[str]()
    for each in PLANTED:
        with tempfile.TemporaryDirectory(prefix="corollary-planted-") as folder:
            said = evidence(Path(folder), each)
        found[each.check] += bool(said)
        change = f"`{_cell(each.old)}` → `{_cell(each.new) or ' '}`"
        rows.append(
            f"| {each.name} | {each.base} | {change} | {each.check} | {_cell(said) or '**not found**'} |"
        )
        print(rows[-1], flush=True)
    checks = ", ".join(f"{check} {count}" for check, count in found.most_common())
    head = HEAD.format(bases=len(BASES), found=found.total(), all=len(PLANTED), checks=checks)
    RESULT.write_text(head + "\n".join(rows) + "\n", encoding="utf-8")


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")


if __name__ == "__main__":
    main()
