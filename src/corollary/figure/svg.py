"""A drawing as SVG text made fit to stand in a page: only shapes, words and colours, nothing that runs or is fetched."""

from __future__ import annotations

import html
import re
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
