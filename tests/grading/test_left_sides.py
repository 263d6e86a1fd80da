"""Left sides of an answer: names are passed over, a factor or one function is solved for its letter, the rest is asked about."""

from __future__ import annotations

import pytest

from corollary.answers.name import is_name, is_talk
from corollary.answers.quantity import read_quantity
from corollary.answers.questions import question_of
from corollary.answers.read_case import read_case
from corollary.answers.verdict import Right, Wrong
from corollary.formula.errors import ParseError
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge


def quantity(text: str, unit: str):
    return read_case({"text": text, "field": "quantity", "unit": unit})


def expression(text: str, *names: str):
    return read_case({"text": text, "field": "expression", "names": list(names)})


@pytest.mark.parametrize(
    "text",
    ["F = 86 N", "Δp_x = 86 N", "F_{avg} = 86 N", "|F| = 86 N", "F(t) = 86 N", "F(y = 0.6 m) = 86 N", "∑F = 86 N", "<F> = 86 N", "F' = 86 N",
     "F = m*a = 86 N", "the mean force = 86 N", "43*2 = 86 N", "86 N = 86 kg m/s²", "m*a = 86 N", "F = 2*F_1 = 86 N"],
)  # fmt: skip
def test_a_name_or_a_side_that_agrees_is_passed_over(text):
    found = quantity(text, "N")
    assert (found["status"], found["value"]) == ("ok", 86.0)


@pytest.mark.parametrize(
    "text",
    ["2F = 86 N", "-F = 86 N", "F/2 = 86 N", "F*dt = 86 N", "x + 2 = 86 N", "F - N = 86 N", "cos(F) = 86 N", "F² = 86 N", "F^2 = 86 N", "43 N = 86 N",
     "40*2 = 86 N", "43 == 86 N", "a + b = 86 N", "2*F = 86 N"],
)  # fmt: skip
def test_another_left_side_is_asked_about(text):
    assert quantity(text, "N")["status"] in ("asked", "refused")


@pytest.mark.parametrize("text", ["cos(theta) = 0.795", "2θ = 90°", "θ + 1 = 90°", "sin θ = 0.5"])
def test_an_angle_behind_a_function_is_not_the_function(text):
    assert quantity(text, "deg")["status"] in ("asked", "refused")


@pytest.mark.parametrize(
    "text",
    ["2*p = m*v", "-p = m*v", "p^2 = m*v", "p/2 = m*v", "m^2 + v^2 = m*v", "2*m*v = m*v", "p + 1 = m*v"],
)
def test_a_formula_behind_another_left_side_is_asked_about(text):
    assert expression(text, "m", "v")["status"] in ("asked", "refused")


@pytest.mark.parametrize("text", ["p = m*v", "p(t) = m*v", "v*m = m*v", "p = v*m = m*v", "Answer: p = m*v"])
def test_a_formula_behind_a_name_is_read(text):
    assert expression(text, "m", "v")["read"] in ("m*v", "v*m")


@pytest.mark.parametrize(
    ("code", "part", "text", "right"),
    [
        ("X12.5", "d", "F/2 = 86 N", True),  # 172 N is right
        ("X12.5", "c", "2 F = 172 N", True),
        ("X12.5", "c", "-F = -86 N", True),
        ("X12.5", "c", "2*F = 2*m*v/dt", True),
        ("X12.5", "c", "m*v/dt = 86 N", True),
        ("X12.1", "b", "2*v = 65 m/s", False),  # which does not come to it
        ("X12.5", "c", "2 F = 86 N", False),
        ("X12.5", "c", "F/2 = 86 N", False),
        ("X12.5", "c", "m = m*v/dt", False),
        ("X12.5", "a", "2*m*v = 8.6 kg m/s", False),
        ("X12.7", "d", "sin(theta) = 1.5708", False),
        ("X12.7", "d", "θ/2 = 90°", False),
    ],
)
def test_what_is_solved_is_judged_and_nothing_else_earns(key, code, part, text, right):
    verdict = judge(key(code), {part: from_json(text)})[part][0][0]
    assert isinstance(verdict, Right) is right, verdict


