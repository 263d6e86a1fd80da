"""`corollary doctor --attack`: withstood where isolation holds, and said where a layer is missing; nothing is left behind."""

from __future__ import annotations

import os
import tempfile

import pytest

from corollary.cli.commands import app
from corollary.course.attack.attack import play
from corollary.course.attack.hostile_notebooks import MARK
from corollary.course.attack.shown_texts import run_by_page, run_by_spreadsheet, run_by_terminal

from .kernel import promised

pytestmark = pytest.mark.whole


@pytest.mark.skipif(promised() < 3, reason="this kernel has not the features for it")
def test_nothing_succeeds_here_and_nothing_is_left_behind(capfd: pytest.CaptureFixture[str]) -> None:
    before = {*os.listdir(tempfile.gettempdir())}
    assert not app(["doctor", "--attack"], standalone_mode=False), capfd.readouterr().out
    assert "were withstood" in capfd.readouterr().out
    left = {name for name in os.listdir(tempfile.gettempdir()) if "attack" in name} - before
    assert not left


@pytest.mark.skipif(promised() < 3, reason="this kernel has not the features for it")
def test_without_layers_the_same_cells_succeed() -> None:
    """Landlock alone keeps no datagram in: the command must see it."""
    done = play(families=("network",), without=frozenset({"namespaces", "seccomp"}))
    harms = {each.name: each.harm for each in done.succeeded}
    assert harms["UDP"] == ("sends messages to other programs",)
    assert done.isolation.level == 0


@pytest.mark.parametrize(
    ("page", "harm"),
    [
        (f"<p>{MARK}</p>", []),
        (f"<p title='{MARK}'>&lt;script&gt;{MARK}&lt;/script&gt;</p>", []),
        (f"<script>{MARK}</script>", ["runs what stands in <script>"]),
        (f"<img src=x onerror='{MARK}'>", ["runs <img onerror>"]),
        (f"<a href='javascript:{MARK}'>x</a>", ["opens an address in <a href>"]),
        (f"<iframe srcdoc='{MARK}'>", ["runs <iframe srcdoc>"]),
    ],
)
def test_what_a_page_would_run(page: str, harm: list[str]) -> None:
    assert run_by_page(page) == harm


def test_what_a_spreadsheet_and_a_terminal_would_run() -> None:
    assert run_by_spreadsheet(f"id,'={MARK}\nx,={MARK}\n") == [f"is calculated: '={MARK}'"]
    assert run_by_terminal("plain\n") == []
    assert run_by_terminal("\x1b[2J") == ["sends '\\x1b' to the terminal"]
