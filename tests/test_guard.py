"""An exception or too much time is a failure that is told; what concerns everybody, and ctrl-C, goes on its way."""

from __future__ import annotations

import errno
import re

import pytest

from corollary.guard import Failure, collecting, guarded, within


def endless() -> None:
    while True:
        pass


def deep(depth: int = 0) -> int:
    return deep(depth + 1)


class Unspeakable(Exception):
    def __str__(self) -> str:
        raise ValueError("not even this")


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (KeyError("x"), "KeyError: 'x'"),
        (MemoryError(), "MemoryError"),
        (ValueError("a\n" * 9_999_999), "ValueError: a a a"),
        (Unspeakable(), "Unspeakable: it cannot even say what is wrong"),
        (UnicodeEncodeError("utf-8", "\ud800", 0, 1, "surrogates not allowed"), "surrogates not allowed"),
    ],
)
def test_an_exception_is_a_failure_with_its_place(error: Exception, words: str) -> None:
    def work() -> None:
        raise error

    found = guarded(work)
    assert isinstance(found, Failure)
    assert words in found.what
    assert len(found.what) < 300
    assert "in work" in found.trace or len(found.trace) == 20_000
    assert len(found.trace) <= 20_000


def test_too_deep_a_recursion_is_a_failure_of_few_lines() -> None:
    found = guarded(deep)
    assert isinstance(found, Failure)
    assert found.what.startswith("RecursionError")
    assert found.trace.count("in deep") <= 31


@pytest.mark.parametrize("work", [endless, lambda: re.match(r"(a+)+$", "a" * 99 + "b")])
def test_what_never_ends_is_a_failure(work) -> None:
    found = guarded(work, 0.2)
    assert isinstance(found, Failure)
    assert found.what == "it took longer than 0.2 s"


def test_a_guard_inside_another_leaves_it_its_time() -> None:
    def both() -> None:
        assert isinstance(guarded(endless, 0.1), Failure)
        endless()

    assert isinstance(guarded(both, 0.3), Failure)
    with within(5.0):
        assert isinstance(guarded(endless, 0.1), Failure)


def test_no_handler_of_all_exceptions_holds_up_the_end() -> None:
    def stubborn() -> None:
        while True:
            try:
                endless()
            except Exception:
                continue

    assert isinstance(guarded(stubborn, 0.2), Failure)


@pytest.mark.parametrize("error", [KeyboardInterrupt(), SystemExit(1), OSError(errno.ENOSPC, "no space")])
def test_what_concerns_everybody_passes(error: BaseException) -> None:
    def work() -> None:
        raise error

    with pytest.raises(type(error)):
        guarded(work)


def test_named_exceptions_pass_and_the_rest_is_collected(monkeypatch) -> None:
    def work() -> None:
        raise LookupError("concerns the course")

    with pytest.raises(LookupError):
        guarded(work, passing=(LookupError,))
    with collecting() as outer:
        with collecting() as inner:
            guarded(work)
        guarded(work)
    assert (len(inner), len(outer)) == (1, 2)
    monkeypatch.setenv("COROLLARY_DEBUG", "1")
    with pytest.raises(LookupError):
        guarded(work)
