"""Every verdict, met through the judge with answers as students type them."""

from __future__ import annotations

import shutil

import pytest

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Wrong, word
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.variant import chosen

SINGLE = [
    # the answer alone, and what a good marker says: the verdict, and a word of what is told
    ("X12.5", "a", "8.6 kg m/s", "right", ""),
    ("X12.5", "a", "8,6 Ns", "right", ""),
    ("X12.5", "a", 8.6, "right", ""),
    ("X12.5", "a", "8600 g m/s", "right", ""),
    ("X12.5", "a", "m*v", "right", ""),
    ("X12.5", "a", "m (v - 0)", "right", ""),
    ("X12.5", "a", "9 kg m/s", "slip", "three significant figures"),
    ("X12.5", "a", "8.7 kg m/s", "wrong", "Close"),
    ("X12.5", "a", "-8.6 kg m/s", "slip", "sign"),
    ("X12.5", "a", "17.2 kg m/s", "slip", "constant factor"),
    ("X12.5", "a", "8600 kg m/s", "slip", "power of ten"),
    ("X12.5", "a", "8.6", "right", "in the unit asked for"),
    ("X12.5", "a", "8,6", "right", "in the unit asked for"),
    ("X12.5", "a", "8.6 J", "slip", "not its unit"),
    ("X12.5", "a", "3.3 J", "wrong", "is an energy"),
    ("X12.5", "a", "-m v", "slip", "sign"),
    ("X12.5", "a", "m*v/dt", "unread", "not in kg m/s"),
    ("X12.5", "a", "m*q", "unread", ""),
    ("X12.5", "a", "", "unread", "No answer"),
    ("X12.5", "a", None, "unread", "No answer"),
    ("X12.5", "a", "8.6 or 9", "unread", ""),
    ("X12.5", "a", "1,234 kg m/s", "unread", "1.234"),
    ("X12.5", "a", [8.6], "right", ""),
    ("X12.5", "a", [8.6, 1.0], "unread", "One number"),
    ("X12.5", "a", True, "unread", ""),
    ("X12.5", "a", float("nan"), "unread", "not a number"),
    ("X12.5", "a", 10**400, "wrong", ""),
    ("S12.5nc", "b", "78.4°", "slip", "Sine and cosine are interchanged"),
    ("X12.5", "c", "0.86 N", "mistaken", "divide the impulse by the time"),
    ("X12.5", "c", "0.86 kg m", "mistaken", "divide the impulse by the time"),
    ("X12.5", "c", "43 N", "mistaken", "half of the mean force"),
    ("X12.5", "d", "172 N", "right", ""),
    ("X12.5", "d", "0 N", "mistaken", "two speeds add"),
    ("X12.7", "a", "(0; 1,6) kg m/s", "right", ""),
    ("X12.7", "a", [0, 1.6], "right", ""),
    ("X12.7", "a", "1.6 kg m/s at 90 deg", "right", ""),
    ("X12.7", "a", ["1.6 kg m/s", "90 deg"], "right", ""),
    ("X12.7", "a", ["0", "2 m v0 sin(theta)"], "right", ""),
    ("X12.7", "a", "(0, 1.6) J", "slip", "not its unit"),
    ("X12.7", "a", ["0 kg m/s", "1.6"], "right", "in the unit asked for"),
    ("X12.7", "a", [0, -1.6], "slip", "sign"),
    ("X12.7", "a", [0.02, 1.6], "wrong", "Component y fits"),
    ("X12.7", "a", [0.004, 1.6], "right", ""),
    ("X12.7", "a", [1.6], "unread", "2 components"),
    ("X12.7", "a", [[0, 1.6], [0, 1.6]], "unread", "table"),
    ("X12.7", "a", "north-east", "unread", ""),
    ("X12.7", "d", "90 deg", "right", ""),
    ("X12.7", "d", "1.57", "right", ""),
    ("X12.7", "d", 90, "slip", "degrees"),
    ("X12.7", "d", "90 rad", "slip", "degrees"),
    ("X12.7", "d", "45 deg", "mistaken", "45°"),
    ("X12.8", "a", "40 kg m/s at 30 deg", "right", ""),
    ("X12.8", "a", "(34.6, -20) kg m/s", "slip", "one component"),
    ("X12.8", "a", "40 N at 30 deg", "slip", "not its unit"),
    ("X12.8", "b", "-0.43 m/s", "right", "coarse"),
    ("X12.8", "b", "-0.4 m/s", "slip", "three significant figures"),
    ("X12.8", "b2", "0", "right", ""),
    ("X12.8", "b2", 0, "right", ""),
    ("X12.8", "b2", "0.1 m/s", "wrong", ""),
    ("X12.10", "a", "20.8 m/s", "right", ""),
    ("X12.10", "a", "74.8 km/h", "right", ""),
    ("X12.10", "a", "21 m/s", "right", "coarse"),
    ("X12.10", "a", "21.2 m/s", "wrong", "Close"),
    ("X12.10", "b", "20.6 J", "slip", "sign"),
    ("X12.10", "b", "-20.6 N m", "right", ""),
    ("P12.14", "a", "1.41 m/s", "slip", "g = 10"),
    ("P12.14", "g", [-1 / 3, 2 / 3, 2 / 3], "right", ""),
    ("P12.14", "g", [0, 0, 1], "wrong", "excludes"),
    ("P12.14", "g", [0.2, 0.3, 0.5], "wrong", "energy"),
    ("P12.14", "g", ["1 J", "0 J", "0 J"], "unread", "velocity"),
    ("P12.14", "g", "any", "unread", ""),
    ("P12.14", "k", "Because the contact is stiff.", "unmarked", ""),
    ("P12.14", "h", "text", "unread", "Nothing was run"),
    ("T1", "a", "(4.33, 2.5) kg m/s", "right", ""),
    ("T1", "a", [4330.127, 2500.0], "slip", "power of ten"),
    ("T1", "a", "(0.771, -4.94) kg m/s", "slip", "radians"),
    ("T1", "b", "1.274 m", "right", ""),
    ("T1", "b", "1.25 m", "slip", "g = 10"),
    ("T1", "b", "16.5 m", "slip", "km/h"),
    ("T1", "b", "5.10 m", "mistaken", "whole speed"),
    ("T1", "b", "3.82 m", "mistaken", "from the ground"),
    ("T1", "c", "m v^2/2", "right", ""),
    ("T1", "c", "½ m v²", "right", ""),
    ("T1", "c", "m v^2", "slip", "constant factor"),
    ("T1", "c", "m v^2 sin(theta)/2", "mistaken", "forgot the square"),
    ("T1", "c", "m v^2 cos(theta)/2", "wrong", "your formula gives"),
    ("T1", "c", "m v/2", "unread", "not in J"),
    ("T1", "c", "m + v", "unread", ""),
    ("T1", "c", 25.0, "unread", "formula"),
    ("T1", "d", "b", "right", ""),
    ("T1", "d", " (B) ", "right", ""),
    ("T1", "d", "c", "mistaken", "needs no force"),
    ("T1", "d", "a", "wrong", ""),
    ("T1", "d", "e", "unread", "one letter"),
    ("T1", "d", 2, "unread", "one letter"),
    ("T1", "e", "p = m*v\nK = p*v/2\nK = p^2/(2*m)", "right", ""),
    ("T1", "e", ["p = m v", "v = p/m", "K = m (p/m)^2/2", "K = p^2/(2 m)"], "right", ""),
    ("T1", "e", "p = m*v\nK = p^2/m\nK = p^2/(2*m)", "wrong", "Line 2"),
    ("T1", "e", "p = m*v\nK = p*v\nK = p^2/(2*m)", "mistaken", "not energy"),
    ("T1", "e", "K = p^2/(2*m)", "wrong", "only the claim"),
    ("T1", "e", "p = m*v\nm = m\nK = p^2/(2*m)", "unmarked", ""),
    ("T1", "e", "p = m*v\nK = m*v^2/2", "wrong", "not yet"),
    ("T1", "e", "so it is", "unread", "equation"),
    ("T1", "f", "Gravity.", "unmarked", ""),
    ("T1", "f", "", "unread", "No answer"),
    ("T1", "h", [4, 6], "right", ""),
    ("T1", "h", "(14.4, 21.6) km/h", "right", ""),
    ("T1", "h", [10, 0], "wrong", "the stone itself"),
    ("T1", "h", [4, 5], "wrong", "do not satisfy"),
    ("T1", "i", "4.905 N", "right", ""),
    ("T1", "i", 4905, "slip", ""),
]


