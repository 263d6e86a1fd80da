"""What lies in archives and folders that were handed in: read in memory and within bounds; no name in them becomes a path."""

from __future__ import annotations

import io
import os
import stat
import struct
import unicodedata
import zipfile
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import IO

from corollary.sandbox.file import MOST_BYTES, Unreadable, bytes_of, too_large

MOST_MEMBERS = 20_000  # a thousand students with twenty files each
DEEPEST = 3  # the archive of all, a student's own, and one that a student put into that
MOST_TIMES = 100  # text and drawings shrink to a tenth; what shrinks to a hundredth, all in all, is a bomb
LEAST_BOUND = 500 << 20
FIRST_YEAR = 1981  # 1980 is what an archive says that has no time
SKIPPED = {"__MACOSX", ".DS_Store", "Thumbs.db", "desktop.ini", ".ipynb_checkpoints"}
# Nothing else can be of use; some browsers save a notebook as text.
READ = (".ipynb", ".ipynb.txt", ".ipynb.json")
FAILURES = (
    zipfile.BadZipFile,
    zlib.error,
    OSError,
    EOFError,
    RuntimeError,
    NotImplementedError,
    ValueError,
    struct.error,
)


@dataclass(frozen=True, slots=True)
class Member:
    """One file. `parts` are the names that lead to it, its own last; `modified` its time, where it has one, and whether
    that has a zone depends on the archive; `content` is None for what is no notebook."""

    parts: tuple[str, ...]
    content: bytes | Unreadable | None
    modified: datetime | None
    archive: str = ""

    @property
    def name(self) -> str:
        return "/".join(self.parts)


def members(path: Path) -> Iterator[Member]:
    """The files in a folder, in an archive, or the file itself; never raises for what is in them. What is refused is yielded
    with the reason in the place of its content."""
    if path.is_dir():
        yield from _of_folder(path)
    elif path.suffix.lower() == ".zip":
        try:
            with path.open("rb") as file:
                yield from _of_archive(file, path.stat().st_size, (), path.name, 1)
        except OSError as error:
            yield Member(
                (path.name,), Unreadable(f"cannot be opened: {error.strerror}", machine_failed=True), None
            )
    else:
        yield from _of_file((path.name,), path, None)


def _of_folder(folder: Path) -> Iterator[Member]:
    count = 0
    for place, folders, names in os.walk(folder):
        inside = Path(place).relative_to(folder).parts
        linked = [name for name in folders if (Path(place) / name).is_symlink()]
        folders[:] = sorted(name for name in folders if name not in SKIPPED and name not in linked)
        for name in linked:
            yield Member((*inside, name), Unreadable("is a link, which is not followed"), None)
        for name in sorted(names):
            if name in SKIPPED or name.startswith("._"):
                continue
            count += 1
            if count > MOST_MEMBERS:
                yield Member(
                    (*inside, name),
                    Unreadable(f"comes after {MOST_MEMBERS} files; collect fewer at a time"),
                    None,
                )
                return
            yield from _of_file((*inside, name), Path(place) / name, folder)


def _of_file(parts: tuple[str, ...], path: Path, within: Path | None) -> Iterator[Member]:
    try:
        modified = datetime.fromtimestamp(path.lstat().st_mtime, UTC)
    except (OSError, OverflowError, ValueError):
        modified = None
    name = path.name.lower()
    if not name.endswith((*READ, ".zip")):
        yield Member(parts, None, modified)
        return
    content = bytes_of(path, within=within)
    if name.endswith(".zip") and isinstance(content, bytes):
        yield from _of_archive(io.BytesIO(content), len(content), parts, "/".join(parts), 2)
    else:
        yield Member(parts, content, modified)


def _of_archive(
    file: IO[bytes], size: int, inside: tuple[str, ...], label: str, depth: int
) -> Iterator[Member]:
    refused = inside or (label,)
    if depth > DEEPEST:
        yield Member(refused, Unreadable("is an archive in an archive in an archive"), None)
        return
    left = max(LEAST_BOUND, MOST_TIMES * size) if depth == 1 else LEAST_BOUND
    try:
        with zipfile.ZipFile(file) as archive:
            found = archive.infolist()
            if len(found) > MOST_MEMBERS:
                why = f"holds {len(found)} files, more than {MOST_MEMBERS}; unpack it and collect the folder in parts"
                yield Member(refused, Unreadable(why), None)
                return
            for info in found:
                parts = tuple(part for part in _name(info).replace("\\", "/").split("/") if part)
                if info.is_dir() or not parts or SKIPPED & set(parts) or parts[-1].startswith("._"):
                    continue
                content = _refusal(info, parts)
                name = parts[-1].lower()
                if content is None and name.endswith((*READ, ".zip")):
                    content = (
                        _content(archive, info)
                        if left > 0
                        else Unreadable("is in an archive that unpacks without end")
                    )
                    left -= len(content) if isinstance(content, bytes) else 0
                if name.endswith(".zip") and isinstance(content, bytes):
                    nested = (*inside, *parts)
                    yield from _of_archive(io.BytesIO(content), len(content), nested, label, depth + 1)
                else:
                    yield Member((*inside, *parts), content, _time(info), label)
    except FAILURES as error:
        yield Member(refused, Unreadable(f"is no archive that can be opened ({error})"), None)


def _refusal(info: zipfile.ZipInfo, parts: tuple[str, ...]) -> Unreadable | None:
    if ".." in parts or info.filename.startswith(("/", "\\")) or parts[0].endswith(":"):
        return Unreadable("has a name that leads out of the archive")
    if stat.S_ISLNK(info.external_attr >> 16):
        return Unreadable("is a link, which is not followed")
    if info.flag_bits & 1:
        return Unreadable("is locked with a password")
    return None


def _content(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> bytes | Unreadable:
    if info.file_size > MOST_BYTES:
        return too_large(MOST_BYTES)
    try:
        with archive.open(info) as file:
            content = file.read(MOST_BYTES + 1)
    except FAILURES as error:
        return Unreadable(f"is damaged ({error})")
    return content if len(content) <= MOST_BYTES else too_large(MOST_BYTES)


def _name(info: zipfile.ZipInfo) -> str:
    """The name as it was meant: some programs write UTF-8 and do not say so."""
    name = info.filename
    if not info.flag_bits & 0x800:
        try:
            name = name.encode("cp437").decode("utf-8")
        except UnicodeError:
            name = info.filename
    return unicodedata.normalize("NFC", name)


def _time(info: zipfile.ZipInfo) -> datetime | None:
    """Its time: in UTC where the archive has it so (the field UT of Info-ZIP), else without a zone; None when there is none."""
    extra, at = info.extra, 0
    while at + 4 <= len(extra):
        kind, length = struct.unpack_from("<HH", extra, at)
        if kind == 0x5455 and length >= 5 and at + 9 <= len(extra) and extra[at + 4] & 1:
            return datetime.fromtimestamp(struct.unpack_from("<I", extra, at + 5)[0], UTC)
        at += 4 + length
    try:
        return datetime(*info.date_time) if info.date_time[0] >= FIRST_YEAR else None
    except ValueError:
        return None
