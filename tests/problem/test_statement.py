"""What stands in the holes of a statement: givens, arithmetic of givens, units asked for, words; and what is said of a hole that will not do."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.answers.questions import question_of
from corollary.api import key, load_bank, solve, variant
from corollary.derive.load import NotDerivable
from corollary.problem.reader import read_problem
from corollary.problem.statement import filled, renamed
from corollary.problem.variant import OutOfRange, at, chapter, index_of, size

FRONT = """\
code: X1.1
title: A cart
given:
  m: {is: mass, value: 0.50, from: 0.25, to: 2.00, step: 0.25, unit: kg}
  v: {is: speed, in: [3, 1.5, 8], unit: m/s}
  theta: {is: slope, value: 30, unit: deg}
  body: {is: what rolls, in: [a cart, a sledge]}
"""
PART = '\n## Momentum {#a .value unit="kg*m/s"}\nHow large?\n'


@pytest.mark.parametrize(
    ("hole", "text"),
    [
        ("{{m}}", "0.50 kg"),
        ("{{2*m}}", "1.00 kg"),
        ("{{m in g}}", "500 g"),
        ("{{ m in g | number }}", "500"),
        ("{{m*v}}", "1.5 kg m/s"),
        ("{{-m|svg}}", "-0.50"),
        ("{{-m}}", "−0.50 kg"),
        ("{{m/3}}", "0.1667 kg"),
        ("{{m/3|2}}", "0.17 kg"),
        ("{{v in km/h}}", "10.8 km/h"),
        ("{{2*theta}}", "60°"),
        ("{{theta in rad|3}}", "0.524 rad"),
        ("{{m*v^2/2}}", "2.25 J"),
        ("{{sqrt(v^2)}}", "3.0 m/s"),
        ("{{2 + 1}}", "3"),
        ("{{body}}", "a cart"),
    ],
)
def test_what_a_hole_may_hold(read, hole, text):
    problem = read(FRONT, f"{hole} rolls.\n{PART}")
    assert filled(problem.statement, chapter(problem)).replace("\N{NO-BREAK SPACE}", " ") == f"{text} rolls."


@pytest.mark.parametrize(
    ("hole", "words"),
    [
        ("{{q}}", "{{q}} is not among the givens (body, m, theta, v)"),
        ("{{2*q}}", "{{q}} is not among the givens"),
        ("{{m + v}}", "cannot be added"),
        ("{{m in s}}", "m is not in s"),
        ("{{m in furlong}}", "furlong is not a unit"),
        ("{{2 m}}", "write * for every product"),
        ("{{m < 2*m}}", "compares"),
        ("{{m|bold}}", "the styles are number and svg, or how many figures"),
        ("{{m|99}}", "the styles are number and svg, or how many figures"),
        ("{{body in kg}}", "body is a word, which has no unit"),
        ("{{2*body}}", "body is a word, with which nothing can be worked out"),
        ("{{m|}}", "a hole holds a given, or arithmetic of givens"),
    ],
)
def test_what_is_said_of_a_hole_that_will_not_do(complaints, hole, words):
    ((line, sentence),) = complaints(FRONT, f"{hole} rolls.\n{PART}")
    assert line == 10
    assert words in sentence


def test_letters_are_renamed_in_arithmetic_too():
    text = "{{m*v in g}} m {{ m | number }} {{2*m1 - m}} {{1e3*e}}"
    assert renamed(text, {"m": "M", "v": "m", "g": "x", "e": "q"}) == (
        "{{M*m in g}} m {{ M | number }} {{2*m1 - M}} {{1e3*q}}"
    )


def test_a_list_is_drawn_from_and_nothing_else(read):
    problem = read(FRONT, f"{{{{body}}}} rolls.\n{PART}")
    assert size(problem) == 8 * 3 * 2
    variants = [at(problem, index) for index in range(size(problem))]
    assert {each.values["v"] for each in variants} == {Fraction(3), Fraction(3, 2), Fraction(8)}
    assert {filled(problem.statement, each) for each in variants} == {"a cart rolls.", "a sledge rolls."}
    assert [index_of(problem, each.values) for each in variants] == list(range(size(problem)))
    assert index_of(problem, {**variants[0].values, "v": Fraction(2)}) is None
    assert chapter(problem).values["v"] == 3
    assert problem.given("v").sign == 1
    assert problem.given("v").grid.last == 8


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ("{is: mass, in: [1], unit: kg}", "list at least two different values"),
        ("{is: mass, in: [1, 1], unit: kg}", "list at least two different values"),
        ("{is: mass, in: [1, heavy], unit: kg}", "lists numbers and words"),
        ("{is: mass, in: [light, heavy], unit: kg}", "lists words, which have no unit"),
        ("{is: mass, in: [1, 2], value: 3, unit: kg}", "value: 3 of m is not in its list (1, 2)"),
        ("{is: mass, in: [1, 2], from: 1, unit: kg}", "`from` of m is not known"),
        ("{is: mass, in: [1, 2], unit: stone}", "stone"),
    ],
)
def test_what_is_said_of_a_list_that_will_not_do(complaints, row, words):
    front = f"code: X1.1\ntitle: A cart\ngiven:\n  m: {row}\n"
    assert any(line == 5 and words in sentence for line, sentence in complaints(front, f"{{{{m}}}}\n{PART}"))


def test_a_word_is_set_by_name_and_a_formula_does_not_know_it(write, tmp_path):
    write(FRONT, f"{{{{body}}}} of {{{{m}}}} rolls at {{{{v}}}} down {{{{theta}}}}.\n{PART}")
    solution = tmp_path / "solutions" / "carts" / "cart.py"
    solution.parent.mkdir(parents=True)
    solution.write_text(
        "from corollary.author import *\nfrom corollary.laws import *\n\ndef derive(m, v):\n    p, = unknowns('p')\n"
        "    return derivation(step(p, 'So.', momentum(p, m, v), answers='a'))\n"
    )
    problem = load_bank(tmp_path)["X1.1"]
    assert variant(problem, {"body": "a sledge"}).values["body"] == 1
    assert key(problem, body="a sledge", m="2 kg").truths["a"].values == (6.0,)
    with pytest.raises(OutOfRange, match="body=a train: say one of a cart, a sledge"):
        variant(problem, {"body": "a train"})
    assert "body" not in {symbol.name for symbol in question_of(problem, problem.part("a")).symbols}
    solution.write_text(solution.read_text().replace("derive(m, v)", "derive(m, v, body)"))
    with pytest.raises(NotDerivable, match="derive takes body"):
        solve(load_bank(tmp_path)["X1.1"])


def test_powers_of_ten_are_printed_as_in_a_book(write):
    front = (
        "code: X1.1\ntitle: A star\ngiven:\n  M: {is: mass, value: 1.99e30, unit: kg}\n"
        "  a: {is: expansion, value: 1.20e-5, unit: 1/K}\n  n: {is: number, value: 1e15}\n"
    )
    path = write(
        front,
        f"{{{{M}}}}, {{{{a}}}}, {{{{n}}}}; $M = {{{{M}}}}$; `M = {{{{M|number}}}}` {{{{M|svg}}}}\n{PART}",
    )
    problem, gap = read_problem(path), "\N{NO-BREAK SPACE}"
    assert filled(problem.statement, chapter(problem)) == (
        f"1.99{gap}·{gap}10³⁰{gap}kg, 1.20{gap}·{gap}10⁻⁵{gap}1/K, 10¹⁵; "
        f"$M = 1.99 \\cdot 10^{{30}}{gap}kg$; `M = 1.99e30` 1.99e30"
    )
