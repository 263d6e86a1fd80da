"""What this kernel can do, asked by system calls of the tests' own: the isolation level that the package must then reach."""

from __future__ import annotations

import ctypes
import errno
import os
import sys

CLONE_NEWNS, CLONE_NEWUTS, CLONE_NEWIPC, CLONE_NEWUSER = 0x20000, 0x4000000, 0x8000000, 0x10000000
CLONE_NEWPID, CLONE_NEWNET = 0x20000000, 0x40000000
MS_BIND, MS_REC, MS_PRIVATE = 4096, 16384, 1 << 18
PR_SET_SECCOMP, SECCOMP_MODE_FILTER = 22, 2
SYS_LANDLOCK_CREATE_RULESET, LANDLOCK_CREATE_RULESET_VERSION = 444, 1

libc = ctypes.CDLL(None, use_errno=True)


def mount(source: str | None, target: str, kind: str | None, flags: int, options: str = "") -> None:
    texts = [None if text is None else text.encode() for text in (source, target, kind)]
    if libc.mount(*texts, ctypes.c_ulong(flags), options.encode() or None):
        raise OSError(ctypes.get_errno(), f"mount {target}")


def has_namespaces() -> bool:
    """Whether a child can enter new namespaces and mount a disk there."""
    child = os.fork()
    if child:
        return os.waitpid(child, 0)[1] == 0
    try:
        flags = CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC | CLONE_NEWUTS
        if os.geteuid() != 0:
            flags |= CLONE_NEWUSER
        if libc.unshare(flags):
            os._exit(1)
        mount(None, "/", None, MS_REC | MS_PRIVATE)
        mount("probe", "/tmp", "tmpfs", 0)
        os._exit(0)
    finally:
        os._exit(1)


def landlock_abi() -> int:
    version = libc.syscall(
        SYS_LANDLOCK_CREATE_RULESET, None, ctypes.c_size_t(0), LANDLOCK_CREATE_RULESET_VERSION
    )
    return max(0, version)


def has_seccomp() -> bool:
    """Whether the kernel takes filters: it then finds fault with the address of this one, else with the request."""
    ctypes.set_errno(0)
    return (
        libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, None, 0, 0) == -1
        and ctypes.get_errno() == errno.EFAULT
    )


def promised(without: frozenset[str] = frozenset()) -> int:
    """The isolation level that these features make possible."""
    if sys.platform != "linux":
        return 0
    namespaces = "namespaces" not in without and has_namespaces()
    landlock = not {"Landlock", "landlockpy"} & without and landlock_abi() >= 1
    seccomp = not {"seccomp", "pyseccomp"} & without and has_seccomp()
    if seccomp and (namespaces or landlock):
        return 3 if namespaces and landlock else 2
    return 1 if namespaces else 0
