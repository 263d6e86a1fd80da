"""Who gets which numbers: distinct while they last, the same again, and none on which a mistake looks right."""

from __future__ import annotations

from textwrap import dedent

import pytest

from corollary.answers.verdict import Follows, Right
from corollary.formula.value import Real
from corollary.grading.assign import admitted, assign_variant, collisions
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.grading.replay import WhatIf, replay
from corollary.grading.rounding import MOST
from corollary.grading.solutions import Solutions
from corollary.problem.bank import home
from corollary.problem.sampling import sample

SECRET = b"a course"


def dealt(solution, roster, secret=SECRET):
    """One after the other, as they stand on the roster."""
    taken: list[int] = []
    for student in roster:
        index = assign_variant(solution, secret, student, taken).variant.index
        assert index is not None
        taken.append(index)
    return taken


@pytest.fixture(scope="module")
def four(tmp_path_factory):
    """A problem with four variants."""
    folder = tmp_path_factory.mktemp("four")
    for place, text in (
        (
            "problems/all/push.md",
            """
            ---
            code: T2
            title: A push
            given:
              m: {is: mass, value: 2, from: 2, to: 5, step: 1, unit: kg}
              a: {is: acceleration, value: 3, unit: m/s^2}
            ---
            Push {{m}} at {{a}}.

            ## Force {#a .value unit="N" points=1}
            Which force?
         """,
        ),
        (
            "solutions/all/push.py",
            '''
            """A push."""

            from corollary.author import derivation, step, unknown
            from corollary.laws import law


            def derive(m, a):
                F = unknown("F")
                return derivation(step(F, "Newton.", law("Newton's second law", "F = m*a", F=F, m=m, a=a), answers="a"))
         ''',
        ),
    ):
        (folder / place).parent.mkdir(parents=True)
        (folder / place).write_text(dedent(text).lstrip(), encoding="utf-8")
    place, problem = home(folder, "T2")
    return Solutions(place).of(problem)


def test_distinct_students_have_distinct_variants_while_they_last(four):
    taken = dealt(four, ["ada", "ben", "cy", "dee", "eve", "fay"])
    assert sorted(taken[:4]) == [0, 1, 2, 3]
    assert set(taken[4:]) <= {0, 1, 2, 3}


def test_twenty_students_of_a_large_grid_are_all_different(solution):
    taken = dealt(solution("X12.5"), [f"student {n}" for n in range(20)])
    assert len(set(taken)) == 20


def test_a_student_added_at_the_end_changes_nobody(solution):
    roster = [f"student {n}" for n in range(8)]
    assert dealt(solution("X12.10"), [*roster, "late"])[:8] == dealt(solution("X12.10"), roster)


def test_another_course_deals_other_numbers(solution):
    roster = [f"student {n}" for n in range(6)]
    assert dealt(solution("X12.5"), roster) != dealt(solution("X12.5"), roster, b"another course")


def test_what_is_dealt_is_admitted(solution):
    for student in ("ada", "ben", "cy"):
        found = assign_variant(solution("X12.8"), SECRET, student)
        key, why = admitted(solution("X12.8"), found.variant)
        assert key is not None, why
        assert found.passed_over >= 0


def test_a_variant_on_which_a_mistake_looks_right_is_passed_over(solution):
    """Whatever is refused for a mistake has one within the tolerance, and half a per cent, of the truth; nothing else is."""
    solved, met = solution("X12.8"), 0
    for variant in sample(solved.problem, 60, salt="deal test"):
        key, why = admitted(solved, variant)
        found = list(collisions(make_key(solved, variant)))
        assert bool(found) == ("cannot be told from the truth" in why), why
        met += key is None
    assert met > 0


def test_no_variant_dealt_has_more_noise_than_is_allowed(solution):
    for code in ("X12.10", "P12.14"):
        for variant in sample(solution(code).problem, 10, salt="noise test"):
            key, why = admitted(solution(code), variant)
            noisy = any(truth.noise > MOST for truth in make_key(solution(code), variant).truths.values())
            assert not noisy or key is None, why


@pytest.mark.parametrize("code", ["X12.5", "X12.8", "X12.10"])
def test_no_listed_mistake_is_right_on_what_is_dealt(solution, code):
    """Followed exactly, each mistake is neither right nor does it follow, at the part of its own step."""
    solved = solution(code)
    for variant in sample(solved.problem, 10, salt="mistake test"):
        key, _ = admitted(solved, variant)
        if key is None:
            continue
        for place, find in enumerate(solved.finds):
            for wrong in find.mistakes if find.answers and len(find.names) == 1 else ():
                value = replay(solved, variant.exact, WhatIf(rules={place: wrong.rule}), place)[place][0]
                ((verdict,), _) = judge(
                    key, {find.answers: Real(value / float(solved.problem.part(find.answers).unit.factor))}
                )[find.answers]
                assert not isinstance(verdict, (Right, Follows)), (variant.label, wrong.text)