def test_the_value_solved_for_is_said(key):
    of = key("X12.5")
    assert question_of(of.variant.problem, of.variant.problem.part("c")).symbols
    verdict = judge(of, {"c": from_json("2 F = 172 N")})["c"][0][0]
    assert "2 F = 172 N gives F = 86 N" in str(verdict)


@pytest.mark.parametrize(
    ("text", "right"),
    [("86 + 0 N", True), ("96 - 10 N", True), ("10 - 96 N", False), ("80-90 N", False), ("80 + 5 N", False), ("86 N is the mean force", True),
     ("86 N (avg)", True), ("86 N is wrong", False)],
)  # fmt: skip
def test_a_sum_with_one_unit_at_its_end_is_that_sum_and_a_range_is_not_its_end(verdicts, text, right):
    assert isinstance(verdicts("X12.5", c=text)["c"], Right) is right


@pytest.mark.parametrize("text", ["1,6 Ns nach oben", "1,6 Ns up", "1.6 Ns upwards", "(0; 1,6) Ns"])
def test_a_decimal_comma_before_a_direction_parts_no_components(verdicts, text):
    assert isinstance(verdicts("X12.7", a=text)["a"], Right)


@pytest.mark.parametrize(
    "side",
    [
        "F_av",
        "Answer",
        "Deltap",
        "F_m",
        "F_{avg}",
        "Fx",
        "F̄",
        "K1",
        "Loss",
        "Verlust",
        "alpha",
        "dK",
        "dp",
        "decrease",
        "delta_max",
        "drop",
        "omega",
        "v'",
        "vA",
        "vA'",
        "v_A1",
        "vA1",
        "v_son",
        "v₂",
        "x-component",
        "|Δp|",
        "Δpx",
        "∑F",
        "⟨F⟩",
        "E_kin",
        "Ekin",
        "p_tot",
        "Fnet",
        "Fmean",
        "F_N",
        "K_0",
        "Ek",
        "KE",
        "beta",
        "eta",
        "zeta",
        "v(t)",
        "vCM",
        "speed",
    ],
)
def test_a_letter_with_an_index_and_a_word_are_names(side):
    assert is_name(side)


@pytest.mark.parametrize(
    "side",
    [
        "cosθ",
        "sinθ",
        "costheta",
        "Cosθ",
        "arccosθ",
        "lnθ",
        "sqrtθ",
        "|cosθ|",
        "Lθ",
        "ωθ",
        "mtheta",
        "½F",
        "F½",
        "F3",
        "Fv",
        "Ft",
        "FΔt",
        "mF",
        "dF",
        "lnF",
        "expF",
        "absF",
        "mv",
        "lnu",
        "mgh",
        "Fdt",
        "half",
        "minus",
        "negative",
        "not",
        "wrong",
        "Double",
        "halv",
        "doppelt",
        "Sin(x)",
    ],
)
def test_what_is_glued_and_a_word_of_change_are_none(side):
    assert not is_name(side)
    assert not is_talk(side)


@pytest.mark.parametrize(
    "side", ["half the force", "twice F", "minus F", "the force times two", "not F", "halve kraften"]
)
def test_words_of_change_are_no_talk(side):
    assert not is_talk(side)


