"""XML of somebody else's, read without entities, without the network, and within limits."""

from __future__ import annotations

import io
import re
from html import unescape
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError, iterparse

from corollary.audit.text_file import text_of
from corollary.problem.diagnostic import Diagnostic, Malformed

DEEPEST, MOST_ELEMENTS = 100, 2_000_000
DECLARED = re.compile(r"<!(?:DOCTYPE|ENTITY)", re.IGNORECASE)
TAG = re.compile(r"<[^>]*>")
RAISED = re.compile(r"<(?:\w+:)?sup\b[^>]*>\s*([-+\N{MINUS SIGN}]?\d+)\s*</(?:\w+:)?sup>")


def xml_of(path: Path) -> Element:
    """The root of a file. Raises Malformed with the line for what is no XML, declares entities, or is nested too deeply."""
    source = text_of(path)
    if declared := DECLARED.search(source):
        line = source.count("\n", 0, declared.start()) + 1
        raise Malformed(
            [Diagnostic(path, line, "declares a document type or entities, which is not read here")]
        )
    depth, count, root = 0, 0, None
    try:
        for event, element in iterparse(io.BytesIO(source.encode()), ("start", "end")):
            depth += 1 if event == "start" else -1
            count += 1
            root = element if root is None else root
            if depth > DEEPEST or count > MOST_ELEMENTS:
                raise Malformed([Diagnostic(path, 1, "has too many elements, or elements nested too deeply")])
    except LookupError as error:  # of its encoding, though it has been read as UTF-8
        raise Malformed([Diagnostic(path, 1, f"is no XML: {error}")]) from None
    except ParseError as error:
        raise Malformed([Diagnostic(path, error.position[0], f"is no XML: {error}")]) from None
    assert root is not None
    return root


def local(element: Element) -> str:
    """The name of an element without its namespace."""
    return element.tag.rpartition("}")[2]


def words_of(markup: str) -> str:
    """The words of a text in HTML; raised numbers are powers."""
    return " ".join(unescape(TAG.sub(" ", RAISED.sub(r"^\1", markup))).split())
