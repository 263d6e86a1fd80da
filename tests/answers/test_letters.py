"""An answer in the letters of its sheet, where a given has been called otherwise since."""

from __future__ import annotations

from corollary.answers.answer import Chain, Formulas, Unclear
from corollary.answers.proof.steps import steps_of
from corollary.answers.renamed_letters import in_letters
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula


def test_a_formula_is_put_into_the_letters_of_today():
    found = in_letters(Formulas((author_formula("M*v/T"),), "M v/T"), {"M": "m", "T": "dt"})
    assert isinstance(found, Formulas)
    assert text(found.trees[0]) == "m*v/dt"
    assert found.as_read == "M v/T"


def test_letters_that_change_places_do():
    found = in_letters(Formulas((author_formula("a - 2*b"),), ""), {"a": "b", "b": "a"})
    assert isinstance(found, Formulas)
    assert text(found.trees[0]) == "b - 2*a"


def test_readings_of_an_unclear_answer_are_put_too():
    found = in_letters(Unclear("which", "", (Formulas((author_formula("M*v"),), ""),)), {"M": "m"})
    assert isinstance(found, Unclear)
    assert [text(each.trees[0]) for each in found.readings if isinstance(each, Formulas)] == ["m*v"]


def test_the_lines_of_a_derivation_are_put_and_a_letter_of_the_student_s_own_stays_apart():
    """The sheet had M for what is m today; the student calls M*v by the letter m."""
    steps = steps_of([(1, "m = M*v"), (2, "p = m")], ("M", "v", "p"))
    assert isinstance(steps, tuple)
    assert [step.defines for step in steps] == ["m", ""]
    found = in_letters(Chain(steps, "m = M*v"), {"M": "m"})
    assert isinstance(found, Chain)
    assert [text(step.relation) for step in found.steps] == ["m_own = m*v", "p = m_own"]
    assert [step.defines for step in found.steps] == ["m_own", ""]
    same = in_letters(Chain(steps, ""), {"v": "w"})
    assert isinstance(same, Chain)
    assert [text(step.relation) for step in same.steps] == ["m = M*w", "p = m"]


def test_two_letters_of_a_sheet_that_changed_places_are_no_letters_of_the_student_s_own():
    steps = steps_of([(1, "p = a*v"), (2, "q = b*v")], ("a", "b", "v", "p", "q"))
    assert isinstance(steps, tuple)
    found = in_letters(Chain(steps, ""), {"a": "b", "b": "a"})
    assert isinstance(found, Chain)
    assert [text(step.relation) for step in found.steps] == ["p = b*v", "q = a*v"]
