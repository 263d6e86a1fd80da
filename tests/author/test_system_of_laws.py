"""One step that answers several parts: its laws are solved together, and a mistake in one of them reaches every part."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from corollary.api import judge, key, load_bank, solve
from corollary.derive.load import NotDerivable, load
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, find
from corollary.problem.variant import chapter

BANK = Path(__file__).with_name("bank")
G = 9.81


@pytest.fixture(scope="module")
def plank():
    return solve(find(load_bank(BANK), "ONE.1"))


@pytest.fixture(scope="module")
def cells():
    return solve(find(load_bank(BANK), "ONE.2"))


def forces(balance, torque, right=((1.0, 1.0), (0.0, 3.0))):
    """The forces of the supports: two equations, solved by numpy."""
    return np.linalg.solve(np.array(right), np.array([balance, torque]))


def test_each_part_has_its_value(plank):
    wanted = forces(37 * G, (12 * 1.5 + 25 * 0.8) * G)
    found = key(plank)
    assert [found.truths[part].values[0] for part in "ab"] == pytest.approx(list(wanted), rel=1e-12)


def test_a_part_of_two_components_and_a_part_of_one_share_a_system(cells):
    matrix = [[1, 1, -1], [2, 0, 6], [0, 1, 6]]
    first, second, lamp = np.linalg.solve(np.array(matrix, float), np.array([0.0, 9.0, 4.0]))
    found = key(cells)
    assert found.truths["a"].values == pytest.approx((first, second), rel=1e-12)
    assert found.truths["b"].values == pytest.approx((lamp,), rel=1e-12)
    assert found.truths["c"].values == pytest.approx((6 * lamp**2,), rel=1e-12)


def test_a_mistake_in_one_law_is_named_in_every_part_that_it_changes(plank):
    left, right = forces(37 * G, (12 * 1.5 + 25 * 2.2) * G)  # the arm from the other end
    graded = judge(plank, {"a": f"{left:.1f} N", "b": f"{right:.1f} N"})
    assert "so the arm of the bucket" in graded.parts[0].feedback
    assert graded.parts[0].points < graded.parts[0].out_of
    alone = judge(plank, {"b": f"{right:.1f} N"})
    assert "so the arm of the bucket" in alone.parts[1].feedback


def test_a_mistake_belongs_to_no_part_that_it_leaves_as_it_is(plank):
    texts = {find.part: [mistake.text for mistake in find.mistakes] for find in plank.unknowns}
    assert "The plank has a weight, too." in texts["a"]
    assert "The plank has a weight, too." not in texts["b"]


def test_one_answer_follows_from_a_wrong_other_one_by_a_law_of_the_system(plank):
    graded = judge(plank, {"a": "200 N", "b": f"{37 * G - 200:.1f} N"})
    assert graded.parts[0].points == 0
    assert graded.parts[1].points > 0
    assert "(a)" in graded.parts[1].feedback


def test_the_worked_solution_states_each_law_once():
    place = load_bank(BANK)
    text = Solutions(place).worked_solution(chapter(find(place, "ONE.1")))
    assert text.count("Balance of forces:") == 1
    assert re.search(r"### \(b\) Right support.*\n\nThe same laws give this, too\.", text)
    assert "238.7" in text
    assert "124.3" in text


PYTHON = '''\
"""The supports carry the plank and the bucket together."""
from corollary.author import at, confirm, derivation, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, M, L, x, g):
    F_1, F_2 = unknowns("F_1 F_2")
    torques = "Balance of torques about the left end"
    return derivation(
        step((F_1, F_2), "Nothing moves: the forces are balanced, and so are the torques about the left end.",
             law("Balance of forces", "F_1 + F_2 = m*g + M*g"), law(torques, "F_2*L = m*g*L/2 + M*g*x"),
             answers={ANSWERS},
             mistakes=[
                 mistake("The plank has a weight, too.", wrong("F_1 + F_2 = M*g"), instead="Balance of forces"),
                 mistake("The weight of the plank acts in its middle.", wrong("F_2*L = m*g*L + M*g*x"), instead=torques),
                 mistake("The torque is reckoned about the left end, so the arm of the bucket is its distance from there.",
                         wrong("F_2*L = m*g*L/2 + M*g*(L - x)"), instead=torques),
             ],
             check="A bucket in the middle is carried by both alike."),
        at("a bucket in the middle", x=L/2, F_1=(m + M)*g/2, F_2=(m + M)*g/2),
        confirm("The torques about the right end are balanced as well.",
                law("Torques about the right end", "F_1*L = m*g*L/2 + M*g*(L - x)")),
    )
'''


def in_python(folder: Path, answers: str) -> Bank:
    problem = (BANK / "problems" / "statics" / "plank.md").read_text(encoding="utf-8")
    for name, text in (
        ("problems/plank.md", problem),
        ("solutions/plank.py", PYTHON.replace("{ANSWERS}", answers)),
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return Bank(folder)


def stated(place: Bank) -> str:
    return re.sub(r"line=\d+", "", repr(load(place, find(place, "ONE.1")).branches))


def test_python_words_state_the_same(tmp_path):
    assert stated(in_python(tmp_path, '{"a": F_1, "b": F_2}')) == stated(Bank(BANK))


@pytest.mark.parametrize(
    ("answers", "words"),
    [
        ('{"a": F_1, "b": F_1}', "F_1 answers a part, and answers it twice"),
        ('{"a": F_1, "b": m}', "m answers a part, and is none of the unknowns of the step"),
        ('{"a": F_1}', "answers no part b"),
        ('{"a": (F_1, F_2), "b": ()}', "part a asks for one number, but F_1, F_2 is found"),
    ],
)
def test_what_does_not_answer_the_parts_is_refused(tmp_path, answers, words):
    place = in_python(tmp_path, answers)
    with pytest.raises(NotDerivable, match=re.escape(words)):
        solve(find(place, "ONE.1"))


@pytest.mark.parametrize(
    ("heading", "words"),
    [
        ("(a, b) F_1", "2 parts are answered, and 1 letters are found: name one for each"),
        ("(a) F_1; F_2 (b)", "a heading is a part in brackets"),
        ("(a) F_1; (b)", "a heading is a part in brackets"),
    ],
)
def test_a_heading_that_fits_nothing_is_refused_with_its_line(tmp_path, heading, words):
    for folder in ("problems", "solutions"):
        text = (BANK / folder / "statics" / "plank.md").read_text(encoding="utf-8")
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "plank.md").write_text(
            text.replace("(a, b) F_1, F_2", heading), encoding="utf-8"
        )
    with pytest.raises(NotDerivable, match=re.escape(words)) as fault:
        solve(find(Bank(tmp_path), "ONE.1"))
    assert fault.value.line == 3
