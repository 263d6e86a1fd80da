"""The bytes of a file that was handed in: read without following links, waiting, or reading more than fits."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from corollary.messages import N_, catalogue

_ = catalogue(__name__)

MOST_BYTES = 20 << 20


@dataclass(frozen=True, slots=True)
class Unreadable:
    """A file that is no notebook. `message` is a sentence in English, with the `values` of its holes, where it has any.
    `machine_failed`: through no fault of the student's, such as rights that whoever marks does not have."""

    message: str
    values: Mapping[str, object] = field(default_factory=dict[str, object])
    machine_failed: bool = False

    @property
    def why(self) -> str:
        """The sentence in the student's language."""
        return _(self.message, **self.values)

    @property
    def in_english(self) -> str:
        """The sentence for whoever teaches, and for records: the same in every language."""
        return self.message.format(**self.values) if self.values else self.message


# Rights, broken disks, and too many open files: of this machine, and nothing that was handed in.
OF_THE_MACHINE = {
    errno.EACCES, errno.EPERM, errno.EIO, errno.EMFILE, errno.ENFILE, errno.ENOMEM, errno.ESTALE,
}  # fmt: skip


def bytes_of(
    path: str | Path, most_bytes: int = MOST_BYTES, within: str | Path | None = None
) -> bytes | Unreadable:
    """What is in a file that was handed in; never raises, never waits, and reads nothing of a file that is too large.

    The file itself must not be a link; below the folder `within`, none of the folders that lead to it either.
    """
    try:
        descriptor = _opened(Path(path), Path(within) if within is not None else None)
    except (OSError, ValueError) as error:
        return _refused(error)
    status = os.fstat(descriptor)
    if not stat.S_ISREG(status.st_mode) or status.st_size > most_bytes:
        os.close(descriptor)
        return (
            too_large(most_bytes) if stat.S_ISREG(status.st_mode) else Unreadable(N_("This is not a file."))
        )
    with open(descriptor, "rb") as file:
        try:
            content = file.read(most_bytes + 1)  # it may be growing
        except OSError as error:
            values = {"what": error.strerror}
            return Unreadable(N_("The file cannot be read: {what}."), values, error.errno in OF_THE_MACHINE)
    return content if len(content) <= most_bytes else too_large(most_bytes)


def too_large(most_bytes: int) -> Unreadable:
    size = f"{most_bytes >> 20} MB" if most_bytes >= 1 << 20 else f"{most_bytes} bytes"
    message = N_("The file is larger than {size}: clear the outputs and hand it in again.")
    return Unreadable(message, {"size": size})


def _opened(path: Path, within: Path | None) -> int:
    if os.open not in os.supports_dir_fd:
        return _opened_by_name(path, within)
    # A named pipe would wait for a writer, and a link leads where the student could not go.
    flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC | os.O_NOCTTY
    if within is None:
        return os.open(path, flags)
    *folders, name = path.relative_to(within).parts
    folder = os.open(within, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        for each in folders:
            inner = os.open(each, flags | os.O_DIRECTORY, dir_fd=folder)
            os.close(folder)
            folder = inner
        return os.open(name, flags, dir_fd=folder)
    finally:
        os.close(folder)


def _opened_by_name(path: Path, within: Path | None) -> int:
    """Where folders cannot be opened one after another (Windows): whatever leads there is looked at first."""
    folders = [] if within is None else [within / part for part in path.relative_to(within).parents][:-1]
    for each in (path, *folders):
        if each.is_symlink() or each.resolve() != each.absolute():
            raise OSError(errno.ELOOP, os.strerror(errno.ELOOP), str(path))
    if not path.is_file():
        raise OSError(errno.ENOENT, os.strerror(errno.ENOENT), str(path))
    return os.open(path, os.O_RDONLY | getattr(os, "O_BINARY", 0))


def _refused(error: OSError | ValueError) -> Unreadable:
    if isinstance(error, ValueError):
        return Unreadable(N_("The file cannot be opened: {what}."), {"what": error})
    match error.errno:
        case errno.ELOOP | errno.EMLINK:  # what O_NOFOLLOW says of a link (open(2); FreeBSD has EMLINK)
            return Unreadable(N_("The file is a link, so it was not read: hand in the file itself."))
        case errno.ENOTDIR:  # O_DIRECTORY with O_NOFOLLOW says this of a link to a folder
            message = N_(
                "Its folder is a link, or not a folder, so it was not read: hand in the folder itself."
            )
            return Unreadable(message)
        case errno.ENXIO:  # a socket
            return Unreadable(N_("This is not a file."))
        case number:
            values = {"what": error.strerror}
            return Unreadable(N_("The file cannot be opened: {what}."), values, number in OF_THE_MACHINE)
