"""The words of a problem: right sentences of clumsy authors, and what is found in wrong ones."""

from __future__ import annotations

from pathlib import Path

import pytest

from corollary.problem.diagnostic import Malformed
from corollary.problem.reader import read_problem
from corollary.verify.checked import Tally
from corollary.verify.words.asked_sign import asks_for_magnitude
from corollary.verify.words.check_words import check_words, unread, unread_of_all

HEAD = """\
---
code: W1
title: Words
{more}given:
  v: {{is: speed of the car, value: 50, from: 30, to: 90, step: 1, unit: km/h}}
  m: {{is: mass of the sample, value: 2, from: 1, to: 9, step: 0.5, unit: kg}}
  t: {{is: time of heating, value: 10, from: 5, to: 60, step: 1, unit: s}}
  h: {{is: height of the tank, value: 20, from: 10, to: 40, step: 1, unit: m}}
  T: {{is: temperature of the bath, value: 25, from: 10, to: 60, step: 1, unit: degC}}
  c: {{is: concentration of the acid, value: 0.50, from: 0.1, to: 1, step: 0.05, unit: mol/l}}
  eta: {{is: efficiency, value: 80, from: 50, to: 95, step: 1, unit: "%"}}
  n: {{is: number of coils, value: 200, from: 100, to: 900, step: 10, unit: 1}}
  theta: {{is: angle of the ramp, value: 30, from: 10, to: 60, step: 1, unit: deg}}
  g: {{is: gravity, value: 9.81, unit: m/s^2}}
---
{statement}

## Asked {{#a .value unit="{unit}"}}
{asked}
"""
HOLES = (
    "{{v}} {{m}} {{t}} {{h}} {{T}} {{c}} {{eta}} {{n}} {{theta}} {{g}}"  # so that each has its hole somewhere
)


def complaints(
    folder: Path, statement: str = "", asked: str = "What is it?", unit: str = "N", more: str = ""
) -> list[str]:
    path = folder / "words.md"
    text = HEAD.format(statement=f"{HOLES}\n\n{statement}", asked=asked, unit=unit, more=more)
    path.write_text(text, encoding="utf-8")
    tally = Tally()
    check_words(read_problem(path), tally)
    return tally.complaints


RIGHT = {  # sentence, question, unit
    "a year": ("The reactor of 1954 is still in use.", "What is the force?", "N"),
    "a count": ("Two of 50 students, 2 balls and 10 trucks take part.", "What is the force?", "N"),
    "an exponent": (
        "The field goes with $r^{-2}$, and $10^{50}$ atoms; x_2 and m2 are others.",
        "Which?",
        "N",
    ),
    "a coefficient": (
        "Let $E = 2 m v^2$ and $F = 50 x$ in this model, where 2R is a diameter.",
        "Which?",
        "N",
    ),
    "a list": ("1. Heat it.\n2. Cool it.\n10. Weigh it.", "What is the force?", "N"),
    "a reference": ("See Figure 2, Section 20.1 and Table 50, eq. (25), exercise 10.", "Which force?", "N"),
    "a formula": ("The water (H2O, 2 H+ per molecule, CO2, pH 2) is in the tank.", "What is the force?", "N"),
    "standard conditions": ("Densities are at 20 °C and 1013 hPa; the air is at 101 325 Pa.", "Which?", "N"),
    "an example": ("Give a text such as 30 deg, or for example 50 km/h.", "Which angle?", "deg"),
    "a typed answer": ('Write "25 °C" with its unit.', "Which temperature?", "degC"),
    "a name": ("The A50 motorway, the steel S235, the M10 bolt and the IPE 200 beam.", "Which load?", "N"),
    "a ratio": ("In a 1:2 mixture, 1/2 of it, 3/2 of that; a 2 to 1 vote.", "What is the force?", "N"),
    "a constant": ("Use g = {{g}} and 4.18 kJ/(kg K) for water, and 1 mol/l as a standard.", "Which?", "N"),
    "another quantity": ("It is 10 m long and lasts 20 s, at 2 V and 50 N.", "Which force?", "N"),
    "a permitted unit": ("Take care.", "What is it? (You may write it in kN.)", "N"),
    "its own unit": ("Give all forces in kN.", "How large is it, in kN?", "kN"),
    "a point": ("A cart goes from A to B.", "What is the velocity in A, seen in S?", "m/s"),
    "a number of turns": ("It turns.", "How many turns does it make?", "1"),
    "times": ("It is heavier.", "How many times as large is it? Answer in one word: in a number.", "1"),
    "a range": ("Pick anything from 5 to 60, in steps of 1.", "What is the force?", "N"),
    "a quantity asked for beside a share": ("It fades.", "After what time is {{eta}} of it left?", "s"),
    "a bolt": ("Two M8 bolts of grade 8.8 hold the flange DN 50, see ISO 2768.", "Which load?", "N"),
    "zero": ("At $t = 0$ it is at rest, and $v = 0$; for $t > 10$ nothing is known.", "Which?", "N"),
    "a product": ("HEB 200 of steel S355, T 200, Apollo 10, $^{200}$Hg with mass number 200.", "Which?", "N"),
    "its own unit, the nearest": ("It moves.", "How large is it, to the nearest newton?", "N"),
    "a whole number": ("It goes to the nearest wall.", "Which force, to the nearest whole number?", "N"),
    "a price": ("It costs 50 € per ton; on 10 May 2020 at 10:50 it was 50:50.", "What is the force?", "N"),
    "an age": ("The 10-year-old twin (age 20) has 2 of 50 coins; in half of 50 cases.", "Which?", "N"),
    "figures": ("Use 2 significant figures and 10 decimals, π = 3.14.", "What is the force?", "N"),
    "a difference": ("It warms up.", "By how many degrees Celsius does it warm?", "K"),
    "a share of speed": ("It moves.", "What is v in m/s after 2 km in 3 min?", "m/s"),
    "letters behind numbers": ("It is 2 t later, and 2 d apart, in 50 t or 50 d.", "What is the force?", "N"),
    "in German words": ("Im Jahr 2010 wurden 50 Autos in 2 Tagen geprüft.", "Welche Kraft?", "N"),
}


