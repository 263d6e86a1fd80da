"""The page on paper: each command of it is run as it stands there."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from corollary.cli.main import main

PAGE = Path(__file__).parents[2] / "docs" / "howto" / "print_sheets.md"
COMMANDS = re.findall(r"^\| `corollary ([^`]+)`", PAGE.read_text(encoding="utf-8"), re.MULTILINE)


@pytest.mark.whole
def test_every_command_of_the_page_on_paper_does_what_it_says(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("roster.csv").write_text("id,first_name\nada,Ada\nbo,Bo\n")

    def run(line: str) -> int:
        monkeypatch.setattr("sys.argv", ["corollary", *shlex.split(line)])
        with pytest.raises(SystemExit) as end:
            main()
        return int(end.value.code or 0)

    assert run("generate momentum_1 --roster roster.csv --course mechanics") == 0
    assert len(COMMANDS) >= 6
    for line in COMMANDS:
        assert run(line) == 0, line
    made = {path.name for path in Path("export").rglob("*.pdf")}
    assert {f"momentum_1-{who}.pdf" for who in ("ada", "bo", "A", "B", "C", "D")} <= made
    assert {"momentum_1.pdf", "momentum_1-ada-key.pdf", "momentum_1-D-key.pdf"} <= made
    assert Path("kick.pdf").read_bytes().startswith(b"%PDF-")
