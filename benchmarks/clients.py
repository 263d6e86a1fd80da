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
MARKS = """
## Files of marks

A class of nine has a term; our marks are written in every way that there is, and given to the LMS's own importer over what stood
in its gradebook. What stood there then, a mark or none for each student, is what `tests/clients/test_moodle_grades.py` and
`test_canvas_grades.py` say that we mean; they hold the records to it, and what the commands write to what the importer was given.
Moodle refuses a file whole in which a mark is more than it allows.

| client | version | ways | students | marks as we mean them, or none | refused |
|---|---|---|---|---|---|"""


def marks_row(recorded: dict) -> str:
    """Of each way of writing them what stood in the gradebook afterwards."""
    cases = recorded["cases"].values()
    marks, refused = sum(len(each["marks"]) for each in cases), sum("refused" in each for each in cases)
    return f"| {recorded['client']} | {recorded['version']} | {len(cases)} | {len(recorded['marks'])} | {marks} | {refused or '–'} |"


def items_row(recorded: dict) -> str:
    """Of the answers to each part what the client gave."""
    counted: Counter[str] = Counter()
    for each in recorded["items"].values():
        counted.update({name: count for name, count in each.items() if name not in ("hash", "parts")})
    parts = sum(each["parts"] for each in recorded["items"].values())
    named = ", ".join(
        f"{name}: {count}" for name, count in sorted(counted.items()) if name not in ("equal", "different")
    )
    rows = sum(counted.values())
    return (
        f"| {recorded['client']} | {recorded['version']} | {len(recorded['items'])} | {parts} | {rows} | {counted['equal']} "
        f"| {named or '–'} | {counted['different']} |"
    )


def tables() -> str:
    """All that is recorded, as Markdown."""
    every = [json.loads(path.read_text(encoding="utf-8")) for path in sorted(RECORDED.glob("*.json"))]
    lines = [
        OPENING,
        "| client | version | problems | parts | answers | equal | otherwise, by name | different |",
        "|---|---|---|---|---|---|---|---|",
        *(items_row(recorded) for recorded in every if "items" in recorded),
        MARKS,
        *(marks_row(recorded) for recorded in every if "cases" in recorded),
    ]
    return "\n".join(lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--markdown", type=Path)
    chosen = parser.parse_args()
    text = tables()
    if chosen.markdown:
        chosen.markdown.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
