"""Figures drawn from plain data: to scale, of one look, with words that cover nothing, and fit to stand in any page."""

from __future__ import annotations

import math
import re
from xml.etree.ElementTree import Element, fromstring

import pytest

from corollary.figure.drawing import WIDTH, FigurePanel, describe, draw, unmentioned
from corollary.figure.drawing_sheet import COLOURS, PRIMITIVES, FigureItem, NotDrawable
from corollary.figure.lettering import lettered, spoken
from corollary.figure.svg import safe_svg

NB = "\N{NO-BREAK SPACE}"
SPACE = "{http://www.w3.org/2000/svg}"


def drawn(*items: FigureItem) -> Element:
    return fromstring(draw([FigurePanel("", items)]))


def ball(name: str, x: float, y: float, *texts: str, radius: float | None = None) -> FigureItem:
    return FigureItem("ball", name, texts, {"at": ((x, y),)}, {} if radius is None else {"radius": (radius,)})


def circles(svg: Element) -> list[tuple[float, float, float]]:
    return [
        (float(each.get("cx", "")), float(each.get("cy", "")), float(each.get("r", "")))
        for each in svg.iter(SPACE + "circle")
    ]


def texts(svg: Element) -> list[str]:
    return ["".join(each.itertext()) for each in svg.iter(SPACE + "text")]


def tips(svg: Element) -> list[tuple[float, float]]:
    """Where the heads of arrows end."""
    found = (re.match(r"M(\S+) (\S+?)L", each.get("d", "")) for each in svg.iter(SPACE + "path") if each.get("d", "").endswith("Z"))  # fmt: skip
    return [(float(each[1]), float(each[2])) for each in found if each]


def test_places_and_sizes_are_drawn_to_one_scale():
    (ax, ay, a), (bx, by, b) = circles(drawn(ball("A", 0, 0, radius=2), ball("B", 3, 1.8, radius=1)))
    assert (bx - ax) / a == pytest.approx(1.5, rel=0.02)
    assert (ay - by) / a == pytest.approx(0.9, rel=0.02)  # y points down in SVG, and up in a figure
    assert a / b == pytest.approx(2, rel=0.02)


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_the_figure_fills_its_own_extents_in_any_unit(unit):
    def of(scale: float) -> list[tuple[float, float, float]]:
        return circles(drawn(ball("A", 0, 0), ball("B", 4 * scale, 2 * scale)))

    assert of(unit) == of(2.0)


def test_arrows_that_measure_the_same_are_as_long_as_their_numbers():
    arrows = [
        FigureItem("arrow", name, (), {}, {"by": (speed, 0.0)}, group="m/s")
        for name, speed in (("A", 6.0), ("B", 3.0), ("C", -6.0))
    ]
    force = FigureItem("arrow", "A", (), {}, {"by": (0.0, 1e6)}, group="N")
    bodies = [ball(name, 20.0 * k, 0, radius=1) for k, name in enumerate("ABC")]
    svg = drawn(*bodies, *arrows, force)
    radius = circles(svg)[0][2]
    a, b, c, up = [
        math.dist(tip, middle[:2]) - radius
        for tip, middle in zip(tips(svg), [*circles(svg), circles(svg)[0]], strict=True)
    ]
    gap = 4.0
    assert (a - gap) / (b - gap) == pytest.approx(2, rel=0.05)
    assert c == pytest.approx(a, abs=0.3)
    assert up == pytest.approx(a, abs=0.3)  # a group of its own


def test_what_is_at_rest_has_its_words_and_no_arrow():
    svg = drawn(ball("A", 0, 0), FigureItem("arrow", "A", ("0 m/s",), {}, {"by": (0.0, 0.0)}))
    assert not tips(svg)
    assert "0 m/s" in texts(svg)


@pytest.mark.parametrize("kind", sorted(PRIMITIVES))
def test_a_figure_is_safe_as_it_is(kind):
    """No ids that two figures of a page could share, nothing that runs or is fetched: the sanitizer finds nothing to take out."""
    item = FigureItem(
        kind, "A", ("m < 5 & more",),
        {"at": ((0.0, 0.0),), "from": ((0.0, 0.0),), "to": ((9.0, 1.0),), "through": ((0.0, 0.0), (5.0, 1.0), (9.0, 0.0))},
        {"between": (0.0, 1.0), "angle": (0.5,), "x": (0.0, 10.0, 2.0), "y": (-1.0, 1.0, 0.5)},
    )  # fmt: skip
    svg = draw([FigurePanel("a & b", (ball("A", 0, 0), item))])
    assert not re.search(r"\bid=|href|url\(|<style|<script", svg)
    before, after = fromstring(svg), fromstring(safe_svg(svg))
    assert [each.tag.removeprefix(SPACE) for each in before.iter()] == [each.tag for each in after.iter()]
    assert [each.attrib for each in before.iter()] == [each.attrib for each in after.iter()]
    assert texts(before)


