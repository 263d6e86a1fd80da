"""The zygote's loop: a process with everything imported, which forks one worker for each notebook and never reads any of them."""

import contextlib
import gc
import os
import signal
import socket
import tempfile

from . import huge_pages, layers, libc, namespaces, privileges, protocol, worker

# What most notebooks do, run once before the first fork: fonts, lazy imports and caches are then there for every worker.
# (Running it ten times, for the interpreter to specialise its bytecode, and copying the pages that workers write to before
# the job arrives, gained less than 10 % of a notebook's time in benchmarks/grading.py, and was left out.)
_WARM_UP = (
    """import numpy as np, matplotlib.pyplot as plt
t = np.linspace(0, 1, 50)
a = float(np.trapezoid(t ** 2, t)); b = [a, 2.0 * a]; c = np.array([1.0, a]); d = "8.6 kg m/s"
print(f"{a:.3g}", b)
c @ np.ones(2)""",
    """plt.plot([0, 1], [0.5, 2], label="$x$"); plt.plot(t, np.sin(t), "--", label="y"); plt.legend(); plt.grid(True)
plt.xlabel("$x$"); plt.ylabel("F / N"); plt.title("title")
plt.savefig(__import__('io').BytesIO())
plt.show()""",
    "fig, ax = plt.subplots(); ax.plot(t, t); ax.set_xlabel('t')",
    "1/0",
)


def serve(config):
    """Builds the isolation, says that it is ready, and forks a worker for each channel that arrives; ends with its parent."""
    control = socket.socket(fileno=config["control"])
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the process that grades
    isolation = layers.Layers(config)
    if libc.on_linux():
        layers.enter_root(isolation, config)
        libc.prctl(libc.PR_SET_CHILD_SUBREAPER, 1)
    else:
        isolation.missing = dict.fromkeys(("namespaces", "Landlock", "seccomp"), "only Linux has it")
    for name in ("HOME", "TMPDIR", "MPLCONFIGDIR", "IPYTHONDIR"):
        os.environ[name] = isolation.folder
    shell = outputs = None
    if not config["probe_only"]:
        shell, outputs = _warm_shell(isolation, config["preload"])
    tempfile.tempdir = None
    if libc.on_linux():
        layers.prepare(isolation, config)
        privileges.hide_memory()
    gc.collect()
    gc.freeze()  # the collector then writes to no object of before the fork, so their pages stay shared
    if isolation.maps is not None:
        huge_pages.use_huge_pages(isolation.maps)
        os.close(isolation.maps)
    isolation.address_space = isolation.status("VmSize") * 1024
    ready = {
        "t": "ready",
        "missing": isolation.missing,
        "namespaces": isolation.namespaces,
        "user": isolation.user,
        "threads": isolation.status("Threads"),
        "kilobytes": isolation.status("VmRSS"),
    }
    protocol.send(ready, descriptor=control.fileno())
    while True:
        _, descriptors, _, _ = socket.recv_fds(control, 1, 1)
        if not descriptors:
            os._exit(0)
        child = namespaces.fork_alone() if isolation.namespaces else os.fork()
        if child == 0:
            control.close()
            worker.run(isolation, shell, outputs, descriptors[0])
        os.close(descriptors[0])
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        _kill_orphans()
        exited = {"t": "exited", "code": 128 - code if code < 0 else code}
        protocol.send(exited, descriptor=control.fileno())


def _warm_shell(isolation, preload):
    from . import executor, outputs  # with what they import, most of the time a zygote takes to start
    from . import shell as shells

    collected = outputs.Outputs(isolation.limits["output_bytes"])
    shell = shells.new_shell(collected)
    layers.import_each(preload)
    out, err = shells.streams(collected)
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        executor.warm_up(shell, collected, _WARM_UP)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the clock of the cells has set it
    shells.reset(shell)
    collected.start()
    return shell, collected


def _kill_orphans():
    """Kills what a notebook left running: as its subreaper (prctl(2)) this process is the parent of all that was orphaned."""
    while True:
        try:
            with open(f"/proc/self/task/{os.getpid()}/children") as file:
                orphans = [int(number) for number in file.read().split()]
        except OSError:  # no /proc: then the PID namespace has ended them, or seccomp has let none begin
            orphans = []
        for process in orphans:
            os.kill(process, signal.SIGKILL)
        try:
            if os.waitpid(-1, 0 if orphans else os.WNOHANG)[0] == 0:
                return
        except ChildProcessError:
            return
