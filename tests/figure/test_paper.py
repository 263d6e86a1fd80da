"""A drawing stands on a light sheet, whatever it is laid upon."""

from __future__ import annotations

from xml.etree.ElementTree import fromstring

import pytest

from corollary.figure.svg import on_paper


def test_the_sheet_lies_behind_all_of_the_drawing_and_a_margin():
    svg = fromstring(on_paper('<svg viewBox="-20 0 520 150.5" font-size="15"><circle r="3"/></svg>'))
    sheet, circle = svg
    x, y, width, height = (float(sheet.get(name, "")) for name in ("x", "y", "width", "height"))
    assert sheet.get("fill") == "#fff"
    assert x < -20
    assert y < 0
    assert x + width > 500
    assert y + height > 150.5
    assert svg.get("viewBox") == f"{x:g} {y:g} {width:g} {height:g}"
    assert circle.tag == "circle"
    assert svg.get("font-size") == "15"


def test_a_drawing_without_a_size_gets_that_of_its_sheet():
    svg = fromstring(on_paper('<svg viewBox="0 0 520 150"><g/></svg>'))
    assert (svg.get("width"), svg.get("height")) == tuple(svg.get("viewBox", "").split()[2:])


@pytest.mark.parametrize(
    ("size", "grown"),
    [
        ('width="420" height="90"', {"width": "444", "height": "114"}),
        ("width='210px' height='45px'", {"width": "222px", "height": "57px"}),
        ('height="9cm"', {"height": "11.4cm"}),
        ('width="100%"', {"width": "100%"}),
    ],
)
def test_a_drawing_stays_as_large_as_its_size_says(size, grown):
    """420 by 90 units with a margin of 12 all round: the sheet is larger, and the drawing is not squeezed into its old size."""
    for svg in (
        f"<svg {size} viewBox='0 0 420 90'><g/></svg>",
        f"<svg viewBox='0 0 420 90' {size}><g/></svg>",
    ):
        found = fromstring(on_paper(svg))
        assert {name: found.get(name) for name in ("width", "height") if found.get(name)} == grown
        assert found.get("viewBox") == "-12 -12 444 114"


def test_without_a_view_box_the_sheet_fills_the_drawing():
    svg = fromstring(on_paper('<svg width="30" height="20" aria-label="a > b"><g/></svg>'))
    assert (svg[0].get("width"), svg[0].get("height"), svg[0].get("fill")) == ("100%", "100%", "#fff")
    assert svg.get("aria-label") == "a > b"


@pytest.mark.parametrize("text", ["<svg/>", '<svg viewBox="0 0 5 1" />', "no drawing", ""])
def test_what_holds_no_drawing_is_left_alone(text):
    assert on_paper(text) == text
