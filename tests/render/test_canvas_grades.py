"""What is said of marks that Canvas's import would put elsewhere, or of a mark that it would take away."""

from __future__ import annotations

import pytest

from corollary.problem.roster import Student
from corollary.records.marks_table import Column, Mark, MarksTable
from corollary.render.targets.canvas_grades import write_marks

ADA, BEN = (
    Student(name, name.title(), "Doe", f"{name}@example.org", (("ID", number), ("SIS Login ID", name)))
    for name, number in (("ada", "2001"), ("ben", "2002"))
)


def notes(title: str, excused: frozenset[str] = frozenset()) -> tuple[str, ...]:
    column = Column(title, (), 3, {"ada": Mark(3, 3)}, excused)
    return write_marks(MarksTable((ADA, BEN), (column,))).notes


@pytest.mark.parametrize("title", ["Week 1", "Week (1) again", "Week(1)", "Impulse (hard)"])
def test_nothing_is_said_of_a_plain_title(title: str) -> None:
    assert notes(title) == ()


def test_a_number_at_the_end_of_a_title_is_that_of_an_assignment() -> None:
    (note,) = notes("Impulse (2)")
    assert note.startswith("Canvas takes a number in brackets at the end of a title")
    assert "Impulse (2); give the set another title" in note


def test_who_loses_an_excuse_in_canvas_is_named() -> None:
    (note,) = notes("Week 1", frozenset({"ben"}))
    assert "deletes the marks that Canvas has of them, also EX: Ben Doe;" in note
