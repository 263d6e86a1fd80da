"""Numbers, lists and components with two readings, of which none is guessed: lost powers, units of the last alone, bounds."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.answer import Numbers, Unclear
from corollary.answers.bound import extreme_asked
from corollary.answers.proof.steps import steps_of
from corollary.answers.question import Question, Symbol
from corollary.answers.read_case import read_case
from corollary.answers.registry import answer_type
from corollary.formula.syntax import author_formula
from corollary.formula.value import Text
from corollary.units.unit import unit

SPEED = Question(
    "a", "v", ("value",), unit("m/s"), "Speed", symbols=(Symbol("g", unit("m/s^2")), Symbol("h", unit("m")))
)
PLACES = Question("a", "x", ("vector",), unit("m"), "Turning points", ("near", "far"))
MOMENTUM = Question(
    "a", "p", ("vector",), unit("kg m/s"), "Momentum", ("x", "y"), symbols=(Symbol("m", unit("kg")),)
)


def read(text: str, question: Question):
    return answer_type(question.types[0]).read(Text(text), question)


def meant(text: str, question: Question) -> list[tuple[float, ...]]:
    """The values of what is asked about."""
    found = read(text, question)
    assert isinstance(found, Unclear), found
    return [each.values for each in found.readings if isinstance(each, Numbers)]


@pytest.mark.parametrize("power", ["10 -3", "10 - 3", "10- 3", "10 –3", "10 −3"])
@pytest.mark.parametrize("before", ["1.13*", "1.13 * ", "1.13x", "1.13 x ", "1.13·", "1,13 × "])
def test_a_power_of_ten_that_lost_its_raising_is_asked_about(before, power):
    found = read_case({"text": f"{before}{power} m/s", "unit": "m/s"})
    if found["status"] == "ok":  # `1.13x10- 3`
        assert found["value"] == pytest.approx(0.00113)
        return
    assert "10^-3" in found["why"] + found["suggestion"]
    assert any(each == pytest.approx((0.00113,)) for each in meant(f"{before}{power}", SPEED))


@pytest.mark.parametrize("text", ["1.13 10 -3", "1.13 10-3", "1.13 10 –3", "1,13 10 -3"])
def test_a_blank_may_stand_for_the_cross_that_was_lost_too(text):
    assert any(each == pytest.approx((0.00113,)) for each in meant(text, SPEED))


@pytest.mark.parametrize("text", ["1.6x10e-19", "1.6*10E-19", "1.6 · 10e−19", "1,6 x 10 e-19"])
def test_ten_to_a_power_typed_with_an_e_is_asked_about(text):
    assert sorted(meant(text, SPEED)) == [pytest.approx((1.6e-19,)), pytest.approx((1.6e-18,))]


@pytest.mark.parametrize(
    ("text", "value"), [("5*10 - 3", 47), ("0.5*10 - 3", 2), ("12*10 - 4", 116), ("1.13*10^-3", 0.00113), ("1.13*10 ^ -3", 0.00113), ("1.13*10", 11.3)]
)  # fmt: skip
def test_a_difference_from_a_product_with_ten_is_one(text, value):
    found = read(text, SPEED)
    assert isinstance(found, Numbers)
    assert found.values == pytest.approx((value,))


@pytest.mark.parametrize(
    "text", ["0.894, 1306 mm", "0.894; 1306 mm", "x = 0.894, 1306 mm", "0.894 and 1306 mm", "0,894; 1306 mm"]
)
def test_a_unit_of_the_last_number_alone_is_asked_about_where_the_numbers_differ_in_size(text):
    assert meant(text, PLACES) == [pytest.approx((0.000894, 1.306)), pytest.approx((0.894, 1.306))]


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("894, 1306 mm", (0.894, 1.306)), ("(0.894, 1306) mm", (0.000894, 1.306)), ("0.894, 1.306 m", (0.894, 1.306)), ("0.894, 1.306", (0.894, 1.306)),
        ("0.894 m, 1306 mm", (0.894, 1.306)), ("0, 1306 mm", (0, 1.306)), ("0.894 m, 1.306", (0.894, 1.306)), ("89.4, 130.6 cm", (0.894, 1.306)),
    ],
)  # fmt: skip
def test_one_unit_at_the_end_or_behind_brackets_is_that_of_all(text, values):
    found = read(text, PLACES)
    assert isinstance(found, Numbers)
    assert found.values == pytest.approx(values)


def test_a_number_without_a_unit_beside_another_unit_is_asked_about():
    assert meant("894 mm, 1306", PLACES) == [pytest.approx((0.894, 1.306)), pytest.approx((0.894, 1306))]


SIZES = {"mm": 1e-3, "cm": 1e-2, "km": 1e3, "m": 1.0}


@given(
    st.integers(1, 9999), st.integers(1, 9999), st.sampled_from(["", *SIZES]), st.sampled_from(["", *SIZES])
)
def test_a_pair_is_read_as_it_stands_or_asked_about(one, other, first, last):
    """Where it is read, a number without a unit has that of the last or, at the end, the one that is asked for."""
    found = read(f"{one} {first}; {other} {last}", PLACES)
    if isinstance(found, Numbers):
        assert found.values == pytest.approx((one * SIZES[first or last or "m"], other * SIZES[last or "m"]))
    else:
        assert isinstance(found, Unclear)
        assert (not first) != (not last)
        assert len(found.readings) == 2


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("142.5 + (-199.5) j", (142.5, -199.5)), ("142.5 + 199.5 j", (142.5, 199.5)), ("142.5 - 199.5j", (142.5, -199.5)),
        ("142.5 kg m/s - 199.5 j", (142.5, -199.5)), ("142.5 + -199.5 j kg m/s", (142.5, -199.5)), ("-199.5 j + 142.5", (142.5, -199.5)),
        ("142.5 i - 199.5", (142.5, -199.5)), ("142.5 - 199.5 i", (-199.5, 142.5)), ("(142.5 - 199.5 ĵ) kg m/s", (142.5, -199.5)),
        ("142.5 Ns - 199.5 Ns j", (142.5, -199.5)), ("142,5 - (-199,5) j", (142.5, 199.5)),
    ],
)  # fmt: skip
def test_a_term_without_a_direction_beside_one_with_a_direction_is_asked_about(text, values):
    assert meant(text, MOMENTUM) == [values]


@pytest.mark.parametrize(
    "text", ["mp = (3, -4)", "m p = (3, -4)", "mp_x = 3, mp_y = -4", "2p = (3, -4)", "pm = (3, -4)"]
)
def test_the_left_side_of_a_vector_sees_the_letters_of_the_problem(text):
    assert isinstance(read(text, MOMENTUM), Unclear)


@pytest.mark.parametrize("text", ["p = (3, -4)", "p_x = 3, p_y = -4", "Δp = (3, -4)", "p' = (3, -4)"])
def test_the_name_of_a_vector_is_passed_over(text):
    found = read(text, MOMENTUM)
    assert isinstance(found, Numbers)
    assert found.values == (3, -4)


BOUNDS = (
    "≥ 7.18 m/s | > 7.18 m/s | v ≥ 7.18 m/s | v >= 7.18 | v \\geq 7.18 m/s | v_A,0 ≥ 7.18 m/s | at least 7.18 m/s | 7.18 m/s at least | 7.18 m/s or more | "
    "it must be at least 7.18 m/s | minimum 7.18 m/s | more than 7.18 m/s | not less than 7.18 m/s | 7.18 m/s ≤ v | mindestens 7,18 m/s | minst 7,18 m/s"
)


@pytest.mark.parametrize("text", BOUNDS.split(" | "))
def test_a_bound_is_a_value_where_the_question_asks_for_it_and_asked_about_elsewhere(text):
    found = read(text, replace(SPEED, extreme="least"))
    assert isinstance(found, Numbers)
    assert found.values == (7.18,)
    assert meant(text, SPEED) == meant(text, replace(SPEED, extreme="greatest")) == [(7.18,)]


@pytest.mark.parametrize(
    "text", ["≤ 7.18 m/s", "at most 7.18 m/s", "v < 7.18 m/s", "up to 7.18 m/s", "7.18 m/s or less", "7.18 m/s ≥ v", "høyst 7.18 m/s"]
)  # fmt: skip
def test_a_greatest_value(text):
    assert isinstance(read(text, replace(SPEED, extreme="greatest")), Numbers)
    assert meant(text, replace(SPEED, extreme="least")) == [(7.18,)]


@pytest.mark.parametrize("text", ["v > 3 and v < 5 m/s", "3 < v < 5", "v ≠ 7 m/s", "> 3 or < 2"])
def test_two_bounds_are_no_value(text):
    assert isinstance(read(text, replace(SPEED, extreme="least")), Unclear)


@pytest.mark.parametrize(
    "text",
    ["ca. 7.18 m/s", "approximately 7.18 m/s", "about 7.18 m/s", "~7.18 m/s", "7.18 m/s approximately", "≈ 7.18 m/s", "=> v = 7.18 m/s", "∴ 7.18 m/s",
     "⇒ v = 7.18 m/s"],
)  # fmt: skip
def test_an_approximate_value_and_one_behind_an_arrow_is_a_value(text):
    assert read_case({"text": text, "unit": "m/s"})["value"] == 7.18


@pytest.mark.parametrize(
    ("title", "text", "asked"),
    [
        ("Speed", "How fast must it be at least?", "least"), ("Smallest speed", "", "least"), ("Height", "How high above its lowest point does it rise?", ""),
        ("", "What is the largest speed?", "greatest"), ("", "At the greatest height it stops. How long does it take?", ""),
        ("", "Between which places has it at least half of its largest speed?", ""), ("", "Wie schnell muss er mindestens sein?", "least"),
        ("", "How long does it take from one moment when the distance is smallest to the next one?", ""), ("", "Which speed has it where the force is largest?", ""),
        ("", "For which angle is the force largest?", ""), ("", "At what smallest speed does it get over the hill?", "least"),
        ("", "What is the largest speed for which there is a circular orbit?", "greatest"), ("", "Wie lange dauert es, wenn die Kraft am größten ist?", ""),
    ],
)  # fmt: skip
def test_what_a_question_asks_of_extremes(title, text, asked):
    assert extreme_asked(title, text) == asked


@pytest.mark.parametrize(
    ("text", "asked", "si", "shown"),
    [("71.6 PS", "W", 71.6 * 735.49875, "71.6 PS"), ("840 lb", "N", 840 * 4.4482216152605, "840 lbf"), ("840 pounds", "N", 840 * 4.4482216152605, "840 lbf"),
     ("20 lb s", "N s", 20 * 4.4482216152605, "20 lbf s"), ("840 lb", "kg", 840 * 0.45359237, "840 lb")],
)  # fmt: skip
def test_a_horsepower_of_the_continent_and_a_pound_of_force(text, asked, si, shown):
    found = read_case({"text": text, "unit": asked})
    assert (found["read"], found["value"]) == (shown, pytest.approx(si))


@pytest.mark.parametrize(
    ("text", "names", "same"),
    [
        (r"\frac{m_{A}v_{A}+m_{B}v_{B}}{m_{A}+m_{B}}", "mA mB vA vB", "(mA*vA + mB*vB)/(mA + mB)"), (r"\frac{m}{2k}", "m k", "m/(2*k)"),
        (r"\frac{1}{2}m_{B}v_{B}^{2}", "mA mB vB", "mB*vB^2/2"), ("v_A,0*mA", "mA vA0", "vA0*mA"), ("v_{A,0}*mA", "mA vA0", "vA0*mA"), ("v_A,0^2/2", "v_A0", "v_A0^2/2"),
        (r"\frac{x}{ab}", "x a b", "x/(a*b)"),
    ],
)  # fmt: skip
def test_letters_with_indices_side_by_side(text, names, same):
    found = read_case({"text": text, "names": names.split(), "equals": same})
    assert found["verdict"] == "equal", found


@pytest.mark.parametrize(
    ("text", "question", "told"),
    [
        ("see above", SPEED, "there is no number in this"), ("per 8.85 m/s", SPEED, "“per” in front of the number is not understood"),
        ("(8.5", SPEED, "a bracket is never closed"),
        ("(3, 4, 5) m/s", SPEED, "one number is asked for, not several"), ("8.5 m/s (heat)", SPEED, "“heat” beside the number may be a sign"),
        ("(3, 4, 5, 6)", MOMENTUM, "2 components are expected, not 4; write them as (3; 4) kg m/s"), ("5", MOMENTUM, "2 components are expected, not 1"),
        ("see above", replace(SPEED, types=("expression",)), "a formula is asked for"),
    ],
)  # fmt: skip
def test_what_is_told_of_an_answer_that_is_none(text, question, told):
    found = read(text, question)
    assert isinstance(found, Unclear)
    assert told in found.why
    assert "at character 1" not in found.why


def test_a_plain_number_is_shown_without_a_blank_behind_it():
    assert "110 is a plain number" in read_case({"text": "110 m/m", "unit": "m/s"})["why"]


def test_a_minus_in_words_before_a_formula():
    assert read("minus sqrt(2*g*h)", SPEED).as_read == "-sqrt(2*g*h)"


@pytest.mark.parametrize("letter", [*"λρσκτΛξαβγχηεωΩδϱ", "ρ_l", "λ_0", "λ'"])
@pytest.mark.parametrize("glued", [False, True])
def test_a_letter_of_ones_own_may_be_greek(letter, glued):
    product = "" if glued and letter not in ("δ", "λ'") else "*"  # `δy` is a change
    known = ["m", "L", "v0", "y", "g", "F", "mu", "R"]
    lines = [f"{letter} = m/L", f"mu = {letter}{product}y", f"F = {letter}{product}(v0^2 + g*y)"]
    steps = steps_of(list(enumerate(lines, 1)), known)
    assert not isinstance(steps, Unclear), steps
    own = steps[0].defines
    assert own.isascii()
    assert steps[1].relation == author_formula(f"mu = {own}*y", {*known, own})
    assert not steps[2].undefined


@pytest.mark.parametrize(
    "sign", ["∴", "∵", "⇒", "⟹", "→", "=>", "->", "⇔", "↔", "➜", r"\therefore", r"\Rightarrow"]
)
@pytest.mark.parametrize("blank", ["", " "])
def test_a_sign_of_consequence_may_begin_a_line(sign, blank):
    lines = ["mu = m*y/L", f"{sign}{blank or ' ' if sign.isascii() else blank}F = mu*g"]
    steps = steps_of(list(enumerate(lines, 1)), ["m", "L", "y", "g", "F", "mu"])
    assert not isinstance(steps, Unclear), steps
    assert steps[1].relation == author_formula("F = mu*g")
