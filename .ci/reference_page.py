"""A page of the documentation that is made from the code: written anew, or held against what stands there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

DOCS = Path(__file__).parents[1] / "docs"


def written(name: str, text: str, words: list[str]) -> int:
    """Writes the page of this name; with `--check` among the words, says (1) where it is not up to date."""
    page = DOCS / name
    if "--check" in words:
        return int(page.read_text(encoding="utf-8") != text)
    page.write_text(text, encoding="utf-8")
    return 0


def table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """A table of Markdown, and a blank line."""
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    for row in rows:
        yield "| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in row) + " |"
    yield ""
