"""Rows of a table: drawn whole and independently of the rest, counted, chosen by hand, translated, and what is wrong with a table."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

import pytest

from corollary.api import variant
from corollary.messages import language
from corollary.problem.count import variants
from corollary.problem.sampling import draws, sample_of_row
from corollary.problem.statement import filled
from corollary.problem.translation import in_language, to_translate
from corollary.problem.variant import at, chapter, first_broken, index_of, size

ROLLING = """\
code: X1.1
title: Rolling
given:
  h: {is: height, value: 2, from: 1, to: 5, step: 1, unit: m}
  k: {is: moment factor}
  rho: {is: density, unit: g/cm^3}
rows:
  - {body: a hoop, k: 1, rho: 7.870}
  - {body: a ball, k: 2/5, rho: 11.3}
  - {body: a disc, k: 0.50, rho: 11.3}
"""
ASKS = "\n{{body}} of {{rho}} from {{h}}: k = {{k}}.\n\n## Speed {#a .value}\nHow fast?\n"
TABLE = {
    ("a hoop", Fraction(1), Fraction(787, 100)),
    ("a ball", Fraction(2, 5), Fraction(113, 10)),
    ("a disc", Fraction(1, 2), Fraction(113, 10)),
}
TWO = """\
code: X1.1
title: Two tables
given:
  c: {is: specific heat of the metal}
  C: {is: specific heat of the liquid}
rows:
  metals: [{metal: iron, c: 4}, {metal: lead, c: 1}, {metal: tin, c: 2}]
  liquids: [{liquid: water, C: 40}, {liquid: oil, C: 20}]
