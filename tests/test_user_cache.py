"""What is kept between commands comes back whole, or not at all."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from corollary import user_cache


@pytest.fixture
def folder(tmp_path, monkeypatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "corollary"


def test_it_comes_back_for_the_same_origin_alone(folder):
    assert user_cache.read("list", "one") is None
    user_cache.write("list", "one", b"text\nof two lines")
    assert user_cache.read("list", "one") == b"text\nof two lines"
    assert user_cache.read("list", "two") is None
    user_cache.write("list", "two", b"")
    assert user_cache.read("list", "two") == b""
    assert user_cache.read("list", "one") is None
    (place,) = folder.iterdir()
    assert stat.S_IMODE(place.stat().st_mode) == 0o600
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700


@pytest.mark.parametrize(
    "harm", [lambda text: b"", lambda text: text[:-1], lambda text: text + b" ", lambda text: b"\0" * 99, lambda text: b"\xff\n\xff\n"]
)  # fmt: skip
def test_what_is_damaged_is_not_read(folder, harm):
    user_cache.write("list", "one", b"text")
    (place,) = folder.iterdir()
    place.write_bytes(harm(place.read_bytes()))
    assert user_cache.read("list", "one") is None


def test_what_is_of_someone_else_is_not_read(folder, monkeypatch):
    user_cache.write("list", "one", b"text")
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    assert user_cache.read("list", "one") is None


def test_where_nothing_can_be_kept_nothing_is(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    user_cache.write("list", "one", b"text")
    assert user_cache.read("list", "one") is None


def test_a_user_without_a_home(monkeypatch):
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)

    def homeless() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(Path, "home", homeless)
    user_cache.write("list", "one", b"text")
    assert user_cache.read("list", "one") is None


def test_programs_are_told_apart_by_size_and_moment(tmp_path, monkeypatch):
    monkeypatch.setattr(user_cache, "PACKAGE", tmp_path)
    (tmp_path / "room" / "inner").mkdir(parents=True)
    inner, alone = tmp_path / "room" / "inner" / "deep.py", tmp_path / "alone.py"
    inner.write_text("x = 1")
    alone.write_text("y = 1")
    first = user_cache.programs(("room", "alone.py"))
    assert first == user_cache.programs(("room", "alone.py"))
    os.utime(inner, ns=(1, 1))
    second = user_cache.programs(("room", "alone.py"))
    alone.write_text("y = 10")
    assert len({first, second, user_cache.programs(("room", "alone.py"))}) == 3
