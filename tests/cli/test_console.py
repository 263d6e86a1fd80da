"""Tables are whole wherever they are read: nothing is cut off for want of a terminal."""

from __future__ import annotations

import pytest
from rich.table import Table

from corollary.cli.terminal import console

WORDS = " ".join(f"word{number}" for number in range(60))


def printed(capsys: pytest.CaptureFixture[str]) -> str:
    table = Table("student", "why")
    table.add_row("ada", WORDS)
    console().print(table)
    return capsys.readouterr().out


def test_a_pipe_gets_every_row_on_one_line(capsys, monkeypatch) -> None:
    monkeypatch.delenv("COLUMNS", raising=False)
    assert WORDS in printed(capsys)


def test_a_width_that_is_given_is_kept_to(capsys, monkeypatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    assert max(map(len, printed(capsys).splitlines())) <= 60
