"""Tags and texts of HTML in one pass, as a browser takes them apart: what is not ended goes to the end and is read once."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from html import unescape
from typing import Literal

NAME = re.compile(r"/?[A-Za-z][^\s/>]*")
BETWEEN = re.compile(r"[\s/]*")
ATTRIBUTE = re.compile(r"=?[^\s/>=]*")
EQUALS = re.compile(r"\s*=\s*")
UNQUOTED = re.compile(r"[^\s>]*")
OF_TEXT = {name: re.compile(rf"(?i)</{name}(?=[\s/>])") for name in ("script", "style", "textarea", "title")}
"""Elements in which nothing is a tag but their own end."""


@dataclass(frozen=True, slots=True)
class HtmlPiece:
    """`content` is the name of an element, in small letters, or a text."""

    kind: Literal["start", "end", "text"]
    content: str
    attributes: Mapping[str, str] = field(default_factory=dict[str, str])


def html_pieces(source: str) -> Iterator[HtmlPiece]:
    """The tags and the texts of a page, without comments and declarations."""
    at, begun = 0, 0  # where to look for a tag, and where the text before it begins
    while (opened := source.find("<", at)) >= 0:
        name = NAME.match(source, opened + 1)
        if name is None and source[opened + 1 : opened + 2] not in {"!", "?", "/"}:
            at = opened + 1  # a sign, as in `a < b`
            continue
        if begun < opened:
            yield HtmlPiece("text", unescape(source[begun:opened]))
        if name is None:
            comment = source.startswith("<!--", opened)
            ended = source.find("-->" if comment else ">", opened + 2)
            if ended < 0:
                return
            at = begun = ended + (3 if comment else 1)
            continue
        attributes, at = _attributes(source, name.end())
        if at < 0:
            return
        begun, tag = at, name[0].lower()
        if tag.startswith("/"):
            yield HtmlPiece("end", tag[1:])
            continue
        yield HtmlPiece("start", tag, attributes)
        if tag in OF_TEXT:
            ends = OF_TEXT[tag].search(source, at)
            if ends is None:
                return
            at = begun = ends.start()
    if begun < len(source):
        yield HtmlPiece("text", unescape(source[begun:]))


def _attributes(source: str, at: int) -> tuple[dict[str, str], int]:
    """The attributes of a tag, the first of each name, and where it has ended; -1 where it does not."""
    found: dict[str, str] = {}
    while True:
        at = _end(BETWEEN, source, at)
        if at >= len(source):
            return found, -1
        if source[at] == ">":
            return found, at + 1
        end = _end(ATTRIBUTE, source, at)
        name, value, at = source[at:end].lower(), "", end
        if (equals := EQUALS.match(source, at)) is not None:
            at = equals.end()
            quote = source[at : at + 1]
            if quote in {'"', "'"}:
                end = source.find(quote, at + 1)
                if end < 0:
                    return found, -1
                value, at = source[at + 1 : end], end + 1
            else:
                end = _end(UNQUOTED, source, at)
                value, at = source[at:end], end
        found.setdefault(name, unescape(value))


def _end(pattern: re.Pattern[str], source: str, at: int) -> int:
    """Where a pattern that may be empty has ended."""
    found = pattern.match(source, at)
    return found.end() if found is not None else at