@pytest.mark.parametrize(
    ("code", "part", "text"),
    [("E12.5.1", "d", f"{side}= 0.748") for side in ("cosθ", "sinθ ", "costheta ", "|cosθ| ", "sqrtθ ", "Lθ ", "mθ ")]
    + [("E12.5.1", "d", "cosθ: 0.748"), ("T12.3", "a", "mv = 8.85"), ("T12.3", "a", "lnv = 8.85")]
    + [("X12.5", "c", f"{side} = 86 N") for side in ("½F", "F½", "F3", "Fv", "FΔt", "mF", "dF", "lnF", "half F", "half the force", "minus F")]
    + [("X12.5", "c", f"{word}: 86 N") for word in ("negative", "not", "wrong", "Half", "Double")]
    + [("X12.1", "a", f"{side} = 2v") for side in ("mu", "uM", "lnu", "v")]
    + [("S12.2", "a", f"{side} = (7.5, -10)") for side in ("-p", "2p", "p/2", "p^2", "1/p", "|p|", "p + q", "half p", "cosp")]
    + [("S12.2", "a", "p_x = 7.5, p_z = -10"), ("S12.2", "a", "p_x = 7.5, 2p_y = -10"), ("S12.2", "a", "(p_y; p_x) = (7.5; -10)")]
    + [("S12.5el", "c", "K_A/K_B = 0.96"), ("X12.9", "c", "J_s/J_e = 2"), ("X12.9", "c", "I2/I1 = 2"), ("X12.9", "c", "v_el/v_st = 2")]
    + [("E12.5.1", "b_rel", "K0/ΔK = -0.990"), ("E12.5.1", "b_rel", "K1/K0 = -0.990")]
    + [("X12.5", "a", f"{before} - {after} = 8.6 kg m/s") for before, after in (("p0", "p1"), ("p_i", "p_f"), ("p_before", "p_after"), ("p", "p'"))],
)  # fmt: skip
def test_another_left_side_earns_nothing_unseen(key, code, part, text):
    assert not isinstance(judge(key(code), {part: from_json(text)})[part][0][0], Right)


@pytest.mark.parametrize(
    ("code", "part", "text"),
    [
        ("X12.9", "c", "J_e/J_s = 2"),
        ("S12.5el", "c", "K_B/K_A = 0.96"),
        ("E12.5.1", "b_rel", "ΔK/K0 = -0.990"),
        ("X12.5", "a", "p_f - p_i = 8.6 kg m/s"),
        ("S12.2", "a", "(p_y; p_x) = (-10; 7.5)"),
        ("S12.2", "a", "p = (7.5; -10)"),
        ("X12.5", "c", "½F = 43 N"),
        ("X12.1", "a", "u = 2v"),
    ],
)
def test_a_left_side_that_stands_for_the_answer_is_read(key, code, part, text):
    assert isinstance(judge(key(code), {part: from_json(text)})[part][0][0], Right)


def test_the_letter_of_another_body_is_asked_about(key):
    of = key("S12.5gen")
    problem = of.variant.problem
    question = question_of(problem, problem.part("a"))  # the velocity of A
    for side, another in (("v_B", True), ("v_B'", True), ("vB1", True), ("v_A'", False), ("v", False)):
        found = read_quantity(f"{side} = -3.56 m/s", question.unit, question)
        assert isinstance(found, ParseError) is another


@pytest.mark.parametrize(
    ("code", "part", "text", "right"),
    [
        ("X12.7", "d", "sin θ = 1", True),
        ("X12.7", "d", "sinθ=1", True),
        ("X12.7", "d", "sin θ = 0.9", False),
        ("X12.7", "d", "sin θ = m/m = 1", True),
        ("X12.7", "d", "cosθ = 1.5708", False),
    ],
)
def test_an_equation_for_an_angle_is_solved_for_it(key, code, part, text, right):
    verdict = judge(key(code), {part: from_json(text)})[part][0][0]
    assert isinstance(verdict, Right) is right, verdict


INVERSES = [
    ("S12.5pi", "b", "K0/K1 = 2.5", "K1/K0 = 0.4"),
    ("S12.5pi", "b", "K_before/K_after = 2.5", "K_after/K_before = 0.4"),
    ("X12.9", "c", "J_s/J_e = 1/2", "J_e/J_s = 2"),
    ("X12.9", "c", "J_st/J_el=0.5", "J_el/J_st = 2"),
    ("E12.5.1", "b", "K0 - K1 = 296.9 J", "K1 - K0 = -296.9 J"),
    ("E12.5.1", "b_rel", "K0/ΔK = -1.01", "ΔK/K0 = -0.990099"),
    ("X12.5", "a", "p0 - p1 = -8.6 kg m/s", "p1 - p0 = 8.6"),
    ("X12.5", "a", "p_i - p_f = -8.6 kg m/s", "p_f - p_i = 8.6"),
    ("T12.3", "b", "p0 - p1 = -693", "p1 - p0 = 693"),
    ("S12.2", "a", "-p = (-7.5, 10)", "p = (7.5, -10)"),
    ("S12.2", "a", "2p = (15, -20) kg m/s", "p = (7.5, -10)"),
    ("S12.2", "a", "p/2 = (3.75; -5)", "p = (7.5, -10)"),
    ("S12.2", "a", "½p = (3.75, -5)", "p = (7.5, -10)"),
]


