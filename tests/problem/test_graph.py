"""Graphs of a figure, read off the drawing as a student would: by the numbers at the ticks."""

from __future__ import annotations

import math
import re

import pytest

from corollary.messages import language
from corollary.problem.figure import BadFigure, drawn, in_letters, letters_graphed
from corollary.problem.variant import at, chapter, size

FRONT = """\
code: X1.1
title: A trip
given:
  V: {is: speed, value: 12, from: 8, to: 20, step: 4, unit: m/s}
  t1: {is: time, value: 4, from: 2, to: 8, step: 2, unit: s}
  tau: {is: time constant, value: 3, from: 1, to: 5, step: 2, unit: s}
  T: {is: temperature, value: 60, unit: °C}
figure: |
"""
ASKS = '\nA trip.\n\n## Way {#a .value unit="m"}\nHow far?\n'
NUMBER = re.compile(
    r'<text x="([-\d.]+)" y="([-\d.]+)" text-anchor="(\w+)" fill="#222" font-size="12">([−\d.,]+)</text>'
)
PATH = re.compile(r'<path d="M([^"Z]*)" fill="none" stroke="([^"]+)" stroke-width="2.5"')
BLUE = "#0072B2"


@pytest.fixture
def graph(read):
    """A problem with these lines as its figure."""
    return lambda *lines: read(FRONT + "".join(f"  {line}\n" for line in lines), ASKS)


def value(text: str) -> float:
    return float(text.replace("−", "-"))


def read_off(svg: str, colour: str = BLUE) -> list[list[tuple[float, float]]]:
    """The corners of each curve of a colour, by the numbers at the ticks: two of an axis tell its scale."""
    ticks = [(float(x), float(y), anchor, value(text)) for x, y, anchor, text in NUMBER.findall(svg)]
    along = [(x, number) for x, _y, anchor, number in ticks if anchor == "middle"]
    up = [(y - 12 * (1.25 / 2 - 0.28), number) for _x, y, anchor, number in ticks if anchor == "end"]

    def scaled(place: float, marks: list[tuple[float, float]]) -> float:
        (first, low), (last, high) = marks[0], marks[-1]
        return low + (place - first) / (last - first) * (high - low)

    return [
        [
            (scaled(float(x), along), scaled(float(y), up))
            for x, y in (each.split() for each in path.split("L"))
        ]
        for path, stroke in PATH.findall(svg)
        if stroke == colour
    ]


def close(found, wanted, within: float) -> bool:
    return len(found) == len(wanted) and all(
        abs(a - c) < within and abs(b - d) < within for (a, b), (c, d) in zip(found, wanted, strict=True)
    )


def test_straight_lines_are_where_each_student_s_numbers_are(graph):
    problem = graph('graph x=t,0,20 y=0,20 units=s,m/s "t" "v"', "curve through=(0,0),(t1,V),(20,V)")
    for index in range(size(problem)):
        variant = at(problem, index)
        speed, time = (float(variant.values[name]) for name in ("V", "t1"))
        (path,) = read_off(drawn(variant).svg)
        assert close(path, [(0, 0), (time, speed), (20, speed)], 0.05)


def test_the_curve_of_a_formula_is_the_formula(graph):
    problem = graph('graph x=t,0,20 y=0,20 units=s,m/s "t" "v"', "curve of=V*(1-exp(-t/tau))")
    (path,) = read_off(drawn(chapter(problem)).svg)
    assert len(path) > 100
    assert all(abs(v - 12 * (1 - math.exp(-t / 3))) < 0.06 for t, v in path)
    assert (path[0][0], path[-1][0]) == (pytest.approx(0, abs=0.05), pytest.approx(20, abs=0.05))


def test_axes_may_have_any_unit(graph):
    """12 m/s is 43.2 km/h, and 4 s is 1/15 min; a plain number is in the unit of its axis."""
    problem = graph('graph x=t,0,0.2 y=0,60 units=min,km/h "t" "v"', "curve through=(0,20),(t1,V),(0.2,V)")
    (path,) = read_off(drawn(chapter(problem)).svg)
    assert close([(100 * t, v) for t, v in path], [(0, 20), (100 / 15, 43.2), (20, 43.2)], 0.2)


