"""Rows as the text of a CSV file that a spreadsheet may open: no cell of it is taken for a formula."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Sequence

# What Excel, LibreOffice and Google's tables calculate; a number with a sign, and a dash, are none.
FORMULA = re.compile(r"\s*[=@]|[\t\r]|\s*[+-](?!$|\d+(?:[.,]\d+)?$)")


def table_text(rows: Iterable[Sequence[str]]) -> str:
    """The text of a file. A name such as `=HYPERLINK(…)` gets an apostrophe in front, by which spreadsheets take it as text."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerows([_harmless(cell) for cell in row] for row in rows)
    return text.getvalue()


def _harmless(cell: str) -> str:
    return f"'{cell}" if FORMULA.match(cell) else cell
