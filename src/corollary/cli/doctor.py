"""`corollary doctor`: whether this machine and this course are fit for work, and what to do where they are not."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

from corollary.cli.ending import FAILS, HOLDS, answer
from corollary.cli.left_out import course_around
from corollary.cli.terminal import hanging
from corollary.course.health import findings

SIGNS = {"good": "ok", "weak": "note", "broken": "BROKEN"}
WIDTH = 100


def run(course: Path | None, as_json: bool) -> int:
    found = list(findings(course or course_around()))
    broken = [each for each in found if each.state == "broken"]
    if as_json:
        answer({"ok": not broken, "findings": [asdict(each) for each in found]})
        return FAILS if broken else HOLDS
    room = max(len(each.name) for each in found)
    for each in found:
        lines = [each.sentence, *([f"do: {each.remedy}"] if each.remedy else [])]
        indent = " " * (8 + room + 2)
        for number, line in enumerate(lines):
            head = f"{SIGNS[each.state]:8}{each.name:{room}}  " if number == 0 else indent
            print(hanging(head, line, WIDTH))
    print(f"\n{len(broken)} of {len(found)} broken" if broken else f"\nall {len(found)} are fine")
    return FAILS if broken else HOLDS
