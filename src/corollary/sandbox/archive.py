"""Archives and folders that were handed in: read in memory and within bounds for each student; no name in them becomes a path."""

from __future__ import annotations

import io
import os
import re
import stat
import struct
import unicodedata
import zipfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import IO

from corollary.sandbox.file import MOST_BYTES, Unreadable, bytes_of, too_large

DEEPEST = 3  # the archive of all, a student's own, and one that a student put into that
FIRST_YEAR = 1981  # 1980 is what an archive says that has no time
SKIPPED = {"__MACOSX", ".DS_Store", "Thumbs.db", "desktop.ini", ".ipynb_checkpoints"}
# Nothing else can be of use; some browsers save a notebook as text.
READ = (".ipynb", ".ipynb.txt", ".ipynb.json")
# A form that a student filled in, whatever an LMS put before its name.
REQUEST = re.compile(r"request[ _-].*\.(?:md|txt|markdown)$", re.IGNORECASE)
# The rest (bzip2, LZMA, Deflate64, PPMd) is unpacked in pieces of no bounded size, and no LMS writes it.
METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
OTHER_METHODS = {9: "Deflate64", 12: "bzip2", 14: "LZMA", 93: "Zstandard", 95: "xz", 98: "PPMd"}
# A student hands in one notebook, or a few; an archive of all has a thousand students with twenty files each.
MOST_OF_ONE = 100 << 20
MOST_READ_OF_ONE = 500
MOST_OTHERS_OF_ONE = 100
MOST_MEMBERS = 200_000
LONGEST_NAME = 255  # as file systems have it
MOST_FOLDERS = 40
MOST_INNER = 20_000  # of an archive in an archive
# What nobody is known to own, all together: text and drawings shrink to a tenth, and a bomb to a thousandth.
MOST_TIMES = 100
LEAST_BOUND = 500 << 20

Whose = Callable[[Sequence[str]], str]


@dataclass(frozen=True, slots=True)
class Member:
    """One file. `parts` are the names that lead to it, its own last; `modified` its time, where it has one, and whether
    that has a zone depends on the archive; `content` is None for what is neither a notebook nor a request for regrading."""

    parts: tuple[str, ...]
    content: bytes | Unreadable | None
    modified: datetime | None
    archive: str = ""

    @property
    def name(self) -> str:
        return "/".join(self.parts)


@dataclass(slots=True)
class _Share:
    """What one student's files may use of an archive, and have used: bytes unpacked, files read, other files met."""

    who: str
    most_bytes: int = MOST_OF_ONE
    most_read: int = MOST_READ_OF_ONE
    bytes: int = 0
    read: int = 0
    others: int = 0

    def refusal(self, size: int) -> Unreadable | None:
        """Counts a file before it is read; the reason why it is not, if it is one too many."""
        self.read += 1
        if self.read > self.most_read:
            return Unreadable(
                f"was not read: {self.who} hold more than {self.most_read} notebooks and archives"
            )
        if self.bytes + size > self.most_bytes:
            return Unreadable(
                f"was not read: {self.who} are larger than {self.most_bytes >> 20} MB when unpacked"
            )
        self.bytes += size
        return None

    def is_named(self) -> bool:
        """Counts a file that is not read; True while each is still named."""
        self.others += 1
        return self.others <= MOST_OTHERS_OF_ONE


@dataclass(slots=True)
class _Bounds:
    """The share of each student; what nobody is known to own has one share for all of it."""

    whose: Whose
    unowned: int = LEAST_BOUND
    shares: dict[str, _Share] = field(default_factory=dict[str, _Share])

    def of(self, parts: Sequence[str]) -> _Share:
        """The share that a file counts for."""
        owner = self.whose(parts)
        if owner not in self.shares:
            self.shares[owner] = (
                _Share(f"the files of {owner}")
                if owner
                else _Share("the files that name no student", self.unowned, MOST_MEMBERS)
            )
        return self.shares[owner]

    def left_out(self) -> Iterator[Member]:
        """One line for each student of whom more files were met than are named."""
        for owner, share in self.shares.items():
            if (more := share.others - MOST_OTHERS_OF_ONE) > 0:
                why = f"{more} more of {share.who} are no notebooks"
                yield Member((owner or "(other files)",), Unreadable(why), None)


def nobody(parts: Sequence[str]) -> str:
    """For files of which nothing says whose they are."""
    del parts
    return ""


def members(path: Path, whose: Whose = nobody) -> Iterator[Member]:
    """The files in a folder, in an archive, or the file itself; never raises for what is in them. What is refused is yielded
    with the reason in the place of its content. `whose` gives the student (or the number of an LMS) that the names leading to a
    file mean, "" where they mean nobody: each has bounds of their own."""
    bounds = _Bounds(whose)
    if path.is_dir():
        yield from _of_folder(path, bounds)
    elif path.suffix.lower() == ".zip" and path.is_file():
        try:
            with path.open("rb") as file:
                size = path.stat().st_size
                bounds.unowned = max(LEAST_BOUND, MOST_TIMES * size)
                yield from _of_archive(file, (), path.name, 1, bounds)
        except OSError as error:
            yield Member((path.name,), _unopened(error), None)
    else:
        yield from _of_file((path.name,), path, None, bounds)
    yield from bounds.left_out()


def _unopened(error: OSError) -> Unreadable:
    return Unreadable(f"cannot be opened: {error.strerror}", machine_failed=True)


