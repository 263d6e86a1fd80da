"""What earns nothing though it fits something."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Wrong
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key, make_key
from corollary.grading.points import grade
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import chosen

from .small import solved

GIVENS = """
    m: {is: mass, value: 2, unit: kg}
    v: {is: speed, value: 3, unit: m/s}
    t: {is: time, value: 2, unit: s}
"""
STEPS = """
    p, K, F, s = unknowns("p K F s")
    return derivation(
        step(p, "Mass times speed.", law("Momentum", "p = m*v", p=p, m=m, v=v), answers="a",
             mistakes=[mistake("The object moves.", law("At rest", "p = 0*v", p=p, v=v))]),
        step(K, "By its definition.", law("Energy", "K = p^2/(2*m)", K=K, p=p, m=m), answers="b",
             mistakes=[mistake("That is the momentum.", law("Energy", "K = p", K=K, p=p))]),
        step(F, "Per time.", law("Force", "F = p/t", F=F, p=p, t=t), answers="c"),
        step(s, "Half the way at full speed.", law("Way", "s = v*t/2", s=s, v=v, t=t), answers="d"),
    )
"""


@pytest.fixture(scope="module")
def stone(tmp_path_factory: pytest.TempPathFactory) -> Key:
    """6 kg m/s, 9 J, 3 N and 3 m."""
    folder = tmp_path_factory.mktemp("stone")
    solution = solved(folder, GIVENS, "a kg*m/s\nb J\nc N\nd m", STEPS, "m, v, t")
    return make_key(solution, chosen(solution.problem, dict[str, Fraction]()))


def judged(key: Key, **answers: object) -> dict[str, object]:
    found = judge(key, {part: from_json(value) for part, value in answers.items()})
    return {part: found[part][0][0] for part in answers}


def points(key: Key, **answers: object) -> dict[str, float]:
    found = judge(key, {part: from_json(value) for part, value in answers.items()})
    return {each.part.id: each.points for each in grade(key, found).parts if each.part.id in answers}


def test_one_number_in_every_part_earns_what_is_right_and_nothing_else(stone):
    assert points(stone, a=3, b=3, c=3, d=3) == {"a": 0, "b": 0, "c": 1, "d": 1}
    assert points(stone, a=12, b=12, c=12, d=12) == {"a": 0, "b": 0, "c": 0, "d": 0}
    assert points(stone, a=12) == {"a": 0.5}  # alone a factor of 2 is a slip


def test_a_number_that_stands_twice_among_others_is_no_guess(stone):
    found = judged(stone, a=12.0, b=36.0, c=6.0, d=12.0)
    assert isinstance(found["a"], Slip)
    assert found["b"] == Follows(("a",))
    assert found["c"] == Follows(("a",))


def test_one_sign_wrong_in_several_parts_is_no_guess(verdicts):
    """The loss is asked for twice, and what is left in the frame of a car has the same size."""
    found = verdicts("X12.3", b="480 kJ", c="960 kJ", d="480 kJ", e="480 kJ")
    assert isinstance(found["b"], Mistaken)
    assert not found["b"].nothing
    assert found["d"] == Right()


def test_a_zero_is_named_and_earns_nothing(stone):
    assert isinstance(judged(stone, a=0)["a"], Mistaken)
    assert points(stone, a=0) == {"a": 0}


def test_a_small_number_is_no_zero(stone):
    assert isinstance(judged(stone, a=0.01)["a"], Wrong)


def test_a_number_that_follows_from_itself_earns_nothing_the_second_time(verdicts):
    """With v_A = 5 m/s and a wall at -2 m/s, -1 m/s after the hit is a sign wrong, and -1 m/s is what follows from it."""
    found = verdicts("S12.5wall", a="-1 m/s", b="-1 m/s")
    assert isinstance(found["a"], Mistaken)
    assert found["b"] == Follows(("a",), nothing=True)


def test_a_mistake_that_copies_a_wrong_answer_earns_nothing(stone):
    assert points(stone, b=6.0) == {"b": 0.25}
    assert points(stone, a=7.0, b=7.0, c=1.0, d=2.0)["b"] == 0


def test_one_figure_is_never_right_nor_nearly(stone):
    """1e1 is what 9 J comes to in one figure, and 5.1 kg m/s and 14 kg m/s as well."""
    assert isinstance(judged(stone, b="1e1 J")["b"], Slip)
    assert points(stone, a="5 kg m/s", b="1e1 J") == {"a": 0, "b": 0}


def test_a_slip_of_one_digit_is_told_and_earns_nothing_but_for_its_sign(stone):
    """300 N is a hundred times 3 N, and what anybody may type; -3 N is 3 N the wrong way round."""
    assert isinstance(judged(stone, c=300)["c"], Slip)
    assert points(stone, c=300) == {"c": 0}
    assert points(stone, c=-3) == {"c": 0.5}
    assert points(stone, b="4.5 J") == {"b": 0.5}


def test_another_factor_is_another_slip(stone):
    """Told in the same words, for these give no factor away; only the very same is paid for."""
    assert points(stone, a="12 kg m/s", b="4.5 J")["b"] == 0.5
    assert points(stone, c="6.00001 N", d="6.00002 m") == {"c": 0.5, "d": 1.0}
    assert points(stone, c=300, d=300)["d"] == 0


def test_the_wrong_option_earns_what_the_set_says(key):
    stone = key("T1")
    found = judge(stone, {"d": from_json("c")})
    assert isinstance(found["d"][0][0], Mistaken)
    marks = [
        {each.part.id: each.points for each in grade(stone, found, scheme).parts}
        for scheme in (Scheme(), Scheme(choice=0.2))
    ]
    assert (marks[0]["d"], marks[1]["d"]) == (0, 0.2)


TURNED = """
    v: {is: velocity, value: 7.3, from: 1, to: 9, step: 0.1, unit: m/s}
    m: {is: mass, value: 2.1, from: 1, to: 9, step: 0.1, unit: kg}
    alpha: {is: angle, value: 45, from: 10, to: 45, step: 0.5, unit: deg}
    r: {is: share, value: 0.5, from: 0.1, to: 0.9, step: 0.01}
