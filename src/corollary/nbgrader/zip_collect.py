"""`nbgrader zip_collect` in a course of ours: no pattern has to be written for the names of an LMS's files."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import cast

from nbgrader.apps import ZipCollectApp
from nbgrader.coursedir import CourseDirectory
from nbgrader.plugins.zipcollect import ExtractorPlugin, FileNameCollectorPlugin

from corollary.atomic import write_whole
from corollary.guard import Failure, guarded
from corollary.notebook.locate import origin
from corollary.records.files import open_course, students
from corollary.records.lms_names import Directory, again, file_words, lms_name
from corollary.records.submissions import stamp, writable
from corollary.sandbox.archive import Member, members
from corollary.sandbox.file import bytes_of
from corollary.sandbox.notebook_file import Notebook, notebook_of

LONGEST = 30.0  # seconds of the processor for one file
LONGEST_NAME = 200  # bytes; nbgrader and the number of a second one add some


class BoundedExtractor(ExtractorPlugin):
    """Unpacks archives, and archives in archives, within bounds; what is refused is named, and the rest is unpacked."""

    def extract(self, archive_path: str, extracted_path: str) -> None:
        for number, member in enumerate(members(Path(archive_path), _outermost)):
            done = guarded(partial(self._put, member, number, Path(extracted_path)))
            if isinstance(done, Failure):
                self.log.error(
                    "%s cannot be unpacked (%s), and is left out", writable(member.name), done.what
                )

    def _put(self, member: Member, number: int, folder: Path) -> None:
        if not isinstance(member.content, bytes):
            why = "is not a notebook" if member.content is None else member.content.in_english
            self.log.warning("%s %s, and is left out", writable(member.name), why)
            return
        place = folder.joinpath(*map(file_name, member.parts))
        if place.stem.lower().endswith(".ipynb"):  # saved as text; nbgrader looks at notebooks only
            place = place.with_suffix("")
        if place.exists():
            place = place.with_name(f"{place.stem} ({number}){place.suffix}")
        write_whole(place, member.content)


class OwnerCollector(FileNameCollectorPlugin):
    """Whose a notebook is, by the name that Moodle or Canvas gave it, by an id or name in its own, and then by its metadata;
    of several of one student, nbgrader takes the one with the latest moment."""

    def collect(self, submitted_file: str) -> dict[str, str] | None:
        found = guarded(partial(self._owner, submitted_file), LONGEST)
        if not isinstance(found, Failure):
            return found
        self.log.error("%s could not be read (%s), and is left out", writable(submitted_file), found.what)
        return None

    def _owner(self, submitted_file: str) -> dict[str, str] | None:
        path = Path(submitted_file)
        app = self.parent
        coursedir = cast(CourseDirectory, app.coursedir) if isinstance(app, ZipCollectApp) else None
        root = Path(coursedir.root) if coursedir is not None else Path.cwd()
        if self.named_regexp or not (root / ".corollary" / "key").is_file():
            return super().collect(submitted_file)
        name = str(coursedir.assignment_id) if coursedir is not None else ""
        content = bytes_of(path) if path.suffix == ".ipynb" else None
        read = notebook_of(content) if isinstance(content, bytes) else None
        if not isinstance(read, Notebook):
            return None
        says = origin(read.node)
        if says.set_name not in ("", name):
            self.log.warning("%s is a notebook of %s, and is left out", path.name, says.set_name)
            return None
        roster = students(open_course(root))
        directory, parts = (
            Directory(roster),
            _below(path, app.extracted_directory if isinstance(app, ZipCollectApp) else ""),
        )
        lms = lms_name(parts)
        owner = directory.of_file(parts, name)
        known = says.student in {each.id for each in roster}
        # A name of somebody else's outweighs what the notebook says of itself.
        if owner is None and known and (lms is None or directory.admits(lms, says.student)):
            owner = says.student
        if owner is None:
            self.log.warning("%s does not name its student", submitted_file)
            return None
        # Of equal moments nbgrader takes the last, and files come in the order of their names: a second one says so in its name.
        when = datetime.fromtimestamp(int(path.stat().st_mtime), UTC).replace(
            microsecond=min(999_999, again(path.stem)[1])
        )
        return {"student_id": owner, "file_id": name, "timestamp": stamp(when)}


def _below(path: Path, extracted: str) -> tuple[str, ...]:
    """The names from the folder of what was unpacked on: the outermost say whose a file is."""
    parts = path.parts
    return parts[parts.index(extracted) + 1 :] if extracted in parts else parts[-2:]


def _outermost(parts: Sequence[str]) -> str:
    """Whose a file of an archive is, as far as bounds go: what an LMS knows the student by, else the folder it lies in."""
    if lms := lms_name(parts):
        return f"{lms.name} ({lms.key})"
    return parts[0] if len(parts) > 1 else ""


def file_name(part: str) -> str:
    """A name of a file as it was, but for what could lead elsewhere, and not longer than one can be; the _ by which LMSs part
    names stays, and so does its ending."""
    name = "_".join(file_words(piece) if piece else "" for piece in part.split("_"))
    stem, ending = (name[:-6], name[-6:]) if name.lower().endswith(".ipynb") else (name, "")
    return stem.encode("utf-8", "replace")[:LONGEST_NAME].decode("utf-8", "ignore") + ending
