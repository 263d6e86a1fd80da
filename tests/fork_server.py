"""The script from which `forked.py` has commands forked: everything imported, and one zygote that they run notebooks with in turn."""

from __future__ import annotations

import atexit
import gc
import importlib
import json
import os
import pkgutil
import sys
import tempfile
import traceback
from typing import Any

HERE = sys.path.pop(0)
NOT_NEEDED: dict[str, Any] = {"rfc3987_syntax": None}  # as the command has it
LIBRARIES = (
    "latex2mathml.converter", "markdown_it", "matplotlib.figure", "msgspec", "nbformat", "nbgrader.api", "nbgrader.apps", "numpy",
    "rich.console", "rich.table", "scipy.optimize", "sympy", "yaml",
)  # fmt: skip
ROOMS = ("corollary.cli", "corollary.nbgrader")
PR_SET_DUMPABLE = 4


def main() -> None:
    sys.modules.update(NOT_NEEDED)
    for name in (*LIBRARIES, *ROOMS):
        importlib.import_module(name)
    for room in ROOMS:
        for each in pkgutil.iter_modules(sys.modules[room].__path__):
            importlib.import_module(f"{room}.{each.name}")
    sys.path.append(HERE)
    lender = importlib.import_module("lender").Lender()
    sys.modules["corollary.sandbox.runner"].Zygote = lender
    sys.path.remove(HERE)  # whose folders have names of libraries
    atexit._clear()
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)
    for line in sys.stdin:
        job = json.loads(line)
        if {"grade", "autograde"} & {*job["argv"][1:2]} and job["account"] is None:
            lender.start_if_possible()
        child = os.fork()
        if not child:
            _do(job, lender)
        print(child, flush=True)
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        if status < 0:
            lender.end()
        print(status, flush=True)
    lender.end()


def _do(job: dict[str, Any], lender: Any) -> None:
    new = os.O_WRONLY | os.O_CREAT
    for number, name, flags in ((0, "in", 0), (1, "out", new), (2, "err", new)):
        os.dup2(os.open(job[name], flags), number)
    sys.stdin = os.fdopen(0)
    os.chdir(job["cwd"])
    if job["umask"] >= 0:
        os.umask(job["umask"])
    os.environ.clear()
    os.environ.update(job["env"])
    tempfile.tempdir = None
    lender.in_fork()
    if job["account"] is not None:
        lender.lendable = False
        _become(job["account"])
    sys.argv = job["argv"]
    try:
        importlib.import_module(job["module"]).main()
        status = 0
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:
        traceback.print_exc()
        status = 70
    atexit._run_exitfuncs()
    lender.settle()
    sys.stdout.flush()
    os._exit(status)


def _become(account: int) -> None:
    sys.path.append(os.path.join(HERE, "adversary"))
    libc = importlib.import_module("kernel").libc
    importlib.import_module("ordinary_user").become_ordinary(account)
    sys.path.pop()
    libc.prctl(PR_SET_DUMPABLE, 1, 0, 0, 0)  # as a program that is started: /proc/self is its own


if __name__ == "__main__":
    main()
