"""What was handed out holds, whatever happens to the problem afterwards."""

from __future__ import annotations

import pytest

from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import worksheet
from corollary.problem.roster import Student
from corollary.problem.variant import Variant, at
from corollary.records.assignments import is_assigned, read_assigned, variant_anywhere
from corollary.records.files import NotACourse, create_course

from .conftest import Kicks

RANGE = ("value: 0.43, from: 0.30, to: 0.60, step: 0.01", "value: 0.43, from: 0.36, to: 0.60, step: 0.02")


def si(kicks: Kicks) -> dict[str, dict[str, float]]:
    """Everybody's numbers as they are marked with now."""
    course = create_course(kicks.folder, [])
    return {
        student: {symbol: value for variant in sheet.variants for symbol, value in variant.si.items()}
        for student, sheet in read_assigned(course, kicks.problem_set).items()
    }


def variant(kicks: Kicks, student: str = "ada") -> Variant:
    course = create_course(kicks.folder, [])
    return read_assigned(course, kicks.problem_set)[student].variants[0]


def test_nothing_is_assigned_before_it_is_generated(kicks: Kicks) -> None:
    course = create_course(kicks.folder, [])
    assert not is_assigned(course, "kicks")
    assert read_assigned(course, kicks.problem_set) == {}
    made = kicks.generate()
    assert is_assigned(course, "kicks")
    assert read_assigned(course, kicks.problem_set) == made.assigned
    assert made.new == ("ada", "ben", "cyd")


def test_unchanged_it_is_the_very_problem_of_the_bank(kicks: Kicks) -> None:
    kicks.generate()
    found = variant(kicks)
    assert found.problem == kicks.problem_set.problems[0]
    assert found.index is not None
    assert found == at(found.problem, found.index)


@pytest.mark.parametrize(
    "edit",
    [
        RANGE,
        ("value: 0.43, from: 0.30, to: 0.60, step: 0.01", "value: 0.43"),
        (
            "value: 20,   from: 8,    to: 35,   step: 0.5,  unit: m/s",
            "value: 20, from: 30, to: 126, step: 2, unit: km/h",
        ),
        ("  - dt > 0\n", "  - dt > 0\n  - m > 0.7 kg\n"),
        ("A football of mass", "A ball of mass"),
    ],
)
def test_nobodys_numbers_move(kicks: Kicks, edit: tuple[str, str]) -> None:
    kicks.generate()
    before = si(kicks)
    kicks.edit(edit)
    assert si(kicks) == before


def test_a_sheet_is_still_in_the_words_and_units_of_the_day_it_was_handed_out(kicks: Kicks) -> None:
    made = kicks.generate()
    before = worksheet(kicks.problem_set, Student("ada"), made.assigned["ada"].variants).exercises[0]
    kicks.edit(("A football of mass", "A ball of mass"), ("kg*m/s", "g*m/s"), ("unit: m/s", "unit: km/h"))
    now = worksheet(kicks.problem_set, Student("ada"), [variant(kicks)]).exercises[0]
    assert now.statement == before.statement
    assert now.figure == before.figure
    assert [prompt.question.unit for prompt in now.prompts] == [
        prompt.question.unit for prompt in before.prompts
    ]


def test_a_unit_that_was_a_mistake_is_corrected_and_its_number_holds(kicks: Kicks) -> None:
    kicks.edit(("step: 0.01, unit: kg}", "step: 0.01, unit: N}"))
    problem = kicks.problem_set.problems[0]
    assert problem.given("m").unit.text == "N"
    # It cannot be generated so: the record is what an author had who noticed too late.
    from corollary.records.assignments import Assigned, numbers_of, save_record

    course = create_course(kicks.folder, [])
    record = Assigned([], {})
    record.students["ada"] = {"X12.5": numbers_of(at(problem, 0), record.place(problem, 1.0))}
    save_record(course, kicks.problem_set, record)
    kicks.edit(("step: 0.01, unit: N}", "step: 0.01, unit: kg}"))
    assert si(kicks)["ada"]["m"] == 0.3
    assert variant(kicks).problem.given("m").unit.text == "kg"


def test_a_given_added_later_has_its_printed_value_and_one_removed_is_of_no_use(kicks: Kicks) -> None:
    kicks.generate()
    before = si(kicks)
    row = "  w:  {is: speed of the incoming ball, value: 20,   from: 8,    to: 35,   step: 0.5,  unit: m/s}\n"
    kicks.edit((row, "  q:  {is: share of the speed, value: 0.8, from: 0.5, to: 0.9, step: 0.1}\n" + row))
    assert si(kicks) == {student: {**row, "q": 0.8} for student, row in before.items()}
    kicks.edit((row, ""), ("at {{w}}.", "at {{v}}."), ("abs(v - w) > 1.5", "v > 1"))
    for student, row_now in si(kicks).items():
        assert {symbol: row_now[symbol] for symbol in ("m", "v", "dt")} == {
            symbol: before[student][symbol] for symbol in ("m", "v", "dt")
        }


def test_a_part_added_later_was_not_asked_and_one_removed_is_not_any_more(kicks: Kicks) -> None:
    kicks.generate()
    kicks.edit(
        (
            "## Mean force {#c",
            '## Energy {#e .value unit="J" points=1}\nHow much energy?\n\n## Mean force {#c',
        )
    )
    assert [part.id for part in variant(kicks).problem.parts] == ["a", "b", "c", "d"]
    text = kicks.file.read_text()
    kicks.file.write_text(text[: text.index("## Returning a ball")])
    assert [part.id for part in variant(kicks).problem.parts] == ["a", "b", "c"]