@pytest.mark.parametrize(("code", "part", "text", "said"), INVERSES)
def test_a_true_statement_of_the_inverse_is_right_and_what_it_gives_is_said(key, code, part, text, said):
    verdict = judge(key(code), {part: from_json(text)})[part][0][0]
    assert isinstance(verdict, Right), verdict
    assert said in verdict.note


@pytest.mark.parametrize(
    ("code", "part", "text"),
    [
        ("S12.5pi", "b", "K0/K1 = 0.4"),
        ("S12.5pi", "b", "p0/K1 = 2.5"),
        ("S12.5pi", "b", "K2/K1 = 2.5"),
        ("S12.5pi", "b", "(K0-K1)/K0 = 0.4"),
        ("S12.5pi", "b", "K0/K1 = 0"),
        ("X12.9", "c", "J_st/J_el = 2"),
        ("X12.9", "c", "m/M = 0.5"),
        ("X12.9", "c", "J_2/J_1 = 0.5"),
        ("E12.5.1", "b", "K0 - K1 = -296.9 J"),
        ("E12.5.1", "b", "K0 - p1 = 296.9 J"),
        ("E12.5.1", "b_rel", "K0/ΔK = -0.990"),
        ("X12.5", "a", "p0 - p1 = 8.6"),
        ("X12.5", "a", "p0 - v1 = -8.6"),
        ("S12.5el", "c", "K_A1/K_A0 = 0.96"),
        ("S12.4", "b", "J/p = 0.0001"),
        ("S12.2", "a", "-p = (7.5, -10)"),
        ("S12.2", "a", "2p = (7.5, -10)"),
        ("S12.2", "a", "2vx = (15, -20)"),
        ("S12.2", "a", "-p = 2p = (15, -20)"),
        ("S12.2", "a", "1/p = (0.133, -0.1)"),
        ("S12.2", "a", "-|p| = (-7.5, 10)"),
        ("S12.5nc", "a", "-v = (1.732, 1)"),
    ],
)
def test_what_is_no_inverse_of_the_answer_earns_nothing_unseen(key, code, part, text):
    assert not isinstance(judge(key(code), {part: from_json(text)})[part][0][0], Right)


@pytest.mark.parametrize(
    "text", ["E_lost = 296.9 J", "E_lost=296.9 J", "K_{loss} = 296.9 J", "Q_verlust: 296.9 J"]
)
def test_a_letter_with_a_loss_as_its_index_is_a_loss(key, text):
    assert isinstance(judge(key("E12.5.1"), {"b": from_json(text)})["b"][0][0], Right)


@pytest.mark.parametrize(
    "text", ["E_kin = 296.9 J", "E_left = 296.9 J", "E_lot = 296.9 J", "v_lost = 296.9 J"]
)
def test_another_index_is_no_loss(key, text):
    assert not isinstance(judge(key("E12.5.1"), {"b": from_json(text)})["b"][0][0], Right)


@pytest.mark.parametrize(
    ("code", "part", "text"),
    [
        ("S12.2", "c", "!A"),
        ("S12.2", "c", "!(A)"),
        ("S12.2", "c", "it is !A"),
        ("X12.5", "c", "86 N more"),
        ("X12.5", "c", "86 N mehr"),
        ("E12.7.2", "b", "301.2 kg more"),
        ("S12.2", "a", "7.5 right, -10 down"),
        ("S12.2", "a", "-7.5 left, -10"),
        ("S12.4", "a", "-0.049 Ns downwards"),
    ],
)
def test_what_takes_back_compares_or_has_two_signs_is_asked(key, code, part, text):
    assert not isinstance(judge(key(code), {part: from_json(text)})[part][0][0], Right | Wrong)


