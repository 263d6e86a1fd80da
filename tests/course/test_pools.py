"""Sets of several banks, pools, parts and points of a set's own, and orders of each student's own: from the set to the marks."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.course.generate import generate
from corollary.grading.solutions import Solutions
from corollary.nbgrader.gradebook import NoNbgrader
from corollary.problem.problem_set import find_set
from corollary.problem.roster import Student
from corollary.records.assignments import read_assigned
from corollary.records.files import open_course

from .changing_bank import ChangingBank, Text

CLASS = [Student(f"s{number}") for number in range(10)]
POOL = "title: A week\nproblems:\n  - X1.1\n  - {any: 2, of: [X1.2, X1.3, X1.4]}\n"


def run(*words: object) -> tuple[int, Any, str]:
    done = CliRunner().invoke(app, [*map(str, words), "--json"], catch_exceptions=False)
    return done.exit_code, json.loads(done.stdout) if done.stdout else {}, done.stderr


@pytest.fixture
def balls(tmp_path: Path) -> ChangingBank:
    """Four problems alike."""
    bank = ChangingBank(tmp_path)
    bank.write(*(Text(code=f"X1.{number}") for number in range(1, 5)))
    return bank


@pytest.fixture
def no_gradebook(monkeypatch: pytest.MonkeyPatch) -> None:
    """As where nbgrader is not installed: making its assignment takes most of the time, and matters to none of these."""

    def missing() -> None:
        raise NoNbgrader("it is not there")

    monkeypatch.setattr("corollary.course.generate.need_nbgrader", missing)


def as_set(balls: ChangingBank, front: str) -> None:
    (balls.bank.sets / "week.md").write_text(f"---\n{front}---\nBalls.\n")


def dealt(balls: ChangingBank) -> dict[str, list[str]]:
    """The codes of each student's sheet, in its order, from the record."""
    sheets = read_assigned(open_course(balls.course), balls.problem_set)
    return {student: [each.problem.code for each in sheet.variants] for student, sheet in sheets.items()}


@pytest.mark.usefixtures("no_gradebook")
def test_each_student_gets_some_of_a_pool_by_the_courses_key(balls: ChangingBank) -> None:
    as_set(balls, POOL)
    made = generate(balls.course, balls.problem_set, CLASS, Solutions(balls.bank))
    sheets = dealt(balls)
    for student, codes in sheets.items():
        assert codes == sorted(codes)
        assert codes[0] == "X1.1"
        assert len(codes) == 3
        assert codes == [each.code for each in balls.problem_set.deal(made.course.key, [student])[student]]
        cells = json.loads(made.notebooks[student].read_text())["cells"]
        asked = {cell["id"].removesuffix("_statement") for cell in cells if cell["id"].endswith("_statement")}
        assert asked == {code.replace(".", "_") for code in codes}
    # All four are met: that ten students all miss one of three has a chance of one in 20 000.
    assert len({code for codes in sheets.values() for code in codes}) == 4
    generate(balls.course, balls.problem_set, CLASS, Solutions(balls.bank))
    assert dealt(balls) == sheets
    assert balls.problem_set.out_of == 9


def test_another_key_deals_others(balls: ChangingBank) -> None:
    as_set(balls, POOL)
    found = {
        key: [tuple(p.code for p in balls.problem_set.deal(key, [each.id])[each.id]) for each in CLASS]
        for key in (b"one", b"two")
    }
    assert found[b"one"] != found[b"two"]
    assert {len(set(codes)) for codes in found.values()} == {3}


@pytest.mark.usefixtures("no_gradebook")
def test_a_shuffled_sheet_keeps_its_order(balls: ChangingBank) -> None:
    as_set(balls, "title: A week\norder: shuffled\nproblems: [X1.1, X1.2, X1.3, X1.4]\n")
    made = generate(balls.course, balls.problem_set, CLASS, Solutions(balls.bank))
    orders = dealt(balls)
    assert len({tuple(codes) for codes in orders.values()}) > 4
    for student, codes in orders.items():
        cells = json.loads(made.notebooks[student].read_text())["cells"]
        ids = [cell["id"] for cell in cells if cell["id"].endswith("_statement")]
        assert ids == [f"{code.replace('.', '_')}_statement" for code in codes]