def test_a_scale_with_an_offset_keeps_it(graph):
    problem = graph('graph x=t,0,10 y=0,100 units=s,°C "t" "T"', "curve through=(0,20),(t1,T),(10,T)")
    (path,) = read_off(drawn(chapter(problem)).svg)
    assert close(path, [(0, 20), (4, 60), (10, 60)], 0.3)


def test_what_leaves_the_axes_is_cut_off_there(graph):
    """A parabola of 2 m/s² is 20 m/s high at the root of 10 s, twice."""
    lines = 'graph x=t,-5,5 y=0,20 units=s,m "t" "s"', "curve of=(t-0*t1)^2*(V/(6*t1))*(1/t1)*t1*2*2/2"
    problem = graph(*lines)
    (path,) = read_off(drawn(chapter(problem)).svg)
    assert all(-0.1 < s < 20.1 for _t, s in path)


def test_a_curve_above_the_axes_comes_back_as_a_second_piece(graph):
    problem = graph('graph x=t,0,10 y=0,10 units=s,m/s "t" "v"', "curve through=(0,0),(t1,3*V),(10,0)")
    pieces = read_off(drawn(chapter(problem)).svg)
    assert close(pieces[0], [(0, 0), (4 * 10 / 36, 10)], 0.05)
    assert close(pieces[1], [(10 - 6 * 10 / 36, 10), (10, 0)], 0.05)


@pytest.mark.parametrize(
    ("ends", "labels"),
    [
        ("0,20", [0, 5, 10, 15, 20]),
        ("-5,30", [-5, 0, 5, 10, 15, 20, 25, 30]),
        ("0,1", [0, 0.2, 0.4, 0.6, 0.8, 1]),
        ("0,V", [0, 2, 4, 6, 8, 10, 12]),
        ("0,V+1", [0, 5, 10, 15]),
        ("0,3e6", [0, 500000, 1000000, 1500000, 2000000, 2500000, 3000000]),
    ],
)
def test_ticks_are_round_and_hold_the_range(graph, ends, labels):
    ends = ends.replace("V+1", "V*13/12")
    problem = graph(f'graph x=t,0,10 y={ends} units=s,m/s "t" "v"', "curve through=(0,0),(10,0)")
    svg = drawn(chapter(problem)).svg
    assert [value(text) for _x, _y, anchor, text in NUMBER.findall(svg) if anchor == "end"] == labels


def test_numbers_at_the_ticks_do_not_cover_each_other(graph):
    panels = [
        'panel "a"',
        'graph x=t,0,1000000 units=s,m/s steps=50000,5 "t" "v"',
        "curve through=(0,0),(1e6,V)",
    ]
    svg = drawn(chapter(graph(*panels, *panels, *panels))).svg
    places = [float(x) for x, _y, anchor, _text in NUMBER.findall(svg) if anchor == "middle"]
    assert len(places) >= 3


def test_without_ends_all_that_is_drawn_is_on_the_axis(graph):
    problem = graph('graph x=t,0,20 units=s,m/s "t" "v"', "curve through=(0,0),(t1,V),(20,-V/2)")
    for index in range(size(problem)):
        variant = at(problem, index)
        numbers = [
            value(text) for _x, _y, anchor, text in NUMBER.findall(drawn(variant).svg) if anchor == "end"
        ]
        assert min(numbers) <= -float(variant.values["V"]) / 2
        assert max(numbers) >= float(variant.values["V"])


def test_who_cannot_see_it_is_told_axes_corners_and_ticks(graph):
    lines = (
        'graph x=t,0,20 y=0,20 units=s,m/s "t" "v"',
        'curve through=(0,0),(t1,V),(20,V) "car"',
        "curve of=V*t/t1 over=t,0,4",
        "point P at=t1,V",
    )
    assert drawn(chapter(graph(*lines))).alt == (
        "Graph of v in m/s, from 0 to 20, against t in s, from 0 to 20. Straight lines (car): 0 at 0; 12 at 4; 12 at 20. "
        "A curve: 0 at 0; 12 at 4. A point (P): 12 at 4."
    )