def test_who_has_a_sheet_keeps_it_and_newcomers_are_given_theirs(kicks: Kicks) -> None:
    first = kicks.generate("ada", "ben")
    files = {student: path.read_bytes() for student, path in first.notebooks.items()}
    kicks.edit(RANGE, ("A football", "A ball"))
    second = kicks.generate("ada", "ben", "cyd")
    assert second.new == ("cyd",)
    assert {student: second.notebooks[student].read_bytes() for student in files} == files
    assert "A ball of mass" in second.notebooks["cyd"].read_text()
    numbers = {tuple(sheet.variants[0].values.values()) for sheet in second.assigned.values()}
    assert len(numbers) == 3
    second.notebooks["ada"].unlink()
    assert kicks.generate("ada", "ben", "cyd").notebooks["ada"].read_bytes() == files["ada"]


def test_who_left_the_roster_is_remembered(kicks: Kicks) -> None:
    before = kicks.generate("ada", "ben").assigned
    kicks.generate("ben")
    assert kicks.generate("ada", "ben").assigned == before


def test_a_problem_added_to_the_set_is_only_for_newcomers_and_one_removed_is_not_marked(kicks: Kicks) -> None:
    kicks.generate("ada")
    kicks.edit(("- X12.5\n", "- X12.5\n"), file=kicks.set_file)
    for step, name in (("problems", "stopping_a_car.md"), ("solutions", "stopping_a_car.md")):
        import shutil

        from corollary.problem.bank import chapter_bank

        shutil.copy(chapter_bank().folder / step / "impulse" / name, kicks.bank.folder / step / "impulse")
    code = next(each.code for each in kicks.bank if each.name == "stopping_a_car")
    kicks.edit(("- X12.5\n", f"- X12.5\n  - {code}\n"), file=kicks.set_file)
    made = kicks.generate("ada", "ben")
    assert [each.problem.code for each in made.assigned["ada"].variants] == ["X12.5"]
    assert [each.problem.code for each in made.assigned["ben"].variants] == ["X12.5", code]
    kicks.edit(("  - X12.5\n", ""), file=kicks.set_file)
    made = kicks.generate("ada", "ben")
    assert [each.problem.code for each in made.assigned["ben"].variants] == [code]
    assert made.assigned["ada"].variants == ()


def test_the_identity_follows_the_numbers_and_not_the_grid(kicks: Kicks) -> None:
    kicks.generate()
    course = create_course(kicks.folder, [])
    before = {student: sheet.identity for student, sheet in read_assigned(course, kicks.problem_set).items()}
    assert len(set(before.values())) == 3
    kicks.edit(RANGE)
    assert {
        student: sheet.identity for student, sheet in read_assigned(course, kicks.problem_set).items()
    } == before


def test_a_students_numbers_are_found_in_whatever_set(kicks: Kicks) -> None:
    made = kicks.generate()
    kicks.edit(RANGE)
    problem = kicks.problem_set.problems[0]
    found = variant_anywhere(made.course, problem, "ben")
    assert found is not None
    assert found.values == made.assigned["ben"].variants[0].values
    assert variant_anywhere(made.course, problem, "eve") is None


def test_what_is_right_can_still_be_worked_out(kicks: Kicks) -> None:
    made = kicks.generate()
    before = Solutions(kicks.bank).key(made.assigned["ada"].variants[0])
    text = kicks.file.read_text()
    kicks.edit(RANGE, ("unit: m/s", "unit: km/h"), ('unit="N" points=2', 'unit="kN" points=3'))
    solutions = Solutions(kicks.bank)
    now = solutions.key(variant(kicks))
    assert {part: truth.values for part, truth in now.truths.items()} == {
        part: truth.values for part, truth in before.truths.items()
    }
    assert solutions.worked_solution(variant(kicks))
    assert kicks.file.read_text() != text


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        '{"ada": 3}',
        '{"editions": [], "students": {"ada": {"X12.5": {"edition": 0, "values": {}}}}}',
        '{"editions": [], "students": {"ada": {"X12.5": {"edition": 0, "values": {"m": "1/0"}}}}}',
        "{",
    ],
)
def test_a_damaged_record_is_reported_and_nobody_is_given_new_numbers(kicks: Kicks, text: str) -> None:
    course = kicks.generate().course
    (course.folder / ".corollary/assigned/kicks.json").write_text(text)
    with pytest.raises(NotACourse, match=r"kicks\.json is damaged"):
        read_assigned(course, kicks.problem_set)
    with pytest.raises(NotACourse, match=r"kicks\.json is damaged"):
        kicks.generate()


def test_a_newer_record_is_left_alone(kicks: Kicks) -> None:
    course = kicks.generate().course
    (course.folder / ".corollary/assigned/kicks.json").write_text(
        '{"editions": [], "students": {}, "format": 99}'
    )
    with pytest.raises(NotACourse, match="newer version"):
        read_assigned(course, kicks.problem_set)


def test_words_that_are_lost_are_replaced_by_todays_and_the_numbers_hold(kicks: Kicks) -> None:
    course = kicks.generate().course
    before = si(kicks)
    kicks.edit(RANGE, ("A football", "A ball"), ("unit: m/s", "unit: km/h"))
    for file in (course.folder / ".corollary/assigned/problems").iterdir():
        file.write_text("---\nwritten for another version\n")
    assert si(kicks) == before
    assert variant(kicks).problem.statement.startswith("A ball")
    assert variant(kicks).problem.given("v").unit.text == "m/s"