@pytest.mark.parametrize(("hole", "found"), [("{{M}}", 0), ("{{v}}", 1)])
def test_a_molar_mass_may_be_called_a_mass_and_a_speed_may_not(tmp_path, hole, found):
    text = HEAD.format(
        statement=f"{HOLES} {{{{M}}}}\n\nAn acid of molar mass {hole}.",
        asked="What is it?",
        unit="N",
        more="",
    )
    given = (
        "given:\n  M: {is: molar mass of the acid, value: 98.1, from: 60, to: 120, step: 0.1, unit: g/mol}"
    )
    (tmp_path / "words.md").write_text(text.replace("given:", given, 1), encoding="utf-8")
    tally = Tally()
    check_words(read_problem(tmp_path / "words.md"), tally)
    assert ["which hole is meant" in each for each in tally.complaints] == [True] * found


@pytest.mark.parametrize("name", RIGHT)
def test_right_sentences_are_let_pass(tmp_path, name):
    assert complaints(tmp_path, *RIGHT[name]) == []


TYPED = (
    "at 50 km/h along",
    "at 50km/h along",
    "at 50 along",
    "at $50$ km/h along",
    r"at $50\,\mathrm{km/h}$ along",
    r"at $v = 50\;\text{km/h}$ along",
    r"at \qty{50}{km/h} along",
    "at 50.0 km/h along",
    "at 50,0 km/h along",
    "at 13.9 m/s along",
    "at fifty kilometers per hour along",
    "a 2-kg sample",
    "a sample of 2000 g",
    "a sample of 0.002 t",
    "a sample of 2 kg as before",
    "at 50 km/h at first",
    "a sample of 2 000 g",
    "a sample of 2,000 g",
    "a mass of 2 is put in",
    "a tank of 2e3 cm",
    r"a tank of $2\cdot10^{3}$ cm",
    "a tank of 2·10³ cm",
    "a bath at 25 °C",
    r"a bath at $25\,^{\circ}\mathrm{C}$",
    "a bath at 298.15 K",
    "an acid of 0.5 mol/l",
    "an acid of 0.5 mol per liter",
    "an efficiency of 80 %",
    "an efficiency of 80 per cent",
    "a ramp at 30°",
    r"a ramp at $30^\circ$",
    "200 coils",
    "it takes 10 seconds",
)


@pytest.mark.parametrize("words", TYPED)
def test_a_given_typed_as_text_is_found(tmp_path, words):
    (said,) = complaints(tmp_path, f"There is, beside others, {words}.")
    assert said.startswith("words.md:18: the statement says ")
    assert "or, where this number is meant for everybody, list it: meant: [" in said


