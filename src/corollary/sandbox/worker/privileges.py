"""What every child gives up before it reads a line of the student's: files, powers, memory, time."""

import os
import resource
import signal

from . import libc

NOBODY = 65534
RESULTS = 3  # the one descriptor beside the standard three that stays open


def die_with_parent():
    if libc.on_linux():
        libc.prctl(libc.PR_SET_PDEATHSIG, signal.SIGKILL)


def keep_descriptors(results, kept):
    """Standard input is empty; 1 and 2 go to files in memory; `results` becomes descriptor 3; all but `kept` others close.

    Gives the file in memory, so that what C code printed can be read back.
    """
    printed = os.memfd_create("printed") if libc.on_linux() else os.open(os.devnull, os.O_RDWR)
    nothing = os.open(os.devnull, os.O_RDONLY)
    if results != RESULTS:
        os.dup2(results, RESULTS)
    os.dup2(nothing, 0)
    os.dup2(printed, 1)
    os.dup2(printed, 2)
    start = RESULTS + 1
    for descriptor in sorted(kept):
        os.closerange(start, descriptor)
        start = descriptor + 1
    os.closerange(start, 4096)


def set_bounds(limits, baseline, may_fork):
    """Resource limits; memory is counted from `baseline`, the bytes of address space the warm parent takes itself."""
    seconds = int(limits["total_seconds"]) + 5
    bounds = [
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_FSIZE, limits["file_bytes"]),
        (resource.RLIMIT_NOFILE, 64),
        (resource.RLIMIT_CPU, seconds),
    ]
    if libc.on_linux() and baseline:
        bounds.append((resource.RLIMIT_AS, baseline + limits["memory_bytes"]))
    if may_fork is not None:
        bounds.append((resource.RLIMIT_NPROC, may_fork))
    for which, most in bounds:
        most = min(most, resource.getrlimit(which)[1]) if resource.getrlimit(which)[1] >= 0 else most
        resource.setrlimit(which, (most, most))
    # A file grown too large is then an OSError the student can read, not the end of the process.
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)


def give_up_powers(user):
    """No longer root (when `user` is given), no capability, none to be gained, no look from outside into this memory."""
    if user is not None:
        os.setgroups([])
        os.setresgid(user, user, user)
        os.setresuid(user, user, user)
    if libc.on_linux():
        libc.drop_capabilities()
        libc.prctl(libc.PR_SET_NO_NEW_PRIVS, 1)
        libc.prctl(libc.PR_SET_DUMPABLE, 0)
    os.umask(0o077)
