"""Markdown as the XHTML that QTI allows, with formulas in MathML."""

from __future__ import annotations

from xml.etree import ElementTree as Xml

from corollary.render.markdown import html
from corollary.render.markdown import inline as inline_html

MATHML = "http://www.w3.org/1998/Math/MathML"
ALLOWED = frozenset({"class", "id"})
"""Attributes of QTI's XHTML; those of formulas are MathML's own."""
OF_PICTURES = frozenset({"src", "alt"})


def block(text: str) -> str:
    """Paragraphs, lists, tables, formulas on lines of their own."""
    return _within_qti(html(text))


def inline(text: str) -> str:
    """One line, without a paragraph around it."""
    return _within_qti(inline_html(text))


def _within_qti(found: str) -> str:
    root = Xml.fromstring(f"<div>{found}</div>")
    for element in root:
        _cleaned(element)
    inside = (root.text or "").replace("&", "&amp;").replace("<", "&lt;")
    return inside + "".join(Xml.tostring(each, encoding="unicode") for each in root)


def _cleaned(element: Xml.Element) -> None:
    """Without attributes that QTI does not know; formulas in their namespace."""
    if element.tag == "math":
        element.set("xmlns", MATHML)
        if displayed := element.attrib.pop(
            "displaystyle", ""
        ):  # which this schema has for a part of a formula only
            style = Xml.Element("mstyle", {"displaystyle": displayed})
            style.extend(list(element))
            for child in list(element):
                element.remove(child)
            element.append(style)
        return
    for name in [
        name for name in element.attrib if name not in (OF_PICTURES if element.tag == "img" else ALLOWED)
    ]:
        del element.attrib[name]
    for child in element:
        _cleaned(child)
