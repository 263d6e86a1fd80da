"""A call made in an interpreter of its own, which is stopped when it takes too long or too much memory."""

from __future__ import annotations

import atexit
import os
import pickle
import struct
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from importlib.util import find_spec
from typing import IO, TypeVar, final

T = TypeVar("T")

LENGTH = struct.Struct(">Q")
INTERPRETER_BYTES = 1 << 30
# The clock on the wall is for what waits without working; a loaded machine must not decide what is decided.
WAITING = 10
SECONDS_TO_START = 60.0
START = "import sys; sys.path[:] = {path!r}; from corollary.sandbox.limited import serve; serve({bytes})"


class NotFinished(RuntimeError):
    """The call was stopped, or its interpreter could not be started."""


@final
class Limited:
    """Calls, one after the other, in one interpreter that waits for the next; a new one when it was stopped."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None
        atexit.register(self.stop)
        if sys.platform != "win32":
            os.register_at_fork(after_in_child=self._forked)

    def call(self, function: Callable[[], T], seconds: float, waiting: float | None = None) -> T:
        """What the function returns. It and its result are pickled. Raises NotFinished, and what the function raises.

        `seconds` are those of the processor; `waiting` may pass, or ten times as many.
        """
        with self._lock:
            try:
                process = self._started()
                assert process.stdin is not None
                assert process.stdout is not None
                timer = threading.Timer(waiting or WAITING * seconds, process.kill)
                timer.start()
                try:
                    _write(process.stdin, pickle.dumps((seconds, function)))
                    answer = _read(process.stdout)
                finally:
                    timer.cancel()
            except (OSError, EOFError) as error:
                self.stop()
                raise NotFinished(str(error)) from None
            except BaseException:  # ctrl-C: the answer still to come is not that of the next call
                self.stop()
                raise
        result: T | BaseException = pickle.loads(answer)
        if isinstance(result, BaseException):
            raise result
        return result

    def _started(self) -> subprocess.Popen[bytes]:
        if self._process is None or self._process.poll() is not None:
            self.stop()
            self._process = subprocess.Popen(
                [
                    sys.executable,
                    "-I",
                    "-c",
                    START.format(path=[each for each in sys.path if each], bytes=INTERPRETER_BYTES),
                ],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,  # a library that has no memory left says so before it dies
                cwd="/" if os.name == "posix" else None,
            )
            timer = threading.Timer(SECONDS_TO_START, self._process.kill)
            timer.start()
            assert self._process.stdout is not None
            _read(self._process.stdout)
            timer.cancel()
        return self._process

    def _forked(self) -> None:
        """A fork has its parent's pipes, and a lock that nobody in it may release."""
        self._lock, self._process = threading.Lock(), None

    def stop(self) -> None:
        """Ends the interpreter that waits."""
        process, self._process = self._process, None
        if process is None:
            return
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                with suppress(OSError):  # what was not sent is of no use any more
                    pipe.close()


LIMITED = Limited()


def limited(function: Callable[..., T], *arguments: object, seconds: float) -> T:
    """What the function returns, with these limits. Raises NotFinished, and what the function raises."""
    return LIMITED.call(partial(function, *arguments), seconds)


def serve(most_bytes: int) -> None:
    """Answers calls until the other end is closed."""
    confine(most_bytes)
    calls, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    sys.stdout = sys.stderr
    _write(answers, b"")
    while True:
        try:
            seconds, function = pickle.loads(_read(calls))
        except EOFError:
            return
        stop_after(seconds)
        try:
            result: object = function()
        except MemoryError:
            result = NotFinished("too little memory")
        except Exception as error:
            result = error
        stop_after(0)
        _write(answers, pickle.dumps(result))


def confine(most_bytes: int) -> None:
    """Bounds the memory, where the system can; beyond it the process dies."""
    if find_spec("resource"):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (most_bytes, most_bytes))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def stop_after(seconds: float) -> None:
    """The system ends this process after so much time of the processor, even inside a library; 0: never."""
    if sys.platform != "win32":
        import signal

        signal.signal(signal.SIGPROF, signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_PROF, seconds)


def _write(pipe: IO[bytes], data: bytes) -> None:
    pipe.write(LENGTH.pack(len(data)) + data)
    pipe.flush()


def _read(pipe: IO[bytes]) -> bytes:
    """Raises EOFError, which is no OSError, where the other end is gone."""
    head = pipe.read(LENGTH.size)
    if len(head) < LENGTH.size:
        raise EOFError("the process has ended")
    return pipe.read(LENGTH.unpack(head)[0])
