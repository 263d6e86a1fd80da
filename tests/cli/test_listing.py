"""`corollary list`: the same document from the cache as without, and quickly."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from corollary.cli.commands import app
from corollary.problem.bank import chapter_bank

BANK = chapter_bank().folder


@pytest.fixture
def bank(tmp_path, monkeypatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    shutil.copytree(BANK / "problems" / "impulse", tmp_path / "bank" / "problems" / "impulse")
    return tmp_path / "bank"


def said(*words: object) -> str:
    done = CliRunner().invoke(app, ["list", *map(str, words)], catch_exceptions=False)
    assert done.exit_code == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("words", [(), ("--json",)])
def test_the_same_from_the_cache(bank, words):
    fresh = said("--bank", bank, *words)
    assert list((bank.parent / "cache" / "corollary").glob("list-*"))
    assert said("--bank", bank, *words) == fresh
    shutil.rmtree(bank.parent / "cache")
    assert said("--bank", bank, *words) == fresh


def test_a_change_is_seen(bank):
    before = json.loads(said("--bank", bank, "--json"))
    path = bank / "problems" / "impulse" / "kicking_a_ball.md"
    path.write_text(path.read_text(encoding="utf-8").replace("title: ", "title: Not ", 1), encoding="utf-8")
    after = {each["code"]: each for each in json.loads(said("--bank", bank, "--json"))}
    changed = [each["code"] for each in before if each != after[each["code"]]]
    assert changed == ["X12.5"]
    assert after["X12.5"]["title"].startswith("Not ")
    path.unlink()
    assert "X12.5" not in {each["code"] for each in json.loads(said("--bank", bank, "--json"))}


def test_what_is_malformed_is_complained_of_each_time(bank):
    said("--bank", bank)
    (bank / "problems" / "impulse" / "kicking_a_ball.md").write_text("nothing", encoding="utf-8")
    for _ in range(2):
        done = CliRunner().invoke(app, ["list", "--bank", str(bank)])
        assert done.exit_code == 2
        assert "kicking_a_ball.md:1: begins without front matter" in done.stderr


PROGRAM = """
import sys
from corollary.cli.main import main
sys.argv = ["corollary", *sys.argv[1:]]
try:
    main()
except SystemExit as end:
    assert not end.code, end.code
print(*sys.modules)
"""


@pytest.mark.parametrize(
    ("words", "heavy"),
    [
        (("list",), {"numpy", "yaml", "flint", "sympy", "corollary.formula.ast", "importlib.metadata"}),
        (("list", "--json"), {"numpy", "yaml", "flint", "sympy", "rich", "corollary.formula.ast"}),
        (("show", "X12.5"), {"numpy", "flint", "sympy", "jinja2", "msgspec", "corollary.grading"}),
        (("read", "8,6Ns", "--unit", "N*s"), {"numpy", "yaml", "flint", "sympy", "corollary.problem.bank"}),
        (("key", "X12.5"), {"numpy", "sympy", "jinja2", "rich", "markdown_it"}),
    ],
)
def test_once_warm_only_what_is_needed_is_imported(tmp_path, words, heavy):
    """What keeps these commands short: three tenths of a second, most of which is imports."""
    environment = os.environ | {"XDG_CACHE_HOME": str(tmp_path)}
    command = [sys.executable, "-c", PROGRAM, *words]
    for _ in range(2):
        ended = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    assert not heavy & set(ended.stdout.splitlines()[-1].split())
