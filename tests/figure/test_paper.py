"""A drawing stands on a light sheet, whatever it is laid upon."""

from __future__ import annotations

from xml.etree.ElementTree import fromstring

import pytest

from corollary.figure.paper import on_paper


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


@pytest.mark.parametrize("size", ['width="3"', 'height="2"', 'width="3" height="2"'])
def test_a_size_of_its_own_is_kept(size):
    for svg in (f"<svg {size} viewBox='0 0 5 1'><g/></svg>", f"<svg viewBox='0 0 5 1' {size}><g/></svg>"):
        found = on_paper(svg)
        assert size in found
        assert found.count("width=") + found.count("height=") == size.count("=") + 2  # the sheet has both


def test_without_a_view_box_the_sheet_fills_the_drawing():
    svg = fromstring(on_paper('<svg width="30" height="20" aria-label="a > b"><g/></svg>'))
    assert (svg[0].get("width"), svg[0].get("height"), svg[0].get("fill")) == ("100%", "100%", "#fff")
    assert svg.get("aria-label") == "a > b"


@pytest.mark.parametrize("text", ["<svg/>", '<svg viewBox="0 0 5 1" />', "no drawing", ""])
def test_what_holds_no_drawing_is_left_alone(text):
    assert on_paper(text) == text
