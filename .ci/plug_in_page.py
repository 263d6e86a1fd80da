"""Fills docs/howto/add_an_answer_type.md between its comments: files of the package in tests/plugin, and what the classes hold.

`python .ci/plug_in_page.py` writes it, `--check` says whether it is up to date (a test asks).
"""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterator
from dataclasses import fields
from typing import Any, get_args

from reference_page import DOCS, table, written

from corollary.answers import answer, expected
from corollary.answers.question import Question

PACKAGE = DOCS.parent / "tests" / "plugin" / "package"
PAGE = "howto/add_an_answer_type.md"
REGION = re.compile(r"(<!-- (file|class) (\S+) -->\n).*?(<!-- end -->)", re.DOTALL)
FOR = {
    "Quantity": "numbers, and formulas for them",
    "RightOption": "choices and words",
    "Requirement": "`.example`",
    "Claim": "`.proof`",
    "FreeBody": "`.forces`",
}


def first_sentence(kind: type) -> str:
    text = " ".join((inspect.getdoc(kind) or "").split())
    return re.split(r"(?<=[.;]) ", text)[0].rstrip(".;") + "."


def names(kind: type) -> str:
    return ", ".join(f"`{each.name}`" for each in fields(kind) if not each.name.startswith("_"))


def answers() -> Iterator[str]:
    rows = ((f"`{kind.__name__}`", first_sentence(kind), names(kind)) for kind in get_args(answer.Answer))
    yield from table(("class", "is", "fields"), rows)


def expectations() -> Iterator[str]:
    rows = ((f"`{name}`", words, names(getattr(expected, name))) for name, words in FOR.items())
    yield from table(("class", "for", "fields"), rows)


def questions() -> Iterator[str]:
    yield names(Question) + ".\n"


TABLES: dict[str, Any] = {"Answer": answers, "Expected": expectations, "Question": questions}


def filled(found: re.Match[str]) -> str:
    opening, kind, name, end = found.groups()
    if kind == "file":
        language = "toml" if name.endswith(".toml") else "python"
        text = (PACKAGE / name).read_text(encoding="utf-8").rstrip()
        return f"{opening}\n```{language}\n{text}\n```\n\n{end}"
    return f"{opening}\n" + "\n".join(TABLES[name]()) + f"\n{end}"


def page() -> str:
    """The whole page."""
    return REGION.sub(filled, (DOCS / PAGE).read_text(encoding="utf-8"))


if __name__ == "__main__":
    sys.exit(written(PAGE, page(), sys.argv[1:]))
