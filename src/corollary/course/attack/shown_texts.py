"""Texts of attackers in what an instructor or a student opens: pages, tables, terminals; True where one would run."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from html.parser import HTMLParser

from corollary.course.attack.hostile_notebooks import MARK

ACTIVE = frozenset({"iframe", "frame", "object", "embed", "base", "form", "link", "meta", "applet", "portal"})
ADDRESSES = frozenset(
    {"href", "src", "action", "xlink:href", "formaction", "srcdoc", "data", "poster", "srcset"}
)
FORMULA = ("=", "+", "-", "@", "\t", "\r")
SIGNS = ("\x1b", "\x9b", "\x07", "\u202e", "\u2066")


class _Page(HTMLParser):
    """Collects what would run or be fetched, of what holds the attackers' mark."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.found: list[str] = []
        self._inside = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._inside = tag if tag in {"script", "style"} else ""
        for name, value in attrs:
            if MARK not in (value or ""):
                continue
            if name.startswith("on") or tag in ACTIVE or name == "style":
                self.found.append(f"runs <{tag} {name}>")
            elif name in ADDRESSES and not (value or "").startswith("#"):
                self.found.append(f"opens an address in <{tag} {name}>")

    def handle_endtag(self, tag: str) -> None:
        self._inside = ""

    def handle_data(self, data: str) -> None:
        if self._inside and MARK in data:
            self.found.append(f"runs what stands in <{self._inside}>")


def run_by_page(text: str) -> list[str]:
    """What a browser would do with texts of attackers in a page."""
    page = _Page()
    page.feed(text)
    page.close()
    return list(dict.fromkeys(page.found))


def run_by_spreadsheet(text: str) -> list[str]:
    """Cells with texts of attackers that a spreadsheet would calculate."""
    return list(dict.fromkeys(_calculated(text)))


def _calculated(text: str) -> Iterator[str]:
    for row in csv.reader(io.StringIO(text)):
        for cell in row:
            if MARK in cell and cell.startswith(FORMULA):
                yield f"is calculated: {cell[:20]!r}"


def run_by_terminal(text: str) -> list[str]:
    """Signs by which a terminal would do more than print."""
    return [f"sends {sign!r} to the terminal" for sign in SIGNS if sign in text]
