"""Faults planted in the words of real problems, and what is said of each: `python benchmarks/planted_words.py` writes `results/planted_words.md`.

The same faults are a test (`tests/content/test_planted_words.py`).
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from pathlib import Path

HOME = Path(__file__).parents[1]
RESULT = HOME / "benchmarks/results/planted_words.md"
HEAD = """\
# Planted words

`python benchmarks/planted_words.py`: each fault is one change in the words, the figure or a translation of a problem of this
repository. {found} of {all} found; by kind: {kinds}.

| kind | file | change | what is said |
|---|---|---|---|
"""


def main() -> None:
    sys.path.insert(0, str(HOME))
    from tests.content.planted_words import NOT_FOUND, WORDS, complaints_of

    rows, found, every = list[str](), Counter[str](), Counter[str]()
    for each in (*WORDS, *NOT_FOUND):
        with tempfile.TemporaryDirectory(prefix="corollary-words-") as folder:
            complaints = complaints_of(Path(folder), each.file, each.old, each.new)
        sentence = next((one for one in complaints if each.finds and each.finds in one), "")
        found[each.kind] += bool(sentence)
        every[each.kind] += 1
        change = f"`{_cell(each.old)}` → `{_cell(each.new)}`"
        rows.append(f"| {each.kind} | {each.file} | {change} | {_cell(sentence) or '**not found**'} |")
    kinds = ", ".join(f"{kind} {found[kind]} of {count}" for kind, count in every.items())
    head = HEAD.format(found=found.total(), all=every.total(), kinds=kinds)
    RESULT.write_text(head + "\n".join(rows) + "\n", encoding="utf-8")


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")


if __name__ == "__main__":
    main()