@pytest.mark.parametrize(
    ("code", "part", "text"),
    [
        ("S12.2", "c", "A!"),
        ("X12.5", "a", "8.6 kg m/s more"),
        ("X12.9", "c", "2 times more"),
        ("S12.2", "a", "7.5 right, 10 down"),
        ("S12.4", "a", "0.049 Ns downwards"),
        ("S12.4", "a", "-0.049 Ns (downwards)"),
    ],
)
def test_and_what_does_not_is_right(key, code, part, text):
    assert isinstance(judge(key(code), {part: from_json(text)})[part][0][0], Right)


@pytest.mark.parametrize(
    "text",
    ["F = m*v/dt = 86 N", "F = m v/dt = 86 N", "F = Δp/dt = 8.6/0.1 = 86 N", "F = 0.43 kg * 20 m/s / 0.1 s = 86 N", "F = 0.43*20/0.1 = 86 N",
     "F = J/dt = 86 N", "F = p/t = 8.6/0.1 = 86 N", "F_av = dp/dt = (8.6 - 0)/0.1 = 86.0 N", "F = (8.6-0) kg m/s / 0.1 s = 86 N",
     "F·dt = Δp, so F = 86 N", "Δp = 8.6 kg m/s, so F = 8.6/0.1 = 86 N", "F = m*a = 0.43*200 = 86 N", "a = 20/0.1 = 200, F = ma = 0.43*200 = 86 N",
     "F = 86.0 N = 0.086 kN", "F = 0.086 kN = 86 N", "F = ma = 86 N", "F = 8.6 Ns / 0.1 s = 86 N", "F = 8.6/(0.1) = 86 N",
     "F= 430 g * 20 m/s / 100 ms = 86 N", "F = m(v - 0)/dt = 86 N", "F = m*(v-0)/Δt = 86 N", "F=\\frac{m v}{\\Delta t} = 86 N", "F = 8,6/0,1 = 86 N",
     "F = 2*43 = 86 N"],
)  # fmt: skip
def test_a_chain_whose_sides_agree_is_its_last_side(verdicts, text):
    assert isinstance(verdicts("X12.5", c=text)["c"], Right)


@pytest.mark.parametrize(
    "text",
    ["F = -m*v/dt = 86 N", "F = 86 J = 86 N", "F = 8.6/0 = 86 N", "F = 100 N; so F = 86 N", "F = 8.6 - 94.6 = 86 N", "F = 2*m*v/dt = 86 N",
     "F = 8.6 kg m/s = 86 N", "F = 8600 N = 86 N", "F = 0 - 172 N = 86 N", "F = -86 N = 86 N", "F = m*v = 86 N", "-86 N = 86 N", "F = 86 kg = 86 N",
     "F = 172/0.1 = 86 N", "F = 43 = 86 N", "F = 172 N, hence F = 86 N", "F = 172 N. Therefore F = 86 N", "F = 1/0 = 86 N", "F = sqrt(-1) = 86 N",
     "F = ln(0) = 86 N", "F = 0/0 = 86 N", "F = 2*m*v/dt = m*v/dt = 86 N", "F = 172 N, i.e. F = 86 N", "F = 172 N -> F = 86 N",
     "F = 172 N\nF = 86 N", "F = 172 → 86 N"],
)  # fmt: skip
def test_a_chain_whose_sides_disagree_earns_nothing_unasked(verdicts, text):
    assert not isinstance(verdicts("X12.5", c=text)["c"], Right | Wrong)


@pytest.mark.parametrize(
    ("text", "read"),
    [("T = 290.45 K = 17.3 °C", True), ("T = 290.45 K - 273.15 K = 17.3 °C", True), ("T = 290.45 - 273.15 = 17.3 °C", True),
     ("T = 300 K = 17.3 °C", False), ("T = 300 - 273.15 = 17.3 °C", False)],
)  # fmt: skip
def test_two_temperatures_agree_in_degrees_and_not_in_shares_of_the_absolute_one(text, read):
    assert (quantity(text, "°C")["status"] == "ok") is read
