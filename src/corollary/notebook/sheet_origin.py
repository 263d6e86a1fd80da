"""The set and the student that a returned notebook names. Anybody can write that: it proves nothing."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import cast

from nbformat import NotebookNode

from corollary.notebook.locate import cells_by_id
from corollary.notebook.worksheet import Worksheet

LONGEST = 100
NUMBER = re.compile(r"\d+(?:[.,]\d+)*")
# The head of a statement and of a part: codes, titles and points, which are not of one student (`notebook.notebook` writes them).
HEAD = re.compile(r"\A\s*(?:---\s+##[^\n]*(?:\s+\*[^*\n]+\*[ \t\r]*(?=\n|\Z))?|####[^\n]*)")


@dataclass(frozen=True, slots=True)
class Origin:
    """The name of the set and the id of the student; "" where the notebook does not say, or says what cannot be one."""

    set_name: str
    student: str


def origin(nb: NotebookNode) -> Origin:
    """What the notebook's metadata say; an editor may have dropped them."""
    about: object = nb.get("metadata", {}).get("corollary")
    metadata = cast("Mapping[str, object]", about if isinstance(about, Mapping) else {})
    return Origin(_word(metadata.get("set")), _word(metadata.get("student")))


def is_of(sheet: Worksheet, nb: NotebookNode) -> bool:
    """Whether a notebook belongs to the set of this sheet: it says so; or it says nothing, and holds one of the sheet's cells or
    the name of one of its answers."""
    if name := origin(nb).set_name:
        return name == sheet.problem_set.name
    found, keys = cells_by_id(nb), {prompt.key for prompt in sheet.prompts}
    asked = {f"{key}{end}" for key in keys for end in ("", "_text", "_answer", "_plot")}
    if asked & found.keys():
        return True
    sources = "\n".join(str(cell.get("source", "")) for cell in nb.cells)
    names = keys | {prompt.name for prompt in sheet.prompts}
    return any(re.search(rf"\b{re.escape(name)}\b", sources) for name in names)


def other_numbers(theirs: str, ours: str) -> bool:
    """Whether two statements or questions give different numbers, however they are worded, in whatever language, and whatever
    they earn."""
    return _numbers(theirs) != _numbers(ours)


def _numbers(text: str) -> Counter[str]:
    asked = HEAD.sub("", text).replace("{,}", ",")  # a decimal comma in TeX
    return Counter(each.replace(",", ".") for each in NUMBER.findall(asked))


def _word(value: object) -> str:
    return value[:LONGEST] if isinstance(value, str) and value.isprintable() else ""
