"""Files of records in every form, and what is wrong with them, named with its line."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.audit.bank_file import laws_by_id, records_of
from corollary.audit.examine import examine
from corollary.audit.record_file import records_in
from corollary.problem.diagnostic import Malformed

YAML = """
source: A book
convention: g = 9.8 m/s^2
laws: {Way: s = v0*t + a*t^2/2, Velocity: v = v0 + a*t}
records:
  - id: "3.1"
    given: {v0: 0 m/s, a: 2.5 m/s^2, s: 80 m}
    laws: [Velocity, Way]
    where: t > 0
    asked: [t, v in km/h]
    published: [8.0 s, "72"]
"""
JSON = """
[{"id": "3.1", "given": {"v0": "0 m/s", "a": "2.5 m/s^2", "s": "80 m"}, "laws": ["Velocity: v = v0 + a*t", "s = v0*t + a*t^2/2"],
  "where": ["t > 0"], "asked": ["t", "v in km/h"], "published": ["8.0 s", "72"]}]
"""
CSV = """id,given,laws,where,asked,published
3.1,v0 = 0 m/s; a = 2.5 m/s^2; s = 80 m,v = v0 + a*t; s = v0*t + a*t^2/2,t > 0,t; v in km/h,8.0 s; 72
"""


@pytest.mark.parametrize(("name", "text"), [("r.yaml", YAML), ("r.json", JSON), ("r.csv", CSV)])
def test_every_form_says_the_same(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    (record,) = records_in(path)
    assert [each.finding for each in examine(record)] == ["agrees", "agrees"]
    assert [each.derived for each in examine(record)] == ["8.000 s", "72.00 km/h"]


@pytest.mark.parametrize(
    ("text", "line", "sentence"),
    [
        (
            "- id: a\n  given: {m: 2 kq}\n  laws: [F = m]\n  asked: F\n  published: 1 N\n",
            2,
            "kq is not a unit",
        ),
        ("- id: a\n  laws: [F = m a]\n  asked: F\n  published: 1 N\n", 2, "F = m a"),
        ("- id: a\n  laws: [F]\n  asked: F\n  published: 1 N\n", 2, "no = sign"),
        ("- id: a\n  laws: [F = m]\n  asked: F\n  published: [1 N, 2 N]\n", 1, "one answer each"),
        (
            "- id: a\n  laws: [F = m]\n  asked: F\n  published: 1 N\n  giveN: {}\n",
            5,
            "`giveN` of record a is not known",
        ),
        ("- id: a\n  asked: F\n  published: 1 N\n", 1, "needs either `laws` or a `problem`"),
        (
            "- id: a\n  given: {m: 5..2 kg}\n  laws: [F = m]\n  asked: F\n  published: 1 N\n",
            2,
            "is not a range",
        ),
        (
            "- id: a\n  constants: Q\n  laws: [F = m]\n  asked: F\n  published: 1 N\n",
            1,
            "Q is not a constant",
        ),
        ("- &x {id: a}\n- *x\n", 2, "refers to another place"),
        ("- [a\n", 2, "is not YAML"),
        ("hello", 1, "is not a list of records"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(tmp_path, text, line, sentence):
    path = tmp_path / "r.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Malformed) as caught:
        records_in(path)
    assert sentence in str(caught.value)
    assert line in {each.line for each in caught.value.complaints}


def test_two_records_with_one_id(tmp_path):
    path = tmp_path / "r.yaml"
    path.write_text("- {id: a, laws: [F = m], asked: F, published: 1 N}\n" * 2, encoding="utf-8")
    first, second = records_in(path)
    assert (first.id, first.unread) == ("a", "")
    assert second.id == "r.yaml:2"
    assert "r.yaml:2: `a` is the id of two records (line 1)" in second.unread


HEADER = "id,given,laws,asked,published\n"
WALK = "walk,v = 2.5 m/s; t = 40 s,s = v*t,s,100 m\n"


@pytest.mark.parametrize(
    ("row", "why"),
    [
        ("bad,v = 2 m/s, t = 3 s,s = v*t,s,6 m", "r.csv:3: has more cells than the first row"),
        ("bad,v = 2 m/s", "r.csv:3: record bad needs either `laws` or a `problem`"),
        ("bad,v = fast; t = 3 s,s = v*t,s,6 m", "r.csv:3: record bad, v: unit 'fast'"),
        ("bad,v = 2 m/s; v = 3 m/s; t = 3 s,s = v*t,s,6 m", "r.csv:3: gives a letter twice"),
        (WALK.strip(), "r.csv:3: `walk` is the id of two records"),
        (",v = 2 m/s; t = 3 s,s = v*t,s,6 m", "r.csv:3: "),
    ],
)
def test_a_row_that_is_not_in_order_does_not_end_the_file(tmp_path, row, why):
    path = tmp_path / "r.csv"
    path.write_text(HEADER + WALK + row + "\n" + WALK.replace("walk", "last"), encoding="utf-8")
    first, bad, last = records_in(path)
    assert (first.id, last.id) == ("walk", "last")
    assert not first.unread
    assert not last.unread
    assert why in bad.unread
    assert examine(bad)[0].finding == "cannot say"


def test_a_quotation_mark_that_is_not_closed_costs_what_follows_and_says_so(tmp_path):
    path = tmp_path / "r.csv"
    path.write_text(HEADER + WALK + 'open,"v = 2 m/s,s = v*t,s,6 m\n' + WALK, encoding="utf-8")
    first, rest = records_in(path)
    assert not first.unread
    assert "r.csv:3: is not CSV from here on" in rest.unread


@pytest.mark.parametrize("parted_by", [";", "\t"])
def test_cells_are_parted_by_what_parts_the_first_row(tmp_path, parted_by):
    path = tmp_path / "r.csv"
    rows = HEADER + 'walk,"v = 2{comma}5 m/s; t = 40 s",s = v*t,s,100 m\n'
    path.write_text(rows.replace(",", parted_by).format(comma=","), encoding="utf-8")
    (record,) = records_in(path)
    assert [str(each.low) for each in record.given] == ["5/2", "40"]


@pytest.mark.parametrize(
    ("header", "why"),
    [
        (HEADER.replace("asked", "given"), "two columns `given`"),
        (HEADER.replace("asked", "askd"), "column `askd` is not known"),
    ],
)
def test_a_first_row_that_is_not_in_order_ends_the_file(tmp_path, header, why):
    path = tmp_path / "r.csv"
    path.write_text(header + WALK, encoding="utf-8")
    with pytest.raises(Malformed, match=f"r.csv:1: .*{why}"):
        records_in(path)


def test_givens(tmp_path):
    path = tmp_path / "r.yaml"
    path.write_text(
        "- {id: a, given: {m: 2..5 kg, t: 1.50e2 ms, w: 1/s, mu: '0,25', k: N/m}, laws: [F = m], asked: F, published: 1 N}",
        encoding="utf-8",
    )
    (record,) = records_in(path)
    given = {each.symbol: each for each in record.given}
    assert (given["m"].low, given["m"].high, given["m"].unit.text) == (2, 5, "kg")
    assert (given["t"].low, given["t"].figures) == (150, 3)
    assert (given["w"].low, given["w"].unit.text) == (None, "1/s")
    assert given["mu"].low == Fraction(1, 4)
    assert given["k"].low is None


def test_laws_are_joined_by_id(tmp_path):
    bank, laws = tmp_path / "r.csv", tmp_path / "laws.yaml"
    bank.write_text("id,given,laws,asked,published\n1,m = 2 kg; a = 3 m/s^2,F = m,F,7 N\n", encoding="utf-8")
    laws.write_text('- {id: "1", laws: [F = m*a], asked: F}\n', encoding="utf-8")
    (record,) = records_of(bank, laws_by_id(laws))
    (outcome,) = examine(record)
    assert (outcome.finding, outcome.derived) == ("wrong", "6.000 N")


def test_an_alias_costs_its_record_alone(audited):
    """References are not followed, however many there are; what is given twice, or nested deeply, is the record's own, too."""
    bomb = "[*a, *a, *a, *a, *a, *a, *a, *a]"
    found = audited(f"""
- &a {{id: good, given: {{m: 2 kg, v: 3 m/s}}, laws: [p = m*v], asked: p, published: 6.0 kg m/s}}
- {{id: bomb, given: {bomb}, laws: {bomb}, asked: {bomb}, published: 1 m}}
- id: merged
  <<: *a
- {{id: twice, id: twice, laws: [p = m*v], asked: p, published: 1 m}}
- {{id: deep, given: [[[[[[[[[[1]]]]]]]]]], laws: [p = m*v], asked: p, published: 1 m}}
- {{id: huge, given: {{m: 1e999999999 kg, v: 3 m/s}}, laws: [p = m*v], asked: p, published: 1 m}}
- {{id: too, given: {{m: 2 kg, v: 3 m/s}}, laws: [p = m*v], asked: p, published: 6.0 kg m/s}}
""")
    assert [each.finding for each in found if each.record.id in ("good", "too")] == ["agrees", "agrees"]
    assert {each.finding for each in found if each.record.id not in ("good", "too")} == {"cannot say"}
    assert any("refers to another place" in each.why for each in found)
