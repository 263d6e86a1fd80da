"""The temporary folder of one zygote: what lies in it, how much, and that none is left behind, even by a process killed."""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import socket
import stat
import tempfile
import time
from pathlib import Path
from typing import TypedDict, final

_PREFIX = "corollary-"
_INSIDE = {"root", "log", "lock", "lock.new", "disk", "canary"}
_NEW = 3600.0  # seconds in which a folder without a lock may just be being made, or removed
_ENTRY = 4096  # an empty file takes room too


class Canary(TypedDict):
    """What a confined worker must not reach: a file, a socket by path and an abstract one."""

    file: str
    socket: str
    abstract: str


@final
class Base:
    """`root` is an empty folder to mount on, `folder` where notebooks write when they have no disk of their own.

    A lock on it is held while its process lives: a folder whose lock is free was left by a process that was killed.
    """

    def __init__(self, path: Path, lock: int) -> None:
        self.path = path
        self.root, self.log = path / "root", path / "log"
        # Landlock's rule is on the folder above: it outlives the notebook's own, which is made anew for each.
        self.folder = path / "disk" / "notebook"
        self._lock = lock
        self._sockets: list[socket.socket] = []

    def canary(self, user: int | None) -> Canary:
        """Made anew; belongs to `user` and is open to everybody. Raises OSError."""
        folder = self.path / "canary"
        folder.mkdir()
        file, by_path, abstract = folder / "file", folder / "socket", f"\0{self.path}"
        file.write_text("canary", encoding="utf-8")
        for address in (str(by_path), abstract):
            listening = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
            self._sockets.append(listening)
            # macOS has no abstract sockets, and a path may be longer than the 108 bytes of sockaddr_un.
            with contextlib.suppress(OSError):
                listening.bind(address)
        for path in (folder, file, by_path):
            if path.exists():
                path.chmod(0o777)
                if user is not None:
                    os.chown(path, user, user)
        return {"file": str(file), "socket": str(by_path), "abstract": abstract}

    def empty_folder(self, user: int | None, room: int) -> None:
        """The folder of notebooks without a disk of their own, empty. Raises OSError where `room` bytes are not free."""
        for left in self.folder.parent.iterdir():
            _remove(left)
        self.folder.mkdir(mode=0o700)
        if user is not None:
            os.chown(self.folder, user, user)
        if shutil.disk_usage(self.folder).free < room:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(self.folder))

    def last_words(self) -> list[str]:
        """What its process wrote on standard error, line by line."""
        try:
            return self.log.read_text(encoding="utf-8", errors="replace").strip().splitlines()
        except OSError:
            return []

    def remove(self) -> None:
        for listening in self._sockets:
            listening.close()
        _remove_base(self.path)
        os.close(self._lock)


def new_base() -> Base:
    """A new folder, after those that killed processes left have been removed. Raises OSError."""
    remove_abandoned()
    path = Path(tempfile.mkdtemp(prefix=_PREFIX))
    try:
        # Locked before it gets its name, or another process could find it free and remove the folder.
        lock = os.open(path / "lock.new", os.O_CREAT | os.O_RDWR | os.O_CLOEXEC, 0o600)
        _flock(lock, wait=True)
        (path / "lock.new").rename(path / "lock")
        base = Base(path, lock)
        path.chmod(0o711)  # a worker that is no longer root must be able to pass
        for folder in (base.root, base.folder.parent, base.folder):
            folder.mkdir()
    except OSError:
        _remove(path)
        raise
    return base


def remove_abandoned() -> None:
    """Removes the folders that ended processes left, whichever way they ended."""
    for path in Path(tempfile.gettempdir()).glob(f"{_PREFIX}????????"):
        try:
            about = path.lstat()
            if not stat.S_ISDIR(about.st_mode) or about.st_uid != os.geteuid():
                continue
            lock = os.open(path / "lock", os.O_RDWR | os.O_NOFOLLOW | os.O_CLOEXEC)
        except OSError:  # not one of these, or just being made, or what is left of one
            if _is_remnant(path):
                _remove_base(path)
            continue
        try:
            _flock(lock, wait=False)
            _remove_base(path)
        except BlockingIOError:
            continue  # in use
        finally:
            os.close(lock)


def _is_remnant(path: Path) -> bool:
    """Whether it is a folder of ours that lost its lock: earlier versions were killed while they removed it."""
    try:
        names = set(os.listdir(path))
        return names <= _INSIDE - {"lock"} and "disk" in names and time.time() - path.stat().st_mtime > _NEW
    except OSError:
        return False


def _remove_base(path: Path) -> None:
    """The lock goes last: cut short before, the next process finds the folder abandoned."""
    for name in os.listdir(path):
        if name != "lock":
            _remove(path / name)
    _remove(path)


def _remove(path: Path) -> None:
    """With everything in it; a notebook may have made folders that their owner may not enter. What resists is left."""
    if os.path.islink(path) or not os.path.isdir(path):
        with contextlib.suppress(OSError):
            path.unlink()
        return
    for here, names, _ in os.walk(path):
        for inner in (os.path.join(here, name) for name in names):
            if not os.path.islink(inner):
                with contextlib.suppress(OSError):
                    os.chmod(inner, 0o700)
    shutil.rmtree(path, ignore_errors=True)


def bytes_in(folder: Path, most_entries: int = 20_000) -> int:
    """Bytes of the files below `folder`, counted without following links.

    Entries beyond `most_entries` are not counted: with 4096 bytes for each at least, these are 80 MB already.
    """
    total, seen, folders = 0, 0, [str(folder)]
    while folders and seen < most_entries:
        try:
            entries = list(os.scandir(folders.pop()))
        except OSError:
            continue
        for entry in entries:
            seen += 1
            try:
                size = entry.stat(follow_symlinks=False).st_size
                if entry.is_dir(follow_symlinks=False):
                    folders.append(entry.path)
            except OSError:
                continue
            total += max(_ENTRY, size)
    return total


def _flock(descriptor: int, *, wait: bool) -> None:
    """Locks an open file. Raises OSError when another has it locked and is not waited for."""
    import fcntl  # only here: Windows has none, and nothing runs there, but what does not run anything is imported

    fcntl.flock(descriptor, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)
