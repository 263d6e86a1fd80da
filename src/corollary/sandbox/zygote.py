"""The zygote seen from outside: a warm interpreter, started clean, which forks one worker for each notebook."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import final

from corollary.sandbox.folders import Canary, new_base
from corollary.sandbox.job import Limits
from corollary.sandbox.protocol import Exited, Frames, Garbled, Ready, zygote_frames

_WORKER = Path(__file__).parent / "worker"
# In the order in which they import one another.
_MODULES = (
    "libc",
    "huge_pages",
    "namespaces",
    "landlock",
    "seccomp",
    "privileges",
    "protocol",
    "outputs",
    "encode",
    "figures",
    "shell",
    "executor",
    "layers",
    "probe",
    "worker",
    "zygote",
)
_FOR_CELLS = {"outputs", "encode", "figures", "shell", "executor"}  # no probe needs them
_PRELOAD = ("numpy", "matplotlib.pyplot", "sympy", "scipy.integrate", "scipy.optimize", "IPython.display")
_PACKAGE = Path(__file__).parents[1]
_NEED_PROC = (
    "psutil",
)  # it fails where /proc is not mounted; dask, and with it pint, does without it where it is absent
_SECONDS_TO_START = 120.0  # a cold disk and a loaded machine; 2 to 6 s are usual
_SECONDS_TO_FORK = 60.0
_SECONDS_TO_EXIT = 30.0


class CannotStart(RuntimeError):
    """The process that runs notebooks cannot be started; one sentence says why."""


@dataclass(frozen=True, slots=True)
class Worker:
    """One forked worker: `channel` carries the job in and the frames out, `pidfd` is None where the system has none."""

    channel: socket.socket
    pidfd: int | None
    pid: int

    def signal(self, number: signal.Signals) -> None:
        """A signal to exactly this worker; nothing when it is gone."""
        try:
            if self.pidfd is not None and sys.platform == "linux":
                signal.pidfd_send_signal(self.pidfd, number)
            else:
                os.kill(self.pid, number)
        except ProcessLookupError:
            return

    def release(self) -> None:
        """Kills what may still run of it; how it ended can be asked of the zygote later, or never."""
        self.signal(signal.SIGKILL)
        self.channel.close()
        if self.pidfd is not None:
            os.close(self.pidfd)


@final
class Zygote:
    """A running zygote: an isolated interpreter with a clean environment, which gets its sources as text.

    `without` names layers to leave out ("namespaces", "Landlock", "seccomp"), or libraries that are then not found there,
    to measure what each is worth. `folder` is where notebooks write when they have no disk of their own. With `probe_only` it can probe and run nothing, and starts in a
    tenth of the time. Raises CannotStart.
    """

    def __init__(
        self,
        limits: Limits,
        without: frozenset[str] = frozenset(),
        probe_only: bool = False,
        packages: tuple[str, ...] = (),
    ) -> None:
        self._limits = limits
        self._packages = packages
        self._probe_only = probe_only
        try:
            self._base = new_base()
        except OSError as error:
            raise CannotStart(
                f"The process that runs notebooks has no temporary folder to start in ({error}); make room, or set TMPDIR."
            ) from None
        self._next: socket.socket | None = None  # the channel of a worker that was asked for ahead of its job
        self.unreaped = 0  # workers whose exit status has not been read yet
        self._process: subprocess.Popen[bytes] | None = None
        try:
            self._control, control = socket.socketpair()
            config = self._config(control.fileno(), without)
            with control, self._base.log.open("wb") as log:
                self._process = subprocess.Popen(
                    [sys.executable, "-I", "-S", "-B", "-c", (_WORKER / "boot.py").read_text("utf-8")],
                    pass_fds=[control.fileno()],
                    env=_environment(),
                    cwd="/",
                    umask=0o022,
                    stdin=subprocess.PIPE,
                    stdout=log,
                    stderr=log,
                    start_new_session=True,
                )
            self._frames = Frames(self._control, zygote_frames, float("inf"))
            self.ready = self._start(config)
        except OSError as error:
            lines = self._base.last_words() or [str(error)]
            self.stop()
            why = lines[-1].split(": ", 1)[-1]  # without the exception's name
            raise CannotStart(f"The process that runs notebooks did not start: {why}") from None
        self.missing = dict(self.ready.missing)
        if (
            self.ready.threads > 1
        ):  # a lock that another thread holds at the fork is never released in the worker
            self.missing["a zygote with one thread"] = (
                f"a library started {self.ready.threads - 1} more: forks may hang"
            )

    @property
    def running(self) -> bool:
        return self._process is not None and self._process.poll() is None

    @property
    def pid(self) -> int:
        return self._process.pid if self._process is not None else 0

    @property
    def worker_waits(self) -> bool:
        """Whether a worker was asked for ahead of its job."""
        return self._next is not None

    @property
    def folder(self) -> Path:
        return self._base.folder

    def canary(self) -> Canary:
        """What a worker tries to reach; raises OSError."""
        return self._base.canary(self.ready.user)

    def stop(self) -> None:
        """Ends it and removes its folder; a worker still running dies with it."""
        if self._next is not None:
            self._next.close()
        if self._process is not None:
            self._control.close()
            self._process.kill()
            self._process.wait()
        self._base.remove()

    def ask(self) -> None:
        """Asks for a worker, which confines itself while the caller does something else. Raises OSError."""
        channel, theirs = socket.socketpair()
        with theirs:
            socket.send_fds(self._control, [b"F"], [theirs.fileno()])
        self._next, self.unreaped = channel, self.unreaped + 1

    def fork(self) -> Worker:
        """A worker that waits for its job. Raises OSError when it does not come up (the zygote is then of no more use)."""
        if not self.ready.namespaces:
            self.reap()  # all workers write in one folder: the last one must be gone
            self._base.empty_folder(self.ready.user, self._limits.file_bytes)
        if self._next is None:
            self.ask()
        channel, self._next = self._next, None
        assert channel is not None
        channel.settimeout(_SECONDS_TO_FORK)
        introduction, pidfds, _, _ = socket.recv_fds(channel, 8, 1)
        if len(introduction) != 8:
            channel.close()
            raise OSError("a new process died before it had its job")
        channel.settimeout(None)
        self._read_exits(1)  # of those before it, so that unread ones do not fill the channel
        return Worker(channel, pidfds[0] if pidfds else None, int.from_bytes(introduction, "big"))

    def reap(self) -> int:
        """How the last worker ended: its exit status, or 128 and the signal's number. Raises OSError on no answer."""
        return self._read_exits(0)

    def _read_exits(self, left: int) -> int:
        code = 0
        until = time.monotonic() + _SECONDS_TO_EXIT
        while self.unreaped > left:
            frame = self._read(until)
            if not isinstance(frame, Exited):
                raise OSError("it answered out of turn")
            code, self.unreaped = frame.code, self.unreaped - 1
        return code

    def _read(self, until: float) -> Ready | Exited:
        try:
            frame = self._frames.read(until)
        except Garbled:
            raise OSError("its answer cannot be read") from None
        if isinstance(frame, str):
            raise OSError("it ended" if frame == "end" else "it does not answer")
        return frame

    def _start(self, config: dict[str, object]) -> Ready:
        assert self._process is not None
        assert self._process.stdin is not None
        with self._process.stdin as channel:
            channel.write(json.dumps(config).encode())
        frame = self._read(time.monotonic() + _SECONDS_TO_START)
        if not isinstance(frame, Ready):
            raise OSError("it answered out of turn")
        return frame

    def _config(self, control: int, without: frozenset[str]) -> dict[str, object]:
        libraries = [
            path
            for path in sys.path
            if path.endswith(("site-packages", "dist-packages")) and Path(path).is_dir()
        ]
        modules = [name for name in _MODULES if not (self._probe_only and name in _FOR_CELLS)]
        return {
            "control": control,
            "modules": [(name, (_WORKER / f"{name}.py").read_text(encoding="utf-8")) for name in modules],
            "probe_only": self._probe_only,
            "libraries": libraries,
            "preload": (*_PRELOAD, *self._packages),
            "without": sorted(without),
            "limits": asdict(self._limits),
            "base": str(self._base.root),
            "folder": str(self._base.folder),
            "hidden": _installation(libraries),
            "absent": sorted({_PACKAGE.name, *_NEED_PROC} | without),
        }


def _installation(libraries: list[str]) -> list[str]:
    """What of the libraries' folders tells of this package: its code and bank, its metadata, and files that name its path."""
    hidden = {str(_PACKAGE)}
    for library in libraries:
        # An editable installation leaves a .pth file and a finder that name the source folder; so does direct_url.json.
        for entry in os.scandir(library):
            if _PACKAGE.name in entry.name.lower() or entry.name.endswith((".pth", ".egg-link")):
                hidden.add(entry.path)
    return sorted(hidden)


def _environment() -> dict[str, str]:
    """Nothing of the instructor's; one thread for linear algebra, so that forking is sound and a core is one notebook's."""
    threads = dict.fromkeys(
        ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "NUMEXPR_NUM_THREADS"), "1"
    )
    return {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "TZ": os.environ.get("TZ", ""), **threads}