@pytest.mark.parametrize(
    ("code", "part", "answer", "wanted", "told"),
    SINGLE,
    ids=[f"{c} {p} {str(a)[:30]!r}" for c, p, a, *_ in SINGLE],
)
def test_an_answer_alone(verdicts, code, part, answer, wanted, told):
    verdict = verdicts(code, **{part: answer})[part]
    assert word(verdict) == wanted, verdict
    said = str(verdict)
    assert told in said, said


@pytest.mark.parametrize("mass", ["0.0617", "61.7"])  # 1.234 and 1234 kg m/s
def test_of_an_ambiguous_number_the_reading_that_is_right_counts(key, mass):
    own = key("X12.5", m=mass, v="20")
    ((verdict,), _) = judge(own, {"a": from_json("1,234 kg m/s")})["a"]
    assert isinstance(verdict, Right)
    assert "1.234 or 1234" in verdict.note


def test_mirrored_answers_where_the_student_says_so(verdicts):
    for answer in (
        "0.433 m/s, x to the left",
        "0.433 m/s; positive to the left",
        "0.433 m/s with x reversed",
        "-0.433 m/s, x to the right",
    ):
        assert isinstance(verdicts("X12.8", b=answer)["b"], Right), answer
    assert isinstance(verdicts("X12.8", b="0.433 m/s")["b"], Slip)
    assert isinstance(verdicts("X12.8", b="-0.433 m/s, x to the left")["b"], Slip)
    assert isinstance(verdicts("X12.8", b="m v cos(theta)/M, x to the left")["b"], Right)
    assert isinstance(verdicts("X12.8", a="(-34.6, 20) kg m/s, x to the left")["a"], Right)
    assert isinstance(verdicts("X12.8", a="(-34.6, -20) kg m/s, x to the left, y down")["a"], Right)
    assert isinstance(verdicts("X12.8", a="(34.6, -20) kg m/s, x to the left")["a"], Slip)
    assert isinstance(verdicts("P12.14", b="(0, -1.4) m/s, positive to the left")["b"], Right)