"""
TURNED_STEPS = """
    beta, p, P, w, eta, K, V = unknowns("beta p P w eta K V")
    return derivation(
        step(beta, "Twice.", law("A", "beta = 2*alpha"), answers="a"),
        step(p, "As ever.", law("B", "p = m*v"), answers="b"),
        step(P, "The other way.", law("C", "P = -2*m*v"), answers="c"),
        step(w, "Turned round.", law("D", "w = -v"), answers="d"),
        step(eta, "As given.", law("E", "eta = r"), answers="e"),
        step(K, "Lost.", law("F", "K = -m*v^2/2"), answers="f"),
        step(V, "A share.", law("G", "V = -r*v*m/(m + m*r)"), answers="g"),
    )
"""
TURNED_PARTS = "a deg\nb kg*m/s\nc kg*m/s\nd m/s\ne 1\nf J\ng m/s"


@pytest.fixture(scope="module")
def turned(tmp_path_factory: pytest.TempPathFactory) -> Key:
    """90°, 15.33 kg m/s, -30.66 kg m/s, -7.3 m/s, 0.5, -55.95 J, -2.433 m/s."""
    folder = tmp_path_factory.mktemp("turned")
    solution = solved(folder, TURNED, TURNED_PARTS, TURNED_STEPS, "v, m, alpha, r")
    return make_key(solution, chosen(solution.problem, dict[str, Fraction]()))


def of_angles(key: Key, degrees: str) -> Key:
    return make_key(key.solution, chosen(key.solution.problem, {"alpha": Fraction(degrees)}))


@pytest.mark.parametrize(
    "typed", ["45°", "180°", "-90°", "45", "0.785 rad", "3.14 rad", "900°", "pi/4", "360 deg"]
)
def test_a_round_angle_is_a_guess(turned, typed):
    found = judged(turned, a=typed)["a"]
    assert isinstance(found, Wrong)
    assert "factor" not in found.why
    assert "sign" not in found.why


@pytest.mark.parametrize(
    "typed", ["-74.6°", "149.2°", "37.3°", "746°", "7.46°", "7.46", "0.746°", "13.02 rad"]
)
def test_no_factor_of_an_angle_is_a_slip_nor_a_sign_that_it_never_has(turned, typed):
    assert points(of_angles(turned, "37.3"), a=typed) == {"a": 0}


@pytest.mark.parametrize("typed", ["0.25", "1", "-0.5", "1.0", "2", "25 %", "0.05"])
def test_a_simple_share_is_a_guess(turned, typed):
    assert points(turned, e=typed) == {"e": 0}


@pytest.mark.parametrize(
    "answers",
    [
        {"c": "-15.33 kg m/s"},  # the answer of (b), turned round
        {"c": "15.33 kg m/s"},
        {"b": "15.33 kg m/s", "c": "15.33 kg m/s"},
        {"b": "15.33 kg m/s", "c": "61.3 kg m/s"},
        {"d": "7.3 m/s"},  # a given copied
        {"a": "45°"},
    ],
)
def test_the_answer_of_another_part_times_a_round_factor_earns_nothing(turned, answers):
    (last,) = [*answers][-1:]
    assert points(turned, **answers)[last] == 0


@pytest.mark.parametrize(
    "answers",
    [
        {"b": "30.66 kg m/s"},
        {"b": "-15.33 kg m/s"},
        {"c": "30.66 kg m/s"},  # its sign alone: the size had to be found
        {"f": "55.95 J"},
        {"g": "2.433 m/s"},
        {"g": "-4.867 m/s"},
    ],
)
def test_a_slip_of_an_answer_that_stands_nowhere_else_earns_its_half(turned, answers):
    ((part, _),) = answers.items()
    assert points(turned, **answers) == {part: 0.5}


def test_what_has_no_direction_has_none_to_check(turned):
    energy, velocity = judged(turned, f="55.95 J")["f"], judged(turned, g="2.433 m/s")["g"]
    assert "direction" not in energy.slip
    assert "sign is wrong" in energy.slip
    assert "which direction is positive" in velocity.slip


MULTIPLES = """
    p, F, Q, w = unknowns("p F Q w")
    return derivation(
        step(p, "As ever.", law("B", "p = m*v"), answers="a"),
        step(F, "Per time.", law("F", "F = p/t"), answers="b"),
        step(Q, "As large.", law("Q", "Q = 50*p*s"), answers="c"),
        step(w, "Turned.", law("W", "w = -F*t/m*s"), answers="d"),
    )
