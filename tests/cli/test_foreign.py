"""The first use of a bank says that its solutions are programs: once, to a person, and not of the chapter's."""

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
    for name in ("one", "two"):
        (tmp_path / name / "problems").mkdir(parents=True)
    one, two = tmp_path / "one", tmp_path / "two"
    assert f"{one}: solutions of a bank are Python programs, which run as you" in said(bank=one)
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
