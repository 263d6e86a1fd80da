"""Namespaces: a root that holds the interpreter and its libraries only, and for each notebook its own processes, net and disk."""

import os
import signal

from . import libc

FOLDER = "/sandbox/notebook"
DEVICES = ("/dev/null", "/dev/zero", "/dev/urandom", "/dev/random")


def enter_new_root(base, visible, hidden, own_users):
    """Leaves the machine's files: only the paths in `visible` remain, read-only, without those in `hidden`.

    It returns in a new process, the first of its own PID namespace, so that nothing it starts outlives it; the old process
    waits for it and exits with its status. Gives descriptors of its /proc/self/status and maps, to which the new root has no
    path.
    `base` is an empty folder to build in; with `own_users` the capabilities to do so come from a user namespace. Raises
    OSError where the kernel or the administrator does not allow it; the process may then be half-way, so try it in a
    throw-away child first.
    """
    user, group = os.geteuid(), os.getegid()
    libc.unshare(libc.CLONE_NEWNS | libc.CLONE_NEWPID | (libc.CLONE_NEWUSER if own_users else 0))
    if own_users:
        # Without CAP_SETGID outside, the kernel (since 3.19, CVE-2014-8989) maps a group only once setgroups is denied.
        _write("/proc/self/setgroups", "deny")
        _write("/proc/self/uid_map", f"{user} {user} 1")
        _write("/proc/self/gid_map", f"{group} {group} 1")
    first = os.fork()
    if first:
        os.closerange(3, 4096)
        os._exit(os.waitstatus_to_exitcode(os.waitpid(first, 0)[1]) & 0xFF)
    libc.prctl(libc.PR_SET_PDEATHSIG, signal.SIGKILL)
    own = os.open("/proc/self/status", os.O_RDONLY), os.open("/proc/self/maps", os.O_RDONLY)
    # Private, so that what is mounted below stays inside: systemd shares all mounts (mount_namespaces(7)).
    libc.mount(None, "/", None, libc.MS_REC | libc.MS_PRIVATE)
    libc.mount("sandbox", base, "tmpfs", libc.MS_NOSUID, "size=1m,mode=755")
    for path in (*DEVICES, *visible):
        if os.path.exists(path):
            _show(base, path)
    os.makedirs(base + FOLDER)
    for path in hidden:
        _hide(base + path)
    libc.make_read_only(base)
    # The zygote writes a little while its libraries are imported; each notebook's disk is mounted over it.
    libc.mount("zygote", base + FOLDER, "tmpfs", libc.MS_NOSUID | libc.MS_NODEV, "size=16m,mode=755")
    libc.pivot_root(base)
    return own


def _show(base, path):
    """A link stays a link (Debian's /lib), anything else is mounted at its own place in the new root."""
    place = base + path
    os.makedirs(os.path.dirname(place), exist_ok=True)
    if os.path.islink(path):
        if not os.path.lexists(place):
            os.symlink(os.readlink(path), place)
        return
    if os.path.isdir(path):
        os.makedirs(place, exist_ok=True)
    elif not os.path.exists(place):
        os.close(os.open(place, os.O_CREAT | os.O_WRONLY, 0o644))
    libc.mount(path, place, None, libc.MS_BIND | libc.MS_REC)


def _hide(path):
    """Something empty is mounted on top of it."""
    if os.path.isdir(path):
        libc.mount("hidden", path, "tmpfs", libc.MS_NOSUID, "size=4k,mode=755")
    elif os.path.exists(path):
        libc.mount("/dev/null", path, None, libc.MS_BIND)


def _write(path, text):
    descriptor = os.open(path, os.O_WRONLY)
    try:
        os.write(descriptor, text.encode())
    finally:
        os.close(descriptor)


def fork_alone():
    """A fork whose child sees no process but its own, and is the first of them: with it all it started ends.

    Gives what os.fork gives. The parent goes back to its own namespace after each, since no process can be made any more in
    a PID namespace whose first has ended (pid_namespaces(7)).
    """
    own = os.pidfd_open(os.getpid())
    try:
        libc.unshare(libc.CLONE_NEWPID)
        child = os.fork()
        if child:
            libc.setns(own, libc.CLONE_NEWPID)
    finally:
        os.close(own)
    return child


def enter_own_namespaces(disk_bytes, user, group):
    """For one notebook: no network, no System V messages to others, and a small empty disk at `FOLDER`."""
    libc.unshare(libc.CLONE_NEWNS | libc.CLONE_NEWNET | libc.CLONE_NEWIPC | libc.CLONE_NEWUTS)
    options = f"size={disk_bytes},nr_inodes=512,mode=700,uid={user},gid={group}"
    libc.mount("notebook", FOLDER, "tmpfs", libc.MS_NOSUID | libc.MS_NODEV, options)
