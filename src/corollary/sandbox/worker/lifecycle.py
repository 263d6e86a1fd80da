"""The life of one child: born of the warm parent, confined, given its job, and gone."""

import errno
import os
import random
import resource
import socket
import sys

from . import executor, frames, libc, namespaces, prefault, privileges, ready


def live(parent, shell, outputs, results):
    """Never returns. `results` is the channel to the coordinator."""
    try:
        privileges.die_with_parent()
        baseline = ready.reading(parent, "VmSize") * 1024
        if parent.namespaces:
            owner = os.geteuid() if parent.user is None else parent.user
            namespaces.enter_own_namespaces(
                parent.limits["file_bytes"], owner, owner if parent.user is not None else os.getegid()
            )
        _confine(parent, results, baseline)
        prefault.copy(parent.written)
        frames.introduce()
        job = frames.listen()
        _close_the_door(parent)
        if job["trial"]:
            frames.say({"t": "trial", "held": what_holds()})
        else:
            executor.work(shell, outputs, job)
        os._exit(0)
    except BaseException as error:
        frames.say({"t": "broken", "why": f"{type(error).__name__}: {error}"[:500]})
        os._exit(70)


def _confine(parent, results, baseline):
    os.setsid()
    kept = [parent.ruleset.fileno()] if parent.ruleset else []
    privileges.keep_descriptors(results, kept)
    # Without seccomp nothing stops a fork but the count of processes, which counts all that a user has anywhere.
    processes = None if parent.filter else 1024 if parent.user is None else 64
    privileges.set_bounds(parent.limits, baseline, processes)
    os.chdir(parent.folder)
    privileges.give_up_powers(parent.user)
    privileges.die_with_parent()
    random.seed()
    if "numpy" in sys.modules:
        sys.modules["numpy"].random.seed()


def _close_the_door(parent):
    if parent.ruleset:
        parent.ruleset.restrict()
        parent.ruleset.close()
    if parent.filter:
        libc.load_filter(parent.filter)


def what_holds():
    """Tries what a notebook must not be able to do; a wall holds when that was refused in the wall's own way."""
    return {
        "namespaces": os.getpid() == 1,
        "Landlock": _refusal(lambda: os.listdir("/")) == errno.EACCES,
        "seccomp": _refusal(socket.socket) == errno.EPERM and _refusal(_fork) == errno.EPERM,
        "rlimits": resource.getrlimit(resource.RLIMIT_FSIZE)[0] != resource.RLIM_INFINITY,
        "user": os.geteuid() != 0,
    }


def _fork():
    if os.fork() == 0:
        os._exit(0)


def _refusal(deed):
    try:
        deed()
    except OSError as error:
        return error.errno
    return None
