"""A drawing as SVG text made fit to stand in a page, on a light sheet where the page may be dark."""

from __future__ import annotations

import html
import re
from collections.abc import Mapping
from typing import Final
from xml.etree.ElementTree import Element, ParseError, fromstring

# A drawing of matplotlib has some 50 kB and 1 000 elements; beyond these a browser would crawl.
LONGEST, DEEPEST, MOST = 2_000_000, 50, 50_000


def _names(text: str) -> frozenset[str]:
    return frozenset(text.split())


TAGS = _names(
    """
    svg g defs symbol use title desc path rect circle ellipse line polyline polygon text tspan textPath
    marker clipPath mask pattern linearGradient radialGradient stop
    """
)
ATTRIBUTES = _names(
    """
    id role aria-label aria-hidden viewBox preserveAspectRatio width height x y x1 y1 x2 y2 cx cy r rx
    ry fx fy d points transform style href offset dx dy rotate textLength lengthAdjust startOffset refX
    refY orient markerWidth markerHeight markerUnits clipPathUnits maskUnits patternUnits
    patternTransform gradientUnits gradientTransform spreadMethod version
    """
)
LOOKS = _names(
    """
    fill fill-opacity fill-rule clip-path clip-rule mask stroke stroke-width stroke-linecap
    stroke-linejoin stroke-miterlimit stroke-dasharray stroke-dashoffset stroke-opacity opacity color
    display visibility marker-start marker-mid marker-end font-family font-size font-style font-weight
    text-anchor dominant-baseline alignment-baseline baseline-shift letter-spacing stop-color
    stop-opacity vector-effect paint-order
    """
)
UNMISSED = frozenset({"metadata"})
SVG = "http://www.w3.org/2000/svg"
WORDS = frozenset({"text", "tspan", "textPath", "title", "desc"})
LOCAL = re.compile(r"(url\(['\"]?#)")
REFERENCE = re.compile(r"#([\w.-]+)")
HARMFUL = re.compile(r"[\\<>@]|/\*|:\s*//|script:|expression|image|url\((?!['\"]?#)", re.IGNORECASE)


class NotADrawing(ValueError):
    """The text is no SVG that can be shown; one sentence says why."""


def safe_svg(text: str, *, prefix: str = "", label: str = "") -> str:
    """The drawing with what could run, restyle the page or be fetched taken out, ready to stand in HTML.

    `prefix` goes before every id, so that two drawings of one page keep theirs apart; `label` is what a screen reader says.
    Raises NotADrawing when the text is too long, no well-formed XML, or no svg.
    """
    root = _read(text)
    referred = {
        name
        for element in root.iter()
        for value in element.attrib.values()
        for name in REFERENCE.findall(value)
    }
    for element in root.iter():
        if element.get("id") not in referred:
            element.attrib.pop("id", None)
    return _written(root, prefix, label, 0)


def alone(svg: str) -> str:
    """An SVG text of these modules as a file of its own, which must name its namespace."""
    return svg.replace("<svg", f'<svg xmlns="{SVG}"', 1)


def left_out(text: str) -> str:
    """The first thing of the drawing that `safe_svg` leaves out and somebody would miss, or that would run or fetch; "" when
    nothing is. What an editor keeps for itself is not missed. Raises NotADrawing."""
    root = _read(text)
    every = [(element, *_names_of(element)) for element in root.iter()]
    classes = any("class" in element.attrib for element, *_ in every)
    for element, space, tag in every:
        if space not in ("", SVG):
            continue
        if tag not in TAGS | UNMISSED and (tag != "style" or classes):
            return f"<{tag}>"
        for name, value in element.attrib.items():
            name = _local_name(name)
            if name.lower().startswith("on"):
                return f"{name}= of <{tag}>"
            if name in LOOKS | {"href"} and not _fit(name, value, ""):
                return f'{name}="{value[:40]}" of <{tag}>'
    return ""


def _names_of(element: Element) -> tuple[str, str]:
    """The namespace and the local name."""
    space, _, tag = element.tag.rpartition("}")
    return space.removeprefix("{"), tag


def _read(text: str) -> Element:
    """The root of a drawing. Raises NotADrawing."""
    if len(text) > LONGEST:
        raise NotADrawing(f"the drawing has {len(text)} characters; at most {LONGEST} are shown")
    text = re.sub(r"<\?xml[^>]*\?>|<!DOCTYPE svg PUBLIC [^\[>]*>", "", text, count=2).strip()
    if re.search(r"<!(DOCTYPE|ENTITY)", text, re.IGNORECASE):
        raise NotADrawing("the drawing declares entities of its own; write it without DOCTYPE")
    try:
        root = fromstring(re.sub(r"<svg\b(?![^>]*\sxmlns:xlink)", '<svg xmlns:xlink="xlink"', text, count=1))
    except (ParseError, ValueError, RecursionError) as error:
        raise NotADrawing(f"the drawing is not well-formed XML: {error}") from None
    if _local_name(root.tag) != "svg":
        raise NotADrawing(f"the drawing begins with <{_local_name(root.tag)}>; it must begin with <svg>")
    if sum(1 for _ in root.iter()) > MOST:
        raise NotADrawing(f"the drawing has more than {MOST} elements")
    return root


