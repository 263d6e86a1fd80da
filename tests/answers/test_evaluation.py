"""Numbers at the edge of what a double holds are answered, and never with a traceback."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from corollary.cli.main import app
from corollary.problem.bank import chapter_bank


@pytest.mark.parametrize("value", [5e-324, 1e308, 1e-200])
def test_an_example_of_numbers_too_small_or_large_is_answered(value: float, tmp_path: Path) -> None:
    problem = next(each for each in chapter_bank() if each.code == "X12.2")
    (part,) = (part.id for part in problem.parts if part.answer_type == "example")
    cases = tmp_path / "cases.json"
    cases.write_text(json.dumps([{"given": {}, "answers": {part: [value] * 4}}]))
    done = CliRunner().invoke(app, ["judge", "X12.2", "--cases", str(cases), "--json"])
    assert done.exit_code == 0, done.stderr
    judged = json.loads(done.stdout)[0]["parts"][part]
    assert judged["verdict"] == "unread"
    assert "of this machine" in judged["feedback"]
