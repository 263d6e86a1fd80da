"""The warm parent seen from outside: started clean, asked for one child per notebook, ended with whoever started it."""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

from corollary.sandbox.job import Limits

WORKER = Path(__file__).parent / "worker"
# In the order in which they import one another.
_MODULES = (
    "libc",
    "namespaces",
    "landlock",
    "seccomp",
    "privileges",
    "frames",
    "outputs",
    "encode",
    "clock",
    "figures",
    "backend",
    "shell",
    "executor",
    "prefault",
    "ready",
    "lifecycle",
    "warm",
)
_PRELOAD = ("numpy", "matplotlib.pyplot", "sympy", "scipy.integrate", "scipy.optimize", "IPython.display")
_PACKAGE = Path(__file__).parents[1]
_READY_SECONDS = 120.0


class CannotStart(RuntimeError):
    """The process that runs notebooks did not get ready; the message says what it said."""


@dataclass(slots=True)
class Parent:
    """A running warm parent; `folder` is where notebooks write when they have no disk of their own."""

    process: subprocess.Popen[bytes]
    control: socket.socket
    base: Path
    folder: Path
    missing: dict[str, str]
    namespaces: bool
    user: int | None
    kilobytes: int
    coming: socket.socket | None = None  # the channel of a child that was asked for and gets itself ready
    owed: int = 0  # how many children's ends the parent has yet to tell, one word each


@dataclass(frozen=True, slots=True)
class Child:
    """One forked child: `channel` carries the job in and the frames out, `handle` is its pidfd (None where there is none)."""

    channel: socket.socket
    handle: int | None
    pid: int


def start(limits: Limits, without: frozenset[str] = frozenset()) -> Parent:
    """A fresh warm parent: an isolated interpreter with a clean environment, which gets its sources as text.

    `without` names walls to leave out ("namespaces", "Landlock", "seccomp"), to measure what each is worth. Raises CannotStart.
    """
    base = Path(tempfile.mkdtemp(prefix="corollary-"))
    base.chmod(0o711)  # a child that is no longer root must be able to pass
    for name in ("root", "notebook"):
        (base / name).mkdir()
    ours, theirs = socket.socketpair()
    command = [
        sys.executable,
        "-I",
        "-S",
        "-B",
        "-c",
        (WORKER / "boot.py").read_text(encoding="utf-8"),
        str(theirs.fileno()),
    ]
    said = base / "said"
    with said.open("wb") as errors, theirs:
        process = subprocess.Popen(
            command,
            pass_fds=[theirs.fileno()],
            env=_environment(),
            cwd="/",
            umask=0o022,
            stdin=subprocess.DEVNULL,
            stdout=errors,
            stderr=errors,
            start_new_session=True,
        )
    parent = Parent(process, ours, base, base / "notebook", {}, False, None, 0)
    try:
        _send(ours, _opening(limits, parent, without))
        ours.settimeout(_READY_SECONDS)
        ready = _receive(ours)
    except OSError as error:
        words = said.read_text(encoding="utf-8", errors="replace").strip().splitlines() or [str(error)]
        stop(parent)
        why = words[-1].split(": ", 1)[-1]  # without the exception's name
        raise CannotStart(f"The process that runs notebooks did not start: {why}") from None
    parent.missing, parent.namespaces = ready["missing"], ready["namespaces"]
    parent.user, parent.kilobytes = ready["user"], ready["kilobytes"]
    if ready["threads"] > 1:
        parent.missing["a parent with one thread"] = (
            f"a library started {ready['threads'] - 1} more: forks may hang"
        )
    return parent


def stop(parent: Parent) -> None:
    """Ends it and removes its folder; a child still running dies with it."""
    if parent.coming is not None:
        parent.coming.close()
    parent.control.close()
    parent.process.kill()
    parent.process.wait()
    shutil.rmtree(parent.base, ignore_errors=True)