def test_marks_of_a_pool_of_some_parts_and_of_two_banks(balls: ChangingBank) -> None:
    as_set(
        balls,
        "title: A week\nproblems:\n  - {code: X1.1, parts: [a, c], points: {c: 5}, weight: 2}\n"
        "  - {any: 1, of: [X1.2, X1.3]}\n  - chapter/X12.4\n",
    )
    made = balls.generate("ada")
    text = made.notebooks["ada"].read_text()
    assert "X1_1_a" in text
    assert "X1_1_b" not in text
    balls.hand_in(made, "ada")
    done = balls.grade(made.course)
    record = done.records["ada"]
    assert {row.verdict for row in record.rows} == {"right"}
    points = {(row.problem, row.part): row.points for row in record.rows}
    (dealt_code,) = {code for code, _ in points} - {"X1.1", "X12.4"}
    assert points.pop(("X12.4", "a")) > 0
    assert {key: each for key, each in points.items() if key[0] != "X12.4"} == {
        ("X1.1", "a"): 2,
        ("X1.1", "c"): 10,
        **{(dealt_code, part): 1 for part in "abc"},
    }
    assert dealt(balls)["ada"] == ["X1.1", dealt_code, "X12.4"]
    (one,) = done.report.handed_in
    assert one.out_of == one.points == balls.problem_set.out_of
    words = ("report", "week", "--course", balls.course, "--bank", balls.bank.folder)
    status, document, _ = run(*words, "--statistics", "--csv", balls.folder / "statistics.csv")
    assert status == 0
    counted = {(each["problem"], each["part"]) for each in document["statistics"]["parts"]}
    assert counted == {*points, ("X12.4", "a")}  # of those asked alone


@pytest.mark.usefixtures("no_gradebook")
def test_a_part_asked_for_later_was_never_asked_of_those_who_have_their_sheet(balls: ChangingBank) -> None:
    as_set(balls, "title: A week\nproblems:\n  - {code: X1.1, parts: [a, c]}\n")
    balls.generate("ada")
    as_set(balls, "title: A week\nproblems:\n  - X1.1\n")
    sheet = read_assigned(open_course(balls.course), balls.problem_set)["ada"]
    assert [part.id for part in sheet.variants[0].problem.parts] == ["a", "c"]
    assert not sheet.removed


@pytest.mark.usefixtures("no_gradebook")
def test_renewed_sheets_keep_what_was_dealt(balls: ChangingBank) -> None:
    as_set(balls, POOL)
    roster = balls.folder / "roster.csv"
    roster.write_text("id\n" + "\n".join(each.id for each in CLASS) + "\n")
    words = ("generate", "week", "--roster", roster, "--course", balls.course, "--bank", balls.bank.folder)
    assert run(*words)[0] == 0
    before = dealt(balls)
    assert run(*words, "--renew", "--yes")[1]["renewed"] == []
    as_set(balls, POOL.replace("any: 2", "any: 1"))
    status, document, _ = run(*words, "--renew", "--yes")
    assert status == 0
    assert len(document["renewed"]) == len(CLASS)
    after = dealt(balls)
    assert all(len(codes) == 2 and codes[0] == "X1.1" for codes in after.values())
    assert all(set(codes) <= set(before[student]) for student, codes in after.items())


@pytest.mark.usefixtures("no_gradebook")
@pytest.mark.parametrize(("weight", "warned"), [(3, True), (1, False)])
def test_sheets_out_of_different_totals_are_warned_of(balls: ChangingBank, weight: int, warned: bool) -> None:
    as_set(balls, POOL.replace("X1.4]", f"{{code: X1.4, weight: {weight}}}]"))
    roster = balls.folder / "roster.csv"
    roster.write_text("id\nada\nben\n")
    words = ("generate", "week", "--roster", roster, "--course", balls.course, "--bank", balls.bank.folder)
    status, _, errors = run(*words)
    assert status == 0
    assert ("warning: sheets of week have different totals" in errors) is warned
    assert ("(X1.2 3, X1.3 3, X1.4 9); make them equal with weight:" in errors) is warned


def test_problems_of_several_banks(balls: ChangingBank, tmp_path: Path) -> None:
    for front in ("- chapter/X12.4", "- {code: X12.4, bank: chapter}"):
        as_set(balls, f"title: A week\nproblems:\n  - X1.1\n  {front}\n")
        codes = [problem.code for problem in balls.problem_set.problems]
        assert codes == ["X1.1", "X12.4"]
    as_set(balls, "title: A week\nbank: chapter\nproblems: [X12.4, bank/X1.1]\n")  # by its folder's name
    assert [problem.code for problem in balls.problem_set.problems] == ["X12.4", "X1.1"]
    other = tmp_path / "elsewhere.md"
    other.write_text(
        "---\ntitle: Both\nproblems: [bank/X1.1, chapter/X12.4]\n---\n"
    )  # a folder beside the set
    assert len(find_set(Solutions(balls.bank).bank, str(other)).problems) == 2


