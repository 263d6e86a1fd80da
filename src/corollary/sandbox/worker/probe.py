"""Probes of a confined worker: each forbidden thing is tried in one, and is harmless where it succeeds."""

import errno
import os
import resource
import socket
from functools import partial


def probe(canary, isolation):
    """Which layers are in force, and which of reads, writes, signals, network, processes and disk they hold in.

    `canary` names a file and two sockets (one by path, one abstract) that belong to the user of this very process and are
    open to everybody, so that what refuses them is a layer and not the file system's permissions.
    """
    return {
        "namespaces": os.getpid() == 1,
        "Landlock": isolation.ruleset is not None and _error(lambda: os.listdir("/")) == errno.EACCES,
        "seccomp": _error(socket.socket) == errno.EPERM and _error(_fork) == errno.EPERM,
        "rlimits": resource.getrlimit(resource.RLIMIT_FSIZE)[0] != resource.RLIM_INFINITY,
        "reads": _refused(lambda: _open(canary["file"], os.O_RDONLY)),
        "writes": _writes_held(canary),
        "signals": _signals_held(isolation),
        "network": _network_held(canary),
        "processes": _refused(_fork),
        "disk": isolation.namespaces,
    }


def _writes_held(canary):
    path = canary["file"]
    beside = f"{path}.new"
    return (
        _refused(lambda: _open(path, os.O_WRONLY))
        and _refused(lambda: _open(beside, os.O_WRONLY | os.O_CREAT))
        # Landlock knows nothing of permissions and times (landlock(7), "Current limitations"); seccomp pretends to set them.
        and not _changed(path, lambda: os.chmod(path, 0o604))
        and not _changed(path, lambda: os.utime(path, (1, 1)))
    )


def _signals_held(isolation):
    if os.getppid() == 0:  # the first of its PID namespace: there is nobody else
        return True
    if _refused(lambda: os.kill(os.getpid(), 0)):  # seccomp refuses the call whatever its target
        return True
    # Between two users the kernel refuses by itself, which says nothing about processes of the same user.
    same_user = isolation.user is None
    return _refused(lambda: os.kill(os.getppid(), 0)) and (same_user or isolation.signals_scoped)


def _network_held(canary):
    # 127.0.0.1 is unreachable in a network namespace whose loopback was never brought up.
    targets = (
        (socket.AF_INET, ("127.0.0.1", 9)),
        (socket.AF_UNIX, canary["socket"]),
        (socket.AF_UNIX, canary["abstract"]),
    )
    return all(_refused(partial(_connect, *target)) for target in targets) and _refused(lambda: _send(canary))


def _connect(family, address):
    with socket.socket(family, socket.SOCK_DGRAM) as channel:
        channel.connect(address)


def _send(canary):
    """Half of a pair is a socket like any other: a datagram with an address leaves it."""
    for half in socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM):
        with half:
            half.sendto(b"", canary["socket"])


def _open(path, flags):
    os.close(os.open(path, flags, 0o600))


def _changed(path, change):
    try:
        before = os.stat(path)
        change()
        after = os.stat(path)
    except OSError:
        return False
    return (before.st_mode, before.st_mtime) != (after.st_mode, after.st_mtime)


def _fork():
    child = os.fork()
    if child == 0:
        os._exit(0)
    os.waitpid(child, 0)


def _refused(deed):
    return _error(deed) is not None


def _error(deed):
    try:
        deed()
    except OSError as error:
        return error.errno
    return None
