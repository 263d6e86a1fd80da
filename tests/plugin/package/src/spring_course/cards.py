"""Flash cards: each part of a set on a card, the question in front; a file of two columns, as card programs import it."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.notebook.worksheet import Worksheet
from corollary.render.exports import Target
from corollary.render.terminal_text import terminal_text


def _cards(worksheet: Worksheet, _worked_solutions: Mapping[str, str]) -> str:
    """One line a part: its name, a tabulator, what is asked."""
    return "".join(
        f"{prompt.name}\t{' '.join(terminal_text(prompt.text).split())}\n" for prompt in worksheet.prompts
    )


TARGET = Target(ending="tsv", worksheet=_cards)