@pytest.mark.parametrize("meant", ["[50 km/h]", '["50 km/h", 12]', "[50km/h]"])
def test_the_author_says_that_a_number_is_meant(tmp_path, meant):
    assert complaints(tmp_path, "In towns 50 km/h is the limit.", more=f"meant: {meant}\n") == []
    assert complaints(tmp_path, "In towns 50 km/h is the limit.", more="meant: [60 km/h]\n")


def test_what_is_meant_has_a_number(tmp_path):
    with pytest.raises(Malformed, match="meant: lists numbers as they stand in the words"):
        complaints(tmp_path, more="meant: [speed]\n")


@pytest.mark.parametrize(
    ("asked", "unit", "found"),
    [
        ("What is the force, to the nearest kilonewton?", "N", "asks for kilonewton, and a bare number"),
        (
            "What is the force? Round to the nearest kN.",
            "N",
            "asks for kN, and a bare number of part a is in N",
        ),
        ("Wie groß ist die Kraft, auf das nächste kN?", "N", "asks for kN"),
        ("Welche Kraft, auf ganze kN gerundet?", "N", "asks for kN"),
        ("Hvor stor er kraften, til nærmeste kN?", "N", "asks for kN"),
        ("What is the force, in kN?", "N", "asks for kN, and a bare number of part a is in N"),
        ("What is the force (kN)?", "N", "asks for kN"),
        ("What is it? Answer: ____ kN", "N", "asks for kN"),
        ("Give the length in centimetres.", "m", "asks for centimetres"),
        ("What is the area in square centimetres?", "m^2", "asks for square centimetres"),
        ("How many minutes does it take?", "s", "asks for minutes"),
        ("How many minutes does it take?", "m", "which measures something else"),
        ("How warm is it (in °C)?", "K", "asks for °C"),
        ("What is the rate in l/min?", "m^3/s", "asks for l/min"),
        ("Gib die Länge in Zentimetern an.", "m", "asks for Zentimetern"),
        ("Oppgi svaret i kilometer.", "m", "asks for kilometer"),
    ],
)
def test_a_unit_in_the_words_that_the_part_does_not_have(tmp_path, asked, unit, found):
    (said,) = complaints(tmp_path, "", asked, unit)
    assert said.startswith("words.md:21: part a ")
    assert found in said


@pytest.mark.parametrize(
    ("text", "language", "words"),
    [
        ("How large is the force?", "en", "How large"),
        ("What is the magnitude of it?", "en", "magnitude"),
        ("How fast is A afterwards?", "en", "How fast"),
        ("Find the distance between them.", "en", "Find the distance"),
        ("At what speed does it land?", "en", "At what speed"),
        ("What is the common speed of block and bullet?", "en", "What is the common speed"),
        ("How much energy is lost?", "en", "How much energy is lost"),
        ("Wie schnell ist der Wagen?", "de", "Wie schnell"),
        ("Hvor langt kommer den?", "nb", "Hvor langt"),
        ("How large is it? Mind the sign.", "en", ""),
        ("How fast does it go? A negative number is a motion to the left.", "en", ""),
        ("By how much does the energy change?", "en", ""),
        ("What is the velocity of A?", "en", ""),
        ("What is the speed of light in glass?", "en", ""),
        ("Wie groß ist die Änderung?", "de", ""),
    ],
)
def test_what_asks_for_a_magnitude(text, language, words):
    assert asks_for_magnitude(text, language) == words


NEGATIVE = """\
return derivation(
    step(p, "Less.", law("Difference", "p = m*v - 2*m*v"), answers="a"),
    step(F, "Per time.", mean_force(F, p, t), answers="b"),
)
"""


def test_a_magnitude_that_is_negative_for_some_numbers(verified, problem):
    found = [each for each in verified(NEGATIVE, problem=problem).complaints if "has no sign" in each]
    assert [each.split(":")[:2] for each in found] == [["cart.md", "13"], ["cart.md", "16"]]
    assert (
        "part a asks 'How large', which has no sign, and the answer is negative for some numbers ("
        in found[0]
    )


def test_a_question_that_says_the_sign(verified, problem):
    asked = problem.replace("How large?", "How large? Mind the sign.")
    assert not [each for each in verified(NEGATIVE, problem=asked).complaints if "has no sign" in each]


