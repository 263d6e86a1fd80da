"""An answer in the letters of its sheet, where a given has been called otherwise since."""

from __future__ import annotations

from corollary.answers.answer import Formulas, Unclear
from corollary.answers.letters import in_letters
from corollary.formula.syntax import author_formula
from corollary.formula.text import text


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
