"""XML of somebody else's, read without document types, entities and the network, and within limits."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path
from typing import final
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

from defusedxml.common import DTDForbidden, EntitiesForbidden, ExternalReferenceForbidden
from defusedxml.ElementTree import DefusedXMLParser

from corollary.audit.text_file import text_of
from corollary.problem.diagnostic import Diagnostic, Malformed

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
        why, line = f"is no XML: {error}", error.position[0]
    raise Malformed([Diagnostic(path, line, why)])


def local(element: Element) -> str:
    """The name of an element without its namespace."""
    return element.tag.rpartition("}")[2]


def words_of(markup: str) -> str:
    """The words of a text in HTML; raised numbers are powers."""
    return " ".join(unescape(TAG.sub(" ", RAISED.sub(r"^\1", markup))).split())