def test_lines_survive_printing_and_letters_have_one_size():
    svg = draw(
        [FigurePanel("", (ball("A", 0, 0, "m"), FigureItem("floor"), FigureItem("axes", texts=("x", "y"))))]
    )
    assert min(map(float, re.findall(r'stroke-width="([\d.]+)"', svg))) >= 1
    assert set(re.findall(r'<svg[^>]*font-size="(\d+)"', svg)) == {"15"}
    assert fromstring(svg).get("viewBox", "").split()[2] == f"{WIDTH:g}"


def test_a_text_that_is_too_wide_widens_the_sheet_and_is_not_cut():
    svg = drawn(ball("A", 0, 0, "w" * 80))
    left, _top, width, _height = map(float, svg.get("viewBox", "").split())
    assert width > lettered("w" * 80)[1]
    assert left < 0


@pytest.mark.parametrize(
    ("text", "slanted", "lowered"),
    [
        ("v_A = 5\N{NO-BREAK SPACE}m/s", ["v"], ["A"]),
        ("v0 = 5", ["v"], ["0"]),
        ("theta = 30°", ["θ"], []),
        ("m = 2\N{NO-BREAK SPACE}m", ["m"], []),  # the second is a metre
        ("b − d", ["b", "d"], []),
        ("a ball", [], []),
        ("Δv", ["v"], []),
        ("y < R: it touches", ["y", "R"], []),
        ("(a), (b)", [], []),
        ("5.0\N{NO-BREAK SPACE}kg, at rest", [], []),
    ],
)
def test_quantities_are_slanted_and_indices_lowered(text, slanted, lowered):
    inside = fromstring(f"<text>{lettered(text)[0]}</text>")
    assert [each.text for each in inside.iter("tspan") if each.get("font-style") == "italic"] == slanted
    assert [each.text for each in inside.iter("tspan") if each.get("font-size")] == lowered
    drop = sum(float(each.get("dy", "0")) for each in inside.iter("tspan"))
    assert drop == (4 if text.endswith(tuple(lowered) or "\0") else 0)


def test_a_figure_is_told_in_words():
    panel = FigurePanel(
        "before",
        (ball("A", 0, 0, f"m_A = 2{NB}kg"), FigureItem("arrow", "A", (f"v_A = 3{NB}m/s",), {}, {"by": (-1.0, 0.0)}), FigureItem("floor")),
    )  # fmt: skip
    told = f"before: a ball A: m_A = 2{NB}kg; an arrow at A to the left: v_A = 3{NB}m/s; a floor."
    assert describe([panel]) == told
    assert unmentioned([panel], f"A ball of 2{NB}kg.") == f"Written in the figure: v_A = 3{NB}m/s."
    assert unmentioned([panel], f"2{NB}kg and 3{NB}m/s") == ""
    assert spoken("-Delta x, alpha = 3") == "−Δx, α = 3"


@pytest.mark.parametrize(
    ("item", "sentence"),
    [
        (FigureItem("ball", "A"), "ball needs at="),
        (FigureItem("arrow", "Q", (), {}, {"by": (1.0, 0.0)}), "nothing here is called Q"),
        (FigureItem("arrow", "", (), {}, {"by": (1.0, 0.0)}), "arrow needs the thing it begins at"),
        (FigureItem("line", "", (), {"through": ((0.0, 0.0),)}), "two points or more"),
        (FigureItem("block", "A", (), {"on": ("I",)}), "no incline of this name"),
        (FigureItem("resistor", "", (), {"from": ((0.0, 0.0),), "to": ((0.0, 0.0),)}), "too close together"),
    ],
)
def test_what_cannot_be_drawn_is_said(item, sentence):
    with pytest.raises(NotDrawable, match=sentence) as caught:
        drawn(item)
    assert caught.value.item is item


def test_a_body_stands_on_an_incline():
    slope = FigureItem(
        "incline", "I", (), {"at": ((0.0, 0.0),)}, {"angle": (math.pi / 4,), "length": (10.0,)}
    )
    svg = drawn(slope, FigureItem("ball", "A", (), {"on": ("I",)}, {"along": (0.5,), "radius": (1.0,)}))
    (x, y, radius) = circles(svg)[0]
    assert (-y - x) / math.sqrt(2) == pytest.approx(radius, rel=0.02)


def test_every_colour_has_a_name_and_is_drawn():
    for name, colour in COLOURS.items():
        flags = frozenset({name})
        arrow = FigureItem("arrow", "", (), {"from": ((0.0, 0.0),)}, {"by": (1.0, 0.0)}, flags)
        assert colour in draw([FigurePanel("", (arrow,))])