def test_verify_a_set_compares_the_problems_of_a_pool(balls: ChangingBank) -> None:
    as_set(balls, POOL.replace("X1.4]", "{code: X1.4, weight: 3}]"))
    path = balls.bank.problems / "topic" / "ball1.md"
    path.write_text(path.read_text().replace("title:", "difficulty: 2\ntitle:", 1))
    path = balls.bank.problems / "topic" / "ball2.md"
    path.write_text(path.read_text().replace("title:", "difficulty: 4\ntitle:", 1))
    status, document, _said = run("verify", "week", "--bank", balls.bank.folder, "--variants", 5)
    assert status == 0
    assert document["ok"] is True
    assert [each["code"] for each in document["problems"]] == ["X1.1", "X1.2", "X1.3", "X1.4"]
    (checked,) = document["sets"]
    assert checked["out_of"] == 15
    assert checked["pools"] == [
        {"deals": 2, "codes": ["X1.2", "X1.3", "X1.4"], "points": [3, 3, 9], "difficulties": [2, 4, 0]}
    ]
    for words in (
        "week.md:5: the problems of this pool have unequal points (X1.2 3, X1.3 3, X1.4 9)",
        "week.md:5: the problems of this pool are unequally difficult (X1.2 2, X1.3 4)",
        "week.md:5: X1.4 of this pool: nothing says how difficult",
    ):
        assert any(words in note for note in checked["notes"]), checked["notes"]
    as_set(balls, "title: A week\nproblems: [X1.1, X9.9]\n")
    status, document, _said = run("verify", "week", "--bank", balls.bank.folder)
    assert status == 1
    assert "week.md:3: no problem is called X9.9" in document["malformed"][0]


@pytest.mark.usefixtures("no_gradebook")
def test_only_so_many_tries_count(balls: ChangingBank, tmp_path: Path) -> None:
    as_set(balls, "title: A week\ntries: 2\nproblems: [X1.1]\n")
    made = balls.generate("ada")
    sheet = made.notebooks["ada"].read_text()
    taken = made.course.notebook("submitted", "ada", "week")
    said: list[str] = []
    for day, answer in enumerate(("1", "2", "2", "3"), 1):
        source = tmp_path / f"day{day}" / "ada" / "week.ipynb"
        source.parent.mkdir(parents=True)
        source.write_text(sheet.replace("X1_1_a = None", f"X1_1_a = {answer}"))
        os.utime(source, (day * 86400, day * 86400))
        _status, document, _ = run("collect", "week", source.parent.parent, "--course", balls.course)
        said.append(next(name for name in ("accepted", "unchanged", "unusable") if document[name]))
    assert said == ["accepted", "accepted", "unchanged", "unusable"]
    assert "exceeds the 2 tries" in document["unusable"][0]["why"]
    assert "X1_1_a = 2" in taken.read_text()


@pytest.mark.usefixtures("no_gradebook")
def test_equal_shares_stay_equal_when_students_join_and_move_nobody(balls: ChangingBank) -> None:
    as_set(balls, "title: A week\nproblems:\n  - {any: 2, of: [X1.1, X1.2, X1.3, X1.4], deal: equally}\n")
    joined = [Student(f"new{number}") for number in range(7)]

    def counts() -> list[int]:
        held = [code for codes in dealt(balls).values() for code in codes]
        return sorted(held.count(f"X1.{number}") for number in range(1, 5))

    made = generate(balls.course, balls.problem_set, CLASS, Solutions(balls.bank))
    assert counts() == [5, 5, 5, 5]
    before = dealt(balls)
    assert len({tuple(codes) for codes in before.values()}) > 2  # and not two halves of the class
    for count in (3, 7):
        generate(balls.course, balls.problem_set, [*CLASS, *joined[:count]], Solutions(balls.bank))
        assert counts()[-1] - counts()[0] <= 1
        assert {student: dealt(balls)[student] for student in before} == before
    ids = [each.id for each in CLASS]
    by_roster = [balls.problem_set.deal(made.course.key, order) for order in (ids, ids[::-1])]
    assert by_roster[0] == by_roster[1]
