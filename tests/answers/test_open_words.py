"""Words beside a number: the question's own and harmless ones change nothing, any other goes to a person, with either sign."""

from __future__ import annotations

import pytest

from corollary import judge, load_bank
from corollary.answers.answer import Numbers, Unclear
from corollary.answers.question import Question, Symbol
from corollary.answers.registry import answer_type
from corollary.formula.value import Text
from corollary.units.unit import unit

FORCE = Question(
    "c", "F", ("value",), unit("N"), "Mean force", text="What is the average force on the ball while your foot touches it?",
    symbols=(Symbol("m", unit("kg")), Symbol("v1", unit("m/s"))),
)  # fmt: skip
SPEED = Question("c", "v", ("value",), unit("m/s"), "Speed of the bullet", text="How fast is the bullet?")
MASS = Question("a", "m", ("value",), unit("kg"), "Nitrogen", text="What mass of nitrogen is in the bottle?")
TURNS = Question(
    "a", "n", ("value",), unit("1/s"), "Faster", text="How many turns a second does it make then?"
)
RATIO = Question("a", "q", ("value",), unit("1"), "Ratio of the impulses", text="How many times as large is that of the elastic ball as that of the sticky ball?")  # fmt: skip
TEMPERATURE = Question(
    "b", "T", ("value",), unit("degC"), "Mixed", text="To what temperature does the tea cool?"
)
TIMES = Question("e", "t", ("list",), unit("s"), "Half as high", ("1", "2"), text="When is it half as high?")
RANGE = Question(
    "e", "x", ("interval",), unit("cm"), "Fast enough", ("from", "to"), text="Where is it faster?"
)


def read(text: str, question: Question) -> Numbers | Unclear:
    found = answer_type(question.types[0]).read(Text(text), question)
    assert isinstance(found, Numbers | Unclear)
    return found


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("the average force on the ball is 86 N", FORCE), ("so F is 86 N", FORCE), ("Die mittlere Kraft beträgt 86 N", FORCE), ("86 N, incl. its weight", FORCE),
        ("F = m v/dt = 86 N", FORCE), ("86 N because F = ma", FORCE), ("\\text{Kraft} = 86\\,\\mathrm{N}", FORCE), ("np.float64(86.0) N", FORCE),
        ("the bullet flies with 250 m/s", SPEED), ("1.77 kg of nitrogen in the bottle", MASS), ("twice as large", RATIO), ("2 times larger", RATIO),
        ("0.359 s (going up) and 2.09 s (coming down)", TIMES), ("von -5,2 cm bis 5,2 cm", RANGE),
    ],
)  # fmt: skip
def test_words_of_the_question_and_harmless_ones_are_passed_over(text: str, question: Question):
    found = read(text, question)
    assert isinstance(found, Numbers)
    assert found.open_words == ""


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("blorp 86 N", FORCE), ("the dummy feels 86 N", FORCE), ("86 N on the wall", FORCE), ("momentum 86 N", FORCE), ("its mass is 86 N", FORCE),
        ("86 N is the weight of the ball", FORCE), ("a tenth of 86 N", FORCE), ("die Hälfte von 86 N", FORCE), ("part of 86 N", FORCE), ("ingen 86 N", FORCE),
        ("niemals 86 N", FORCE), ("milli 86 N", FORCE), ("F_g = 86 N", FORCE), ("F_max = 86 N", FORCE), ("v1 = 250 m/s", FORCE), ("ungültig: 86 N", FORCE),
        ("250 m/s relative to the target", SPEED), ("Δv = 250 m/s", SPEED), ("slowed by 250 m/s", SPEED), ("1.77 kg of oxygen", MASS),
        ("3.09 rad/s", TURNS), ("2 rad", RATIO), ("the impulse of the sticky ball is 2 times that of the elastic one", RATIO),
        ("45.1 °C cooler", TEMPERATURE), ("cooled down by 45.1 °C", TEMPERATURE), ("ΔT = 45.1 °C", TEMPERATURE),
        ("t^2 = 0.359 s, 2.09 s", TIMES), ("the mean of 0.359 s and 2.09 s", TIMES), ("at 0.359 s, and 2.09 s after that", TIMES), ("outside -5.2 cm to 5.2 cm", RANGE),
    ],
)  # fmt: skip
def test_any_other_word_is_left_to_a_person(text: str, question: Question):
    found = read(text, question)
    assert isinstance(found, Unclear) or found.open_words
    assert not (isinstance(found, Unclear) and (found.benefit or found.sign_alone))


def mark(code: str, part: str, typed: str) -> str:
    bank = load_bank()
    return type(judge(bank[code], {part: typed})[part].verdict).__name__.lower()


@pytest.mark.parametrize(
    ("code", "part", "typed", "verdict"),
    [
        ("X12.6", "a", "the dummy gets -100 kN", "unmarked"),
        ("X12.3", "b", "Energieverlust von 480 kJ", "unmarked"),
        ("X12.3", "b", "sinkt um 480 kJ", "unmarked"),
        ("X12.6", "a", "a braking force of 100 kN", "unmarked"),
        ("X12.6", "a", "gegen die Fahrtrichtung: 100 kN", "unmarked"),
        ("X12.5", "c", "the dummy feels 43 N", "mistaken"),
        ("X12.5", "c", "the mean force is 86 N", "right"),
    ],
)
def test_a_person_decides_only_where_the_number_or_its_opposite_is_right(
    code: str, part: str, typed: str, verdict: str
):
    assert mark(code, part, typed) == verdict


@pytest.mark.parametrize("text", ["3.39 l in a second", "3.39 litres in one second", "3.39 l in 1 s"])
def test_in_a_second_is_per_second(text: str):
    flow = Question("a", "Q", ("value",), unit("l/s"), "Flow", text="What is the flow?")
    found = read(text, flow)
    assert isinstance(found, Numbers)
    assert found.values == pytest.approx((3.39e-3,))


@pytest.mark.parametrize("text", ["45,1 Grad", "45.1 grader", "45.1 Grad Celsius", "45.1 Grad C"])
def test_degrees_are_of_the_temperature_that_is_asked(text: str):
    found = read(text, TEMPERATURE)
    assert isinstance(found, Numbers)
    assert found.values == pytest.approx((318.25,))


def test_words_of_a_way_do_not_turn_a_time():
    found = read("up: 0.359 s, down: 2.09 s", TIMES)
    assert isinstance(found, Numbers)
    assert found.values == pytest.approx((0.359, 2.09))


@pytest.mark.parametrize("text", ["5.2 cm < x < -5.2 cm", "-5.2 cm > x > 5.2 cm", "5.2 cm > x < -5.2 cm"])
def test_a_chain_that_no_number_fulfils_is_asked_about(text: str):
    assert isinstance(read(text, RANGE), Unclear)


def test_a_chain_may_run_downwards():
    assert isinstance(found := read("5.2 cm > x > -5.2 cm", RANGE), Numbers)
    assert found.values == pytest.approx((-0.052, 0.052))
