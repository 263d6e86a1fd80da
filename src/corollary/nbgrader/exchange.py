"""nbgrader's exchange in a course of ours: each student gets the own sheet, in a folder that nobody else can read.

`outbound/SET/STUDENT/` belongs to the student and is closed to all others, so that it does not matter what a student's own
configuration says. Where that cannot be had, nothing is released, and a sentence says what to do instead.
"""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

import os
import shutil
import struct
import sys
from pathlib import Path
from typing import cast

from nbgrader.coursedir import CourseDirectory
from nbgrader.exchange.default import (
    ExchangeFetchAssignment,
    ExchangeReleaseAssignment,
    ExchangeReleaseFeedback,
    ExchangeSubmit,
)
from nbgrader.utils import get_username

from corollary.atomic import write_whole
from corollary.messages import few
from corollary.records.assigned import is_assigned
from corollary.records.files import BESIDE, Course, open_course, students
from corollary.records.hand_in_time import beside
from corollary.records.marks import feedback_place

INSTEAD = "give the sheets out with corollary release --to zip, mail, moodle or canvas instead"
MOST_NAMED = 5
ACCESS_LIST, READ, SEARCH = "system.posix_acl_access", 4, 5


class ReleaseOwnSheets(ExchangeReleaseAssignment):
    """Release: every student's own sheet in the place of the chapter's numbers for everybody. Other assignments as ever."""

    def copy_files(self) -> None:
        coursedir = cast(CourseDirectory, self.coursedir)
        root, name = Path(coursedir.root), str(coursedir.assignment_id)
        if sheets := _own_sheets(root, name):
            self._release(sheets, Path(self.dest_path))
            self.log.info(
                "Released the own sheets of %s students: %s %s", len(sheets), coursedir.course_id, name
            )
        else:  # an assignment of the owner's own, with the same notebook for everybody
            super().copy_files()

    def _release(self, sheets: dict[str, Path], destination: Path) -> None:
        accounts = {student: _account(student) for student in sheets}
        self._refuse_without_separation(accounts)
        if destination.is_dir() and not self.force:
            self.fail(
                f"{destination.name} is released already; --force releases it again, with the sheets of students who were added"
            )
        destination.mkdir(mode=0o755, exist_ok=True)
        destination.chmod(0o755)
        for each in destination.iterdir():
            if not each.is_dir():  # the chapter's numbers, released by an older version
                each.unlink()
        for student, place in sheets.items():
            self._give(place, destination / student, cast(int, accounts[student]))

    def _refuse_without_separation(self, accounts: dict[str, int | None]) -> None:
        if without := [student for student, account in accounts.items() if account is None]:
            more = f" and {len(without) - MOST_NAMED} more" if len(without) > MOST_NAMED else ""
            listed = ", ".join(without[:MOST_NAMED]) + more
            self.fail(
                f"{listed} have no account on this machine, so their sheets cannot be for them alone; {INSTEAD}"
            )
        if os.geteuid() != 0 and sys.platform != "linux":
            self.fail(
                f"only root, or Linux's access lists, can give each student a folder that nobody else can read; {INSTEAD}"
            )

    def _give(self, place: Path, destination: Path, account: int) -> None:
        """The files are moved into place when they are readable for their student alone, and for nobody in between."""
        draft = destination.with_name(f".{destination.name}.draft")
        shutil.rmtree(draft, ignore_errors=True)
        draft.mkdir(mode=0o700)
        for source in sorted(place.iterdir()):
            if source.is_file() and not source.is_symlink():
                shutil.copyfile(source, draft / source.name)
                (draft / source.name).chmod(0o600)
                self._hand_over(draft / source.name, account)
        self._hand_over(draft, account)
        shutil.rmtree(destination, ignore_errors=True)
        draft.rename(destination)

    def _hand_over(self, path: Path, account: int) -> None:
        try:
            open_for(path, account)
        except OSError as error:
            self.fail(f"{path} cannot be opened for its student alone ({error.strerror}); {INSTEAD}")


