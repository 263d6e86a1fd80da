"""A course of an earlier version, which recorded places in the grid, is carried over without anybody's numbers moving."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from corollary.problem.variant import at
from corollary.records.assigned import read_assigned, variant_anywhere
from corollary.records.files import Course, NotACourse

from .conftest import Kicks

AsBefore = Callable[[Course, dict[str, dict[str, int]]], None]
INDICES = {"ada": {"X12.5": 817}, "ben": {"X12.5": 1_003_021}}
RANGE = ("value: 0.43, from: 0.30, to: 0.60, step: 0.01", "value: 0.43, from: 0.36, to: 0.60, step: 0.02")


@pytest.fixture
def course(kicks: Kicks, as_before: AsBefore) -> Course:
    """Without the notebooks that were handed out."""
    made = kicks.generate("ada", "ben").course
    as_before(made, INDICES)
    for path in made.folder.glob("release/*/kicks/kicks.ipynb"):
        path.unlink()
    return made


def test_places_are_resolved_once_on_the_grid_of_that_day(course: Course, kicks: Kicks) -> None:
    problem = kicks.problem_set.problems[0]
    then = {student: at(problem, row["X12.5"]) for student, row in INDICES.items()}
    assert {who: sheet.variants for who, sheet in read_assigned(course, kicks.problem_set).items()} == {
        student: (variant,) for student, variant in then.items()
    }
    kicks.edit(RANGE)
    now = read_assigned(course, kicks.problem_set)
    assert {who: sheet.variants[0].values for who, sheet in now.items()} == {
        student: variant.values for student, variant in then.items()
    }
    assert (course.folder / ".corollary/dealt/kicks.json").exists(), "it is left as it was"


def test_marks_made_by_then_need_not_be_made_again(course: Course, kicks: Kicks) -> None:
    """Their fingerprint was taken of the places, as JSON with sorted names."""
    assert read_assigned(course, kicks.problem_set)["ada"].identity == '{"X12.5": 817}'


def test_what_the_notebook_has_wins_over_a_grid_that_has_changed_since(
    kicks: Kicks, as_before: AsBefore
) -> None:
    made = kicks.generate("ada", "ben", "cyd")
    indices = {student: {"X12.5": sheet.variants[0].index or 0} for student, sheet in made.assigned.items()}
    as_before(made.course, indices)
    kicks.edit(RANGE)
    now = read_assigned(made.course, kicks.problem_set)
    assert {student: sheet.variants[0].values for student, sheet in now.items()} == {
        student: sheet.variants[0].values for student, sheet in made.assigned.items()
    }
    assert all("817" not in sheet.identity for sheet in now.values())


def test_a_place_beyond_the_grid_of_today_is_read_off_the_notebook(kicks: Kicks, as_before: AsBefore) -> None:
    made = kicks.generate("ada")
    as_before(made.course, {"ada": {"X12.5": made.assigned["ada"].variants[0].index or 0}})
    kicks.edit(
        ("from: 0.30, to: 0.60, step: 0.01", "from: 0.30, to: 0.32, step: 0.01"),
        ("from: 0.02, to: 0.15", "from: 0.02, to: 0.04"),
    )
    (now,) = read_assigned(made.course, kicks.problem_set).values()
    assert now.variants[0].values == made.assigned["ada"].variants[0].values


def test_a_problem_that_the_notebook_does_not_have_was_never_asked(kicks: Kicks, as_before: AsBefore) -> None:
    made = kicks.generate("ada", "ben")
    as_before(made.course, INDICES)
    path = made.notebooks["ada"]
    path.write_text(path.read_text().replace("X12_5_statement", "X12_6_statement"))
    now = read_assigned(made.course, kicks.problem_set)
    assert now["ben"].variants
    assert "ada" not in now or not now["ada"].variants


def test_a_single_problem_is_found_too(course: Course, kicks: Kicks) -> None:
    problem = kicks.problem_set.problems[0]
    found = variant_anywhere(course, problem, "ada")
    assert found is not None
    assert found.values == at(problem, 817).values


def test_who_is_new_is_given_other_numbers(course: Course, kicks: Kicks) -> None:
    made = kicks.generate("ada", "ben", "cyd")
    assert made.new == ("cyd",)
    assert made.assigned["ada"].variants[0].index == 817


@pytest.mark.parametrize("text", ["", "[]", '{"ada": 3}', '{"ada": {"X": "y"}}', "{"])
def test_a_damaged_record_of_before_is_reported(course: Course, kicks: Kicks, text: str) -> None:
    (course.folder / ".corollary/dealt/kicks.json").write_text(text)
    with pytest.raises(NotACourse, match=r"kicks\.json is damaged"):
        read_assigned(course, kicks.problem_set)
