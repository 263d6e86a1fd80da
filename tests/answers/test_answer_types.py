"""Every kind of question: how an answer is read, and what its own samples are."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from corollary.answers.answer import Blank, Chain, Formulas, Letter, Numbers, Prose, Unclear
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type, judging
from corollary.formula.value import Complex, Exact, Items, Measured, Nothing, Real, Refused, Text
from corollary.problem.part import Option
from corollary.problem.reader import read_problem
from corollary.units.unit import unit

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
VALUE = PROBLEM.part("a")
PLANE = replace(VALUE, answer_types=("vector",), components=("x", "y"))
LINE = replace(PLANE, components=("A", "B", "C"))
FORMULA = replace(VALUE, answer_types=("expression",))
LETTER = replace(VALUE, answer_types=("choice",), options=(Option("a", "one"), Option("b", "two")))
OWN = replace(PLANE, answer_types=("example",))
PROOF = replace(VALUE, answer_types=("proof",), components=("p",))
WORDS = replace(VALUE, answer_types=("explain",))


def read(given, part=VALUE):
    return answer_type(part.answer_type).read(given, question_of(PROBLEM, part))


def items(*each):
    return Items(tuple(Text(one) if isinstance(one, str) else Real(one) for one in each), (len(each),))


@pytest.mark.parametrize(
    ("given", "value", "figures"),
    [
        (Text("8.6 kg m/s"), 8.6, 2),
        (Text("8,60 Ns"), 8.6, 3),
        (Text("p = 8.6 kg m/s"), 8.6, 2),
        (Text("8600 g m/s"), 8.6, 2),
        (Text("31 kg km/h"), 31 / 3.6, 2),
        (Real(8.6), 8.6, 2),
        (Real(8.612345678), 8.612345678, 0),
        (Exact(Fraction(43, 5)), 8.6, 0),
        (Exact(Fraction(8)), 8.0, 1),
        (Complex(8.6, 0.0), 8.6, 2),
        (Measured(8.6, "kg*m/s"), 8.6, 2),
        (items(8.6), 8.6, 2),
        (Items((items(8.6),), (1, 1)), 8.6, 2),
        (Exact(Fraction(10) ** 400), math.inf, 0),
        (Exact(-(Fraction(10) ** 400)), -math.inf, 0),
        (Exact(Fraction(2 * 10**8)), 2e8, 2),
        (Exact(Fraction(3 * 10**9)), 3e9, 0),
        (Real(-0.0), 0.0, 0),
    ],
)
def test_one_quantity(given, value, figures):
    found = read(given)
    assert isinstance(found, Numbers)
    assert found.values == pytest.approx((value,), rel=1e-15)
    assert found.figures == (figures,)
    assert not found.missing
    assert not found.misfit


def test_a_unit_that_is_missing_or_another_one_is_said():
    missing, other, none = read(Text("8.6")), read(Text("8.6 J")), read(Text("0"))
    assert isinstance(missing, Numbers)
    assert missing.missing == "taken in kg m/s; better write 8.6 kg m/s"
    assert isinstance(other, Numbers)
    assert "is an energy" in other.misfit
    assert isinstance(none, Numbers)
    assert not none.missing


@pytest.mark.parametrize("part", [VALUE, PLANE, FORMULA, LETTER, OWN, PROOF, WORDS])
@pytest.mark.parametrize("given", [Nothing(), Text(""), Text("..."), Text("  ")])
def test_nothing_is_blank(part, given):
    assert isinstance(read(given, part), Blank)


@pytest.mark.parametrize(
    ("part", "given", "why"),
    [
        (VALUE, Real(math.nan), "not a number"),
        (VALUE, Real(math.inf), "infinite"),
        (VALUE, Complex(1.0, 1.0), "complex"),
        (VALUE, items(1.0, 2.0), "one number"),
        (VALUE, Text("rather a lot"), ""),
        (VALUE, Text("8.6 furlong"), "furlong"),
        (VALUE, Text("3 m - 4 s"), ""),
        (VALUE, Refused("it is a set", "{…}"), "a set"),
        (VALUE, Text("m + v"), ""),
        (PLANE, Real(1.0), "list"),
        (PLANE, items(1.0), "2 components"),
        (PLANE, items(1.0, math.nan), "not a number"),
        (PLANE, Items((items(1.0, 2.0), items(3.0, 4.0)), (2, 2)), "table"),
        (PLANE, Items((Real(1.0), Nothing()), (2,)), "missing"),
        (FORMULA, Real(1.0), "formula"),
        (FORMULA, Text("m*v*"), ""),
        (FORMULA, Text("m*v^2"), "not in"),
        (FORMULA, Text("m + v"), ""),
        (FORMULA, Text("2"), "this is a number"),
        (LETTER, Text("c"), "one letter"),
        (LETTER, Real(1.0), "one letter"),
        (OWN, items("m*v", "0"), "not formulas"),
        (OWN, items("1 J", "2 J"), "energy"),
        (PROOF, Text("p"), "one = sign"),
        (PROOF, Text("p + m*v"), "one = sign"),
        (PROOF, Text("the mass * the speed"), "one = sign"),
        (PROOF, Text("mass > 0"), "one = sign"),
        (PROOF, Text("so it is"), "equation"),
        (PROOF, Text("\n".join(["p = m*v"] * 61)), "more than 60"),
        (PROOF, Real(1.0), "equations"),
        (WORDS, Real(1.0), "text is asked for"),
    ],
)
def test_what_cannot_be_read_says_why(part, given, why):
    found = read(given, part)
    assert isinstance(found, Unclear), found
    assert why in found.why
    assert found.why


@pytest.mark.parametrize(
    ("given", "values"),
    [
        (items(3.0, 4.0), (3, 4)),
        (Text("(3, 4) kg m/s"), (3, 4)),
        (Text("3 Ns; 4 Ns"), (3, 4)),
        (Text("(3; 4,5) kg m/s"), (3, 4.5)),
        (Text("3 i - 4 j kg m/s"), (3, -4)),
        (items("3 kg m/s", "4 kg m/s"), (3, 4)),
        (Items((items(3.0), items(4.0)), (2, 1)), (3, 4)),
        (Text("5 kg m/s at 90 deg"), (0, 5)),
        (items("5 kg m/s", "180 deg"), (-5, 0)),
        (items("5 kg m/s", "1.5 rad"), (5 * math.cos(1.5), 5 * math.sin(1.5))),
        (Text("(-3, 4) kg m/s, x to the left"), (3, 4)),
        (Text("(-3, -4) kg m/s; x to the left, y down"), (3, 4)),
        (Text("(3, 4) kg m/s, x to the right, y up"), (3, 4)),
        (Text("(3, -4) kg m/s (y reversed)"), (3, 4)),
        (Text("(-3, -4) kg m/s with positive reversed"), (3, 4)),
        (Text("(-3, 4) kg m/s, positive to the left"), (3, 4)),
        (Text("5 kg m/s at 90 deg, y down"), (0, -5)),
        (items("y = 4 Ns", "x = 3 Ns"), (3, 4)),
        (items("p_y = 4 Ns", "p_x = 3 Ns"), (3, 4)),
        (items("x = 3 Ns", "4 Ns"), (3, 4)),
    ],
)
def test_a_vector(given, values):
    found = read(given, PLANE)
    assert isinstance(found, Numbers), found
    assert found.values == pytest.approx(values, abs=1e-12)


def test_axes_of_bodies_on_one_line_turn_all_of_them():
    found = read(Text("(-1; 2; 3) kg m/s, positive to the left"), LINE)
    assert isinstance(found, Numbers)
    assert found.values == (1, -2, -3)
    assert found.as_read.endswith("positive to the left")
    assert isinstance(read(Text("(1; 2) kg m/s, z down"), PLANE), Unclear)


def test_axes_turn_formulas_and_readings_but_no_energy():
    turned = read(Text("m*v, x to the left"))
    assert isinstance(turned, Formulas)
    asked = read(Text("1,234 kg m/s, x to the left"))
    assert isinstance(asked, Unclear)
    assert {each.values[0] for each in asked.readings} == {-1.234, -1234.0}
    energy = replace(VALUE, unit=unit("J"))
    assert isinstance(read(Text("3 J, x to the left"), energy), Unclear)


def test_formulas_letters_chains_and_words():
    assert isinstance(read(Text("2mv"), VALUE), Formulas)
    assert isinstance(read(Text("m v"), FORMULA), Formulas)
    mixed = read(items("0", "m*v"), PLANE)
    assert isinstance(mixed, Formulas)
    assert len(mixed.trees) == 2
    assert read(Text("(B)"), LETTER) == Letter("b", "(B)")
    assert isinstance(read(Items((Text("a"),), (1,)), LETTER), Letter)
    chain = read(Text("p = m*v\n\nm*v = p\n"), PROOF)
    assert isinstance(chain, Chain)
    assert [step.line for step in chain.steps] == [1, 3]
    assert read(Text(" so it is "), WORDS) == Prose("so it is")


@pytest.mark.parametrize("part", [VALUE, PLANE, FORMULA, LETTER, OWN, PROOF])
@pytest.mark.parametrize(
    "given",
    [
        Text("9" * 500_000),
        Text(" " * 500_000 + "left"),
        Text("(" * 50_000),
        Text("1," * 100_000),
        Text(", x to the left" * 20_000),
    ],
)
def test_long_texts_are_turned_away_with_little_work(part, given, calls_of):
    found = read(given, part)
    assert calls_of(lambda: read(given, part)) < 2_000
    assert isinstance(found, Unclear)
    assert len(found.as_read) <= 80


def test_lists_in_lists_however_deep():
    deep: Items | Real = Real(8.6)
    for _ in range(5000):
        deep = Items((deep,), (1,))
    found = read(deep)
    assert isinstance(found, Numbers)


@pytest.mark.parametrize(
    ("part", "truth"),
    [
        (VALUE, (8.6,)),
        (VALUE, (0.0,)),
        (PLANE, (3.0, 4.0)),
        (FORMULA, "m*v"),
        (LETTER, "a"),
        (OWN, (3.0, 4.0)),
        (PROOF, "p = m*v\nm = p/v"),
        (WORDS, "So."),
    ],
)
def test_samples_are_read_as_they_are_named(part, truth):
    from corollary.grading.from_json import from_json

    samples = judging(part.answer_type).samples(truth, question_of(PROBLEM, part))
    assert {"unread"} < {sample.verdict for sample in samples}
    for sample in samples:
        found = read(from_json(sample.answer), part)
        assert isinstance(found, (Blank, Unclear)) == (sample.verdict == "unread"), sample


def test_a_machine_number_is_read_with_the_unit_it_needs():
    assert read(Real(8.6)).as_read.split(" ", 1)[1] == "kg m/s"
    assert read(Exact(Fraction(9))).as_read == "9 kg m/s"


def test_words_alone_are_left_to_a_person():
    assert answer_type("explain").preview(
        Text("Gravity pulls it down."), question_of(PROBLEM, VALUE)
    ).text == ("your teacher will read it")


def test_what_is_asked_for_is_said_with_the_names_that_are_wanted():
    """Of a proof its letters, of formulas along axes how many there are and what they are called."""
    assert "and, as said above, `p`" in answer_type("proof").instructions(question_of(PROBLEM, PROOF))
    pair = replace(FORMULA, components=("x", "y"))
    found = read(Real(1.0), pair)
    assert isinstance(found, Unclear)
    assert "a list of 2 formulas is asked for, [x, y], each as text" in found.why


def test_pairs_in_texts_of_a_list_are_opened():
    four = replace(PLANE, components=("A_x", "A_y", "B_x", "B_y"))
    found = read(items("1 Ns; 2 Ns", "(3, 4) Ns"), four)
    assert isinstance(found, Numbers), found
    assert found.values == (1, 2, 3, 4)
    assert isinstance(read(items("1 Ns; 2 Ns", "3 Ns", "4 Ns"), four), Unclear)


def test_headings_and_blanks_say_what_is_asked_for():
    number = answer_type("value")
    assert number.heading(question_of(PROBLEM, VALUE)) == "A number, in kg m/s."
    assert (
        number.heading(question_of(PROBLEM, replace(VALUE, unit=unit("1"))))
        == "A plain number, without a unit."
    )
    blank = answer_type("proof").blank(question_of(PROBLEM, PROOF))
    assert blank.splitlines()[1:] == ['    "",   # one equation a line, each as text: "a + b = c"', "]"]
    assert blank.startswith(question_of(PROBLEM, PROOF).name + " = [")
