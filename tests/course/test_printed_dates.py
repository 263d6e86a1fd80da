"""A deadline is moved after the sheets were given out: nobody is late before the moment that the own sheet prints."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.course.export import sheets_of_course
from corollary.records.files import open_course
from corollary.records.origin import set_of
from corollary.records.report_model import report_of

from .changing_bank import ChangingBank, Text
from .conftest import grade

pytestmark = pytest.mark.whole

PRINTED = "due Friday 4 December 2099, 23:59 (UTC)"
STAMP = "2099-12-01 12:00:00 UTC"  # before what the sheets print, and after what the set says in the end


def date(ball: ChangingBank, due: str, zone: str = "UTC") -> None:
    line = f"due: {due}\n" if due else ""
    (ball.bank.sets / "week.md").write_text(
        f"---\ntitle: A week\n{line}credit: {{late: 0.5}}\nproblems:\n  - X1.1\n---\nBalls.\n"
    )
    ball.course.mkdir(exist_ok=True)
    (ball.course / "corollary.toml").write_text(f'timezone = "{zone}"\n')


def run(ball: ChangingBank, *words: str) -> tuple[int, Any, str]:
    line = [*words, "--course", str(ball.course), "--json"]
    done = CliRunner().invoke(app, line, catch_exceptions=False)
    return done.exit_code, json.loads(done.stdout) if done.stdout else {}, done.stderr


def generate(ball: ChangingBank, *words: str, roster: str = "ada ben") -> tuple[int, Any, str]:
    (ball.folder / "roster.csv").write_text("id\n" + "\n".join(roster.split()) + "\n")
    bank = "--bank", str(ball.bank.folder)
    return run(ball, "generate", "week", "--roster", str(ball.folder / "roster.csv"), *bank, *words)


def sheet(ball: ChangingBank, student: str) -> Path:
    return ball.course / "release" / student / "week" / "week.ipynb"


@pytest.fixture
def ball(tmp_path: Path) -> ChangingBank:
    """Ada and Ben have sheets that are due on the fourth; Ada has handed in, on the first."""
    ball = ChangingBank(tmp_path)
    ball.write(Text())
    date(ball, "2099-12-04")
    generate(ball)
    assert PRINTED in sheet(ball, "ada").read_text()
    course = open_course(ball.course)
    opened = set_of(course, "week")[1]
    made = ball.generate("ada", "ben")
    assert opened.due is not None
    ball.hand_in(made, "ada")
    (ball.course / "submitted/ada/week/timestamp.txt").write_text(STAMP)
    return ball


def test_an_earlier_date_makes_nobody_late_whose_sheet_prints_the_other(ball: ChangingBank) -> None:
    before = sheet(ball, "ben").read_bytes()
    date(ball, "2099-11-20", "Europe/Oslo")
    status, document, said = generate(ball, roster="ada ben cyd")
    assert status == 0
    (correction,) = document["corrections"]
    assert (correction["code"], sorted(correction["students"])) == ("week", ["ada", "ben"])
    assert correction["sentence"].startswith(
        "is due Friday 20 November 2099, 23:59 (Europe/Oslo) now, and these sheets print Friday 4 December 2099, 23:59 (UTC)"
    )
    assert document["with_renew"] == {"ben": []}
    assert "2 students: ada, ben" in said
    assert sheet(ball, "ben").read_bytes() == before
    assert "Friday 20 November 2099, 23:59 (Europe/Oslo)" in sheet(ball, "cyd").read_text()

    done = grade(ball.course, name="week")
    assert done.points == {"ada": 3.0}
    assert "the sheets of 2 students: ada, ben print Friday 4 December 2099, 23:59" in done.errors
    course = open_course(ball.course)
    (ada,) = report_of(course, set_of(course, "week")[1]).noticed
    assert ada.notes[-1] == (
        "handed in after Friday 20 November 2099, 23:59 (Europe/Oslo), but the sheet prints Saturday 5 December 2099, 00:59 "
        "(Europe/Oslo), which counts"
    )


def test_a_new_sheet_gives_the_new_date(ball: ChangingBank) -> None:
    date(ball, "2099-11-20")
    (ball.course / "submitted/ada/week/week.ipynb").rename(ball.folder / "mine.ipynb")
    assert generate(ball, "--renew", "--yes")[1]["renewed"] == ["ada", "ben"]
    assert "20 November 2099" in sheet(ball, "ada").read_text()
    (ball.folder / "mine.ipynb").rename(ball.course / "submitted/ada/week/week.ipynb")
    done = grade(ball.course, name="week")
    assert (done.status, done.points) == (0, {"ada": 1.5})
    assert "which counts for them" not in done.errors
    assert generate(ball)[1]["corrections"] == []


def test_a_later_date_and_a_date_where_none_was_count_at_once(ball: ChangingBank) -> None:
    date(ball, "2099-12-11")
    (correction,) = generate(ball)[1]["corrections"]
    assert correction["sentence"].endswith("the later date counts")
    (ball.course / "submitted/ada/week/timestamp.txt").write_text("2099-12-10 12:00:00 UTC")
    assert grade(ball.course, name="week").points == {"ada": 3.0}
    date(ball, "")
    (correction,) = generate(ball)[1]["corrections"]
    assert correction["sentence"].endswith("nobody is late any more")
    generate(ball, "--renew", "--yes")
    date(ball, "2099-12-01")
    found = {tuple(each["students"]): each["sentence"] for each in generate(ball)[1]["corrections"]}
    assert "print no date: the new date counts" in next(text for who, text in found.items() if "ben" in who)


def test_a_sheet_that_is_lost_is_written_with_its_own_date(ball: ChangingBank) -> None:
    before = sheet(ball, "ben").read_bytes()
    sheet(ball, "ben").unlink()
    date(ball, "2099-11-20", "Europe/Oslo")
    generate(ball)
    assert sheet(ball, "ben").read_bytes() == before
    course = open_course(ball.course)
    printed = sheets_of_course(course, set_of(course, "week")[1])
    assert {each.problem_set.due.isoformat() for each in printed if each.problem_set.due} == {
        "2099-12-04T23:59:59.999999+00:00"
    }