def _local_name(name: object) -> str:
    return name.rpartition("}")[2] if isinstance(name, str) else ""


def _written(element: Element, prefix: str, label: str, depth: int) -> str:
    tag = _local_name(element.tag)
    if tag not in TAGS:
        return ""
    if depth > DEEPEST:
        raise NotADrawing(f"the drawing nests groups more than {DEEPEST} deep")
    attributes = {
        name: value
        for name, value in (
            (_local_name(name), _fit(_local_name(name), value, prefix))
            for name, value in element.attrib.items()
        )
        if value
    }
    if depth == 0:
        attributes |= {"role": "img", "aria-label": label} if label else {}
    inside = html.escape(element.text or "", quote=False) if tag in WORDS else ""
    for child in element:
        inside += _written(child, prefix, "", depth + 1)
        inside += html.escape(child.tail or "", quote=False) if tag in WORDS else ""
    written = "".join(f' {name}="{html.escape(value)}"' for name, value in attributes.items())
    return f"<{tag}{written}>{inside}</{tag}>"


def _fit(name: str, value: str, prefix: str) -> str:
    """The attribute's value as it may stand in the page, or nothing."""
    if name == "style":
        rules = (rule.partition(":") for rule in value.split(";"))
        return "; ".join(
            f"{look.strip()}: {fit}"
            for look, _, text in rules
            if look.strip() in LOOKS and (fit := _fit(look.strip(), text.strip(), prefix))
        )
    if name not in ATTRIBUTES | LOOKS or HARMFUL.search(value):
        return ""
    if name == "id":
        return prefix + value
    if name == "href":
        return f"#{prefix}{value[1:]}" if value.startswith("#") else ""
    return LOCAL.sub(lambda found: found[1] + prefix, value)


MARGIN: Final = 12
"""Around the drawing, in its own units."""
OPENING = re.compile(r"""<svg\b(?:[^>"']|"[^"]*"|'[^']*')*>""")
EMPTY = re.compile(r"\s*/>$")
VIEW = re.compile(r"""\sviewBox=["']([\d.-]+)[\s,]+([\d.-]+)[\s,]+([\d.]+)[\s,]+([\d.]+)["']""")
SIZE = re.compile(
    r"""(?P<name>\s(?:width|height)=)(?P<quote>["'])\s*(?P<number>[\d.]+)(?P<unit>[a-z]*)\s*(?P=quote)"""
)
SIZED = re.compile(r"\s(?:width|height)=")


def on_paper(svg: str) -> str:
    """The SVG text with a white sheet behind it, and with a size of its own: without one it would fill the page.

    A size that it has grows with the sheet, so that the drawing on it stays as large as it was. A drawing without a viewBox
    keeps its size, and one that is no SVG is left as it is.
    """
    opening = OPENING.search(svg)
    if opening is None or EMPTY.search(opening[0]):
        return svg
    tag, sheet = opening[0], '<rect width="100%" height="100%" fill="#fff"/>'
    if view := VIEW.search(tag):
        left, top, width, height = map(float, view.groups())
        x, y, wide, high = left - MARGIN, top - MARGIN, width + 2 * MARGIN, height + 2 * MARGIN
        size = "" if SIZED.search(tag) else f' width="{wide:g}" height="{high:g}"'
        grown = {"width": wide / width, "height": high / height} if width and height else {}
        tag = SIZE.sub(lambda found: _grown(found, grown), tag)
        tag = tag.replace(view[0], f' viewBox="{x:g} {y:g} {wide:g} {high:g}"{size}', 1)
        sheet = f'<rect x="{x:g}" y="{y:g}" width="{wide:g}" height="{high:g}" rx="{MARGIN}" fill="#fff"/>'
    return svg[: opening.start()] + tag + sheet + svg[opening.end() :]


def _grown(size: re.Match[str], by: Mapping[str, float]) -> str:
    """`width="420"` for a sheet that is so many times as wide. (A size in percent is another thing's.)"""
    number = float(size["number"]) * by.get(size["name"].strip(" =\n\t"), 1.0)
    return f"{size['name']}{size['quote']}{number:.6g}{size['unit']}{size['quote']}"


BLACK: Final = "#000000"
ORANGE: Final = "#E69F00"
SKY: Final = "#56B4E9"
GREEN: Final = "#009E73"
YELLOW: Final = "#F0E442"
BLUE: Final = "#0072B2"
VERMILLION: Final = "#D55E00"
PURPLE: Final = "#CC79A7"
GREY: Final = "#999999"

CYCLE: Final = (BLUE, VERMILLION, GREEN, PURPLE, ORANGE, SKY, BLACK, YELLOW)
"""The order in which curves take their colours: neighbours differ most, yellow (faint on white) last."""