def test_the_words_of_a_sketch_tell_its_shape_and_no_number(graph):
    found = drawn(
        chapter(
            graph('graph x=t,0,20 y=0,24 units=s,m/s "t" "v" sketch', "curve through=(0,0),(t1,V),(20,V)")
        )
    )
    assert (
        found.alt
        == "Sketch of v against t, without numbers. Straight lines: 0 % at 0 %; 50 % at 20 %; 50 % at 100 %."
    )
    assert not NUMBER.findall(found.svg)
    assert "m/s" not in found.svg


def test_numbers_of_axes_are_written_as_the_language_does(graph):
    problem = graph('graph x=t,0,1 y=0,20 units=s,m/s "t" "v"', "curve through=(0,0),(0.5,V)")
    with language("de"):
        found = drawn(chapter(problem))
    assert ">0,2</text>" in found.svg
    assert "12 bei 0,5" in found.alt


def test_the_letter_of_an_axis_is_slanted_and_its_unit_is_not(graph):
    svg = drawn(
        chapter(graph('graph x=t,0,1 y=0,20 units=s,m/s "time t" "v_x"', "curve through=(0,0),(0.5,V)"))
    ).svg
    slanted = re.findall(r'font-style="italic">([^<]*)<', svg)
    assert slanted == ["t", "v"]
    assert ">x</tspan>" in svg


def test_a_given_of_another_name_moves_in_formulas_and_not_in_units():
    line = 'graph x=t,0,s units=s,m/s "t" "v"'
    assert in_letters(line, {"s": "T"}) == 'graph x=t,0,T units=s,m/s "t" "v"'


def test_what_a_graph_shows_can_be_read_off_it(graph):
    problem = graph('graph x=t,0,20 y=0,20 units=s,m/s "t" "v"', "curve of=V*t/t1")
    assert letters_graphed(problem) == {"V", "t1"}


HEAD = 'graph x=t,0,20 y=0,20 units=s,m/s "t" "v"'


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        (['graph y=0,20 "t" "v"'], "needs the letter of its horizontal axis"),
        (['graph x=t1,0,20 "t" "v"'], "needs the letter of its horizontal axis"),
        (['graph x=t,0,20 "t"'], "needs two texts"),
        (['graph x=t,0,20 units=s "t" "v"'], "units= are those of both axes"),
        (['graph x=t,0,20 units=s,furlong "t" "v"'], "furlong"),
        (['graph x=t,0,20 units=s,m/s steps=0,5 "t" "v"'], "steps= are positive numbers"),
        (['graph x=t,0,V units=s,m/s "t" "v"'], "x: V is not in s, as the axis is"),
        ([HEAD, "curve of=t1*t"], "of: t1*t is not in m/s, as the axis is"),
        ([HEAD, "curve of=V*z"], "z is not among the letters here"),
        ([HEAD, "curve through=(0,0),(V,t1)"], "through: V is not in s, as the axis is"),
        ([HEAD, "ball at=0,0"], "there is no ball on a graph"),
        ([HEAD, "arrow at=0,0 by=V,0"], "by= has no size on a graph"),
        ([HEAD, "curve of=V over=s,0,1"], "over= has the letter of the axis: over=t,0,1"),
        ([HEAD, HEAD], "a graph begins its panel"),
        (["ball at=0,0", HEAD], "a graph begins its panel"),
        (["curve of=V*2"], "of= is the height of a curve on a graph"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_graph(complaints, lines, words):
    found = complaints(FRONT + "".join(f"  {line}\n" for line in lines), ASKS)
    assert len(found) == 1
    assert words in found[0][1]
    assert found[0][0] == 10 + len(lines) - 1


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        (['graph x=t,20,0 y=0,20 units=s,m/s "t" "v"'], "has no length"),
        (['graph x=t,0,20 y=0,20 units=s,m/s steps=0.1,5 "t" "v"'], "steps of 0.1 are 200"),
        (['graph x=t,0,20 units=s,m/s "t" "v"'], "say from where to where, y=0,10"),
        ([HEAD, "curve of=V/(t/t1)"], "no value with these numbers"),
    ],
)
def test_what_cannot_be_drawn_is_said(graph, lines, words):
    with pytest.raises(BadFigure, match=re.escape(words)):
        drawn(chapter(graph(*lines)))
