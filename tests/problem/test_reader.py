"""A problem file read: what it holds, and every way it may be wrong, with its line."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.units.unit import canonical

CART = "code: X1.1\ntitle: A cart\ngiven:\n"
MASS = "  m: {is: mass, value: 0.5, from: 0.1, to: 0.9, step: 0.1, unit: kg}\n"
SPEED = "  v: {is: speed, value: 3, unit: m/s}\n"
ASKS = "\n## Momentum {#a .value}\nHow much?\n"


def test_what_a_problem_holds(read):
    problem = read(
        CART + MASS + SPEED + "require:\n  - m > 0\nwhere: v != 2 m/s\n", "A cart of {{m}}.\n" + ASKS
    )
    assert (problem.code, problem.prefix, problem.title) == ("X1.1", "X1_1", "A cart")
    assert (problem.name, problem.topic) == ("cart", "carts")
    mass, speed = problem.givens
    assert mass.value == Fraction(1, 2)
    assert [mass.grid[i] for i in range(mass.grid.count)] == [Fraction(i, 10) for i in range(1, 10)]
    assert (speed.grid.count, speed.grid.first, speed.value) == (1, 3, 3)
    assert [(each.text, each.hard, each.line) for each in problem.conditions] == [
        ("v != 2 m/s", False, 9),
        ("m > 0", True, 8),
    ]
    assert problem.statement == "A cart of {{m}}."
    assert problem.part("a").text == "How much?"


def test_a_chapter_value_may_lie_off_the_grid(read):
    problem = read(CART + "  m: {is: mass, value: 1/3, from: 1, to: 2, step: 1/4}\n", "{{m}}" + ASKS)
    assert problem.given("m").value == Fraction(1, 3)
    assert problem.given("m").grid.count == 5


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ("  m: 0.5", "m must be a table"),
        ("  m: {value: 1}", "m has no `is`"),
        ("  m: {is: mass}", "m has no `value`"),
        ("  m: {is: mass, value: }", "`value` of m is empty"),
        ("  m: {is: , value: 1}", "`is` of m is empty"),
        ("  m: {is: mass, value: 1, unit: }", "`unit` of m is empty"),
        ("  m: {is: mass, value: no}", "not a number"),
        ("  m: {is: mass, value: 1:30}", "not a number"),
        ("  m: {is: mass, value: [1]}", "must be one value"),
        ("  m: {is: mass, value: 1, unit: furlong}", "unit of m"),
        ("  m: {is: mass, value: 1, form: 2}", "`form` of m is not known"),
        ("  m: {is: mass, value: 1, from: 1, to: 2}", "all of from, to and step"),
        ("  m: {is: mass, value: 1, from: 2, to: 1, step: 1}", "from must not exceed to"),
        ("  m: {is: mass, value: 1, from: 1, to: 2, step: 0}", "step be positive"),
        ("  m: {is: mass, value: 1, from: 1, to: 2, step: 0.3}", "does not reach `to`"),
        ("  2m: {is: mass, value: 1}", "is not a symbol"),
        ("  pi: {is: mass, value: 1}", "meaning of its own"),
        ("  lambda: {is: length, value: 1}", "meaning of its own"),
        ("  sin: {is: length, value: 1}", "sin is a function in formulas; call it sin_1"),
        ("  gamma: {is: angle, value: 1}", "gamma is a function in formulas; call it gamma_1"),
    ],
)
def test_a_given_that_will_not_do(complaints, row, words):
    found = complaints(CART + SPEED + row, "{{v}}" + ASKS)
    assert any(line == 6 and words in sentence for line, sentence in found)


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("- m", "is not a comparison"),
        ("- m >", "condition 'm >'"),
        ("- m > q", "q is not among the givens (m)"),
        ("- 1 > 2", "contains none of the givens"),
        ("- [m > 0]", "must be one relation"),
        ("- m > 0 > -1", "condition"),
        ("- __import__('os') > m", "condition"),
    ],
)
def test_a_condition_that_will_not_do(complaints, condition, words):
    ((line, sentence),) = complaints(CART + MASS + f"where:\n  {condition}", "{{m}}" + ASKS)
    assert line == 7
    assert words in sentence


@pytest.mark.parametrize(
    ("front", "line", "words"),
    [
        ("title: A cart", 2, "the front matter has no `code`"),
        ("code: X1.1", 2, "the front matter has no `title`"),
        ("code:\ntitle: A cart", 2, "`code` of the front matter is empty"),
        ("code: X 1/1\ntitle: A cart", 2, "is not a valid code"),
        ("code: X1.1\ntitle: A {{m}} cart", 3, "has a hole"),
        (
            "code: X1.1\ntitle: A cart\ngivens: {}",
            4,
            "`givens` of the front matter is not known (did you mean given?); known are alt, author, code",
        ),
        ("code: X1.1\ntitle: A cart\ngiven: []", 4, "must hold `name: value` lines"),
        ("code: X1.1\ntitle: A cart\nwhere: {a: 1}", 4, "must be a list"),
        ("code: X1.1\ntitle: A cart\nfigure: <svg/>", 4, "has no `alt`"),
        (
            "code: X1.1\ntitle: A cart\nfigure: |\n  <svg>\n  {{q}}</svg>\nalt: A cart.",
            6,
            "{{q}} is not among the givens",
        ),
        (
            "code: X1.1\ntitle: A cart\nfigure: <svg/>\nalt: A cart of {{q}}.",
            5,
            "{{q}} is not among the givens",
        ),
    ],
)
def test_a_front_that_will_not_do(complaints, front, line, words):
    ((at, sentence),) = complaints(front, ASKS)
    assert words in sentence
    assert at == line


def test_holes(complaints):
    found = complaints(CART + MASS, "One of {{tau}},\ntwo of {{m|decimal}},\nthree of {{2 m}}.\n" + ASKS)
    assert found == [
        (7, "{{tau}} is not among the givens (m)"),
        (8, "{{m|decimal}}: the styles are number and svg, or how many figures (1 to 15)"),
        (
            9,
            "{{2 m}}: formula '2 m', at character 3: a product sign is missing here; write * for every product",
        ),
    ]


def test_every_complaint_is_made_at_once_in_the_order_of_the_lines(complaints):
    found = complaints("title: A cart\ngiven:\n  m: 1\n  v: 2\n", "{{x}}\n\n## A {.value}\n")
    assert [line for line, _ in found] == sorted(line for line, _ in found)
    assert len(found) == 6


def part(read, attributes: str, text: str = "How much?", title: str = "A part"):
    return read(CART + MASS, f"{{{{m}}}}\n\n## {title} {{{attributes}}}\n{text}\n").parts[0]


def test_a_part(read):
    found = part(read, '#c_2 .vector unit="kg*m/s" components="x y" points=2.5')
    assert (found.id, found.answer_type, found.points, found.components, found.line) == (
        "c_2",
        "vector",
        2.5,
        ("x", "y"),
        9,
    )
    assert canonical(found.unit) == "kg*m/s"


@pytest.mark.parametrize("title", [r"Mean force $\bar{F}$", r"$\frac{a}{b}$", "A set {1, 2}", "Plain"])
def test_a_title_may_hold_braces(read, title):
    found = part(read, "#c .value points=2", title=title)
    assert (found.title, found.points) == (title, 2.0)


def test_a_choice_has_its_options(read):
    found = part(read, "#a .choice", "Which?\n\n- (a) this, $x_{1}$\n- (b) that\n")
    assert [(option.letter, option.text) for option in found.options] == [
        ("a", "this, $x_{1}$"),
        ("b", "that"),
    ]
    assert found.text == "Which?"


def test_code_and_plot_go_together(read):
    found = part(read, '#a .code .plot function="motion(N, m)"')
    assert found.answer_types == ("code", "plot")
    assert found.function == "motion"


def test_a_heading_in_a_program_is_no_part(read):
    found = part(read, "#a .value", "Look:\n```python\n## Not a part {#b .value}\n```\n")
    assert "## Not a part" in found.text


@pytest.mark.parametrize(
    ("heading", "words"),
    [
        ("## No attributes", "needs attributes"),
        (r"## Only $\bar{F}$", "needs attributes"),
        ("## A {.value}", "needs one id"),
        ("## A {#A .value}", "needs one id"),
        ("## A {#a #b .value}", "needs one id"),
        ("## A {#a .value points=many}", "points=many"),
        ("## A {#a .value points=-1}", "points=-1"),
        ("## A {#a .value points=nan}", "points=nan"),
        ("## A {#a .value unit=furlong}", "unit of part a"),
        ("## A {#a .value marks=2}", "unknown attribute marks"),
        ("## A {#a .value 'x'}", "cannot read"),
        ("## A {#a .choice}\n- (a) one\n- (a) two", "letter twice"),
        ("## A {{m}} {#a .value}", "has a hole"),
    ],
)
def test_a_part_that_will_not_do(complaints, heading, words):
    found = complaints(CART + MASS, "{{m}}\n\n" + heading + "\n")
    assert any(words in sentence and line == 9 for line, sentence in found)


def test_two_parts_of_one_name(complaints):
    ((line, sentence),) = complaints(CART + MASS, "{{m}}\n\n## A {#a .value}\n\n## B {#a .value}\n")
    assert line == 11
    assert "part a occurs twice" in sentence


def test_a_problem_that_asks_nothing(complaints):
    ((_, sentence),) = complaints(CART + MASS, "A cart of {{m}}.\n")
    assert "asks nothing" in sentence