def test_no_axis_turns_an_energy(verdicts):
    assert isinstance(verdicts("X12.10", b="20.6 J, x to the left")["b"], Unread)


def test_a_mirrored_value_is_carried_on_the_usual_axes(verdicts):
    found = verdicts("X12.8", b="0.6 m/s, x to the left", c="-0.6 m/s")
    assert isinstance(found["b"], Wrong)
    assert found["c"] == Follows(("b",), nothing=True)


def test_what_was_found_before_is_carried_along(verdicts):
    found = verdicts("X12.5", a="5 kg m/s", b="5 kg m/s", c="50 N")
    assert isinstance(found["a"], Wrong)
    assert found["b"] == Follows(("a",), nothing=True)
    assert isinstance(found["c"], Follows)


def test_every_combination_of_earlier_values_counts(verdicts):
    for answer, earlier in (("50 N", ("a",)), ("70 N", ("b",)), ("86 N", None), ("60 N", ())):
        verdict = verdicts("X12.5", a="5 kg m/s", b="7 kg m/s", c=answer)["c"]
        if earlier is None:
            assert isinstance(verdict, Right)
        elif earlier:
            assert verdict == Follows(earlier)
        else:
            assert isinstance(verdict, Wrong)


def test_both_routes_to_the_loss_count(verdicts):
    """From a bullet of 25 m/s: by the speed after the hit it is 1.03 J - 31.25 J, by the loss formula -(1/10.5)... of 31.25 J."""
    assert verdicts("X12.10", a="25 m/s", b="-30.2 J")["b"] == Follows(("a",))
    assert verdicts("X12.10", a="25 m/s", b="-29.76 J")["b"] == Follows(("a",))
    assert isinstance(verdicts("X12.10", a="25 m/s", b="-33.3 J")["b"], Wrong)
    assert isinstance(verdicts("X12.10", a="25 m/s", b="-20.6 J")["b"], Right)


