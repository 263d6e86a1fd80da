"""Getting ready once: the walls that can be had here, found by trying, and the slow imports."""

import contextlib
import functools
import glob
import importlib
import os
import re
import sys
import sysconfig

from . import landlock, libc, namespaces, privileges, seccomp

_SYSTEM = (
    "/lib",
    "/lib64",
    "/usr/lib",
    "/usr/lib64",
    "/etc/ld.so.cache",
    "/etc/fonts",
    "/etc/localtime",
    "/usr/share/fonts",
    "/usr/share/fontconfig",
    "/usr/share/zoneinfo",
)
_DEVICES = ("/dev/null", "/dev/zero", "/dev/urandom", "/dev/random")
_LEFT_OUT = "left out on request"


class TooPowerful(Exception):
    """Nothing stands between a notebook and the machine."""


class Parent:
    """What every child inherits: the walls that hold here, and why the others do not."""

    def __init__(self, opening):
        self.limits = opening["limits"]
        self.folder = opening["folder"]
        self.missing = {}
        self.namespaces = False
        self.user = None  # whom to become, when this process is root
        self.ruleset = None
        self.filter = None
        self.status = None
        self.machine = None  # /proc, while getting ready
        self.written = []  # runs of memory that every child writes to


def choose_root(parent, opening):
    """Enters a root of its own, if a throw-away child could; says why not otherwise."""
    _import_early()
    stdlib = sysconfig.get_path("stdlib")
    visible = [*_SYSTEM, *glob.glob(f"{sys.base_prefix}/lib/lib*.so*"), stdlib, *opening["libraries"]]
    root = os.geteuid() == 0
    for own_users in (False, True) if root else (True,):
        enter = functools.partial(
            namespaces.enter_new_root, opening["base"], visible, opening["hidden"], own_users
        )
        why = (
            _LEFT_OUT
            if "namespaces" in opening["without"]
            else _tried(functools.partial(_enter, enter, parent))
        )
        if why is None:
            parent.status, parent.machine = enter()
            parent.namespaces, parent.folder = True, namespaces.FOLDER
            parent.missing.pop("namespaces", None)
            break
        parent.missing["namespaces"] = why
    else:
        parent.status = os.open("/proc/self/status", os.O_RDONLY)
        own_users = False
    if root and not own_users:
        why = _tried(lambda: _read_as(privileges.NOBODY, [stdlib, *opening["libraries"]]))
        if why is None:
            parent.user = privileges.NOBODY
        else:
            parent.missing["a user without rights"] = why


def prepare_walls(parent, opening):
    """Landlock's rules and seccomp's program, made once; what cannot be had is noted in `missing`."""
    stdlib = sysconfig.get_path("stdlib")
    listed = [stdlib, *opening["libraries"]]
    readable = [*landlock.entries(stdlib, ("site-packages", "dist-packages"))]
    for folder in opening["libraries"]:
        readable += landlock.entries(folder, tuple(opening["unread"]))
    for path in _SYSTEM:
        readable += landlock.entries(path, ("python",)) if os.path.isdir(path) and "/lib" in path else [path]
    signals_stay = parent.namespaces
    # The rule is on the folder above: the disk of each notebook is mounted inside it, after the rule was made.
    writable = [os.path.dirname(parent.folder), *_DEVICES]
    try:
        if "Landlock" in opening["without"]:
            raise landlock.NoLandlock(_LEFT_OUT)
        parent.ruleset, scoped = landlock.prepare(listed, readable, writable)
        signals_stay = signals_stay or scoped
    except (landlock.NoLandlock, OSError) as error:
        parent.missing["Landlock"] = str(error)
    try:
        if "seccomp" in opening["without"]:
            raise seccomp.NoSeccomp(_LEFT_OUT)
        parent.filter = seccomp.compile_filter(signals_stay)
        why = _tried(lambda: (libc.prctl(libc.PR_SET_NO_NEW_PRIVS, 1), libc.load_filter(parent.filter)))
        if why is not None:
            raise seccomp.NoSeccomp(why)
    except (seccomp.NoSeccomp, OSError) as error:
        parent.filter = None
        parent.missing["seccomp"] = str(error)
    held_in = (signals_stay or parent.filter) and (parent.namespaces or parent.ruleset)
    if os.geteuid() == 0 and parent.user is None and not held_in:
        # One line of a notebook, os.kill(-1, 9), would end every process of the machine; another would erase its files.
        raise TooPowerful(
            "As root, and with nothing here to keep its signals and writes in, a notebook could end every process "
            "of this machine; run as an ordinary user."
        )


def import_slow(names):
    for name in names:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)


def reading(parent, field):
    """A number from this process's /proc/self/status, e.g. VmSize (in kB) or Threads; 0 where there is none."""
    if parent.status is None:
        return 0
    found = re.search(rf"^{field}:\s*(\d+)", os.pread(parent.status, 8192, 0).decode(), re.MULTILINE)
    return int(found.group(1)) if found else 0


def _import_early():
    # Both look for shared libraries with programs that the new root does not have.
    import_slow(("landlockpy",))
    with contextlib.suppress(ImportError, OSError, RuntimeError):
        importlib.import_module("pyseccomp")


def _enter(enter, parent):
    enter()
    for _ in range(2):
        inner = namespaces.fork_alone()
        if inner == 0:
            namespaces.enter_own_namespaces(parent.limits["file_bytes"], os.geteuid(), os.getegid())
            os._exit(0 if os.getpid() == 1 else 1)
        if os.waitpid(inner, 0)[1] != 0:
            raise OSError("a process in its own namespaces did not come up")


def _read_as(user, folders):
    os.setgroups([])
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)
    for folder in folders:
        os.listdir(folder)
    for name in ("numpy", "IPython"):
        if not any(os.access(f"{folder}/{name}/__init__.py", os.R_OK) for folder in folders):
            raise OSError(f"{name} can be read by root only")


def told(deed):
    """What the deed gives, a text, when it is done in a throw-away child; None when it does not get so far."""
    theirs, ours = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            said = deed().encode()
            while said:
                said = said[os.write(ours, said) :]
        finally:
            os._exit(0)
    os.close(ours)
    with open(theirs, encoding="utf-8") as file:
        said = file.read()
    os.waitpid(child, 0)
    return said or None


def _tried(deed):
    """Does it in a throw-away child; None when that went well, else why not."""

    def attempt():
        try:
            deed()
        except BaseException as error:
            return "." + (str(error) or type(error).__name__)
        return "."

    said = told(attempt)
    return "the kernel ended the process that tried" if said is None else said[1:] or None
