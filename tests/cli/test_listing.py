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
from tests import forked

from corollary.cli.commands import app
from corollary.problem.bank import chapter_bank

BANK = chapter_bank().folder


@pytest.fixture
def bank(tmp_path, monkeypatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    shutil.copytree(BANK / "problems" / "impulse", tmp_path / "bank" / "problems" / "impulse")
    return tmp_path / "bank"


def said(*words: object) -> str:
    done = CliRunner(env={"COLUMNS": "160"}).invoke(app, ["list", *map(str, words)], catch_exceptions=False)
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
    for each in path.parent.glob("kicking_a_ball*.md"):  # with its translations
        each.unlink()
    assert "X12.5" not in {each["code"] for each in json.loads(said("--bank", bank, "--json"))}


def test_what_is_malformed_is_complained_of_each_time(bank):
    said("--bank", bank)
    (bank / "problems" / "impulse" / "kicking_a_ball.md").write_text("nothing", encoding="utf-8")
    for _ in range(2):
        done = CliRunner().invoke(app, ["list", "--bank", str(bank)])
        assert done.exit_code == 1
        assert "kicking_a_ball.md:1: begins without front matter" in done.stderr
        assert "X12.6" in done.stdout  # the others are listed


def test_chosen_and_sorted():
    def codes(*words: str) -> list[str]:
        return [each["code"] for each in json.loads(said(*words, "--json"))]

    problems = {each["code"]: each for each in json.loads(said("--json"))}
    assert {problems[code]["topic"] for code in codes("--topic", "impulse")} == {"impulse"}
    assert set(codes("--topic", "impulse", "--topic", "momentum")) > set(codes("--topic", "impulse"))
    for code in codes("--type", "plot"):
        assert any("plot" in part["kind"].split("+") for part in problems[code]["parts"].values())
    by_a_person = codes("--person")
    assert "P12.14" in by_a_person
    assert "X12.5" not in by_a_person
    for code, problem in problems.items():
        waits = [part["kind"] == "explain" for part in problem["parts"].values() if part["person"]]
        assert all(waits)
        assert bool(waits) is (code in by_a_person)
    counts = [problems[code]["variants"] for code in codes("--sort", "variants")]
    assert counts == sorted(counts)
    titles = [problems[code]["title"].lower() for code in codes("--sort", "title")]
    assert titles == sorted(titles)


def test_for_people_a_part_that_waits_for_a_person_has_a_star():
    lines = said("--topic", "impulse").splitlines()
    assert lines[0].strip() == "8 problems, 38 parts (* waits for a person)"
    (window,) = [line for line in lines if "T12.3" in line]
    assert "a b c d e f*" in window
    assert "value, explain" in window


def test_one_problem_is_one_problem(bank):
    for path in (bank / "problems" / "impulse").glob("*.md"):
        if path.stem != "kicking_a_ball":
            path.unlink()
    assert "1 problem, 4 parts" in said("--bank", bank)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            ["list", "--topic", "impuls"],
            "--topic impuls is in no problem (did you mean impulse?); choose one of ",
        ),
        (["list", "--type", "explan"], "--type explan is in no problem (did you mean explain?)"),
        (["key", "kicking_a_bal"], "no problem is called kicking_a_bal (did you mean kicking_a_ball?)"),
        (["key", "X12-5"], "(did you mean X12.5"),
        (["scene", "cradel"], "no scene 'cradel' (did you mean cradle?)"),
        (["scene", "cradle", "--set", "mases=1"], "(did you mean masses?)"),
        (["show", "X12.5", "--format", "htlm"], "(did you mean html?)"),
        (["export", "momentum_1", "--to", "htlm"], "(did you mean html?)"),
        (["export", "momentun_1", "--to", "html"], "no problem set momentun_1 (did you mean momentum_1?)"),
        (["generat"], "did you mean 'generate'"),
        (["key", "X12.5", "--casses", "f"], "did you mean"),
    ],
)
def test_what_is_nearly_right_is_guessed(tmp_path, words, sentence):
    done = forked.run([forked.COMMAND, *words], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (2, "")
    assert sentence.lower() in done.stderr.lower()


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


@pytest.mark.whole
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