def open_for(path: Path, account: int) -> None:
    """Lets an account read what nobody else but its owner can: by root it becomes the owner; anybody else writes it into the
    access list of what is the own. Raises OSError where the file system has no such lists."""
    if os.geteuid() == 0:
        os.chown(path, account, -1)
    else:
        os.setxattr(path, ACCESS_LIST, access_list(account, SEARCH if path.is_dir() else READ))


def access_list(account: int, rights: int) -> bytes:
    """Linux's access list (acl(5), `posix_acl_xattr.h`) by which the owner may do everything, the account this, and nobody else
    anything."""
    everything, nothing, of_none = 7, 0, 0xFFFFFFFF
    entries = (
        (0x01, everything, of_none),  # the owner
        (0x02, rights, account),
        (0x04, nothing, of_none),  # the group
        (0x10, rights, of_none),  # the most that an account or the group gets
        (0x20, nothing, of_none),  # all others
    )
    return struct.pack("<I", 2) + b"".join(struct.pack("<HHI", *each) for each in entries)


class FetchOwnSheet(ExchangeFetchAssignment):
    """Fetch: from the student's own folder, where there are such. Students' nbgrader needs it in its configuration."""

    def init_src(self) -> None:
        super().init_src()
        self.src_path = _own(self.src_path, cast(CourseDirectory, self.coursedir))


class SubmitOwnSheet(ExchangeSubmit):
    """Submit: what was handed in is held against the own sheet, when nbgrader looks whether a notebook is missing."""

    def init_release(self) -> None:
        super().init_release()
        self.release_path = _own(self.release_path, cast(CourseDirectory, self.coursedir))


class ReleaseOwnFeedback(ExchangeReleaseFeedback):
    """Feedback: to those who handed in through the exchange. The pages of others have no place in it, and it is said whose."""

    def copy_files(self) -> None:
        coursedir = cast(CourseDirectory, self.coursedir)
        name, course = str(coursedir.assignment_id), _ours(Path(coursedir.root))
        if course is None or not is_assigned(course, name):
            super().copy_files()
            return
        pages = [each.id for each in students(course) if feedback_place(course, name, each.id).is_file()]
        if not pages:
            self.fail(f"nobody has a feedback page of {name}; run corollary grade {name}, then release again")
        without = [student for student in pages if not _can_be_fetched(course, name, student)]
        if without:
            self.log.warning(
                "%s did not hand in %s through this exchange, so their pages cannot be fetched from it; "
                "give them back with corollary export %s --to feedback-zip, or by mail",
                few(without, MOST_NAMED),
                name,
                name,
            )
            coursedir.student_id_exclude = ",".join(
                (*filter(None, (coursedir.student_id_exclude,)), *without)
            )
        super().copy_files()


def _own_sheets(root: Path, name: str) -> dict[str, Path]:
    """The folder with the own sheet of each student; none where the course or the assignment is none of ours."""
    course = _ours(root)
    places = {each.id: root / "release" / each.id / name for each in students(course)} if course else {}
    return {student: place for student, place in places.items() if place.is_dir()}


def _can_be_fetched(course: Course, name: str, student: str) -> bool:
    """Whether what nbgrader finds a page by lies beside it, put there from what was handed in where it is missing."""
    place = course.place("feedback", student, name)
    for each in BESIDE:
        if not (place / each).is_file() and (content := beside(course, name, student, each)):
            write_whole(place / each, content)
    return all((place / each).is_file() for each in BESIDE)


def _ours(root: Path) -> Course | None:
    return open_course(root) if (root / ".corollary" / "key").is_file() else None


def _own(path: str, coursedir: CourseDirectory) -> str:
    student = str(coursedir.student_id)
    own = os.path.join(path, get_username() if student in {"", "*"} else student)
    return own if os.path.isdir(own) else path


def _account(student: str) -> int | None:
    try:
        import pwd  # Windows has none, nor accounts by which an exchange could tell students apart

        return pwd.getpwnam(student).pw_uid
    except (KeyError, ModuleNotFoundError):
        return None
