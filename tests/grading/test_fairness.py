"""What a good marker would say of answers as students in many countries type them."""

from __future__ import annotations

import pytest

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Wrong, word
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge

# the same right answer, 8.6 kg m/s in the positive direction, by many hands
MOMENTUM = """8,6 kg·m/s|8.6kgm/s|8.6 kg*m*s^-1|8.6 kg m s⁻¹|8.6 kg.m.s-1|8.6 N-s|8.6 Newton seconds|8.6 kilogram meters per second
8.6 [kg m/s]|8.6 (kg·m)/s|8.6 kg·(m/s)|Δp = 8.6kg m/s|delta p = 8.6 kg m/s|p: 8.6 kg m/s|≈ 8.6 kg m/s|~8.6 kg m/s|=8.6 kg m/s
ca. 8.6 kg m/s|about 8.6 kg m/s|8.6 kg m/s.|0.86 10^1 kg m/s|８.６ kg m/s|“8.6 kg m/s”|8.6 kg m/s ± 0.1|(8.6 ± 0.1) kg m/s
The momentum changes by 8.6 kg m/s|a) 8.6 kg m/s|8.6 kg m/s to the right|8.6 kg m/s forward|8.6 kg m/s in the positive direction
p = m v = 8.6 kg m/s|p = mv = 0.43*20 = 8.6 kg m/s|0.43 kg * 20 m/s|Δp = 0.43 kg · 20 m/s = 8.6 kg m/s|p1 - p0 = m*v|$m\\cdot v$
$8.6\\,\\mathrm{kg\\,m/s}$|8.6 \\frac{kg m}{s}|m × v|p = m*v"""
# (34.6, 20.0) kg m/s
THROW = """(34,6; 20,0) kg m/s|<34.6, 20.0> kg m/s|{34.6, 20.0} kg m/s|34.6 and 20.0 kg m/s|34.6 ex + 20 ey kg m/s
34.6 \\hat{i} + 20 \\hat{j} kg m/s|x: 34.6 kg m/s, y: 20.0 kg m/s|p_x = 34.6 kg m/s and p_y = 20.0 kg m/s|40 kg m/s, 30°
p_y = 20.0 kg m/s, p_x = 34.6 kg m/s|40 kg m/s at 30° above the horizontal|40∠30° kg m/s|(m v cosθ, m v sinθ)|m v (cos θ, sin θ)
m v cosθ î + m v sinθ ĵ|(40 cos 30°, 40 sin 30°) kg m/s|(20√3, 20) kg m/s|$(34.6, 20.0)\\,\\mathrm{kg\\,m/s}$"""
ANGLE = "pi/2|π/2|0.5π|1/2 π|\\frac{\\pi}{2}|$90^\\circ$|arccos(0)|90 degrees|θ = 90°|1,57 rad"
CHOICE = "b|(B)|b.|b)|option b|Answer: b|“b”|**b**|ｂ|the answer is b"


@pytest.mark.parametrize(
    ("code", "part", "answer"),
    [("X12.5", "a", each) for each in MOMENTUM.replace("\n", "|").split("|")]
    + [("X12.8", "a", each) for each in THROW.replace("\n", "|").split("|")]
    + [("S12.5nc", "b", each) for each in ANGLE.split("|")]
    + [("X12.2", "a", each) for each in CHOICE.split("|")],
)
def test_right_by_many_hands(verdicts, code, part, answer):
    assert isinstance(verdicts(code, **{part: answer})[part], Right)