"""
TWO_ASK = "\n{{metal}} {{c}} {{liquid}} {{C}}\n\n## A {#a .value}\nHow much?\n"


def row(problem, drawn) -> tuple[str, Fraction, Fraction]:
    return problem.given("body").words[int(drawn.values["body"])], drawn.values["k"], drawn.values["rho"]


def test_a_row_is_drawn_whole(read):
    problem = read(ROLLING, ASKS)
    every = [at(problem, index) for index in range(size(problem))]
    assert len(every) == 5 * 3
    assert {row(problem, each) for each in every} == TABLE
    assert len({(each.values["h"], *row(problem, each)) for each in every}) == 15
    assert [index_of(problem, each.values) for each in every] == list(range(15))


def test_a_row_that_is_none_has_no_place_in_the_grid(read):
    problem = read(ROLLING, ASKS)
    mixed = {**chapter(problem).values, "k": Fraction(2, 5)}
    assert index_of(problem, mixed) is None


def test_the_first_row_is_printed_and_numbers_stand_as_they_are_written(read):
    problem = read(ROLLING, ASKS)
    assert filled(problem.statement, chapter(problem)) == "a hoop of 7.870\xa0g/cm³ from 2\xa0m: k = 1."
    texts = {filled("{{rho|number}} {{k}}", at(problem, index)) for index in range(size(problem))}
    assert texts == {"7.870 1", "11.3 0.4", "11.3 0.50"}


def test_students_get_every_row(read):
    problem = read(ROLLING, ASKS)
    dealt = Counter(row(problem, next(draws(problem, b"k" * 32, f"student {n}"))) for n in range(300))
    assert dealt.keys() == TABLE
    assert all(60 < number < 140 for number in dealt.values())  # 100 expected, with a spread of 8


@pytest.mark.parametrize(
    "condition", ["where: k < 0.9", "where: [k*h > 1 m, rho > 8 g/cm^3]", "where: h > 2 m", ""]
)
def test_rows_are_counted_as_one_by_one(read, condition):
    problem = read(ROLLING + condition, ASKS)
    one_by_one = sum(first_broken(at(problem, index)) is None for index in range(size(problem)))
    assert variants(problem) == (one_by_one, True)


def test_tables_are_drawn_independently(read):
    problem = read(TWO, TWO_ASK)
    texts = {filled(problem.statement, at(problem, index)) for index in range(size(problem))}
    metals, liquids = ("iron 4", "lead 1", "tin 2"), ("water 40", "oil 20")
    assert texts == {f"{metal} {liquid}" for metal in metals for liquid in liquids}
    assert variants(problem) == (6, True)


def test_a_number_or_a_word_chosen_by_hand_brings_its_row(read):
    problem = read(ROLLING, ASKS)
    assert row(problem, variant(problem, {"body": "a disc"})) == ("a disc", Fraction(1, 2), Fraction(113, 10))
    assert row(problem, variant(problem, {"k": "0.4"})) == ("a ball", Fraction(2, 5), Fraction(113, 10))
    own = row(problem, variant(problem, {"body": "a ball", "k": 0.37}))  # a value beside the grid is allowed
    assert own == ("a ball", Fraction(37, 100), Fraction(113, 10))


def test_each_row_has_a_sample(read):
    problem = read(ROLLING, ASKS)
    columns = tuple(problem.given(symbol) for symbol in ("k", "rho", "body"))
    for place, wanted in enumerate(
        TABLE := [("a hoop", 1), ("a ball", Fraction(2, 5)), ("a disc", Fraction(1, 2))]
    ):
        found = list(sample_of_row(problem, columns, place, 30))
        assert {row(problem, each)[:2] for each in found} == {wanted}
        assert len({each.values["h"] for each in found}) == 5
    assert len(TABLE) == 3


def test_words_of_a_table_are_translated(read, write):
    problem = read(ROLLING, ASKS)
    assert {"a hoop", "a ball", "a disc"} <= set(to_translate(problem))
    (problem.path.parent / "cart.de.md").write_text(
        "---\ntitle: Rollen\n---\n{{body}} aus {{h}}.\n\n## Tempo {#a}\nWie schnell?\n\n# Texts\n\n> a ball\n\neine Kugel\n",
        encoding="utf-8",
    )
    with language("de"):
        german = in_language(problem)
        ball = variant(german, {"k": "0.4"})
        assert filled(german.statement, ball) == "eine Kugel aus 2\xa0m."


HEAD = "code: X1.1\ntitle: A\ngiven:\n  k: {is: factor}\n"


@pytest.mark.parametrize(
    ("front", "line", "words"),
    [
        (HEAD + "rows: [{body: a, k: 1}]", 6, "rows: list 2 to 200 rows"),
        (HEAD + "rows: a", 6, "rows: lists rows such as"),
        (HEAD + "rows:\n  - {body: a, k: 1}\n  - {body: b}", 8, "row 2 has no k"),
        (HEAD + "rows:\n  - {body: a, k: 1}\n  - {body: b, k: 2, m: 1}", 8, "row 2 has m, which the first row has not"),
        (HEAD + "rows:\n  - {body: a, k: 1}\n  - {body: a, k: 1.0}", 8, "row 2 is the same as row 1"),
        (HEAD + "rows:\n  - {body: a, k: 1}\n  - [b, 2]", 8, "row 2 holds one value for each column"),
        (HEAD + "rows:\n  - {body: a, k: 1}\n  - {body: b, k: }", 8, "row 2 holds one value for each column"),
        (HEAD + "rows:\n  - {body: a, k: 1}\n  - {body: b, k: 2 kg}", 8, "k has numbers and words in rows ('2 kg')"),
        (HEAD + "rows:\n  - {m: 5, k: 1}\n  - {m: 6, k: 2}", 7, "m has numbers in rows: say what it means"),
        (HEAD + "rows:\n  - {pi: a, k: 1}\n  - {pi: b, k: 2}", 7, "pi has a meaning of its own"),
        (HEAD + "  m: {is: mass}\nrows:\n  - {k: 1}\n  - {k: 2}", 6, "m has no `value`, and no column of rows is called m"),
        (HEAD.replace("}", ", value: 1}") + "rows:\n  - {k: 1}\n  - {k: 2}", 5, "k has its values in rows; leave value out"),
        (HEAD + "  b: {is: body, unit: kg}\nrows:\n  - {k: 1, b: a}\n  - {k: 2, b: c}", 6, "b has words in rows, which have no unit"),
        (HEAD.replace("}", ", unit: furlong}") + "rows:\n  - {k: 1}\n  - {k: 2}", 5, "unit of k"),
        (HEAD + "rows:\n  A: [{k: 1}, {k: 2}]\n  B: [{k: 1}, {k: 2}]", 8, "k is a column of A, too"),
        ("code: X1.1\ntitle: A\ngiven:\n  k: 1\nrows:\n  - {k: 1}\n  - {k: 2}", 5, "k is a column of rows: say what it means"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_table(complaints, front, line, words):
    found = complaints(front, "\n{{k}}\n\n## A {#a .value}\nHow much?\n")
    assert any(at == line and words in sentence for at, sentence in found), found
    assert len(found) == 1
