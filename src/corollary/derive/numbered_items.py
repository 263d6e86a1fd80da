"""Items of a solution in text about a list with an entry for each whole number of a range."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import sympy

from corollary.derive.formula_text import LetterTable
from corollary.derive.item_clauses import name_of_mistake
from corollary.derive.markdown_items import ListItem, MarkdownError, Section
from corollary.derive.statements import Each, Exchange, Mistake
from corollary.laws.law import known_by_name

RANGE = re.compile(r"`(?P<letter>[A-Za-z]\w*)` from `(?P<low>[^`]+)` to `(?P<high>[^`]+)`[.,]?$")
SUCH_AS = "`m` from `1` to `floor(d/lam)`"


def numbers_letter(item: ListItem, table: LetterTable) -> tuple[str, sympy.Symbol]:
    """The letter of a range: a whole number, and of which sign where the range begins at a number. Raises ValueError."""
    found = RANGE.match(item.text.strip())
    if not found:
        raise ValueError(f"write the whole numbers that there is an entry for as in each: {SUCH_AS}")
    letter, low = found["letter"], found["low"].strip()
    if letter in table.meanings:
        raise ValueError(f"{letter} means something already; call the whole number by another letter")
    sign = (
        {"positive": True} if re.fullmatch(r"[1-9]\d*", low) else {"nonnegative": True} if low == "0" else {}
    )
    symbol = sympy.Symbol(letter, integer=True, **sign)
    known_by_name(letter, symbol)
    return letter, symbol


def numbers_of(section: Section, table: LetterTable) -> Each | None:
    """The range that a section states; None where it states none. Raises MarkdownError."""
    items = [item for item in section.items if item.key == "each"]
    if len(items) > 1:
        raise MarkdownError(items[1].line, "each: stands here for the second time; a list has one range")
    try:
        return _range(items[0].text, table) if items else None
    except (ValueError, TypeError) as error:
        raise MarkdownError(items[0].line, str(error)) from error


def mistake_in_list(
    item: ListItem, each: Each, table: LetterTable, read: Callable[[ListItem], Mistake[Exchange]]
) -> Mistake[Exchange]:
    """A mistake in a list: in the law, in the numbers, or in both. `read` reads one in the law. Raises MarkdownError."""
    try:
        stated, below = RANGE.search(item.text.strip()), item.values("each")
        own = _range(stated[0] if stated else below[0].text, table) if stated or below else None
        if own is not None and own.letter != each.letter:
            raise ValueError(f"the whole numbers of this step are called {each.letter}, here, too")
        text = RANGE.sub("", item.text.strip()).strip().removesuffix("each").strip().removesuffix(",")
        rest = replace(item, text=text, items=[one for one in item.items if one.key != "each"])
        if own is not None and "`" not in text and not [one for one in rest.items if one.key != "named"]:
            if not text:
                raise ValueError("say what the student reads who made this mistake, before the numbers")
            return Mistake(text, Exchange((), (), None, own), item.line, name_of_mistake(item))
    except (ValueError, TypeError) as error:
        raise MarkdownError(item.line, str(error)) from error
    found = read(rest)
    return replace(found, rule=replace(found.rule, each=own))


def _range(text: str, table: LetterTable) -> Each:
    found = RANGE.search(text.strip())
    if not found:
        raise ValueError(f"write whole numbers as in {SUCH_AS}")
    low, high = table.expression(found["low"]), table.expression(found["high"])
    return Each(table.symbol(found["letter"]), low, high)
