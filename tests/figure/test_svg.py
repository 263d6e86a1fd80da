"""Drawings keep their shapes and words, and lose whatever runs, restyles the page or is fetched."""

from __future__ import annotations

import re
from xml.etree.ElementTree import fromstring

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.figure.svg import ATTRIBUTES, LOOKS, NotADrawing, safe_svg


def test_shapes_and_words_stay():
    words = '<text x="1" y="2">m = <tspan>2 &lt; 3</tspan> kg</text>'
    drawn = safe_svg(f'<svg viewBox="0 0 9 9">{words}<circle cx="1" cy="2" r="3"/></svg>')
    assert drawn == f'<svg viewBox="0 0 9 9">{words}<circle cx="1" cy="2" r="3"></circle></svg>'


@pytest.mark.parametrize(
    "harm",
    [
        "<script>alert(1)</script>",
        '<script href="data:text/javascript,alert(1)"/>',
        "<style>* {display: none}</style>",
        '<foreignObject><body xmlns="http://www.w3.org/1999/xhtml" onload="alert(1)"/></foreignObject>',
        '<image href="http://example.org/a.png"/>',
        '<a href="javascript:alert(1)"><text>x</text></a>',
        '<animate attributeName="href" to="javascript:alert(1)"/>',
        '<set attributeName="onload" to="alert(1)"/>',
        '<circle onclick="alert(1)" r="1"/>',
        '<use href="http://example.org/a.svg#b"/>',
        '<use xlink:href="data:image/svg+xml,alert"/>',
        '<rect fill="url(http://example.org/a)"/>',
        "<rect fill=\"url( '//example.org/a')\"/>",
        '<rect style="fill: url(&quot;http://example.org&quot;)"/>',
        "<rect style=\"background: image-set('http://example.org' 1x); position: fixed; overflow: visible\"/>",
        '<rect style="fill: \\75rl(http://example.org)"/>',
        '<rect class="page" width="expression(alert(1))"/>',
        "<?php alert ?>",
        "<!-- alert -->",
    ],
)
def test_harm_is_taken_out(harm):
    drawn = safe_svg(f'<svg viewBox="0 0 9 9"><circle r="4"/>{harm}<text>after</text></svg>')
    assert not re.search(
        r"alert|http|script|example|style=|on\w+=|class|url|image|75rl|<a\b|<animate|<set", drawn
    )
    assert '<circle r="4">' in drawn
    assert "<text>after</text>" in drawn


def test_ids_are_kept_apart_by_a_prefix():
    drawn = safe_svg(
        '<svg xmlns:xlink="http://www.w3.org/1999/xlink"><defs><marker id="arrow"/><path id="p"/></defs><g id="unused"/>'
        '<line marker-end="url(#arrow)" style="clip-path: url(\'#p\')"/><use xlink:href="#p"/></svg>',
        prefix="X12_5-",
    )
    assert '<marker id="X12_5-arrow">' in drawn
    assert 'marker-end="url(#X12_5-arrow)"' in drawn
    assert "url(&#x27;#X12_5-p&#x27;)" in drawn
    assert '<use href="#X12_5-p">' in drawn
    assert "unused" not in drawn


def test_a_label_is_said():
    assert 'role="img" aria-label="a &quot;ball&quot;"' in safe_svg("<svg/>", label='a "ball"')


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "not well-formed"),
        ("<svg><g></svg>", "not well-formed"),
        ("<html/>", "must begin with <svg>"),
        ('<!DOCTYPE svg [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><svg>&b;</svg>', "entities"),
        ("<svg>" + "<g>" * 60 + "</g>" * 60 + "</svg>", "50 deep"),
        ("<svg>" + "<g/>" * 60_000 + "</svg>", "elements"),
        ("<svg>" + " " * 2_000_000 + "</svg>", "characters"),
    ],
)
def test_what_is_no_drawing_is_refused_in_a_sentence(text, why):
    with pytest.raises(NotADrawing, match=why):
        safe_svg(text)


@given(
    st.sampled_from(sorted(ATTRIBUTES | LOOKS | {"onload", "onclick", "src"})),
    st.text(alphabet="url(#'\"):/;javscript:htp\\@<>& 0", max_size=40),
)
def test_no_attribute_fetches_or_runs(name, value):
    escaped = value.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    root = fromstring(safe_svg(f'<svg><rect {name}="{escaped}"/></svg>'))
    for kept, written in root[0].attrib.items():
        assert not kept.startswith("on")
        assert not re.search(r"://|:\s*//|script:|url\(\s*['\"]?[^'\"#]", written)
        assert kept != "href" or written.startswith("#")