@pytest.mark.parametrize(
    ("code", "part", "answer", "wanted"),
    [
        ("X12.5", "a", "8.6 or 9.6 kg m/s", Unread),
        ("X12.5", "a", "not 8.6 kg m/s", Unread),
        ("X12.5", "a", "less than 9 kg m/s", Unread),
        ("X12.5", "a", "8 - 9 kg m/s", Unread),
        ("X12.5", "a", "> 8 kg m/s", Unread),
        ("X12.5", "a", "p = m v = 9.6 kg m/s", Wrong),
        ("X12.5", "a", "9.6 kg m/s = 8.6 kg m/s", Unread),
        ("X12.5", "a", "8.6 kg m/s = 30.96 kg km/h", Right),
        pytest.param("P12.15", "b", "k (b -x)", Right, marks=pytest.mark.whole),
        ("X12.5", "a", "8.6 kg m/s to the left", Unmarked),
        ("X12.5", "a", "8.6 kg m/s in the direction of the kick", Unmarked),
        ("X12.8", "b", "0.433 m/s to the left", Right),
        ("X12.8", "b", "0.433 m/s away from my son", Unmarked),
        ("X12.8", "b", "3 m/s to the left", Wrong),
        ("X12.8", "b", "-34.6 kg m/s / 80 kg", Right),
        ("X12.8", "b", "-m v cos θ/M", Right),
        ("X12.8", "b", "-m v cos(30°)/M", Right),
        ("X12.8", "b", "-m v cos(30)/M", Right),
        ("X12.8", "b", "-0.433 ms^-1", Right),
        ("X12.8", "a", "(20.0, 34.6) kg m/s", Mistaken),
        ("X12.8", "a", "40 kg m/s at 30° below the horizontal", Slip),
        ("X12.5", "a", "8.6 kg ms^-1", Right),
        ("X12.5", "a", "8.6 Ns (newton seconds)", Right),
        ("X12.5", "d", "170 N", Right),
        ("X12.5", "d", "180 N", Wrong),
        ("X12.5", "d", "200 N", Wrong),
        ("X12.8", "a", [35, 20], Right),
        ("X12.8", "a", [[34.6], [20.0]], Right),
        ("S12.5nc", "c", [[1.595, 0.8037], [0.405, -0.8037]], Right),
        ("S12.5nc", "e", "4 unknowns, 3 equations", Right),
        ("X12.7", "a", "(0; 1,600) kg m/s", Right),
        ("E12.5.1", "a", "(m_A+m_B)/m_A sqrt(2gh)", Right),
        ("E12.5.1", "a", "m_B/m_A sqrt(2gh)", Wrong),
        ("E12.5.1", "a", "1.01 kg * 2.425 m/s / 0.01 kg", Right),
        ("E12.5.1", "a", "245 m/s (g = 9.81 m/s²)", Right),
        ("E12.5.1", "d", "46°", Right),
        ("E12.5.1", "b", "a loss of 297 J", Right),
        ("E12.5.1", "b", "297 J", Slip),
        ("X12.12", "b", "L/9", Right),
        ("X12.12", "b", "L/8", Wrong),
        ("X12.12", "a", "block: 2.95 m/s, sphere: -1.48 m/s", Right),
        ("S12.5pi", "b", "0.4 (40 %)", Right),
        ("S12.5pi", "b", "0.4 (60 %)", Unread),
        ("X12.2", "a", "a or b", Unread),
        ("X12.2", "a", "not b", Unread),
        ("X12.2", "b", ["2 kg", "3 m/s", "3 kg", "-2 m/s"], Right),
        ("X12.2", "b", "v2 = -2, m2 = 3, v1 = 3, m1 = 2", Right),
        ("X12.2", "b", "m1 = 2, v1 = 3, m2 = 3, v2 = 2", Wrong),
        ("P12.14", "g", "v_C = 2/3 m/s, v_B = 2/3 m/s, v_A = -1/3 m/s", Right),
    ],
)
def test_what_a_good_marker_says(verdicts, code, part, answer, wanted):
    verdict = verdicts(code, **{part: answer})[part]
    assert isinstance(verdict, wanted), verdict


def test_a_formula_follows_from_an_earlier_one(verdicts):
    found = verdicts("X12.5", a="m*v + m*w/3", c="(m*v + m*w/3)/dt")
    assert isinstance(found["a"], Wrong)
    assert found["c"] == Follows(("a",))


