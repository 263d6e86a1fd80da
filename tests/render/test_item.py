"""An item earns what grading gives, by its marks alone; what no LMS can ask is refused by name."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.tolerance import same_signs
from corollary.grading.solutions import Solutions
from corollary.problem.bank import chapter_bank, home
from corollary.problem.problem_set import Scheme
from corollary.problem.variant import at, chapter
from corollary.render.lms_item import (
    ChoiceAsked,
    Credit,
    LmsItem,
    NotAsked,
    NumbersAsked,
    ProseAsked,
    answer_table,
    item,
)
from corollary.render.targets.moodle import typed_units
from corollary.units.unit import read_unit, unit

SOLUTIONS = Solutions(chapter_bank())
USUAL = Scheme()


def of(code: str, variant: int | None = None, scheme: Scheme = USUAL) -> LmsItem:
    problem = home(None, code)[1]
    return item(SOLUTIONS, chapter(problem) if variant is None else at(problem, variant), 1, 1.0, scheme)


def earned(asked, fields) -> float:
    if isinstance(asked, ChoiceAsked):
        return next((each.share for each in asked.options if each.option.letter == fields[0]), 0.0)
    if not all(fields):
        return 0.0
    numbers = [float(text.replace(",", ".")) for text in fields]
    return next((mark.share for mark in asked.marks if meets(mark, numbers)), 0.0)


def meets(mark: Credit, numbers: list[float]) -> bool:
    """All components together are near enough, and on the side of zero that counts."""
    small = [0.0 if signed else math.inf for signed in mark.signed]
    return math.dist(numbers, mark.values) <= mark.reach and same_signs(numbers, mark.values, small)


@pytest.mark.parametrize(
    ("code", "variant"), [("X12.5", None), ("X12.5", 700), ("X12.7", None), ("S12.2", None), ("X12.10", 3)]
)
def test_the_marks_of_an_item_are_those_of_grading(code, variant):
    made = of(code, variant)
    parts = {each.prompt.part.id: each for each in made.parts}
    rows = answer_table(made)
    assert {row.sort for row in rows} >= {
        "right",
        "rounded",
        "just inside",
        "just outside",
        "mistaken",
        "slip",
        "blank",
    }
    for row in rows:
        assert earned(parts[row.part.id], row.fields) == pytest.approx(row.share), (
            row.part.id,
            row.sort,
            row.fields,
        )


def test_the_table_has_marks_of_every_size():
    shares = {(row.sort, row.share) for row in answer_table(of("X12.5"))}
    assert {
        ("right", 1.0),
        ("rounded", 1.0),
        ("just inside", 1.0),
        ("just outside", 0.0),
        ("mistaken", 0.25),
    } <= shares
    assert {("slip", 0.5), ("blank", 0.0), ("comma", 1.0), ("far off", 0.0)} <= shares


def test_a_set_says_what_a_misconception_earns():
    made = of("X12.5", scheme=Scheme(mistaken=0.1, slip=0.0))
    shares = {
        mark.verdict: mark.share
        for each in made.parts
        if isinstance(each, NumbersAsked)
        for mark in each.marks
    }
    assert shares == {"right": 1.0, "mistaken": 0.1, "slip": 0.0}


def test_the_key_of_kicking_a_ball():
    """0.43 kg from rest to 20 m/s in 0.10 s: 8.6 kg m/s and 86 N, by hand."""
    first, _impulse, force, *_ = of("X12.5").parts
    assert isinstance(first, NumbersAsked)
    assert isinstance(force, NumbersAsked)
    assert first.marks[0].values == pytest.approx((8.6,))
    assert force.marks[0].values == pytest.approx((86.0,))
    assert any(mark.values == pytest.approx((-8.6,)) and mark.verdict == "slip" for mark in first.marks)


def test_what_no_lms_can_ask_is_refused_by_name():
    sorts = {each.prompt.part.id: each for each in of("P12.14").parts}
    assert isinstance(sorts["k"], ProseAsked)
    refused = {part: each.why for part, each in sorts.items() if isinstance(each, NotAsked)}
    assert refused.keys() == {"g", "h", "j"}
    assert "program" in refused["h"]
    assert all(refused.values())


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 10), st.floats(-20, 20))
def test_a_range_holds_what_the_mark_holds(value, reach, off):
    mark = Credit((value,), reach, (True,), 1.0, "right", "")
    ((low, high),) = mark.ranges()
    number = value + off
    edge = min(abs(number - low), abs(number - high), abs(number) if value else math.inf)
    if edge > 1e-6:
        assert meets(mark, [number]) == (low <= number <= high)


@pytest.mark.parametrize(
    "text", ["kg*m/s", "N", "m/s", "J", "deg", "N/m", "m/s^2", "kg/s", "W", "s", "rad/s", "1"]
)
def test_units_are_listed_as_they_are_read(text):
    asked = unit(text)
    units = typed_units(asked)
    assert len({name for name, _ in units}) == len(units)
    for name, size in units:
        assert " " not in name
        meant = read_unit(name)
        assert meant.dimension == asked.dimension
        assert size * meant.si == pytest.approx(asked.si)


def test_the_usual_spellings_are_listed():
    assert {"kgm/s", "kg*m/s", "Ns", "N*s"} <= {name for name, _ in typed_units(unit("kg*m/s"))}
    assert {"N", "kN", "newton", "mN"} <= {name for name, _ in typed_units(unit("N"))}
    assert dict(typed_units(unit("N")))["kN"] == pytest.approx(1e-3)
    assert dict(typed_units(unit("m/s")))["km/h"] == pytest.approx(3.6)
    assert typed_units(unit("degC")) == []


def test_hertz_is_no_name_for_an_angular_velocity():
    names = {name for name, _ in typed_units(unit("rad/s"))}
    assert {"rad/s", "rpm"} <= names
    assert not [name for name in names if name.lower().endswith(("hz", "hertz", "hertzs"))]
    assert "Hz" in {name for name, _ in typed_units(unit("s^-1"))}
