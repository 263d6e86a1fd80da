"""Marking by hand in the terminal: one answer after the other, equal ones once."""

from __future__ import annotations

import getpass
from collections.abc import Callable, Sequence

from corollary.messages import visible
from corollary.records.manual import ManualMark
from corollary.records.near_misses import AnswerGroup, PartToMark
from corollary.render.wording import points, points_earned

Give = Callable[[str, Sequence[str], ManualMark], None]
HELP = "points, or r and the rubric's numbers (r13), then a comment if you like; empty: leave it; q: end"


def mark_in_terminal(parts: Sequence[PartToMark], give: Give) -> None:
    """Asks for each answer and gives at once what is answered; the end of input ends it, with a sentence."""
    if not parts:
        print("no answer waits for a person")
    given: list[str] = []

    def counted(part: str, students: Sequence[str], mark: ManualMark) -> None:
        give(part, students, mark)
        given.extend(students)

    try:
        _ask_all(parts, counted)
    except EOFError:
        count = "1 mark" if len(given) == 1 else f"{len(given)} marks"
        print(f"\nthe input ended here: {count} given and saved, and what is left still waits")


def _ask_all(parts: Sequence[PartToMark], give: Give) -> None:
    for part in parts:
        print(f"\n{part.problem} {part.part} {part.title} ({points_earned(part.out_of)})")
        for number, item in enumerate(part.rubric, 1):
            print(f"  {number} {visible(item)}")
        for place, group in enumerate(part.groups, 1):
            if not _ask(part, group, f"answer {place} of {len(part.groups)}", give):
                return


def read_mark(line: str, part: PartToMark) -> ManualMark | str:
    """What was typed: `1.5 Well argued`, `r12`. A sentence for what is none of it."""
    first, _, comment = line.strip().partition(" ")
    if first.startswith("r") and first[1:].isdigit():
        chosen = {int(each) for each in first[1:]}
        if wrong := [each for each in chosen if not 1 <= each <= len(part.rubric)]:
            return f"the rubric has no item {wrong[0]}"
        score = part.out_of * len(chosen) / len(part.rubric)
    else:
        try:
            score = float(first.replace(",", "."))
        except ValueError:
            return HELP
    if not 0 <= score <= part.out_of:
        return f"from 0 to {points(part.out_of)} points"
    return ManualMark(round(score, 2), None, comment.strip() or None, by=getpass.getuser())


def _ask(part: PartToMark, group: AnswerGroup, heading: str, give: Give) -> bool:
    """Whether to go on. Raises EOFError."""
    count = f", given by {len(group.students)} students" if len(group.students) > 1 else ""
    late = f", {group.late} late" if group.late else ""
    print(f"\n--- {heading}{count}{late}")
    if group.near_miss is not None:
        print(f"near miss of reading ({group.near_miss.kind}): it earned nothing; read otherwise it is right")
        for each in group.near_miss.answers:
            print(visible(f"  {each.typed} as {each.read}"))
    for cell in group.cells:
        print(visible(cell.verbatim))
        if cell.pictures:
            print(f"[{len(cell.pictures)} pictures; corollary mark without --terminal shows them]")
    while True:
        line = input(f"points of {points(part.out_of)}> ")
        if line.strip() == "q":
            return False
        if not line.strip():
            return True
        mark = read_mark(line, part)
        if isinstance(mark, ManualMark):
            give(part.key, group.students, mark)
            return True
        print(mark)
