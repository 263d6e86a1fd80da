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
        ("- id: a\n  given: {m: 5..2 kg}\n  laws: [F = m]\n  asked: F\n  published: 1 N\n", 2, "is no range"),
        ("- id: a\n  constants: Q\n  laws: [F = m]\n  asked: F\n  published: 1 N\n", 1, "Q is no constant"),
        ("- &x {id: a}\n- *x\n", 2, "refers to another place"),
        ("- [a\n", 2, "is not YAML"),
        ("hello", 1, "is no list of records"),
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
    with pytest.raises(Malformed, match="the id of two records"):
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
