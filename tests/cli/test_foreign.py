"""The first use of a bank says that it has programs: once, to a person, and neither of the chapter's nor of one with texts only."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from corollary.cli.ending import first_use
from corollary.problem.bank import chapter_bank


@pytest.fixture
def said(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv("COROLLARY_BANK", raising=False)

    def use(*, terminal: bool = True, **options: object) -> str:
        monkeypatch.setattr(sys.stderr, "isatty", lambda: terminal)
        return first_use(options)

    return use


def test_once_for_each_bank(said, tmp_path, monkeypatch):
    for name in ("one", "two", "three"):
        (tmp_path / name / "problems").mkdir(parents=True)
        (tmp_path / name / "solutions" / "heat").mkdir(parents=True)
        (tmp_path / name / "solutions" / "heat" / "kettle.py").write_text("")
    one, two = tmp_path / "one", tmp_path / "two"
    assert f"{one}: beside its solutions this bank has Python programs, which run as you" in said(bank=one)
    assert said(bank=one) == ""
    monkeypatch.setenv("COROLLARY_BANK", f"{one}:{two}" if sys.platform != "win32" else f"{one};{two}")
    assert said(bank=None).startswith(f"{two}: ")
    assert said(bank=None) == ""
    monkeypatch.delenv("COROLLARY_BANK")
    three = tmp_path / "three" / "problems" / "heat" / "kettle.md"
    assert said(bank=None, code=str(three)).startswith(f"{tmp_path / 'three'}: ")
    assert said(bank=None, code=str(three)) == ""
    assert said(bank=Path("a_package")).startswith("a_package: ")


def test_not_of_the_chapter_nor_to_a_script(said, tmp_path, monkeypatch):
    assert said(bank=None) == ""
    assert said(bank=Path("chapter")) == ""
    assert said(bank=chapter_bank().folder) == ""
    assert said(bank=tmp_path, terminal=False) == ""


def test_not_of_a_bank_with_texts_only(said, tmp_path):
    solution = tmp_path / "solutions" / "heat" / "kettle.md"
    solution.parent.mkdir(parents=True)
    solution.write_text("## (a) v\n\n- law: Speed, `v = s/t`\n")
    assert said(bank=tmp_path) == ""
    solution.with_suffix(".py").write_text("def scene(s, t, answer):\n    return []\n")
    assert "Python programs" in said(bank=tmp_path)