def ask(parent: Parent) -> None:
    """Asks for a child, which builds its walls while the one who asked does something else. Raises OSError."""
    ours, theirs = socket.socketpair()
    with theirs:
        socket.send_fds(parent.control, [b"J"], [theirs.fileno()])
    parent.coming, parent.owed = ours, parent.owed + 1


def fork(parent: Parent, seconds: float = 20.0) -> Child:
    """A new child that waits for its job. Raises OSError when it does not come up (the parent is then beyond use)."""
    if not parent.namespaces:
        if parent.owed:
            reap(parent)  # they share a folder: the last one must be gone
        shutil.rmtree(parent.folder, ignore_errors=True)
        parent.folder.mkdir(mode=0o700)
        if parent.user is not None:
            os.chown(parent.folder, parent.user, parent.user)
    if parent.coming is None:
        ask(parent)
    ours, parent.coming = parent.coming, None
    assert ours is not None
    ours.settimeout(seconds)
    introduction, handles, _, _ = socket.recv_fds(ours, 9, 1)
    if len(introduction) != 9:
        ours.close()
        raise OSError("the child died at birth")
    ours.settimeout(None)
    _words(parent, 1)  # of those before it, lest they fill the channel
    return Child(ours, handles[0] if handles else None, int.from_bytes(introduction[1:], "big"))


def tell(child: Child, number: signal.Signals) -> None:
    """A signal to exactly this child; nothing when it is gone."""
    try:
        if child.handle is not None and sys.platform == "linux":
            signal.pidfd_send_signal(child.handle, number)
        else:
            os.kill(child.pid, number)
    except ProcessLookupError:
        return


def leave(child: Child) -> None:
    """Kills what may still run of it, and lets go of it; how it ended can be asked for later, or never."""
    tell(child, signal.SIGKILL)
    child.channel.close()
    if child.handle is not None:
        os.close(child.handle)


def reap(parent: Parent, seconds: float = 30.0) -> int:
    """How the last child ended: its exit status, or 128 and the signal's number. Raises OSError when the parent does not say."""
    parent.control.settimeout(seconds)
    return _words(parent, 0)


def _words(parent: Parent, left: int) -> int:
    code = 0
    while parent.owed > left:
        code = _receive(parent.control)["code"]
        parent.owed -= 1
    return code


def _environment() -> dict[str, str]:
    """Nothing of the instructor's; one thread for linear algebra, so that forking is sound and a core is one notebook's."""
    threads = dict.fromkeys(
        ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "NUMEXPR_NUM_THREADS"), "1"
    )
    return {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "TZ": os.environ.get("TZ", ""), **threads}


def _opening(limits: Limits, parent: Parent, without: frozenset[str]) -> dict[str, object]:
    libraries = [
        path for path in sys.path if path.endswith(("site-packages", "dist-packages")) and Path(path).is_dir()
    ]
    return {
        "modules": [(name, (WORKER / f"{name}.py").read_text(encoding="utf-8")) for name in _MODULES],
        "libraries": libraries,
        "preload": _PRELOAD,
        "without": sorted(without),
        "limits": asdict(limits),
        "base": str(parent.base / "root"),
        "folder": str(parent.folder),
        # An editable installation leaves the bank in a folder of the package's name beside the libraries.
        "hidden": [str(_PACKAGE), *(f"{path}/{_PACKAGE.name}" for path in libraries)],
        "absent": _PACKAGE.name,
        "unread": [_PACKAGE.name, f"_{_PACKAGE.name}", f"__editable__.{_PACKAGE.name}"],
    }


def _send(channel: socket.socket, said: dict[str, object]) -> None:
    text = json.dumps(said).encode()
    channel.sendall(len(text).to_bytes(8, "big") + text)


def _receive(channel: socket.socket) -> dict:
    return json.loads(_exactly(channel, int.from_bytes(_exactly(channel, 8), "big")))


def _exactly(channel: socket.socket, count: int) -> bytes:
    parts = []
    while count:
        part = channel.recv(min(count, 1 << 20))
        if not part:
            raise OSError("it ended")
        parts.append(part)
        count -= len(part)
    return b"".join(parts)
