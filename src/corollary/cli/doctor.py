"""`corollary doctor`: whether this machine and this course are fit for work, and what to do where they are not."""

from __future__ import annotations

import sys
from dataclasses import asdict
from pathlib import Path

from corollary.cli.ending import FAILS, HOLDS, answer, refuse
from corollary.cli.left_out import course_around
from corollary.cli.terminal import bar, console, hanging
from corollary.course.health import findings

SIGNS = {"good": "ok", "weak": "note", "broken": "BROKEN"}
WIDTH = 100


def run(course: Path | None, attack: bool, as_json: bool) -> int:
    if attack:
        return _attacked(as_json)
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


def _attacked(as_json: bool) -> int:
    """What hostile hand-ins could do on this machine."""
    if sys.platform == "win32":
        refuse("notebooks are not run on Windows; attack the machine that grades, in WSL or in a container")
    from corollary.course.attack.attack import count, play

    with bar("attacking a throw-away course", count()) as progress:
        done = play(progress)
    families = dict.fromkeys(each.family for each in done.attacks)
    played = {family: [each for each in done.attacks if each.family == family] for family in families}
    if as_json:
        answer(
            {
                "ok": not done.succeeded,
                "played": len(done.attacks),
                "seconds": round(done.seconds, 1),
                "isolation": {"level": done.isolation.level, "line": done.isolation.line},
                "families": {
                    family: {"played": len(those), "withstood": sum(not each.harm for each in those)}
                    for family, those in played.items()
                },
                "succeeded": [asdict(each) for each in done.succeeded],
            }
        )
        return FAILS if done.succeeded else HOLDS
    from rich.table import Table

    table = Table("hostile hand-ins", "played", "withstood", title="What a student could do here")
    for family, those in played.items():
        table.add_row(family, str(len(those)), str(sum(not each.harm for each in those)))
    console().print(table)
    print(f"isolation level {done.isolation.level}: {done.isolation.line}")
    for each in done.succeeded:
        print(hanging("SUCCEEDED  ", f"{each.family}: {each.name}: {'; '.join(each.harm)}", WIDTH))
    if done.succeeded:
        print(
            f"\n{len(done.succeeded)} of {len(done.attacks)} succeeded: do not grade strangers' work here before that is mended"
        )
        return FAILS
    print(f"\nnothing: all {len(done.attacks)} were withstood, in {done.seconds:.0f} s")
    return HOLDS
