"""`corollary extend`: deadlines of one's own, given, listed, taken back; and what is said of dates."""

from __future__ import annotations

import json
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.cli.told_dates import warn_of_dates, warn_of_grading_early
from corollary.records.deadlines import Extension, read_deadlines, write_extension
from corollary.records.files import open_course
from corollary.records.origin import set_of

SET = "---\ntitle: One\ndue: 2999-12-04\nopens: 2999-11-27\nreveal: {reveal}\nproblems: [X12.5]\n---\nOne exercise.\n"
DUE = datetime(2999, 12, 4, 22, 59, 59, 999999, tzinfo=UTC)


def run(*words: object) -> tuple[int, str, str]:
    done = CliRunner().invoke(app, [str(word) for word in words], catch_exceptions=False)
    return done.exit_code, done.stdout, done.stderr


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("term")
    (folder / "one.md").write_text(SET.replace("{reveal}", "by hand"))
    (folder / "roster.csv").write_text(
        "id,first_name,last_name,email\nada,Ada,Lovelace,ada@uni.example\nben,,,\n0007153,Finn,Berg,\n0008633,Finn,Berg,\n"
    )
    (folder / "mech").mkdir()
    (folder / "mech" / "corollary.toml").write_text('timezone = "Europe/Oslo"\n')
    status, _, err = run(
        "generate", folder / "one.md", "--roster", folder / "roster.csv", "--course", folder / "mech"
    )
    assert status == 0, err
    warning = (
        "warning: one opens Wednesday 27 November 2999, 00:00 (Europe/Oslo); do not give sheets out before"
    )
    assert warning in err
    assert "past" not in err
    status, _, err = run("generate", "one", "--course", folder / "mech")
    assert status == 0, err
    assert warning not in err
    return folder / "mech"


@pytest.fixture
def course(generated: Path, monkeypatch) -> Path:
    """The course, around the working folder; no extensions yet."""
    monkeypatch.chdir(generated)
    for record in generated.glob(".corollary/extensions/*/*.json"):
        record.unlink()
    return generated


def deadlines(course: Path):
    opened = open_course(course)
    return read_deadlines(opened, set_of(opened, "one")[1])


def test_a_day_is_extended_to_its_end_in_the_courses_zone(course: Path):
    status, out, err = run("extend", "ada", "one", "2999-12-11")
    assert (status, err) == (0, "")
    assert out == "ada has until Wednesday 11 December 2999, 23:59 (Europe/Oslo) for one\n"
    assert deadlines(course).of("ada") == DUE + timedelta(days=7)
    assert deadlines(course).of("ben") == DUE
    status, out, _ = run("extend", "ada@uni.example", "one", "2999-12-11", "18:00", "--json")
    assert json.loads(out) == {
        "student": "ada",
        "set": "one",
        "until": "2999-12-11T18:00:00+01:00",
        "excused": False,
    }


