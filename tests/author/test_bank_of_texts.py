"""The bank beside these tests, of solutions in text alone: `corollary verify` finds nothing to complain of."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app

BANK = Path(__file__).with_name("bank")
CODES = [
    line.removeprefix("code: ").strip()
    for path in sorted(BANK.glob("problems/*/*.md"))
    for line in path.read_text(encoding="utf-8").splitlines()
    if line.startswith("code: ")
]


@pytest.mark.parametrize("code", CODES)
def test_the_problem_is_verified(code):
    done = CliRunner().invoke(app, ["verify", code, "--bank", str(BANK), "--variants", "20"])
    assert done.exit_code == 0, done.output
    assert done.stdout.splitlines()[-1] == "all hold"


def test_no_solution_is_a_program():
    assert len(CODES) == len(list(BANK.glob("solutions/*/*.md")))
    assert not list(BANK.glob("solutions/**/*.py"))
