"""A package of QTI with the chapter's problems, every row of their answer tables as an attempt, and marks held against ours."""

from __future__ import annotations

import io
import zipfile
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from corollary.render.exports import target
from corollary.render.lms_item import ChoiceAsked, LmsItem, NumbersAsked


@dataclass(frozen=True)
class Attempted:
    """An item, its file in the package, and for each row what goes into which field."""

    item: LmsItem
    file: str
    parts: dict
    rows: list

    def responses(self) -> list[dict[str, str]]:
        return [
            {f"RESPONSE_{row.part.id}_{at}": text for at, text in enumerate(row.fields, 1)}
            for row in self.rows
        ]

    def is_choice(self, row) -> bool:
        return isinstance(self.parts[row.part.id], ChoiceAsked)


def package(items: Sequence[LmsItem], apart: bool = False) -> bytes:
    made = target("qti").items
    assert made is not None
    return made("chapter", items, apart).files["chapter-qti.zip"]


def attempts(items: Sequence[LmsItem], table: Callable, archive: bytes) -> list[Attempted]:
    """Those of items that have fields, or prose, and so are in the package."""
    there = set(zipfile.ZipFile(io.BytesIO(archive)).namelist())
    found = [
        Attempted(
            item,
            f"{item.exercise.problem.name}-1.xml",
            {
                each.prompt.part.id: each
                for each in item.parts
                if isinstance(each, NumbersAsked | ChoiceAsked)
            },
            table(item),
        )
        for item in items
    ]
    return [each for each in found if each.file in there]


def unpack(archive: bytes, folder: Path) -> None:
    with zipfile.ZipFile(io.BytesIO(archive)) as opened:
        opened.extractall(folder)


def compared(
    tried: Sequence[Attempted], marks: Sequence[Sequence[dict]], fingerprint: Callable
) -> tuple[dict, list]:
    """What is recorded of each item, and the rows that differ without a name."""
    items, nameless = {}, []
    for each, given in zip(tried, marks, strict=True):
        counted = Counter()
        code = each.item.exercise.problem.code
        for row, outcomes in zip(each.rows, given, strict=True):
            theirs = float(outcomes[f"SCORE_{row.part.id}"] or 0.0) / each.parts[row.part.id].prompt.out_of
            how = "equal" if abs(theirs - row.share) < 1e-4 else "comma" if row.sort == "comma" else ""
            counted[how or "different"] += 1
            if not how:
                nameless.append((code, row.part.id, row.sort, row.fields, row.share, theirs))
        if each.parts:
            items[code] = {"hash": fingerprint(each.item), "parts": len(each.parts), **counted}
    return items, nameless