def test_a_negative_answer_in_other_words_is_right(verified, problem):
    asked = problem.replace("How large?", "What is it?")
    assert not [each for each in verified(NEGATIVE, problem=asked).complaints if "has no sign" in each]


def test_what_nothing_has_read_is_one_line(tmp_path):
    complaints(tmp_path)
    found = unread(read_problem(tmp_path / "words.md"))
    line = unread_of_all([("W1", found)])
    assert line.startswith("read by nobody: ")
    assert "the sentences of the question" in line
    assert "\n" not in unread_of_all([("W1", found), ("W2", found)])
    assert "(2 problems)" in unread_of_all([("W1", found), ("W2", found)])


FIGURE = """\
---
code: W2
title: A figure
given:
  u: {is: velocity, value: -3, from: -5, to: -1, step: 0.5, unit: m/s}
  w: {is: velocity of the other, value: 2, from: -4, to: 4, step: 0.5, unit: m/s}
  s: {is: speed, value: 4, from: 1, to: 6, step: 0.5, unit: m/s}
  L: {is: length, value: 4, from: 1, to: 6, step: 0.5, unit: m}
  H: {is: height, value: 4, from: 1, to: 6, step: 0.5, unit: m}
figure: |
  ball a at=0,0
  LINE
---
{{u}} {{w}} {{s}} {{L}} {{H}}

## Asked {#a .value unit="N"}
What is it?
"""


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ('arrow a by=u,0 "{{u}}"\n  axes "x"', ""),
        ('arrow a by=-u,0 "{{u}}"\n  axes "x"', "points along the axes where u is −5"),
        ('arrow a by=-u,0 "u"\n  axes "x"', "points along the axes where u is −5"),
        ('arrow a by=0,-u "{{u}}"\n  axes "x"', ""),  # down may be positive
        ('arrow a by=0,-u "{{u}}"\n  axes "y" above', "points along the axes"),
        ('arrow a by=0,-u "{{u}}"\n  axes "x" "y"', "points along the axes"),
        ('arrow a by=-u,0 "{{u}}"', ""),  # without axes the author may count to the left
        ('arrow a by=1,0 "{{w}}"', "whatever the sign of w, which is from −4 to 4"),
        ('arrow a by=w,0 "{{w}}"', ""),
        ('arrow a by=abs(w),0 "{{w}}"', "whatever the sign of w"),
        ('arrow a by=-s,0 "{{s}}"\n  axes "x"', ""),  # a speed to the left
        ('arrow a by=s,0 "s = ?"', ""),
        ('arrow a by=s,0 "{{w}}"', "drawn as s (speed) and labelled with w"),
        ('length from=0,0 to=L,0 "{{H}}"', "the length is drawn as L (length) and labelled with H (height)"),
        ('length from=0,0 to=L,0 "H"', "labelled with H"),
        ('length from=0,0 to=L,0 "{{L}}"', ""),
        ('length from=0,0 to=L,0 "{{s}}"', "the length is drawn as L (length) and labelled with s (speed)"),
        ('arrow a by=L,0 "{{s}}"', ""),  # to a scale of its own
        ('length from=0,0 to=0.7*L,0 "{{H}}"', ""),  # a sketch
        ('length from=L,0 to=L,H "{{L}}"', "drawn as H (height) and labelled with L"),
        ('length from=0,0 to=L,0 "L + {{H}} - {{L}}"', ""),
        ('text at=0,1 "s = {{w}}"', "shows the value of w"),
    ],
)
def test_the_figure_is_held_against_the_numbers(tmp_path, line, found):
    path = tmp_path / "figure.md"
    path.write_text(FIGURE.replace("LINE", line), encoding="utf-8")
    tally = Tally()
    check_words(read_problem(path), tally)
    assert len(tally.complaints) == bool(found), tally.complaints
    assert all(found in each and each.startswith("figure.md:1") for each in tally.complaints)


def test_an_answer_type_that_is_not_known_is_no_matter_of_words(tmp_path):
    path = tmp_path / "figure.md"
    path.write_text(FIGURE.replace("LINE", "").replace(".value", ".guess"), encoding="utf-8")
    problem, tally = read_problem(path), Tally()
    check_words(problem, tally)
    assert not tally.complaints
    assert unread(problem)