def _of_folder(folder: Path, bounds: _Bounds) -> Iterator[Member]:
    unread = list[OSError]()
    for place, folders, names in os.walk(folder, onerror=unread.append):
        inside = Path(place).relative_to(folder).parts
        linked = [name for name in folders if (Path(place) / name).is_symlink()]
        folders[:] = sorted(name for name in folders if name not in SKIPPED and name not in linked)
        for name in linked:
            yield Member((*inside, name), Unreadable("is a link, which is not followed"), None)
        for name in folders:
            if name.lower().endswith(READ):
                yield Member((*inside, name), Unreadable("is a folder, not a notebook"), None)
        for name in sorted(names):
            if name not in SKIPPED and not name.startswith("._"):
                yield from _of_file((*inside, name), Path(place) / name, folder, bounds)
    for error in unread:
        parts = Path(error.filename).relative_to(folder).parts or (folder.name,)
        yield Member(parts, _unopened(error), None)


def _is_read(name: str) -> bool:
    """Whether a file of this name, in small letters, is opened: a notebook, an archive, a request for regrading."""
    return name.endswith((*READ, ".zip")) or REQUEST.search(name) is not None


def _of_file(parts: tuple[str, ...], path: Path, within: Path | None, bounds: _Bounds) -> Iterator[Member]:
    try:
        modified = datetime.fromtimestamp(path.lstat().st_mtime, UTC)
    except (OSError, OverflowError, ValueError):
        modified = None
    name = path.name.lower()
    if not _is_read(name):
        if bounds.of(parts).is_named():
            yield Member(parts, None, modified)
        return
    content = bytes_of(path, within=within)
    if isinstance(content, bytes):
        content = bounds.of(parts).refusal(len(content)) or content
    if name.endswith(".zip") and isinstance(content, bytes):
        yield from _of_archive(io.BytesIO(content), parts, "/".join(parts), 2, bounds)
    else:
        yield Member(parts, content, modified)


def _of_archive(
    file: IO[bytes], inside: tuple[str, ...], label: str, depth: int, bounds: _Bounds
) -> Iterator[Member]:
    whole = inside or (label,)
    if depth > DEEPEST:
        yield Member(whole, Unreadable("is an archive in an archive in an archive"), None)
        return
    archive = _opened(file, MOST_MEMBERS if depth == 1 else MOST_INNER)
    if isinstance(archive, Unreadable):
        yield Member(whole, archive, None)
        return
    with archive:
        if not archive.infolist():
            yield Member(whole, Unreadable("is an archive with nothing in it"), None)
        for info in archive.infolist():
            member = _member(archive, info, inside, label, bounds)
            if member is None:
                continue
            if member.parts[-1].lower().endswith(".zip") and isinstance(member.content, bytes):
                yield from _of_archive(io.BytesIO(member.content), member.parts, label, depth + 1, bounds)
            else:
                yield member


def _opened(file: IO[bytes], most: int) -> zipfile.ZipFile | Unreadable:
    try:
        archive = zipfile.ZipFile(file)
    except (
        Exception
    ) as error:  # of whatever kind: the bytes are a stranger's, and zipfile says so in a dozen ways
        return Unreadable(f"is not an archive that can be opened{_reason(error)}")
    if (count := len(archive.infolist())) > most:
        archive.close()
        return Unreadable(f"holds {count} files, more than {most}, so it was not read")
    return archive


def _member(
    archive: zipfile.ZipFile, info: zipfile.ZipInfo, inside: tuple[str, ...], label: str, bounds: _Bounds
) -> Member | None:
    """One member of an archive; None for a folder, for what an operating system put there, and for what is only counted."""
    parts = tuple(part for part in _name(info).replace("\\", "/").split("/") if part)
    if info.filename.endswith("/"):
        return None
    if not parts:
        return Member((*inside, "(a file without a name)"), Unreadable("has no name"), None, label)
    if SKIPPED & set(parts) or parts[-1].startswith("._"):
        return None
    content = _refusal(info, parts)
    if len(parts) > MOST_FOLDERS or max(map(len, parts)) > LONGEST_NAME:
        parts, content = (
            tuple(part[:40] for part in parts[:3]),
            Unreadable("has a name longer than a file's can be"),
        )
    wanted = _is_read(parts[-1].lower())
    if content is None and wanted and info.file_size > MOST_BYTES:
        content = too_large(MOST_BYTES)
    elif content is None and wanted:
        # Counted as what it says of itself, and also where it turns out to be damaged: more than that is not unpacked.
        share = bounds.of((*inside, *parts))
        content = share.refusal(max(info.file_size, 0)) or _content(archive, info)
    elif content is None and not bounds.of((*inside, *parts)).is_named():
        return None
    return Member((*inside, *parts), content, _time(info), label)


def _refusal(info: zipfile.ZipInfo, parts: tuple[str, ...]) -> Unreadable | None:
    if ".." in parts or info.filename.startswith(("/", "\\")) or parts[0].endswith(":"):
        return Unreadable("has a name that leads out of the archive")
    if stat.S_ISLNK(info.external_attr >> 16):
        return Unreadable("is a link, which is not followed")
    if info.flag_bits & 1:
        return Unreadable("is locked with a password")
    if info.compress_type not in METHODS:
        how = OTHER_METHODS.get(info.compress_type, f"method {info.compress_type}")
        return Unreadable(f"is packed with {how}, which is not unpacked here; pack it as an ordinary zip")
    return None


def _content(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> bytes | Unreadable:
    try:
        with archive.open(info) as file:
            content = file.read(MOST_BYTES + 1)
    except Exception as error:  # of whatever kind, as above
        return Unreadable(f"is damaged{_reason(error)}")
    return content if len(content) <= MOST_BYTES else too_large(MOST_BYTES)


def _reason(error: Exception) -> str:
    """What zipfile says in a sentence of its own; nothing where it stumbled over the bytes."""
    return f" ({error})" if isinstance(error, zipfile.BadZipFile) and str(error).isprintable() else ""


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
