"""The bar's words: how fast it goes and how long it will take; lines in a pipe where it takes long, and else nothing."""

from __future__ import annotations

import pytest

from corollary.cli import terminal
from corollary.cli.terminal import bar, countdown, pace


@pytest.mark.parametrize(
    ("moments", "left", "said"),
    [
        ([10.0, 10.5], 8, ""),  # one step apart says too little
        ([10.0, 10.5, 11.0], 8, "2.0/s, 4 s left"),
        ([100.0, 102.0, 104.0], 100, "30/min, 3 min left"),
        ([100.0, 102.0, 104.0], 0, "30/min"),
        ([5.0, 5.0, 5.0], 3, "1000.0/s, 0 s left"),
        ([1.0, 2.0, 3.0], None, ""),
    ],
)
def test_the_pace_is_counted_from_step_to_step(moments: list[float], left: int | None, said: str) -> None:
    assert pace(moments, left) == said


def test_nothing_is_written_to_a_file_of_what_is_soon_done(capsys: pytest.CaptureFixture[str]) -> None:
    with countdown("grading") as tell:
        for left in (2, 1, 0):
            tell("ada", left)
    assert capsys.readouterr() == ("", "")


def test_long_work_writes_lines_into_a_pipe(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(terminal, "EVERY", 0.0)
    with bar("verifying", 3) as progress:
        for code in ("S12.1", "S12.2"):
            progress(code)
    with countdown("grading") as tell:
        tell("ada", 41)
    assert capsys.readouterr() == (
        "", "verifying: 1 of 3 (S12.1)\nverifying: 2 of 3 (S12.2)\ngrading: 1 of 42 (ada)\n"
    )  # fmt: skip
