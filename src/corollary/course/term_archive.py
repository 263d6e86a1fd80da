"""Archive of a term: what of a course must be stored, in one file that says until when, and the check of that date."""

from __future__ import annotations

import json
import os
import tempfile
import zipfile
from collections.abc import Callable, Iterator
from datetime import UTC, date, datetime
from pathlib import Path

from corollary.atomic import rights_in
from corollary.problem.diagnostic import Finding
from corollary.records.assignments import sets_with_numbers
from corollary.records.files import Course
from corollary.version import __version__

ABOUT = "corollary-archive.json"
MADE_AGAIN = ("autograded", "export", "given_out", "release", "source")  # from what is in the archive
LOCK = (".corollary", "lock")


def write_archive(
    course: Course, until: date, place: Path, progress: Callable[[str], None] = lambda name: None
) -> int:
    """Writes the archive whole or not at all, readable for its owner alone, and in a shared course for the team; returns how many files are in it. Raises OSError."""
    place.parent.mkdir(parents=True, exist_ok=True)
    handle, draft = tempfile.mkstemp(dir=place.parent, prefix=f".{place.name}.")
    os.close(handle)
    try:
        with zipfile.ZipFile(draft, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(ABOUT, json.dumps(_about(course, until), indent=1, ensure_ascii=False))
            count = 0
            for name, path in _files(course, {place.resolve(), Path(draft).resolve()}):
                progress(name)
                archive.write(path, f"{course.name}/{name}")
                count += 1
        os.chmod(draft, rights_in(place.parent, 0o600))
        os.replace(draft, place)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise
    return count


def archive_findings(folder: Path | None) -> Iterator[Finding]:
    """One finding for each archive in the course's folder, the one above it, or the working folder: whether its date has passed."""
    looked_in = [Path.cwd()] if folder is None else [folder.resolve(), folder.resolve().parent, Path.cwd()]
    for path in dict.fromkeys(path for place in looked_in for path in sorted(place.glob("*.zip"))):
        until = keep_until(path)
        if until is None:
            continue
        if until < datetime.now(UTC).date():
            yield Finding("archive", "weak", f"{path} was to be stored until {until}", f"delete {path}")
        else:
            yield Finding("archive", "good", f"{path}, to be stored until {until}")


def keep_until(path: Path) -> date | None:
    """The date that an archive of a term says; None for any other file."""
    try:
        with zipfile.ZipFile(path) as archive:
            if archive.getinfo(ABOUT).file_size > 1 << 20:
                return None
            return date.fromisoformat(json.loads(archive.read(ABOUT))["keep_until"])
    except (OSError, zipfile.BadZipFile, KeyError, ValueError, TypeError, NotImplementedError, RuntimeError):
        return None


def _about(course: Course, until: date) -> dict[str, object]:
    return {
        "course": course.name,
        "made": datetime.now(UTC).isoformat(timespec="seconds"),
        "keep_until": until.isoformat(),
        "corollary": __version__,
        "sets": sets_with_numbers(course),
        "left_out": [f"{name}/" for name in MADE_AGAIN if (course.folder / name).is_dir()],
        "to_open": "unpack it, and run corollary report SET --course FOLDER --bank DIR",
    }


def _files(course: Course, without: set[Path]) -> Iterator[tuple[str, Path]]:
    for folder, names, files in os.walk(course.folder):
        here = Path(folder)
        if here == course.folder:
            names[:] = [name for name in names if name not in MADE_AGAIN]
        names[:] = sorted(name for name in names if name != ".git")
        for name in sorted(files):
            path = here / name
            parts = path.relative_to(course.folder).parts
            regular = path.is_file() and not path.is_symlink()
            if (
                regular
                and parts != LOCK
                and path.resolve() not in without
                and (path.suffix != ".zip" or keep_until(path) is None)
            ):
                yield "/".join(parts), path
