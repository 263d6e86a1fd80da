"""The few calls of the C library and the kernel that Python has no name for."""

import ctypes
import os
import sys

CLONE_NEWNS = 0x00020000
CLONE_NEWUTS = 0x04000000
CLONE_NEWIPC = 0x08000000
CLONE_NEWUSER = 0x10000000
CLONE_NEWPID = 0x20000000
CLONE_NEWNET = 0x40000000

MS_NOSUID, MS_NODEV, MS_BIND, MS_REC, MS_PRIVATE = 2, 4, 4096, 16384, 1 << 18
MNT_DETACH = 2

PR_SET_PDEATHSIG, PR_SET_DUMPABLE, PR_SET_SECCOMP = 1, 4, 22
PR_SET_CHILD_SUBREAPER, PR_SET_NO_NEW_PRIVS = 36, 38

_MADV_COLLAPSE = 25
_AT_RECURSIVE, _MOUNT_ATTR_RDONLY, _MOUNT_ATTR_NOSUID, _SYS_MOUNT_SETATTR = 0x8000, 1, 2, 442
_CAPABILITY_VERSION_3 = 0x20080522
_SECCOMP_MODE_FILTER = 2
_AT_FDCWD = -100

_libc = ctypes.CDLL(None, use_errno=True)


def _checked(result, deed):
    if result != 0:
        error = ctypes.get_errno()
        raise OSError(error, f"{deed}: {os.strerror(error)}")


def unshare(flags):
    _checked(_libc.unshare(flags), "new namespaces")


def setns(descriptor, flags):
    _checked(_libc.setns(descriptor, flags), "return to the earlier namespaces")


def mount(source, target, kind, flags, options=""):
    arguments = [None if text is None else text.encode() for text in (source, target, kind)]
    _checked(_libc.mount(*arguments, ctypes.c_ulong(flags), options.encode() or None), f"mount {target}")


def make_read_only(path):
    """Everything mounted at `path` and below becomes read-only (Linux 5.12)."""
    attributes = (ctypes.c_uint64 * 4)(_MOUNT_ATTR_RDONLY | _MOUNT_ATTR_NOSUID, 0, 0, 0)
    result = _libc.syscall(
        _SYS_MOUNT_SETATTR,
        _AT_FDCWD,
        path.encode(),
        _AT_RECURSIVE,
        ctypes.byref(attributes),
        ctypes.c_size_t(ctypes.sizeof(attributes)),
    )
    _checked(result, f"make {path} read-only")


def pivot_root(folder):
    """`folder`, a mount, becomes the root; what was the root is gone."""
    os.chdir(folder)
    _checked(_libc.pivot_root(b".", b"."), "pivot_root")
    _checked(_libc.umount2(b".", MNT_DETACH), "leaving the old root")
    os.chdir("/")


def prctl(option, first=0, second=0):
    _checked(_libc.prctl(option, ctypes.c_ulong(first), ctypes.c_ulong(second), 0, 0), f"prctl {option}")


def drop_capabilities():
    header = (ctypes.c_uint32 * 2)(_CAPABILITY_VERSION_3, 0)
    _checked(_libc.capset(header, (ctypes.c_uint32 * 6)()), "dropping capabilities")


class Filter(ctypes.Structure):
    """A compiled seccomp program (bytes of 8-byte instructions), laid out once as the kernel reads it."""

    _fields_ = (("length", ctypes.c_ushort), ("instructions", ctypes.c_void_p))

    def __init__(self, program):
        self._instructions = ctypes.create_string_buffer(program, len(program))
        super().__init__(len(program) // 8, ctypes.addressof(self._instructions))


def load_filter(compiled):
    """Puts a `Filter` in force, for good."""
    prctl(PR_SET_SECCOMP, _SECCOMP_MODE_FILTER, ctypes.addressof(compiled))


def collapse(start, length):
    """Whether the memory is now in huge pages (madvise(2), Linux 6.1); it holds what it held."""
    return _libc.madvise(ctypes.c_void_p(start), ctypes.c_size_t(length), _MADV_COLLAPSE) == 0


def on_linux():
    return sys.platform == "linux"
