"""Claims about problems with tables: proven for the rows that there are, though not for all mixtures of their columns."""

from __future__ import annotations

import pytest

from corollary.problem.bank import Bank, find
from corollary.problem.reader import read_problem
from corollary.problem.sampling import spread
from corollary.verify.verify import verify
from corollary.verify.walk import TriedDraw, narrower

PROBLEM = """\
---
code: X1.1
title: A quotient
given:
  n: {is: number, value: 2, from: 1, to: 4, step: 1}
  a: {is: one}
  b: {is: other}
rows:
  - {name: alpha, a: 11, b: 12}
  - {name: beta, a: 12, b: 13}
  - {name: gamma, a: 13, b: LAST}
require: [n > 0, a > 0, b > 0]
---
Of {{name}}, {{n}}, {{a}} and {{b}}.

## Quotient {#a .value}
How large is it?
"""
SOLUTION = """\
A quotient.

## (a) x

It is the quotient of the number and the difference.

- law: Quotient, `x*(b - a) = n`
- mistake: You added. `x*(b + a) = n`
- mistake: You took the other one. `x*b = n`
"""


@pytest.fixture
def verified(tmp_path):
    def put(last: str, problem: str = PROBLEM, solution: str = SOLUTION):
        for folder, text in (("problems", problem.replace("LAST", last)), ("solutions", solution)):
            (tmp_path / folder / "numbers").mkdir(parents=True)
            (tmp_path / folder / "numbers" / "quotient.md").write_text(text, encoding="utf-8")
        bank = Bank(tmp_path)
        return verify(bank, find(bank, "X1.1"), 20)

    return put


def outcomes(checked, kind: str) -> list[str]:
    return [each.outcome for each in checked.obligations if each.kind == kind]


def test_what_holds_for_each_row_is_proven_though_columns_mixed_would_break_it(verified):
    """b - a is 0 for the a of beta and the b of alpha, which nobody gets."""
    checked = verified("14")
    assert not checked.complaints
    for kind in ("value exists", "one root", "laws hold", "not zero"):
        assert outcomes(checked, kind) == ["proven"], kind


PRODUCT = """\
A product.

## (a) x

It is the product of the number and the difference.

- law: Product, `x = n*(b - a)`
- mistake: You added. `x = n*(b + a)`
- mistake: You took the other one. `x = n*b`
"""


def test_one_row_that_breaks_a_claim_is_the_counter_example(verified):
    """The product is negative for gamma alone."""
    checked = verified("12", solution=PRODUCT + "\n## Checks\n\n- always: it is positive `x > 0`\n")
    (broken,) = [each for each in checked.obligations if each.kind == "claimed"]
    assert broken.outcome == "counter-example"
    assert (broken.numbers["a"], broken.numbers["b"]) == ("13", "12")
    assert any("a = 13, b = 12" in each for each in checked.complaints)


def test_of_what_is_redrawn_each_row_has_its_share(verified):
    """The answer is 0 for gamma, a third of all draws."""
    checked = verified("13", solution=PRODUCT)
    (redrawn,) = [each for each in checked.obligations if each.kind == "not zero"]
    assert redrawn.broken == pytest.approx(1 / 3)
    assert (redrawn.numbers["a"], redrawn.numbers["b"]) == ("13", "13")


def test_a_row_that_a_condition_leaves_out_breaks_nothing_and_is_named(verified):
    checked = verified("13", PROBLEM.replace("b > 0]", "b > 0]\nwhere: b != a"))
    assert not checked.complaints
    assert outcomes(checked, "value exists") == ["proven"]
    notes = [each for each in checked.notes if "was not dealt" in each]
    assert len(notes) == 1
    assert "the row (a: 13, b: 13, name: gamma)" in notes[0]


def test_each_row_is_walked(verified):
    assert verified("14").checks["rows walked"] == 3


def test_numbers_of_a_row_need_not_stand_in_the_text_where_its_words_do(verified):
    silent = PROBLEM.replace(", {{a}} and {{b}}", "")
    assert not [each for each in verified("14", silent).notes if "not in the text" in each]


def test_numbers_of_a_row_without_words_must_stand_in_the_text(verified):
    silent = PROBLEM.replace(", {{a}} and {{b}}", "").replace("Of {{name}}", "Of something")
    notes = [each for each in verified("14", silent).notes if "not in the text" in each]
    assert {each.split("the given ")[1].split()[0] for each in notes} == {"name", "a", "b"}


def test_a_row_of_which_all_draws_are_refused_is_the_one_to_leave_out(tmp_path):
    path = tmp_path / "quotient.md"
    path.write_text(
        PROBLEM.replace("LAST", "14").replace("to: 4, step: 1", "to: 40, step: 1"), encoding="utf-8"
    )
    draws = spread(read_problem(path), 200, salt="test")
    found = narrower([TriedDraw(each, each.values["a"] != 12) for each in draws])
    assert (
        found
        == "with the row (a: 12, b: 13, name: beta) left out it would be 0 % of them; beyond that it is 100 %"
    )