def test_who_has_what_is_listed_and_taken_back(course: Path):
    assert run("extend", "--list")[1] == "nobody has an extension or an excuse\n"
    run("extend", "ada", "one", "2999-12-11")
    assert run("extend", "ben", "one", "--excuse")[1] == "ben is excused from one\n"
    assert deadlines(course).excused("ben")
    assert run("extend", "--list")[1].splitlines() == [
        "ada has until Wednesday 11 December 2999, 23:59 (Europe/Oslo) for one",
        "ben is excused from one",
        "everybody else has until Wednesday 4 December 2999, 23:59 (Europe/Oslo) for one",
    ]
    assert [each["student"] for each in json.loads(run("extend", "ben", "--list", "--json")[1])] == ["ben"]
    assert (
        run("extend", "ada", "one", "--remove")[1] == "ada has no longer an extension or an excuse in one\n"
    )
    assert run("extend", "ada", "one", "--remove")[1] == "ada has neither an extension nor an excuse in one\n"
    assert deadlines(course).of("ada") == DUE


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["ada", "one"], "give one of"),
        (["ada", "one", "2999-12-11", "--excuse"], "give one of"),
        (["ada", "--excuse"], "name the student and the problem set"),
        (["ada", "one", "soon"], "soon is not a date or time; write it as 2026-12-04"),
        (["ada", "one", "2999-12-01"], "is before one is due anyway, Wednesday 4 December 2999"),
        (["adda", "one", "--excuse"], "adda is not on the roster of "),
        (["adda", "one", "--excuse"], "(did you mean ada?)"),
        (["Ada  Lovelace", "one", "--excuse"], "is not an id on the roster of "),
        (["ada lovelace", "one", "--excuse"], "; did you mean ada?\n"),
        (["Finn Berg", "one", "--excuse"], "; did you mean 0007153 or 0008633?\n"),
        (["7153", "one", "--excuse"], "; did you mean 0007153?\n"),
        (["ada", "momentum_2", "--excuse"], "(did you mean momentum_1?)"),
        (["ada", "onne", "--excuse"], "there is no problem set onne (did you mean one?); "),
    ],
)
def test_what_will_not_do(course: Path, words: list[str], sentence: str):
    status, out, err = run("extend", *words)
    assert (status, out) == (2, "")
    assert sentence in err


def test_a_set_without_a_date_cannot_be_extended(course: Path):
    (course / "free.md").write_text("---\ntitle: Free\nproblems: [X12.5]\n---\n")
    status, _, err = run("extend", "ada", "free.md", "2999-12-11")
    assert (status, "free has no date to extend" in err) == (2, True)


def test_reveal_is_for_sets_that_leave_it_to_the_hand(course: Path):
    status, _, err = run("grade", "one", "--reveal", "--dry-run")
    assert (status, "give one of them" in err) == (2, True)
    assert not deadlines(course).by_hand
    (course.parent / "one.md").write_text(SET.replace("{reveal}", "after due"))
    status, _, err = run("grade", "one", "--reveal")
    assert (status, "one has reveal: after due" in err) == (2, True)
    (course.parent / "one.md").write_text(SET.replace("{reveal}", "by hand"))


def test_what_is_said_before_grading(course: Path, capsys):
    opened = open_course(course)
    problem_set = set_of(opened, "one")[1]
    warn_of_grading_early(opened, problem_set, DUE)
    assert (
        "warning: one is not due before Wednesday 4 December 2999, 23:59 (Europe/Oslo)"
        in capsys.readouterr().err
    )
    warn_of_grading_early(opened, problem_set, DUE + timedelta(hours=1))
    assert capsys.readouterr().err == ""
    write_extension(opened, "one", "ada", Extension(DUE + timedelta(days=1)))
    warn_of_grading_early(opened, problem_set, DUE + timedelta(hours=1))
    assert capsys.readouterr().err.startswith(
        "Ada Lovelace (ada) can still hand in one, at the latest until Thursday 5 December 2999, 23:59 (Europe/Oslo)"
    )
    warn_of_grading_early(opened, problem_set, DUE + timedelta(days=2))
    assert capsys.readouterr().err == ""


def test_sheets_given_out_before_the_set_opens(course: Path, tmp_path: Path):
    status, _, err = run("release", "one", "--to", "folder", "--output", tmp_path / "sheets")
    assert status == 0, err
    assert (
        "warning: one opens Wednesday 27 November 2999, 00:00 (Europe/Oslo); do not give sheets out before"
        in err
    )


def test_a_date_in_the_past_is_pointed_out(course: Path, capsys):
    problem_set = set_of(open_course(course), "one")[1]
    warn_of_dates(problem_set, DUE + timedelta(seconds=1))
    assert (
        "one was due Wednesday 4 December 2999, 23:59 (Europe/Oslo), so every hand-in counts as late"
        in capsys.readouterr().err
    )
    warn_of_dates(problem_set, DUE)
    assert capsys.readouterr().err == ""
