"""Fingerprints of what verdicts follow from: a problem's file but for its points, a solution but for its rubrics."""

from __future__ import annotations

import ast

from corollary.derive.markdown_items import ListItem, sections
from corollary.problem.parts_markdown import ATTRIBUTE, HEADING

_RUBRIC_OF = "explain"  # of corollary.author: the part, the rubric, and what a full answer says


def without_points(text: bytes) -> bytes:
    """A problem's file without the points of its parts."""
    return "\n".join(map(_without_points, text.decode("utf-8").split("\n"))).encode()


def _without_points(line: str) -> str:
    heading = HEADING.match(line)
    if heading is None:
        return line
    attributes = [
        each[0] for each in ATTRIBUTE.finditer(heading["attributes"] or "") if each["name"] != "points"
    ]
    return " ".join(("##", heading["title"], *sorted(attributes)))


def without_rubrics(source: bytes) -> bytes:
    """A solution, and the modules beside it, as trees without what a person marks by, without remarks and lines."""
    return b"\0".join(map(_without_rubrics, source.split(b"\0")))


def _without_rubrics(source: bytes) -> bytes:
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return _text_without_rubrics(source)
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == _RUBRIC_OF:
            del node.args[1:], node.keywords[:]
    return ast.dump(tree).encode()


def _text_without_rubrics(source: bytes) -> bytes:
    """The sections of a solution in text; of one with a rubric nothing but its heading."""
    found: list[object] = []
    for section in sections(source.decode("utf-8", "replace")):
        if any(item.key == "rubric" for item in section.items):
            found.append(section.title)
        else:
            found.append((section.level, section.title, section.paragraph, _contents(section.items)))
    return repr(found).encode()


def _contents(items: list[ListItem]) -> list[object]:
    return [(item.key, item.text, _contents(item.items)) for item in items]