def test_a_mistake_on_top_of_a_carried_value(verdicts):
    verdict = verdicts("X12.5", b="7 kg m/s", c="0.7 N")["c"]
    assert isinstance(verdict, Mistaken)
    assert verdict.earlier == ("b",)


@pytest.mark.parametrize("empty", ["0 kg m/s", 0, float("inf"), 10**400, "1e-400 kg m/s", None, "what?"])
def test_nothing_follows_from_a_degenerate_value(verdicts, empty):
    for answer in ("0 kg m/s", 0, 10**400):
        assert not isinstance(verdicts("X12.5", a=empty, b=answer)["b"], (Right, Follows))
    assert not isinstance(verdicts("X12.10", a=empty, b="1.029 J")["b"], (Right, Follows))


def test_the_same_slip_costs_once(verdicts):
    found = verdicts("X12.5", a="8.6 N", b="8.6 N", c="86 N")
    assert isinstance(found["a"], Slip)
    assert isinstance(found["b"], Right)
    assert "only once" in found["b"].note
    assert isinstance(found["c"], Right)


def test_a_sign_carried_is_no_second_slip(verdicts):
    found = verdicts("X12.5", a="-8.6 kg m/s", b="-8.6 kg m/s", d="-172 N")
    assert isinstance(found["a"], Slip)
    assert found["b"] == Follows(("a",), nothing=True)
    assert isinstance(found["d"], Right | Follows)


def test_another_slip_costs_again(verdicts):
    found = verdicts("X12.5", a="-8.6 kg m/s", d="344 N")
    assert isinstance(found["a"], Slip)
    assert isinstance(found["d"], Slip)


def test_rounding_an_earlier_right_value_is_no_fault(verdicts):
    """With 20.7 m/s for 20.789, the loss by the formula is -20.4 J; the truth is -20.58 J."""
    found = verdicts("X12.10", a="20.7 m/s", b="-20.40 J")
    assert isinstance(found["a"], Right)
    assert isinstance(found["b"], Right)


def test_the_sign_of_a_small_component_counts(key):
    """At 83 degrees from the wall the force along it is nought; in the throw at 89 degrees p_x is 1.7 % of p and has a sign."""
    for theta in (
        "179/2",
        "17977/200",
    ):  # at 89.885 degrees the other sign is 0.4 % off, within the tolerance of the length
        own = key("X12.8", theta=theta, v="20")
        x, y = own.truths["a"].values
        assert 0 < x < 0.01 * y
        ((right,), _), ((turned,), _) = (judge(own, {"a": from_json([sign * x, y])})["a"] for sign in (1, -1))
        assert isinstance(right, Right)
        assert not isinstance(turned, Right)


