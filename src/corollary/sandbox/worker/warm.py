"""The warm parent: it forks one child per notebook, waits for its end, and never reads any of them."""

import contextlib
import gc
import json
import os
import signal
import socket
import sys
import tempfile

from . import executor, libc, lifecycle, namespaces, prefault, ready
from . import outputs as shown
from . import shell as shells

# What a notebook does most: done often enough in the parent that the interpreter has adapted to it before the fork.
_REHEARSAL = (
    """import numpy as np, matplotlib.pyplot as plt
t = np.linspace(0, 1, 50)
a = float(np.trapezoid(t ** 2, t)); b = [a, 2.0 * a]; c = np.array([1.0, a]); d = "8.6 kg m/s"
print(f"{a:.3g}", b)
c @ np.ones(2)""",
    """def f(x, u, h):
    return x + u * h, u - 9.81 * h
for i in range(50): f(1.0, 2.0, 0.1)
assert abs(a) < 10""",
    """plt.plot([0, 1], [0.5, 2], label="x"); plt.plot(t, np.sin(t), "--", label="y"); plt.legend(); plt.grid(True)
plt.xlabel("$x$"); plt.ylabel("F / N"); plt.title("title")
plt.show()""",
    "fig, ax = plt.subplots(); ax.plot(t, t); ax.set_xlabel('t')",
)
_TIMES = 10
_ONCE = ("plt.plot(t, t, label='$x$'); plt.legend(); plt.savefig(__import__('io').BytesIO())", "1/0")


def serve(control, opening):
    """Gets ready, says so, and forks a child for each results channel that comes in; ends when the other side does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the coordinator's to answer
    parent = ready.Parent(opening)
    if libc.on_linux():
        ready.choose_root(parent, opening)
        libc.prctl(libc.PR_SET_CHILD_SUBREAPER, 1)
    else:
        parent.missing = dict.fromkeys(("namespaces", "Landlock", "seccomp"), "only Linux has it")
    for name in ("HOME", "TMPDIR", "MPLCONFIGDIR", "IPYTHONDIR"):
        os.environ[name] = parent.folder
    outputs = shown.Outputs(parent.limits["output_bytes"])
    shell = _warm_shell(outputs, opening["preload"])
    tempfile.tempdir = None
    modules: dict = sys.modules
    modules[opening["absent"]] = None  # so that importing it says plainly that it is not here
    if libc.on_linux():
        ready.prepare_walls(parent, opening)
    gc.collect()
    gc.freeze()
    if parent.machine is not None:
        with contextlib.suppress(OSError):  # then every child only takes a little longer
            _settle(parent, shell, outputs)
        os.close(parent.machine)
    if libc.on_linux():
        libc.prctl(libc.PR_SET_DUMPABLE, 0)
    _reply(
        control,
        {
            "missing": parent.missing,
            "namespaces": parent.namespaces,
            "user": parent.user,
            "threads": ready.reading(parent, "Threads"),
            "kilobytes": ready.reading(parent, "VmRSS"),
        },
    )
    while True:
        results = _next(control)
        child = namespaces.fork_alone() if parent.namespaces else os.fork()
        if child == 0:
            control.close()
            lifecycle.live(parent, shell, outputs, results)
        os.close(results)
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        _end_what_is_left()
        _reply(control, {"code": 128 - code if code < 0 else code})


def _warm_shell(outputs, preload):
    shell = shells.new_shell(outputs)
    ready.import_slow(preload)
    out, err = shells.streams(outputs)
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        for _ in range(_TIMES):
            executor.rehearse(shell, outputs, _REHEARSAL)
        executor.rehearse(shell, outputs, _ONCE)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the clock of the cells has set it
    shells.forget(shell)
    outputs.start()
    return shell


def _settle(parent, shell, outputs):
    """Large pages; and a throw-away child tells which of them every notebook writes to."""
    maps = os.open("self/maps", os.O_RDONLY, dir_fd=parent.machine)
    prefault.join(maps)

    def rehearse():
        out, err = shells.streams(outputs)
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            executor.rehearse(shell, outputs, _REHEARSAL[:3])
        return json.dumps(prefault.written(maps, parent.machine))

    parent.written = json.loads(ready.told(rehearse) or "[]")
    os.close(maps)


def _next(control):
    _, descriptors, _, _ = socket.recv_fds(control, 1, 1)
    if not descriptors:
        os._exit(0)
    return descriptors[0]


def _reply(control, said):
    text = json.dumps(said).encode()
    control.sendall(len(text).to_bytes(8, "big") + text)


def _end_what_is_left():
    """Ends processes a notebook left behind; they are children of this one now, which has no others."""
    while True:
        try:
            with open(f"/proc/self/task/{os.getpid()}/children") as file:
                left = [int(number) for number in file.read().split()]
        except OSError:  # no /proc: then the namespace has ended them, or seccomp has let none begin
            left = []
        for process in left:
            os.kill(process, signal.SIGKILL)
        try:
            if os.waitpid(-1, 0 if left else os.WNOHANG)[0] == 0:
                return
        except ChildProcessError:
            return
