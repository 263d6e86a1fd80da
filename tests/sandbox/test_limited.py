"""Calls in an interpreter of their own: what they return, what they raise, and how they are stopped."""

from __future__ import annotations

import os
import threading

import pytest

from corollary.sandbox.limited import Limited, NotFinished


@pytest.fixture
def limited():
    calls = Limited()
    yield calls
    calls.stop()


def test_a_call_returns_and_raises(limited):
    assert limited.call(dict, seconds=2) == {}
    with pytest.raises(ZeroDivisionError):
        limited.call(_divides_by_zero, seconds=2)
    assert limited.call(os.getpid, seconds=2) == limited.call(os.getpid, seconds=2) != os.getpid()


@pytest.mark.parametrize("endless", ["_loops", "_powers", "_swallows", "_dies"])
def test_what_does_not_end_is_stopped(limited, endless):
    """Also inside one long call of C, and beyond its memory; the next call is answered."""
    with pytest.raises(NotFinished):
        limited.call(globals()[endless], seconds=0.3)
    assert limited.call(list, seconds=2) == []


def test_threads_wait_for_one_another(limited):
    found: list[int] = []
    threads = [
        threading.Thread(target=lambda: found.append(limited.call(os.getpid, seconds=2))) for _ in range(6)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 6
    assert len(set(found)) == 1


def test_a_fork_has_an_interpreter_of_its_own(limited):
    mine = limited.call(os.getpid, seconds=2)
    reading, writing = os.pipe()
    if (fork := os.fork()) == 0:
        try:
            os.write(writing, str(limited.call(os.getpid, seconds=2)).encode())
            limited.stop()
        finally:
            os._exit(0)
    os.waitpid(fork, 0)
    assert int(os.read(reading, 100)) != mine
    assert limited.call(os.getpid, seconds=2) == mine
    os.close(reading)
    os.close(writing)


def _divides_by_zero() -> float:
    return 1 / 0


def _loops() -> None:
    while True:
        pass


def _powers() -> int:
    return len(str(7 ** (7**9)))


def _swallows() -> int:
    return len([bytearray(1 << 28) for _ in range(64)])


def _dies() -> None:
    os._exit(3)
