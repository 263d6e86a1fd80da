"""Workers beside this one: one that is killed at whatever moment costs what it was at, and nobody waits for ever."""

from __future__ import annotations

import os
import random
import signal
import time
from collections.abc import Sequence
from concurrent.futures import Future
from threading import Thread

import pytest

from corollary.parallel import ProcessDied, Workers

LONG = 60  # seconds: none of what is waited for here takes one
LARGE = 2_000_000  # bytes: many times what a pipe holds


def nothing() -> None:
    pass


def doubled(number: int) -> int:
    return 2 * number


def returned(given: bytes) -> bytes:
    return given


def slept(seconds: float, given: bytes) -> bytes:
    time.sleep(seconds)
    return given


def killed(given: bytes) -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def left_running() -> int:
    Thread(target=time.sleep, args=(10 * LONG,)).start()
    return 1


def divided(by: int) -> float:
    return 1 / by


def not_to_be_sent() -> object:
    return lambda: None


def outcomes(futures: Sequence[Future[bytes]]) -> list[bytes | None]:
    """What each gave, None where its process died. Fails where one neither gives anything nor dies."""
    found: list[bytes | None] = []
    for future in futures:
        try:
            found.append(future.result(timeout=LONG))
        except ProcessDied:
            found.append(None)
    return found


def test_all_of_it_is_done_whatever_its_size() -> None:
    texts = [bytes([place]) * (LARGE if place % 2 else 1) for place in range(20)]
    with Workers(3, nothing) as processes:
        assert outcomes([processes.submit(returned, text) for text in texts]) == texts


@pytest.mark.parametrize("size", [1, LARGE])
@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_process_that_dies_costs_what_it_was_at(count: int, size: int) -> None:
    """Also where much more is waiting than a pipe holds, and where no process is left."""
    text = b"a" * size
    with Workers(count, nothing) as processes:
        deadly = processes.submit(killed, text)
        others = [processes.submit(returned, text) for _ in range(8)]
        with pytest.raises(ProcessDied):
            deadly.result(timeout=LONG)
        assert outcomes(others) == [text if count > 1 else None] * 8
        if count == 1:
            with pytest.raises(ProcessDied):
                processes.submit(returned, text).result(timeout=LONG)


@pytest.mark.whole
@pytest.mark.parametrize("seed", range(12))
def test_killed_at_random_moments(seed: int) -> None:
    """While it waits, works, takes a task or gives its result, of which the half may be on the way."""
    chance = random.Random(seed)
    texts = [bytes([place]) * chance.choice((1, 100_000, 10 * LARGE)) for place in range(12)]
    with Workers(2, nothing) as processes:
        victim = processes.submit(os.getpid).result(timeout=LONG)
        futures = [processes.submit(slept, chance.uniform(0, 0.01), text) for text in texts]
        moment = chance.uniform(0, 0.15)
        killer = Thread(target=lambda: (time.sleep(moment), os.kill(victim, signal.SIGKILL)))
        killer.start()
        found = outcomes(futures)
        killer.join()
    assert all(given in (text, None) for given, text in zip(found, texts, strict=True))
    assert found.count(None) <= 1


def test_what_the_work_raises_is_raised_here_and_the_process_goes_on() -> None:
    with Workers(1, nothing) as processes:
        with pytest.raises(ZeroDivisionError) as error:
            processes.submit(divided, 0).result(timeout=LONG)
        assert "in divided" in error.value.__notes__[0]
        with pytest.raises(Exception, match="pickle"):
            processes.submit(not_to_be_sent).result(timeout=LONG)
        with pytest.raises(Exception, match="pickle"):
            processes.submit(divided, lambda: 1).result(timeout=LONG)  # pyright: ignore[reportArgumentType]
        assert processes.submit(doubled, 4).result(timeout=LONG) == 8


def test_what_has_not_begun_is_cancelled_when_they_are_left() -> None:
    with Workers(1, nothing) as processes:
        begun = [processes.submit(slept, 0.2, b"") for _ in range(20)]
        begun[0].result(timeout=LONG)
    assert begun[-1].cancelled()
    assert all(future.done() for future in begun)


def test_one_that_cannot_begin_has_died() -> None:
    with Workers(2, killed, b"") as processes:
        assert outcomes([processes.submit(returned, b"") for _ in range(3)]) == [None] * 3


def test_a_thread_that_a_task_leaves_running_keeps_nobody_waiting(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("corollary.parallel.GRACE_S", 0.2)
    with Workers(2, nothing) as processes:
        assert processes.submit(left_running).result(timeout=LONG) == 1
        assert processes.submit(doubled, 4).result(timeout=LONG) == 8
