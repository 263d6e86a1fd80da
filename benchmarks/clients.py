"""What learning management systems gave for the rows of the answer tables, when they were last asked, as a table.

    python benchmarks/clients.py [--markdown FILE]

The answers lie in tests/clients/recorded; the tests marked `client` ask again.
"""

from __future__ import annotations

import argparse
import json
from collections import Counter
from pathlib import Path

RECORDED = Path(__file__).parents[1] / "tests" / "clients" / "recorded"
OPENING = """# Marks given by real clients

What can be typed into each question (right, rounded to three figures, just inside and just outside of what is tolerated, each
misconception, each slip, far off, one component alone, with a decimal comma, blank; with units apart: each other unit, a wrong
one, none) was typed there, and the share of the points held against ours. A difference with a name is one that the export
announces. Made by `python benchmarks/clients.py --markdown FILE` from what `pytest tests/clients -m client` recorded.
"""


def table(recorded: dict) -> list[str]:
    counted: Counter[str] = Counter()
    for each in recorded["items"].values():
        counted.update({name: count for name, count in each.items() if name not in ("hash", "parts")})
    parts = sum(each["parts"] for each in recorded["items"].values())
    named = ", ".join(
        f"{name}: {count}" for name, count in sorted(counted.items()) if name not in ("equal", "different")
    )
    rows = sum(counted.values())
    return [
        f"| {recorded['client']} | {recorded['version']} | {len(recorded['items'])} | {parts} | {rows} | {counted['equal']} "
        f"| {named or '–'} | {counted['different']} |"
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--markdown", type=Path)
    chosen = parser.parse_args()
    lines = [
        OPENING,
        "| client | version | problems | parts | answers | equal | otherwise, by name | different |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for path in sorted(RECORDED.glob("*.json")):
        recorded = json.loads(path.read_text(encoding="utf-8"))
        lines += table(recorded) if "items" in recorded else []
    text = "\n".join(lines) + "\n"
    if chosen.markdown:
        chosen.markdown.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
