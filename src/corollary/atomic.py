"""A file written whole or not at all, whenever the power goes or the disk fills."""

from __future__ import annotations

import os
import stat
import tempfile
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Final

SIDE_BY_SIDE: Final = 8
"""Files that wait for the disk at a time."""


def is_shared(folder: Path) -> bool:
    """True for a folder that a group works in: its members may write, and what is made in it belongs to the group."""
    mode = folder.stat().st_mode
    return bool(mode & stat.S_ISGID and mode & stat.S_IWGRP)


def rights_in(folder: Path, mode: int) -> int:
    """The mode of a new file or folder; in a shared folder for the group too, whatever the umask, and for nobody beyond it."""
    if not is_shared(folder):
        return mode
    others = 0o007 if folder.stat().st_mode & 0o005 else 0
    own = mode & 0o700
    return own | own >> 3 | mode & others


def make_folders(folder: Path) -> None:
    """Make a folder, and those around it, with the rights of the place."""
    if folder.is_dir():
        return
    make_folders(folder.parent)
    folder.mkdir(exist_ok=True)
    if is_shared(folder.parent) and folder.stat().st_uid == os.geteuid():
        folder.chmod(stat.S_ISGID | rights_in(folder.parent, 0o755))


@contextmanager
def umask_of(folder: Path) -> Generator[None]:
    """In a shared folder all that is made meanwhile is for the group, and for nobody beyond it; elsewhere nothing changes."""
    before = os.umask(0o007) if is_shared(folder) else None
    try:
        yield
    finally:
        if before is not None:
            os.umask(before)


def open_to_append(path: Path, mode: int = 0o644) -> int:
    """A file's descriptor, to add to its end; a new file has the rights of the place."""
    make_folders(path.parent)
    try:
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND, mode)
    except FileExistsError:
        return os.open(path, os.O_WRONLY | os.O_APPEND)
    os.chmod(path, rights_in(path.parent, mode))
    return descriptor


def write_whole(path: Path, content: str | bytes, *, mode: int = 0o644) -> None:
    """Writes aside and moves into place: readers find the old file or the new one. Folders are made as needed."""
    make_folders(path.parent)
    handle, draft = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:40]}.")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)
            file.flush()
            os.fsync(file.fileno())  # else the move may reach the disk before what was moved
        os.chmod(draft, rights_in(path.parent, mode))
        os.replace(draft, path)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise


def write_each_whole(files: Mapping[Path, str | bytes], *, mode: int = 0o644) -> None:
    """Many files, each whole or not at all, in no order and side by side: what takes the time is waiting for the disk."""
    from concurrent.futures import ThreadPoolExecutor  # most commands write no files, or one

    with ThreadPoolExecutor(min(SIDE_BY_SIDE, len(files) or 1)) as pool:
        for written in [pool.submit(write_whole, path, each, mode=mode) for path, each in files.items()]:
            written.result()


def write_files(folder: Path, files: Mapping[str, bytes], *, mode: int = 0o644) -> list[Path]:
    """Writes them below the folder, and says where they are."""
    placed = {folder / name: content for name, content in files.items()}
    write_each_whole(placed, mode=mode)
    return list(placed)
