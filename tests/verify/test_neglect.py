"""What answers neglect: bounded by laws, small enough on every variant, told in the worked solution, and met by scenes."""

from __future__ import annotations

import re

import pytest
from tests.chapter_problems import PROBLEMS

from corollary.grading.neglect import neglected_in, neglects
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, find
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter

BANK = chapter_bank()
KNOWN = Solutions(BANK)
SLOWED = """\
    E, J_d = unknowns("E J_d")
    tau, touch = supposed("tau", "%s", "it is over sooner")
    return derivation(
        step(p, "Mass times velocity.", momentum(p, m, v), answers="a"),
        step(F, "Per time.", mean_force(F, p, t), answers="b"),
        neglected("a", "a drag of a hundredth of the weight", J_d, "It acts for the time τ.",
                  law("Drag", "J = m*g*tau/100", J=J_d, m=m, g=%s, tau=tau)%s),
    )
"""
GRAVITY = 'supposed("g", "10 m/s^2", "")[0]'
SCENE = """

def scene(m, v, t, answer, neglected):
    drag = neglected["a"] / t
    return [simulate("kick", {"m": m, "v0": 0.0, "F": answer["b"] - drag, "dt": t}, impulse=answer["a"], neglected=neglected["a"] / answer["a"]),
            simulate("kick", {"m": m, "v0": 0.0, "F": answer["b"] - %s * drag, "dt": t}, impulse=answer["a"], neglected=neglected["a"] / answer["a"])]
"""


def body(time: str = "20 ms", rest: str = ", supposing=[touch, fall]") -> str:
    return "g, fall = supposed('g', '10 m/s^2', 'on the ground')\n" + "\n".join(
        line.removeprefix("    ") for line in (SLOWED % (time, "g", rest)).splitlines()
    )


def test_an_effect_small_enough_is_sound_and_counted_on_every_variant(verified):
    checked = verified(body())
    assert checked.ok, checked.complaints
    assert checked.checks["neglected effects"] == 20
    assert checked.checks["laws put back"] == 3
    assert checked.checks["dimensions"] == 3


def test_an_effect_too_large_is_met_where_it_is_bounded(verified):
    checked = verified(body("2000 ms"))
    assert not checked.ok
    assert "cart.py:14: part a of X1.1#" in checked.complaints[0]
    assert (
        "neglects a drag of a hundredth of the weight, which may change the answer by"
        in checked.complaints[0]
    )


def test_what_the_question_wants_left_out_may_be_large(verified):
    assert verified(body("2000 ms", ", supposing=[touch, fall], asked=True")).ok


def test_the_effect_switched_on_in_a_scene_stays_within_the_bound_or_is_met(verified):
    assert verified(body(), SCENE % "0.5").ok


def test_a_scene_beyond_the_bound_is_met(verified):
    checked = verified(body(), SCENE % "1.5")
    assert any(
        "impulse is" in complaint and "where the algebra says" in complaint
        for complaint in checked.complaints
    )


@pytest.mark.parametrize(
    ("time", "rest", "words"),
    [
        ("soon", ", supposing=[touch, fall]", "tau is supposed to be 'soon'"),
        ("3 degrees", ", supposing=[touch, fall]", "give angles in rad"),
        ("20 m", ", supposing=[touch, fall]", "it is"),
        ("20 ms", ", supposing=[fall]", "tau"),
    ],
)
def test_a_bound_that_cannot_be_found(verified, time, rest, words):
    (complaint,) = verified(body(time, rest)).complaints
    assert complaint.startswith("cart.py:14: what part a neglects: ")
    assert words in complaint


def test_only_of_numbers_something_is_neglected(verified, problem):
    asked = problem.replace(
        '## Momentum {#a .value unit="kg*m/s"}\nHow large?', "## Momentum {#a .explain}\nWhy?"
    )
    (complaint,) = verified(body().replace('step(p, "Mass times velocity.", momentum(p, m, v), answers="a")', 'explain("a", "Says.", answer="So.")'),
                            problem=asked).complaints  # fmt: skip
    assert "only of a number can be said what is neglected in it" in complaint


def test_the_chapters_own_checks_of_the_tennis_ball_are_the_bounds():
    key = KNOWN.key(chapter(find(BANK, "E12.3.2")))
    weight = {each.part: each for each in neglects(key)}
    assert weight["c2"].most == pytest.approx(key.truths["d1"].values[0])  # (12.33)
    assert weight["c2"].share == pytest.approx(0.5586 / 922.5, rel=1e-3)
    assert neglected_in(key)["a"] == 0.0


CODES = sorted(
    problem.code
    for problem in PROBLEMS
    if re.search(r"neglected[(:]", BANK.solution(problem).read_text(encoding="utf-8"))
)


def test_many_problems_say_what_they_neglect():
    assert len(CODES) >= 9


@pytest.mark.parametrize("code", CODES)
def test_each_is_told_with_its_size(code):
    problem = find(BANK, code)
    for variant in (chapter(problem), next(iter(sample(problem, 1)))):
        key = KNOWN.key(variant)
        told = KNOWN.worked_solution_of(key)
        assert told.count("*Neglected:* ") == len(key.solution.neglected) > 0
        assert told.count("it may be neglected") + told.count(
            "left out since the question asks for it"
        ) == len(key.solution.neglected)
        assert "nan" not in told
        for each in neglects(key):
            assert each.left.asked or each.share < 0.02
