"""The text of a file of somebody else's, or its XML: read within limits, and only where it is a regular file."""

from __future__ import annotations

import os
import re
import stat
from html import unescape
from pathlib import Path
from typing import final
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

from defusedxml.common import DTDForbidden, EntitiesForbidden, ExternalReferenceForbidden
from defusedxml.ElementTree import DefusedXMLParser

from corollary.problem.diagnostic import Diagnostic, Malformed

LARGEST_FILE = 20_000_000  # bytes: a bank of some thousand questions
LARGEST_PROGRAM = 1_000_000  # bytes: one question; the longest of a library of 2,467 has 24 kB
WITHOUT_WAITING = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)
KINDS = (
    (stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISSOCK, "a socket"),
    (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"),
)  # fmt: skip


def text_of(path: Path, most: int = LARGEST_FILE) -> str:
    """The text of a file. Raises Malformed where it is no regular file, cannot be read, is no text, or is larger than so many bytes."""
    try:
        content = _content(path, most)
    except OSError as error:
        raise _malformed(path, f"cannot be read: {error.strerror}") from None
    if len(content) > most:
        raise _malformed(path, f"is larger than {most // 1_000_000} MB; divide it")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise _malformed(path, "is not text in UTF-8; save it as UTF-8") from None


def _content(path: Path, most: int) -> bytes:
    """At most one byte more than allowed, whatever the size is said to be. Raises OSError, and Malformed for what is no file."""
    _refuse_other(path, path.stat().st_mode)  # before it is opened: to open a device may do something
    with os.fdopen(os.open(path, os.O_RDONLY | WITHOUT_WAITING), "rb", buffering=0) as file:
        _refuse_other(path, os.fstat(file.fileno()).st_mode)
        pieces, left = list[bytes](), most + 1
        while left and (piece := file.read(left)):
            pieces.append(piece)
            left -= len(piece)
    return b"".join(pieces)


def _refuse_other(path: Path, mode: int) -> None:
    if not stat.S_ISREG(mode):
        kind = next((name for holds, name in KINDS if holds(mode)), "no file")
        raise _malformed(path, f"is {kind}; name a file")


def _malformed(path: Path, sentence: str) -> Malformed:
    return Malformed([Diagnostic(path, 1, sentence)])


DEEPEST, MOST_ELEMENTS = 100, 500_000
TAG = re.compile(r"<[^<>]*>")
RAISED = re.compile(r"<(?:\w+:)?sup\b[^<>]*>\s*([-+\N{MINUS SIGN}]?\d+)\s*</(?:\w+:)?sup>")


class TooManyElements(ValueError):
    """More elements than a bank has, or nested more deeply."""


@final
class BoundedTree(TreeBuilder):
    """A tree of as many elements as a bank may have."""

    def __init__(self) -> None:
        super().__init__()
        self.depth = self.count = 0

    def start(self, tag: str, attrs: dict[str, str], /) -> Element:
        self.depth, self.count = self.depth + 1, self.count + 1
        if self.depth > DEEPEST or self.count > MOST_ELEMENTS:
            raise TooManyElements
        return super().start(tag, attrs)

    def end(self, tag: str, /) -> Element:
        self.depth -= 1
        return super().end(tag)


def xml_of(path: Path) -> Element:
    """The root of a file. Raises Malformed with the line for what is no XML, declares entities, or is nested too deeply."""
    source = text_of(path)
    # What the declaration says of the encoding does not count: the text has been read as UTF-8.
    parser = DefusedXMLParser(target=BoundedTree(), encoding="utf-8", forbid_dtd=True)
    try:
        parser.feed(source.encode())
        return parser.close()
    except (DTDForbidden, EntitiesForbidden, ExternalReferenceForbidden):
        why, line = (
            "declares a document type or entities, which is not read here",
            parser.parser.CurrentLineNumber,
        )
    except TooManyElements:
        why, line = "has too many elements, or elements nested too deeply", parser.parser.CurrentLineNumber
    except ParseError as error:
        why, line = f"is not XML: {error}", error.position[0]
    raise Malformed([Diagnostic(path, line, why)])


def local(element: Element) -> str:
    """The name of an element without its namespace."""
    return element.tag.rpartition("}")[2]


def words_of(markup: str) -> str:
    """The words of a text in HTML; raised numbers are powers."""
    return " ".join(unescape(TAG.sub(" ", RAISED.sub(r"^\1", markup))).split())
