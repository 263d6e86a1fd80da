"""What `corollary verify` says to a person: the table, what is wrong, how many notes, and the verdict in the last line."""

from __future__ import annotations

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app

ONE_OF_TWO = "- mistake: That is the time for the way back. `w = d/t`\n"


@pytest.fixture
def verify(tmp_path):
    bank = str(tmp_path / "mine")
    assert CliRunner().invoke(app, ["new", "Q1", "ride", "--bank", bank]).exit_code == 0

    def run(*options: str, old: str = "", new: str = ""):
        path = tmp_path / "mine" / "solutions" / "exercises" / "ride.md"
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new, 1), encoding="utf-8")
        return CliRunner().invoke(app, ["verify", "Q1", "--bank", bank, "--variants", "10", *options])

    return run


def test_the_verdict_is_the_last_line(verify):
    done = verify()
    assert done.exit_code == 0
    assert done.stdout.splitlines()[-1] == "all hold"


def test_complaints_begin_with_their_place_and_the_verdict_names_the_problem(verify):
    done = verify(old="v = d/t", new="v = d*t")
    assert done.exit_code == 1
    complaints = [line for line in done.stderr.splitlines() if line]
    assert complaints[0].startswith("solutions/exercises/ride.md:3: part a: the answer is not in s")
    assert done.stdout.splitlines()[-1] == "1 of 1 problem with complaints: Q1"


def test_notes_on_several_problems_are_counted_and_shown_where_they_are_asked_for(verify, tmp_path):
    """One mistake is few: a note, and no complaint."""
    assert CliRunner().invoke(app, ["new", "Q2", "walk", "--bank", str(tmp_path / "mine")]).exit_code == 0
    done = verify("Q2", old=ONE_OF_TWO)
    assert done.exit_code == 0
    assert done.stderr.split("\n\n")[-1].strip() == "1 note, no fault (Q1): --verbose shows them"
    shown = verify("Q2", "--verbose")
    assert "notes on Q1:\n  solutions/exercises/ride.md:" in shown.stderr
    assert "--verbose" not in shown.stderr
    assert shown.stdout.splitlines()[-1] == "all hold"


def test_notes_on_one_problem_are_shown(verify):
    done = verify(old=ONE_OF_TWO)
    assert "notes on Q1:\n  solutions/exercises/ride.md:" in done.stderr
    assert done.stdout.splitlines()[-1] == "all hold"
