"""Numbers at the edge of what a double holds are answered, and never with a traceback."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.answers.evaluation import holds_nearly
from corollary.cli.commands import app
from corollary.formula.ast import Name, Number, Product, Relation
from corollary.formula.rational_pi import RationalPi
from corollary.problem.bank import chapter_bank


@pytest.mark.parametrize("value", [5e-324, 1e308, 1e-200])
def test_an_example_of_tiny_or_huge_numbers_is_judged_by_the_laws(value: float, tmp_path: Path) -> None:
    problem = next(each for each in chapter_bank() if each.code == "X12.2")
    (part,) = (part.id for part in problem.parts if part.answer_type == "example")
    cases = tmp_path / "cases.json"
    cases.write_text(json.dumps([{"given": {}, "answers": {part: [value] * 4}}]))
    done = CliRunner().invoke(app, ["judge", "X12.2", "--cases", str(cases), "--json"])
    assert done.exit_code == 0, done.stderr
    judged = json.loads(done.stdout)[0]["parts"][part]
    assert judged["verdict"] == "wrong"
    assert "conservation of momentum" in judged["feedback"]


@pytest.mark.parametrize("size", ["1e-200", "1e-300", "5e-324"])
def test_products_below_the_least_double_do_not_agree_by_being_zero(size: str) -> None:
    a = RationalPi(Fraction(size))
    product, double = (
        Product((Name("a"), Name("b"))),
        Product((Number(Fraction(2)), Name("a"), Name("b"))),
    )
    assert not holds_nearly(Relation("=", product, double), {"a": a, "b": a}, 0.01)
    assert holds_nearly(Relation("=", product, product), {"a": a, "b": a}, 0.01)