@pytest.mark.parametrize(
    ("theta", "answer", "wanted"),
    [  # the momentum is 40 kg m/s at theta
        ("30", "40 kg m/s at 30 deg", "right"),
        ("30.4", "40 kg m/s at 30 deg", "coarse"),  # 0.7 % off: as far as the two figures of the angle go
        ("30.4", "40.0 kg m/s at 30.0 deg", "wrong"),
        ("30.4", "40.0 kg m/s at 30 deg", "coarse"),
        ("30.6", "40 kg m/s at 30 deg", "wrong"),
        ("30", "40 kg m/s at 30.45 deg", "wrong"),  # a coarse length says nothing of the direction
        ("30", "40.4 kg m/s at 30 deg", "wrong"),
        ("8.4", "40.0 kg m/s at 8 deg", "slip"),  # one figure is too few to tell
        ("30.4", "40 kg m/s at 0.5236 rad", "wrong"),
    ],
)
def test_an_angle_s_own_figures_bound_the_direction(key, theta, answer, wanted):
    own = key("X12.8", theta=theta)
    ((verdict,), _) = judge(own, {"a": from_json(answer)})["a"]
    assert ("coarse" if "coarse" in str(verdict) else word(verdict)) == wanted, verdict


def test_a_length_s_own_figures_bound_the_length(key):
    own = key("X12.8", m="242/100")  # 48.4 kg m/s at 30°
    for answer, wanted in (
        ("48 kg m/s at 30 deg", "coarse"),
        ("48.0 kg m/s at 30 deg", "wrong"),
        ("48 kg m/s at 30.45 deg", "wrong"),
        ("50 kg m/s at 30 deg", "wrong"),
    ):
        ((verdict,), _) = judge(own, {"a": from_json(answer)})["a"]
        assert ("coarse" if "coarse" in str(verdict) else word(verdict)) == wanted, (answer, verdict)


def test_formulas_of_numbers_are_carried_too(verdicts):
    found = verdicts("X12.5", a="m*v/2", b="4.3 kg m/s")
    assert isinstance(found["a"], Slip)
    assert found["b"] == Follows(("a",), nothing=True)


def test_a_blank_is_blank(verdicts):
    verdict = verdicts("X12.5", a=None)["a"]
    assert isinstance(verdict, Unread)
    assert verdict.blank


READS = """
from corollary.answers.value.reading import ValueType

class Shaky(ValueType):
    def read(self, value, question):
        raise KeyError("the height is 1.3")

TYPE = Shaky()
"""
JUDGES = """
def judge(answer, expected):
    raise KeyError(f"the height is {expected.quantity.values}")

def samples(truth, question):
    return []
"""


@pytest.mark.parametrize("broken", ["judging", "reading"])
def test_another_package_that_raises_costs_its_own_part_alone(installed, small_bank, tmp_path, broken):
    """The part waits for a person, nothing of what the error says reaches the student, and the others keep their marks."""
    name = f"shaky_{broken}"
    reads = READS if broken == "reading" else "from corollary.answers.value.reading import TYPE\n"
    files = {f"{name}/__init__.py": "", f"{name}/reading.py": reads, f"{name}/judging.py": JUDGES}
    installed(name, {"corollary.answers": [f"{name} = {name}"]}, files)
    shutil.copytree(small_bank, tmp_path / "bank")
    path = tmp_path / "bank" / "problems" / "all" / "stone.md"
    path.write_text(path.read_text(encoding="utf-8").replace("{#b .value", "{#b ." + name), encoding="utf-8")
    bank, problem = home(tmp_path / "bank", "T1")
    key = make_key(Solutions(bank).of(problem), chosen(problem, {}))
    answers = {"b": "1.3 m", "c": "m v^2/2", "d": "b", "i": "4.9 N"}
    judged = judge(key, {part: from_json(answer) for part, answer in answers.items()})
    ((shaky,), _) = judged["b"]
    assert isinstance(shaky, Unmarked)
    assert f"your teacher will mark it. (KeyError in the answer type {name})" in shaky.why
    assert "height" not in shaky.why
    assert {part: type(judged[part][0][0]) for part in "cdi"} == {"c": Right, "d": Right, "i": Right}
