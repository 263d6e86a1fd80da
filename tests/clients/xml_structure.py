"""What an XML schema looks at in a document: which elements stand in which, with which attributes, and in which order."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from xml.etree import ElementTree as Xml

IN_ORDER = frozenset(
    {"assessmentItem", "responseDeclaration", "outcomeDeclaration", "responseProcessing", "responseCondition", "responseIf"}
    | {"responseElseIf", "and", "gte", "lte", "match", "product", "subtract", "setOutcomeValue", "choiceInteraction"}
)  # fmt: skip
"""Elements whose children the schema wants in an order; the others take text, or any of theirs."""


def structure(document: bytes) -> set[str]:
    """One line for each attribute, each child and each order of children; repetitions count once."""
    return set(_lines(Xml.fromstring(document)))


def _lines(element: Xml.Element) -> Iterator[str]:
    name = _local(element.tag)
    for attribute in element.attrib:
        yield f"{name} @{_local(attribute)}"
    children = [_local(child.tag) for child in element]
    yield from (f"{name} > {child}" for child in children)
    if name in IN_ORDER:
        yield f"{name}: {' '.join(each for each, _ in groupby(children))}"
    for child in element:
        yield from _lines(child)


def _local(name: str) -> str:
    return name.rpartition("}")[2]
