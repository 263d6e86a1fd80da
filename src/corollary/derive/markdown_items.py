"""Markdown as sections with a heading, a paragraph and a list, each with its line."""

from __future__ import annotations

import re
from collections.abc import Collection, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

HEADING = re.compile(r"(#{1,6})\s+(.*\S)\s*$")
BULLET = re.compile(r"(\s*)[-*+]\s+(.*\S)\s*$")
NUMBERED = re.compile(r"\d+[.)]\s+|[-–—*+]\s*(?=[a-z ]+:)")
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
KEY = re.compile(r"([a-z][a-z ]*[a-z]):(?:\s+(.*))?$", re.DOTALL)


class MarkdownError(ValueError):
    """A line of a text that cannot be read, and what to write there."""

    def __init__(self, line: int, sentence: str):
        self.line, self.sentence = line, sentence
        super().__init__(f"{line}: {sentence}")


@contextmanager
def at_line(line: int) -> Generator[None]:
    """Raises MarkdownError, with the line, for what is wrong inside."""
    try:
        yield
    except MarkdownError:
        raise
    except (ValueError, TypeError, OSError, SyntaxError) as error:
        raise MarkdownError(line, str(error)) from error


@dataclass(slots=True)
class ListItem:
    """An item of a list, with the items below it. `key` is the word before its colon, "" where there is none."""

    text: str
    line: int
    indent: int = 0
    items: list[ListItem] = field(default_factory=list["ListItem"])
    key: str = ""

    def values(self, key: str) -> list[ListItem]:
        """The items below it with this key."""
        return [each for each in self.items if each.key == key]


@dataclass(slots=True)
class Section:
    """A heading (level 0 and no title: what stands before the first), the paragraphs below it, and the items of its lists."""

    level: int
    title: str
    line: int
    paragraph: str = ""
    items: list[ListItem] = field(default_factory=list[ListItem])


def sections(text: str, keys: Collection[str] = ()) -> list[Section]:
    """The sections of a text, in order. Lines that go on are joined by blanks; comments are left out.

    With `keys`, raises MarkdownError for a line of a paragraph that is meant for a heading or an item: `##(a) v`, `1. law: …`, or
    `law: …` without a dash.
    """
    without = COMMENT.sub(lambda found: "\n" * found[0].count("\n"), text.lstrip("\ufeff"))
    found = [Section(0, "", 1)]
    path: list[ListItem] = []  # the item that the next line may go on with, and those above it
    gap = False
    for line, content in enumerate(without.splitlines(), 1):
        section = found[-1]
        if not content.strip():
            gap = True
        elif keys and content.strip() == "---":
            raise MarkdownError(
                line, "a solution has no front matter, and no rules between its sections; leave --- out"
            )
        elif heading := HEADING.match(content):
            found.append(Section(len(heading[1]), heading[2], line))
            path = []
        elif bullet := BULLET.match(content):
            indent = len(bullet[1].expandtabs(4))
            while path and path[-1].indent >= indent:
                path.pop()
            item = ListItem(bullet[2], line, indent)
            (path[-1].items if path else section.items).append(item)
            path.append(item)
        elif path and not (gap and content[0] not in " \t"):
            if content[0] not in " \t":
                _refuse_lost(content, line, keys)
            path[-1].text += f" {content.strip()}"
        else:
            _refuse_lost(content, line, keys)
            if keys and section.items:
                sentence = "words for the reader stand above the list of their section; indent what belongs to an item"
                raise MarkdownError(line, sentence)
            path = []
            section.paragraph = f"{section.paragraph} {content.strip()}".lstrip()
        gap = not content.strip()
    for section in found:
        for item in _all(section.items):
            if key := KEY.match(item.text):
                item.key, item.text = key[1], key[2] or ""
    return found


def _refuse_lost(content: str, line: int, keys: Collection[str]) -> None:
    if not keys:
        return
    text = content.strip()
    if text.startswith("#"):
        raise MarkdownError(
            line, f"write a heading with a blank behind its signs, such as ## {text.lstrip('#')}"
        )
    numbered = NUMBERED.match(text)
    key = KEY.match(text[numbered.end() :] if numbered else text)
    if (numbered and text[0].isdigit()) or (key and key[1] in keys):
        item = text[numbered.end() :] if numbered else text
        raise MarkdownError(line, f"begin an item of a list with a dash and a blank: - {item[:60]}")


def _all(items: list[ListItem]) -> Iterator[ListItem]:
    for item in items:
        yield item
        yield from _all(item.items)
