"""Processes beside this one: how many this program may use, how they work, that none outlives it; and a Dask cluster."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import gc
import os
import signal
import sys
import traceback
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from multiprocessing import get_context, parent_process
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from queue import Empty, SimpleQueue
from threading import Lock, Thread
from typing import TYPE_CHECKING, Any, Self, TypeVar, TypeVarTuple

from corollary.extras import installing

if TYPE_CHECKING:
    from distributed import Client

Given = TypeVarTuple("Given")
Result = TypeVar("Result")
Task = tuple["Future[Any]", Callable[..., Any], tuple[Any, ...]]

GRACE_S = 5.0  # seconds in which a process that has nothing more to do ends by itself


class ProcessDied(RuntimeError):
    """The process that was at a task ended before it gave the result: killed, or out of memory."""


def cores() -> int:
    """How many this program may use."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


class Workers:
    """So many processes, each with one task at a time; when left, tasks not begun are cancelled and the others awaited.

    Each has a pipe and a thread of its own: one that is killed, at whatever moment, costs the task it was at, and the others go
    on. The processes of concurrent.futures share two queues, and one killed halfway through a message makes the rest wait for
    ever (python/cpython#94777; half a result in the later versions, too).
    """

    def __init__(self, count: int, initializer: Callable[[*Given], None], *given: *Given) -> None:
        self._tasks: SimpleQueue[Task | None] = SimpleQueue()
        self._alive, self._lock = count, Lock()
        # All of them before the first thread: a fork takes along what other threads hold locked.
        started = [_started(initializer, given) for _ in range(count)]
        self._threads = [Thread(target=self._serve, args=each, daemon=True) for each in started]
        for each in self._threads:
            each.start()

    def submit(self, work: Callable[[*Given], Result], *given: *Given) -> Future[Result]:
        """Have it done by the next process that is free. The future raises what the work raises, or ProcessDied."""
        future: Future[Result] = Future()
        with self._lock:
            if self._alive:
                self._tasks.put((future, work, given))
            else:
                future.set_exception(ProcessDied())
        return future

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *about: object) -> None:
        for future, _, _ in self._not_begun():
            future.cancel()
        for _ in self._threads:
            self._tasks.put(None)
        for each in self._threads:
            each.join()

    def _serve(self, process: BaseProcess, pipe: Connection) -> None:
        while task := self._tasks.get():
            future, work, given = task
            if future.set_running_or_notify_cancel() and not _done_by(pipe, future, work, given):
                process.kill()
                self._one_less()
                future.set_exception(ProcessDied())
                break
        with suppress(OSError):  # it is gone already
            pipe.send(None)
        process.join(GRACE_S)  # it would wait for threads that a task has begun and not ended
        process.kill()
        process.join()
        pipe.close()

    def _one_less(self) -> None:
        with self._lock:
            self._alive -= 1
            left = [] if self._alive else self._not_begun()
        for future, _, _ in left:
            if future.set_running_or_notify_cancel():
                future.set_exception(ProcessDied())

    def _not_begun(self) -> list[Task]:
        found: list[Task] = []
        while True:
            try:
                task = self._tasks.get_nowait()
            except Empty:
                return found
            found += [task] if task else []


def _done_by(pipe: Connection, future: Future[Any], work: Callable[..., Any], given: tuple[Any, ...]) -> bool:
    """True when the process at the other end has answered; False when it is gone."""
    try:
        pipe.send((work, given))
        good, found = pipe.recv()
    except (EOFError, OSError):
        return False
    except Exception as error:  # what cannot be pickled is the task's own fault
        future.set_exception(error)
        return True
    if good:
        future.set_result(found)
    else:
        future.set_exception(found)
    return True


def _started(initializer: Callable[..., None], given: tuple[Any, ...]) -> tuple[BaseProcess, Connection]:
    # A fork has what was loaded and derived already; elsewhere the system's own libraries do not survive one.
    context = get_context("fork") if sys.platform == "linux" else get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_work, args=(theirs, initializer, given))
    process.start()
    theirs.close()  # so that its end is seen here
    return process, ours


def _work(pipe: Connection, initializer: Callable[..., None], given: tuple[Any, ...]) -> None:
    """In a process: task after task, until None comes."""
    begin()
    initializer(*given)
    while task := pipe.recv():
        work, arguments = task
        try:
            answer = True, work(*arguments)
        except BaseException as error:
            error.add_note(traceback.format_exc())
            answer = False, error
        try:
            pipe.send(answer)
        except Exception as error:  # what cannot be pickled
            pipe.send((False, error))


def begin() -> None:
    """In a new process: Ctrl-C ends it at once, and it does not outlive the one that made it, however that one ends."""
    gc.freeze()  # what was there before stays: looking through it again and again would be a tenth to a fifth of the time
    gc.set_threshold(100_000, 50, 100)
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)


SECONDS_TO_CONNECT = 15


class NoCluster(Exception):
    """The cluster cannot be used; one sentence says why and what to do."""


def connect(address: str) -> Client:
    """A client of the scheduler at this address, which the caller closes; raises NoCluster where there is none, or no worker."""
    try:
        from distributed import Client
    except ImportError:
        raise NoCluster(f"a cluster needs Dask; install it with: {installing('dask')}") from None
    try:
        client = Client(address, timeout=SECONDS_TO_CONNECT)
    except (OSError, ValueError) as error:
        raise NoCluster(
            f"no Dask scheduler answers at {address} ({error}); start one, or leave out --executor"
        ) from None
    if not worker_count(client):
        client.close()
        raise NoCluster(
            f"the Dask cluster at {address} has no workers; start some with: dask worker {address} --nthreads 1"
        )
    return client


def worker_count(client: Client) -> int:
    """Of processes."""
    info: Any = client.scheduler_info(n_workers=-1)
    return len(info["workers"])
