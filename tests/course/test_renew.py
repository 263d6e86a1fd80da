"""`corollary generate` after a correction: what is said, what is asked, and what a new sheet changes for whom."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.records.assignments import read_assigned
from corollary.records.files import open_course

from .changing_bank import ChangingBank, Text, replace

OTHER = {
    "m": "value: 0.43, from: 0.3, to: 0.6, step: 0.01, unit: kg",
    "v": "value: 20, from: 30, to: 35, step: 0.5, unit: m/s",
    "dt": "value: 0.1, from: 0.02, to: 0.15, step: 0.01, unit: s",
}


def generate(ball: ChangingBank, *words: str, roster: str = "ada ben cyd") -> tuple[int, Any, str]:
    (ball.folder / "roster.csv").write_text("id\n" + "\n".join(roster.split()) + "\n")
    line = ["generate", "week", "--roster", ball.folder / "roster.csv", "--course", ball.course, "--json"]
    done = CliRunner().invoke(
        app, [*map(str, line), "--bank", str(ball.bank.folder), *words], catch_exceptions=False
    )
    return done.exit_code, json.loads(done.stdout) if done.stdout else {}, done.stderr


def numbers(ball: ChangingBank) -> dict[str, dict[str, float]]:
    course = open_course(ball.course)
    return {
        student: {symbol: value for variant in sheet.variants for symbol, value in variant.si.items()}
        for student, sheet in read_assigned(course, ball.problem_set).items()
    }


@pytest.fixture
def ball(tmp_path: Path) -> ChangingBank:
    """Ada has handed in."""
    ball = ChangingBank(tmp_path)
    ball.write(Text())
    made = ball.generate("ada", "ben", "cyd")
    ball.hand_in(made, "ada")
    return ball


def test_nothing_is_said_where_nothing_changed(ball: ChangingBank) -> None:
    status, document, said = generate(ball)
    assert (status, document["corrections"], document["with_renew"]) == (0, [], {})
    assert "renew" not in said


def test_every_change_is_listed_and_renewing_keeps_the_numbers_that_may_stay(ball: ChangingBank) -> None:
    before = numbers(ball)
    files = {path: path.read_bytes() for path in ball.course.glob("release/*/week/week.ipynb")}
    ball.write(
        replace(
            Text(), givens=OTHER | {"q": "value: 2"}, parts=("a", "b", "d"), points=2, words="Ball of {{m}}."
        )
    )
    status, document, said = generate(ball)
    assert status == 0
    assert [each["sentence"] for each in document["corrections"]] == [
        "the given v is drawn from other values now: the numbers handed out stay valid",
        "the given q is new: these students have its printed value",
        "part a is worth 2 now, and was worth 1: marks follow the change",
        "part b is worth 2 now, and was worth 1: marks follow the change",
        "part c was removed: marks given for it stay, and unmarked answers are not counted",
        "part d is new: it does not count for these students, who were not asked it",
        "has a changed text or figure: these students keep the text and figure they were given",
        "has a corrected solution: marks follow the correction",
    ]
    moving = sorted(student for student in ("ben", "cyd") if before[student]["v"] < 30)
    assert document["with_renew"] == {
        student: ["X1.1"] if student in moving else [] for student in ("ben", "cyd")
    }
    assert "no new sheet, with or without --renew, since they have handed in: 1 student: ada" in said
    assert {path: path.read_bytes() for path in files} == files

    status, _, said = generate(ball, "--renew")
    assert (status, "Nothing is changed; --yes agrees" in said) == (1, True)
    assert {path: path.read_bytes() for path in files} == files

    status, document, _ = generate(ball, "--renew", "--yes")
    assert (status, document["renewed"]) == (0, ["ben", "cyd"])
    after = numbers(ball)
    assert after["ada"] == before["ada"] | {"q": 2}
    for student in ("ben", "cyd"):
        assert (after[student]["v"] == before[student]["v"]) == (student not in moving)
        assert after[student]["v"] >= 30
    changed = {path.parent.parent.name for path, content in files.items() if path.read_bytes() != content}
    assert changed - {"release"} == {"ben", "cyd"}
    assert generate(ball)[1]["with_renew"] == {}


def test_a_rename_is_asked_about_and_nothing_is_changed_or_marked_before(ball: ChangingBank) -> None:
    before = numbers(ball)
    renamed = {"M" if symbol == "m" else symbol: row for symbol, row in OTHER.items()}
    text = replace(Text(), givens=renamed, conditions=("M > 0",), words="A ball of {{M}} moves at {{v}}.")
    ball.write(text)
    solution = ball.bank.folder / "solutions" / "topic" / "ball0.py"
    solution.write_text(solution.read_text().replace("derive(m,", "derive(M,").replace("m=m", "m=M"))
    record = (ball.course / ".corollary" / "assigned" / "week.json").read_bytes()

    done = CliRunner().invoke(
        app, ["grade", "week", "--course", str(ball.course), "--bank", str(ball.bank.folder)]
    )
    assert done.exit_code == 2
    assert "the given m looks renamed to M (the same unit and printed value)" in done.stderr
    status, document, said = generate(ball)
    assert (status, document) == (1, {})
    assert "X1.1: the given m looks renamed to M" in said
    assert (ball.course / ".corollary" / "assigned" / "week.json").read_bytes() == record

    assert generate(ball, "--yes")[0] == 0
    now = numbers(ball)
    assert {student: row["M"] for student, row in now.items()} == {
        student: row["m"] for student, row in before.items()
    }
    outcome = ball.grade(open_course(ball.course))
    assert outcome.records["ada"].points == 3.0


@pytest.mark.whole
def test_a_rename_is_not_told_as_other_numbers(ball: ChangingBank) -> None:
    ball.grade(open_course(ball.course))
    givens = {"M" if symbol == "m" else symbol: row for symbol, row in Text().givens.items()}
    ball.write(
        replace(Text(), givens=givens, conditions=("M > 0",), words="A ball of {{M}} moves.", points=2)
    )
    solution = ball.bank.folder / "solutions" / "topic" / "ball0.py"
    solution.write_text(solution.read_text().replace("derive(m,", "derive(M,").replace("m=m", "m=M"))
    assert generate(ball, "--yes")[0] == 0
    (changed,) = ball.grade(open_course(ball.course)).changed
    assert changed.student == "ada"
    assert "what is called otherwise" in changed.why
    assert "the problem X1.1" in changed.why
    assert "the numbers" not in changed.why


@pytest.mark.whole
def test_a_part_and_a_problem_are_called_otherwise(ball: ChangingBank) -> None:
    ball.hand_in(ball.generate("ada", "ben", "cyd"), "ada", X1_1_c="1e9")
    first = ball.grade(open_course(ball.course)).records["ada"]
    assert first.parts["X1_1_c"].verdict == "wrong"
    path = ball.bank.folder / "problems" / "topic" / "ball0.md"
    solution = ball.bank.folder / "solutions" / "topic" / "ball0.py"
    path.write_text(path.read_text().replace("{#c ", "{#force "))
    solution.write_text(solution.read_text().replace('answers="c"', 'answers="force"'))
    assert "the part c looks renamed to force" in generate(ball)[2]
    assert generate(ball, "--yes")[0] == 0
    outcome = ball.grade(open_course(ball.course))
    assert outcome.records["ada"].points == first.points
    assert outcome.records["ada"].parts["X1_1_c"].verdict == "wrong"

    path.write_text(path.read_text().replace("code: X1.1", "code: X1.7"))
    (ball.bank.sets / "week.md").write_text("---\ntitle: A week\nproblems:\n  - X1.7\n---\n")
    ball_parts = generate(ball)
    assert ball_parts[0] == 0, "its parts are no longer the same: it is another problem"
    assert [each["code"] for each in ball_parts[1]["corrections"]] == ["X1.1"]


@pytest.mark.whole
def test_a_problem_of_another_code_is_asked_about(ball: ChangingBank) -> None:
    before = numbers(ball)
    ball.grade(open_course(ball.course))
    ball.write(replace(Text(), code="X1.7"))
    status, _, said = generate(ball)
    assert (status, "the problem X1.1 looks renamed to X1.7" in said) == (1, True)
    assert generate(ball, "--yes")[0] == 0
    assert numbers(ball) == before
    assert ball.grade(open_course(ball.course)).records["ada"].points == 3.0


@pytest.mark.whole
def test_what_looks_renamed_is_not_where_somebody_says_so(ball: ChangingBank) -> None:
    """As the word no on a terminal; scripts have none."""
    ball.grade(open_course(ball.course))
    ball.write(replace(Text(), code="X1.7"))
    status, _, said = generate(ball)
    assert (status, "--not-renamed treats it as removed and added" in said) == (1, True)
    status, document, said = generate(ball, "--not-renamed")
    assert status == 0, said
    assert "X1.1 is no longer in the set" in said
    assert document["students"]["ada"]["variants"] == {}, "nobody was asked X1.7"
    assert generate(ball)[0] == 0, "it is asked once"
