"""Giving up descriptors, privileges, memory and time before a worker reads a line of the student's."""

import os
import resource
import signal

from . import libc

NOBODY = 65534  # the overflow user, who owns nothing (user_namespaces(7))
_MOST_DESCRIPTORS = 4096


def die_with_parent():
    if libc.on_linux():
        libc.prctl(libc.PR_SET_PDEATHSIG, signal.SIGKILL)


def hide_memory():
    """No process of the same user reads or traces this one: /proc/PID/mem, ptrace(2) and core dumps ask PR_GET_DUMPABLE."""
    libc.prctl(libc.PR_SET_DUMPABLE, 0)


def keep_descriptors(channel, inherited):
    """Standard input is empty; 1 and 2 go to a file in memory; `channel` becomes descriptor 3; all but `inherited` others close.

    What C code prints past Python's streams can be read back from descriptor 1.
    """
    printed = os.memfd_create("printed") if libc.on_linux() else os.open(os.devnull, os.O_RDWR)
    nothing = os.open(os.devnull, os.O_RDONLY)
    if channel != 3:
        os.dup2(channel, 3)
    os.dup2(nothing, 0)
    os.dup2(printed, 1)
    os.dup2(printed, 2)
    start = 4
    for descriptor in sorted(inherited):
        os.closerange(start, descriptor)
        start = descriptor + 1
    os.closerange(start, _MOST_DESCRIPTORS)


def set_limits(limits, baseline, processes):
    """Resource limits; memory is counted from `baseline`, the bytes of address space that the zygote takes itself."""
    bounds = [
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_FSIZE, limits["file_bytes"]),
        (resource.RLIMIT_NOFILE, 64),
        # The clock outside is the limit; this one ends a worker whose grader has died and left it running.
        (resource.RLIMIT_CPU, int(limits["total_seconds"]) + 5),
    ]
    if libc.on_linux() and baseline:  # macOS refuses RLIMIT_AS with EINVAL
        bounds.append((resource.RLIMIT_AS, baseline + limits["memory_bytes"]))
    if processes is not None:
        bounds.append((resource.RLIMIT_NPROC, processes))
    for which, most in bounds:
        hard = resource.getrlimit(which)[1]
        most = min(most, hard) if hard >= 0 else most
        resource.setrlimit(which, (most, most))
    # A file grown too large is then an OSError the student can read, not the end of the process.
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)


def drop_privileges(user):
    """No longer root (when `user` is given), no capability, none to be gained by exec, no look from outside into this memory."""
    if user is not None:
        os.setgroups([])
        os.setresgid(user, user, user)
        os.setresuid(user, user, user)
    if libc.on_linux():
        libc.drop_capabilities()
        libc.prctl(libc.PR_SET_NO_NEW_PRIVS, 1)
        hide_memory()  # again: a change of user resets it to fs.suid_dumpable (proc(5))
    os.umask(0o077)
