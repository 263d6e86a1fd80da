"""The layers of isolation that can be had here, found by trying each in a throw-away child before the first notebook."""

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
_LEFT_OUT = "left out on request"


class NotContained(Exception):
    """A notebook could harm the machine; nothing is run."""


class Layers:
    """What every worker inherits: the layers that are in force here, and why the others are not."""

    def __init__(self, config):
        self.limits = config["limits"]
        self.folder = config["folder"]
        self.missing = {}
        self.namespaces = False
        self.user = None  # whom to become, when this process is root
        self.ruleset = None
        self.filter = None
        self.signals_scoped = False
        self.address_space = 0  # bytes of it that the zygote takes, and with it every worker at its birth
        self._status = self.maps = None

    def status(self, field):
        """A number from this process's /proc/self/status, e.g. VmSize (in kB) or Threads; 0 where there is none."""
        if self._status is None:
            return 0
        found = re.search(rf"^{field}:\s*(\d+)", os.pread(self._status, 8192, 0).decode(), re.MULTILINE)
        return int(found.group(1)) if found else 0

    def watch(self, status, maps):
        """Descriptors of this process's own files in /proc."""
        self._status, self.maps = status, maps

    def owner(self):
        """The user and group that a worker ends up as."""
        return (os.geteuid(), os.getegid()) if self.user is None else (self.user, self.user)


def enter_root(isolation, config):
    """Enters a root of its own, if a throw-away child could; notes why not otherwise. Chooses whom a worker runs as."""
    _import_early()
    stdlib = sysconfig.get_path("stdlib")
    visible = [*_SYSTEM, *glob.glob(f"{sys.base_prefix}/lib/lib*.so*"), stdlib, *config["libraries"]]
    root = os.geteuid() == 0
    # Root needs no user namespace, and some containers allow root the one and not the other.
    for own_users in (False, True) if root else (True,):
        enter = functools.partial(
            namespaces.enter_new_root, config["base"], visible, config["hidden"], own_users
        )
        why = (
            _LEFT_OUT
            if "namespaces" in config["without"]
            else _why_not(functools.partial(_try_root, enter, isolation))
        )
        if why is None:
            isolation.watch(*enter())
            isolation.namespaces, isolation.folder = True, namespaces.FOLDER
            isolation.missing.pop("namespaces", None)
            break
        isolation.missing["namespaces"] = why
    else:
        isolation.watch(*(os.open(f"/proc/self/{name}", os.O_RDONLY) for name in ("status", "maps")))
        own_users = False
    if root and not own_users:
        why = _why_not(lambda: _read_as(privileges.NOBODY, [stdlib, *config["libraries"]]))
        if why is None:
            isolation.user = privileges.NOBODY
        else:
            isolation.missing["a user without rights"] = why


def prepare(isolation, config):
    """Landlock's ruleset and seccomp's program, made once; what cannot be had is noted in `missing`."""
    _prepare_landlock(isolation, config)
    try:
        if "seccomp" in config["without"]:
            raise seccomp.NoSeccomp(_LEFT_OUT)
        harmless = isolation.namespaces or isolation.signals_scoped
        isolation.filter = libc.Filter(seccomp.compile_filter(harmless))
        why = _why_not(lambda: (libc.prctl(libc.PR_SET_NO_NEW_PRIVS, 1), libc.load_filter(isolation.filter)))
        if why is not None:
            raise seccomp.NoSeccomp(why)
    except (seccomp.NoSeccomp, OSError) as error:
        isolation.filter = None
        isolation.missing["seccomp"] = str(error)
    signals_held = isolation.namespaces or isolation.signals_scoped or isolation.filter
    if (
        os.geteuid() == 0
        and isolation.user is None
        and not (signals_held and (isolation.namespaces or isolation.ruleset))
    ):
        # One line of a notebook, os.kill(-1, 9), would end every process of the machine; another would erase its files.
        raise NotContained(
            "As root, and with nothing here to keep its signals and writes in, a notebook could end every process "
            "of this machine; run as an ordinary user."
        )


def _prepare_landlock(isolation, config):
    stdlib = sysconfig.get_path("stdlib")
    readable = landlock.entries(stdlib, ("site-packages", "dist-packages"), ())
    for folder in config["libraries"]:
        readable += landlock.entries(folder, (), config["hidden"])
    for path in _SYSTEM:
        # Debian has its packages of Python below /usr/lib/python3: a copy of the course's library may lie there too.
        is_library = os.path.isdir(path) and "/lib" in path
        readable += landlock.entries(path, ("python",), ()) if is_library else [path]
    # The rule is on the folder above: the disk of each notebook is mounted inside it, after the rule was made.
    writable = [os.path.dirname(isolation.folder), *namespaces.DEVICES]
    try:
        if "Landlock" in config["without"]:
            raise landlock.NoLandlock(_LEFT_OUT)
        isolation.ruleset, isolation.signals_scoped = landlock.prepare(
            [stdlib, *config["libraries"]], readable, writable
        )
    except (landlock.NoLandlock, OSError) as error:
        isolation.missing["Landlock"] = str(error)


def import_each(names):
    for name in names:
        with contextlib.suppress(Exception):  # a broken package fails in whatever way
            importlib.import_module(name)


def _import_early():
    # Both find their shared libraries with programs (ldconfig, gcc) that the new root does not have.
    import_each(("landlockpy",))
    with contextlib.suppress(ImportError, OSError, RuntimeError):
        importlib.import_module("pyseccomp")


def _try_root(enter, isolation):
    enter()
    # Twice: returning to the PID namespace of before, for the second, is what some kernels refuse.
    for _ in range(2):
        inner = namespaces.fork_alone()
        if inner == 0:
            namespaces.enter_own_namespaces(isolation.limits["file_bytes"], os.geteuid(), os.getegid())
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


def _why_not(deed):
    """Tries it in a throw-away child: None when that went well, else why not."""
    end, start = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            deed()
            os.write(start, b"+")
        except BaseException as error:
            os.write(start, f"-{error or type(error).__name__}".encode()[:1000])
        finally:
            os._exit(0)
    os.close(start)
    with open(end, encoding="utf-8", errors="replace") as file:
        answer = file.read()
    os.waitpid(child, 0)
    if answer.startswith("-"):
        return answer[1:] or "it failed without a reason"
    return None if answer == "+" else "the kernel killed the process that tried"
