"""The figure of a problem: placed by the student's numbers, and complaints with the line and the remedy."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.figure.drawing_sheet import PRIMITIVES
from corollary.problem.diagnostic import Malformed
from corollary.problem.figure import BadFigure, drawn, in_letters
from corollary.problem.reader import read_problem
from corollary.problem.variant import at, chapter

FRONT = """\
---
code: X1.1
title: A cart
given:
  m:     {is: mass,     value: 2.0, from: 1, to: 5,  step: 0.5, unit: kg}
  v:     {is: velocity, value: 3.0, from: -3, to: 5,  step: 0.5, unit: m/s}
  L:     {is: length,   value: 40,  from: 10, to: 90, step: 10,  unit: cm}
  theta: {is: angle,    value: 30,  from: 5, to: 60, step: 5,   unit: deg}
figure: |
"""
REST = """\
---
A cart.

## Momentum {#a .value unit="kg m/s"}
How large?
"""
FIRST = 10  # the line of the figure's first line


@pytest.fixture
def problem(tmp_path: Path):
    def read(figure: str, alt: str = ""):
        lines = "".join(f"  {line}\n" for line in figure.splitlines())
        path = tmp_path / "cart.md"
        path.write_text(FRONT + lines + (f"alt: {alt}\n" if alt else "") + REST, encoding="utf-8")
        return read_problem(path)

    return read


def test_numbers_place_things_and_fill_texts(problem):
    cart = problem('block A at=0,0 "m = {{m}}"\narrow A by=v,0 "{{v}}"')
    first, other = drawn(chapter(cart)), drawn(at(cart, 0))
    assert "2.0\N{NO-BREAK SPACE}kg" in first.svg
    assert (
        first.alt
        == "A block A: m = 2.0\N{NO-BREAK SPACE}kg; an arrow at A to the right: 3.0\N{NO-BREAK SPACE}m/s."
    )
    assert "an arrow at A to the left: −3.0" in other.alt
    assert first.svg != other.svg


def test_an_authors_words_come_first_and_what_they_leave_out_is_added(problem):
    cart = problem('block A at=0,0 "m = {{m}}"\narrow A by=v,0 "{{v}}"', alt="A cart of {{m}}.")
    assert drawn(chapter(cart)).alt == (
        "A cart of 2.0\N{NO-BREAK SPACE}kg. Written in the figure: 3.0\N{NO-BREAK SPACE}m/s."
    )


def test_angles_are_in_degrees_as_numbers_and_themselves_as_letters(problem):
    def of(line: str) -> str:
        return drawn(chapter(problem(line))).svg

    assert of("angle at=0,0 between=0,30") == of("angle at=0,0 between=0,theta")
    assert of("angle at=0,0 between=0,180") == of("angle at=0,0 between=0,pi")


def test_units_do_not_matter_only_lengths(problem):
    """40 cm, drawn beside a length of 1 m."""
    svg = drawn(chapter(problem("length from=0,0 to=L,0\nlength from=0,1 to=1,1"))).svg
    starts = [float(piece.partition("L")[2].split()[0]) for piece in svg.split('d="M')[1:]]
    assert max(starts) / min(each for each in starts if each > 50) == pytest.approx(2.5, rel=0.1)


def test_a_curve_follows_its_formula(problem):
    svg = drawn(chapter(problem("curve through=(s,sin(pi*s)) over=s,0,1"))).svg
    path = svg.partition('d="M')[2].partition('"')[0]
    points = [tuple(map(float, each.split())) for each in path.split("L")]
    assert len(points) == 41
    assert max(points, key=lambda each: -each[1]) == points[20]


def test_brackets_stand_in_brackets(problem):
    """45 degrees, however it is written."""
    one, other = (
        drawn(chapter(problem(f"floor\nray through=(0,0),({x},1)"))).svg
        for x in ("1", "1*tan(asin(sin(atan(abs(-1)))))")
    )
    assert one == other


@pytest.mark.parametrize(
    ("figure", "line", "words"),
    [
        ("blok A at=0,0", 0, "there is no `blok`; is `block` meant?"),
        ("floor\nblock A at=0,0 mass=3", 1, "block takes no mass=; it takes along=, at=, on=, size=, turn="),
        ("block A at=0", 0, "at=0 is not a place; write two coordinates, at=0,h, or a name, at=A.top"),
        ("block A at=0,q", 0, "q is not among the letters here (L, m, theta, v)"),
        ("block A at=L,v", 0, "at=v does not measure the same as L"),
        ("block A at=0,0 dahsed", 0, "`dahsed` is neither a name nor known of block; is `dashed` meant?"),
        ("arrow from=0,0 by=v,m", 0, "the components measure different things"),
        ("arrow from=0,0 by=v", 0, "by takes 2 numbers, by=v,0"),
        ("block A at=0,L+m", 0, "cannot be added"),
        ("angle at=0,0 between=0,L", 0, "is not an angle"),
        ('block A at=0,0 "open', 0, "texts stand in double quotes"),
        ('floor "a" "b"', 0, "floor takes 1 text, here are 2"),
        ("block A at=0,0 at=1,1", 0, "at= is given twice"),
        ("curve through=(m,m) over=m,0,1", 0, "a letter that is not a given"),
        ("ball A at=0,0\nball A at=1,0", 1, "two things here are called A"),
        ("panel left right", 0, "a panel has a title"),
        ('floor\n\nblock A at=0,0 "{{q}}"', 2, "{{q}} is not among the givens"),
    ],
)
def test_complaints_name_line_and_remedy(problem, figure, line, words):
    with pytest.raises(Malformed) as caught:
        problem(figure)
    (complaint,) = caught.value.complaints
    assert words in complaint.sentence
    assert complaint.line == FIRST + line


@pytest.mark.parametrize(
    ("figure", "line", "words"),
    [
        ("floor\narrow Q by=v,0", 1, "nothing here is called Q"),
        ("ball at=0,L/(1-m/m)", 0, "a formula has no value with these numbers"),
    ],
)
def test_what_cannot_be_drawn_names_its_line(problem, figure, line, words):
    with pytest.raises(BadFigure, match=words) as caught:
        drawn(chapter(problem(figure)))
    assert caught.value.line == line


def test_comments_and_blank_lines(problem):
    assert drawn(chapter(problem('# a cart\n\nblock A at=0,0 "#1" # it'))).alt == "A block A: #1."


def test_letters_may_be_called_otherwise_in_formulas():
    figure = 'ball v at=v,2*v_0 "v = {{v}}"\narrow v by=(v+1)*m,0\nline from=v.top to=v'
    assert in_letters(figure, {"v": "w", "m": "M"}) == (
        'ball v at=w,2*v_0 "v = {{v}}"\narrow v by=(w+1)*M,0\nline from=v.top to=v'
    )


def test_there_is_a_word_for_everything_that_is_taken():
    from corollary.figure.drawing_sheet import WORDS

    assert {word for each in PRIMITIVES.values() for word in each.words} <= WORDS.keys()