"""
MULTIPLES_GIVENS = """
    m: {is: mass, value: 0.32, from: 0.1, to: 0.9, step: 0.01, unit: kg}
    v: {is: velocity, value: 21, from: 10, to: 30, step: 1, unit: m/s}
    t: {is: time, value: 20, from: 10, to: 30, step: 1, unit: ms}
    s: {is: share, value: 0.7, from: 0.1, to: 0.9, step: 0.01}
"""


@pytest.fixture(scope="module")
def multiples(tmp_path_factory: pytest.TempPathFactory) -> Key:
    """6.72 kg m/s, 336 N, 235.2 kg m/s, -14.7 m/s."""
    folder = tmp_path_factory.mktemp("multiples")
    solution = solved(folder, MULTIPLES_GIVENS, "a kg*m/s\nb N\nc kg*m/s\nd m/s", MULTIPLES, "m, v, t, s")
    return make_key(solution, chosen(solution.problem, dict[str, Fraction]()))


@pytest.mark.parametrize(
    ("answers", "earned"),
    [
        ({"a": "6.72 kg m/s", "b": "672 N"}, 0),  # twice 336 N, and the digits of (a)
        ({"b": "672 N"}, 0.5),
        ({"a": "", "b": "672 N"}, 0.5),
        ({"a": "6.7 kg m/s", "b": "670 N"}, 0),
        ({"a": "5.1 kg m/s", "b": "510 N"}, 0),  # twice what follows, and the digits of a wrong (a)
        ({"a": "6.72 kg m/s", "b": "168 N"}, 0.5),
        ({"a": "6.72 kg m/s", "b": "33.6 N"}, 0.5),
        ({"a": "6.72 kg m/s", "b": "-336 N"}, 0.5),
        ({"a": "6.72 kg m/s", "c": "470.4 kg m/s"}, 0.5),
    ],
)
def test_the_digits_of_another_answer_earn_nothing_as_a_factor(multiples, answers, earned):
    (last,) = [*answers][-1:]
    assert points(multiples, **answers)[last] == earned


def test_an_angle_of_one_figure_earns_nothing(turned):
    assert points(turned, a="9°") == {"a": 0}
