"""The figure that a motion is played in: what is said of it in words, and what the script is given."""

from __future__ import annotations

import json
import re
from html import unescape

import pytest

from corollary.derive.ready_scenes import film_of
from corollary.messages import language
from corollary.render.animation import animation, number

HEAD_ON = {
    "mA": 2.0,
    "mB": 3.0,
    "dx": 0.08,
    "dy": 0.0,
    "vA": (4.0, 0.0),
    "vB": (-1.5, 0.0),
    "k": 1e9,
    "eta": 0.0,
}


def figure(scene, settings) -> tuple[str, dict]:
    film = film_of(scene, settings)
    assert film is not None
    html = animation(film)
    found = re.search(r'class="reel">(.*?)</script>', html)
    assert found is not None
    return html, json.loads(found[1])


def test_who_cannot_see_it_reads_what_happens():
    html, _reel = figure("spheres", HEAD_ON)
    words = unescape(html)
    assert "A (2 kg): at the beginning 4 m/s to the right, at the end 2.6 m/s to the left." in words
    assert "Total momentum: 3.5 kg m/s, then 3.5 kg m/s." in words
    assert "Total kinetic energy: 19.4 J, then 19.4 J." in words


def test_the_script_gets_places_on_the_drawing_and_velocities_in_si():
    html, reel = figure("spheres", HEAD_ON)
    width, height = map(float, re.search(r'viewBox="0 0 (\S+) (\S+)"', html).groups())
    for body in reel["bodies"]:
        assert len(body["p"]) == len(body["v"]) == len(reel["t"])
        assert all(0.0 <= x <= width and 0.0 <= y <= height for x, y in body["p"])
    assert [body["m"] for body in reel["bodies"]] == [2.0, 3.0]
    assert reel["bodies"][0]["v"][0] == [4.0, 0.0]
    assert reel["flat"] == "x"
    assert reel["stored"] is None


def test_height_has_its_own_bar():
    html, reel = figure("ball_on_floor", {"m": 0.1, "k": 1e6, "R": 0.02, "y0": 1.02, "v0": 0.0, "g": 9.8})
    assert "potential energy" in html
    assert min(reel["stored"]) == 0.0
    assert reel["flat"] == "y"


@pytest.mark.parametrize(
    ("value", "written"), [(0.0, "0"), (-2.6, "−2.6"), (19.375, "19.4"), (1234.0, "1230"), (2e16, "2·10^16")]
)
def test_numbers_have_three_figures(value, written):
    assert number(value) == written


def test_numbers_have_the_comma_of_the_language():
    with language("de"):
        assert number(19.375) == "19,4"