def test_a_hint_on_components_is_true(verdicts):
    one = verdicts("S12.5nc", c=[1.595, 0.9, 0.405, -0.9])["c"]
    assert isinstance(one, Wrong)
    assert one.why == "Components Bx and Ax fit; look at the others again."
    three = verdicts("S12.5nc", c=[1.595, 0.81, 0.405, -0.9])["c"]
    assert isinstance(three, Wrong)
    assert three.why.startswith("Component")
    # 1.5 % of the length: three figures at every operation explain 1.2 %
    close = verdicts("S12.5nc", c=[1.6095, 0.818, 0.3905, -0.818])["c"]
    assert isinstance(close, Wrong)
    assert close.why.startswith("Close, but rounding does not explain it")


CHAIN = ["F - mu*g = v0*R", "R = (m/L)*v0", "mu = (m/L)*y", "F = mu*g + v0*R", "F = (m/L)*(v0^2 + g*y)"]


@pytest.mark.parametrize(
    ("lines", "wanted"),
    [
        (CHAIN, "right"),
        ("F = mu*g + v0*R\n= (m/L)*y*g + (m/L)*v0*v0\n= (m/L)*(v0^2 + g*y)", "unmarked"),
        (
            "mu = m*y/L, R = m*v0/L\nF = mu*g + v0*R\n= (m/L)*y*g + (m/L)*v0*v0\n= (m/L)*(v0^2 + g*y)",
            "right",
        ),
        (
            "Newton: F - mu*g = v0*R\nThe mass that hangs: mu = m*y/L\nThe rate: R = m*v0/L\nSo F = (m/L)*(v0^2 + g*y).",
            "right",
        ),
        (
            "1) $F - \\mu g = v_0 R$\n2) $\\mu = \\frac{m y}{L}$\n3) $R = \\frac{m v_0}{L}$\n=> $F = \\frac{m}{L}(v_0^2 + g y)$",
            "right",
        ),
        ([CHAIN[0], CHAIN[-1]], "unmarked"),
        ([CHAIN[0], CHAIN[-1], CHAIN[-1]], "unmarked"),
        ([CHAIN[-1], CHAIN[0], CHAIN[-1]], "unmarked"),
        ([CHAIN[0], "F = F", CHAIN[-1]], "unmarked"),
        (["m*F - m*(m/L)*(v0^2 + g*y) = 0", CHAIN[3], CHAIN[-1]], "unmarked"),
        (["m*F - m*(m/L)*(v0^2 + g*y) = 0", CHAIN[-1]], "wrong"),
        (["1 = 1", CHAIN[-1]], "wrong"),
        (["(v0 + y)^2 = v0^2 + 2*v0*y + y^2", "F = F"], "wrong"),
        (CHAIN[:-1], "wrong"),
        ("I think so", "unread"),
    ],
)
def test_a_proof_shows_the_way(verdicts, lines, wanted):
    assert word(verdicts("X12.13", p=lines)["p"]) == wanted


def test_a_factor_of_nought_makes_no_law(key):
    """The claim times the mass is no law, though both hold when the mass is nought: nobody has shown where it comes from."""
    ((verdict,), _) = judge(
        key("S12.5nc"),
        {"f": from_json(["mA*A_x*B_x + mA*A_y*B_y = 0", "v0 = A_x + B_x", "A_x*B_x + A_y*B_y = 0"])},
    )["f"]
    assert isinstance(verdict, Unmarked)


def test_a_letter_with_a_zero_behind_it_is_no_unit(verdicts):
    """F0 is the force at the top of the pulse, and neither a farad nor a number beside one."""
    found = verdicts("S12.3", a="2*F0")["a"]
    assert isinstance(found, Unread)
    assert "2*F0 is not in N s: it is a force" in found.why
