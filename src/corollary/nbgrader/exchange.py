"""nbgrader's exchange in which each student fetches the own sheet: rights, release and collection."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

import os
import shutil
import stat
import struct
import sys
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, suppress
from datetime import datetime
from functools import partial
from io import StringIO
from pathlib import Path
from typing import Any, cast

from nbgrader.coursedir import CourseDirectory
from nbgrader.exchange.default import (
    ExchangeCollect,
    ExchangeFetchAssignment,
    ExchangeList,
    ExchangeReleaseAssignment,
    ExchangeReleaseFeedback,
    ExchangeSubmit,
)
from nbgrader.utils import get_username

from corollary.atomic import umask_of, write_whole
from corollary.guard import Failure, guarded
from corollary.messages import few
from corollary.nbgrader.gradebook import directory, need_nbgrader, programs_on_path
from corollary.records.assignments import is_assigned
from corollary.records.files import BESIDE, Course, open_course, students
from corollary.records.marks import feedback_place
from corollary.records.notebook_archive import restore_sheet, unfolded
from corollary.records.regrade_requests import is_request
from corollary.records.submissions import STAMP, beside, writable
from corollary.sandbox.file import bytes_of

ACCESS_LIST, FOR_NEW, READ, SEARCH = "system.posix_acl_access", "system.posix_acl_default", 4, 5
FOLDER_RIGHTS, FILE_RIGHTS, SHARED = 0o755, 0o644, 0o060


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


def make_ordinary(folder: Path, shared: bool = False) -> None:
    """Take the access lists off a folder and all that is in it; its owner may write, and others read as far as the umask says.

    A copy by `shutil.copytree` takes the lists and the modes of its source along. `shared`: the group may write, too.
    """
    umask = os.umask(0o077)
    os.umask(umask)
    for place, _, names in os.walk(folder):
        for path in (place, *(os.path.join(place, each) for each in names)):
            if os.path.islink(path) or os.geteuid() not in (0, os.stat(path).st_uid):
                continue
            if sys.platform == "linux":
                for each in (ACCESS_LIST, FOR_NEW):
                    with suppress(OSError):  # it has none, or the file system knows none
                        os.removexattr(path, each)
            mode = os.stat(path).st_mode
            rights = FOLDER_RIGHTS if stat.S_ISDIR(mode) else FILE_RIGHTS
            os.chmod(path, (mode & stat.S_ISGID) | (rights & ~umask) | (shared and SHARED))


INSTEAD = "give the sheets out with corollary release --to zip, mail, moodle or canvas instead"
MOST_NAMED = 5
NO_TIME = datetime.min


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
        for student, place in sheets.items():
            self._give(place, destination / student, cast(int, accounts[student]))

    def _refuse_without_separation(self, accounts: dict[str, int | None]) -> None:
        if without := [student for student, account in accounts.items() if account is None]:
            self.fail(
                f"{few(without, MOST_NAMED)} have no account on this machine, so their sheets cannot be for them alone; {INSTEAD}"
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


class FetchOwnSheet(ExchangeFetchAssignment):
    """Fetch: from the student's own folder, where there are such. Students' nbgrader needs it in its configuration."""

    def init_src(self) -> None:
        super().init_src()
        self.src_path = _own(self.src_path, cast(CourseDirectory, self.coursedir))

    def do_copy(self, src: str, dest: str) -> None:
        """The list by which the sheet was opened for its student does not go home with it, nor on to inbound."""
        super().do_copy(src, dest)
        make_ordinary(Path(dest))


class SubmitOwnSheet(ExchangeSubmit):
    """Submit: what was handed in is held against the own sheet, when nbgrader looks whether a notebook is missing."""

    def init_release(self) -> None:
        super().init_release()
        self.release_path = _own(self.release_path, cast(CourseDirectory, self.coursedir))

    def do_copy(self, src: str, dest: str, log: Any = None) -> None:
        """Whatever rights the student's files have, the instructor can read the copy, and the student add the time to it."""
        super().do_copy(src, dest, log)
        make_ordinary(Path(dest))


class CollectFromEach(ExchangeCollect):
    """Collect: what one student handed in cannot keep the others' from being collected. Who is left out is named."""

    def _path_to_record(self, path: str) -> dict[str, Any]:
        try:
            return cast(dict[str, Any], super()._path_to_record(path))
        except Exception:  # anybody may give a folder in inbound any name
            name = os.path.basename(path)
            return {"username": name.partition("+")[0], "filename": name, "timestamp": NO_TIME}

    def copy_files(self) -> None:
        to_collect: list[dict[str, Any]] = []
        for each in self.src_records:
            fault = guarded(partial(self._fault, each))
            if fault := fault.what if isinstance(fault, Failure) else fault:
                self._leave_out(each["username"], each["filename"], fault)
            else:
                to_collect.append(each)
        root = Path(str(cast(CourseDirectory, self.coursedir).root))
        for each in to_collect:
            self.src_records = [each]
            with umask_of(root):
                before = self._notebooks(each["username"])
                done = guarded(super().copy_files)
                self._same_time(each["username"], before)
            if isinstance(done, Failure):  # such as a timestamp.txt that holds no time, with --update
                self._leave_out(each["username"], each["filename"], done.what)
        self.src_records = to_collect

    def _notebooks(self, student: str) -> tuple[dict[str, bytes], bytes]:
        """What lies in the course of this student: the notebooks, and when they were handed in."""
        coursedir = cast(CourseDirectory, self.coursedir)
        place = Path(coursedir.format_path(coursedir.submitted_directory, student, coursedir.assignment_id))
        contents = {each.name: bytes_of(each) for each in place.glob("*.ipynb")}
        stamped = bytes_of(place / STAMP, 1 << 10)
        course = _ours(Path(str(coursedir.root)))
        whole = {
            name: content if course is None else unfolded(course, content)
            for name, content in contents.items()
            if isinstance(content, bytes)
        }
        return whole, stamped if isinstance(stamped, bytes) else b""

    def _same_time(self, student: str, before: tuple[dict[str, bytes], bytes]) -> None:
        """Who hands in the same notebooks again, with a request for regrading, handed them in when they came first."""
        coursedir = cast(CourseDirectory, self.coursedir)
        name = str(coursedir.assignment_id)
        place = Path(coursedir.format_path(coursedir.submitted_directory, student, name))
        notebooks, stamped = before
        asks = place.is_dir() and any(is_request(each.name, name) for each in place.iterdir())
        if asks and notebooks and stamped and self._notebooks(student)[0] == notebooks:
            write_whole(place / STAMP, stamped)

    def do_copy(self, src: str, dest: str, log: Any = None) -> None:
        try:
            super().do_copy(src, dest, log)
        except (OSError, RuntimeError) as error:  # it changed since it was looked at
            shutil.rmtree(dest, ignore_errors=True)
            self._leave_out(Path(dest).parent.name, os.path.basename(src), str(error))
            return
        make_ordinary(Path(dest), shared=bool(cast(CourseDirectory, self.coursedir).groupshared))

    def _fault(self, record: dict[str, Any]) -> str:
        """Why it cannot be collected; empty where it can."""
        place = os.path.join(str(self.inbound_path), record["filename"])
        most = 1000 * cast(CourseDirectory, self.coursedir).max_dir_size
        if record["timestamp"] == NO_TIME:
            return "its name holds no time"
        if unreadable := next(_unreadable(place), None):
            return f"{os.path.relpath(unreadable, place)} cannot be read, or is neither a file nor a folder"
        return f"it is larger than {most // 1_000_000} MB" if self.get_size(place) > most else ""

    def _leave_out(self, student: str, name: str, fault: str) -> None:
        self.log.warning(
            "The hand-in %s of %s is left out: %s; ask %s to submit again", name, student, fault, student
        )


class ListEach(ExchangeList):
    """List: what was handed in that cannot be read is left out and named, and the others are listed."""

    def parse_assignments(self) -> list[dict[str, Any]]:
        if self.inbound or self.cached:
            self.assignments = [each for each in self.assignments if self._can_be_listed(each)]
        return cast(list[dict[str, Any]], super().parse_assignments())

    def _can_be_listed(self, place: str) -> bool:
        """Whether it is listed on its own; why not is said."""
        self.assignments = [place]
        parse = cast(Callable[[], object], super().parse_assignments)
        unreadable = guarded(lambda: next(_unreadable(place), None))
        done = guarded(parse) if unreadable is None else unreadable
        if unreadable is not None or isinstance(done, Failure):
            why = done.what if isinstance(done, Failure) else "it, or a file in it, cannot be read"
            self.log.warning("%s is left out: %s", writable(os.path.basename(place)), why)
            return False
        return True


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
        for page in Path(str(self.dest_path)).glob("*.html"):  # known by its name to its student alone
            if page.stat().st_uid == os.geteuid():
                page.chmod(FILE_RIGHTS)


def _unreadable(place: str) -> Iterator[str]:
    """What in a folder cannot be read, or is a link or device, which may lead anywhere."""
    if os.path.islink(place) or not os.path.isdir(place) or not os.access(place, os.R_OK | os.X_OK):
        yield place
        return
    with os.scandir(place) as entries:
        for each in entries:
            if each.is_dir(follow_symlinks=False):
                yield from _unreadable(each.path)
            elif not each.is_file(follow_symlinks=False) or not os.access(each.path, os.R_OK):
                yield each.path


def _own_sheets(root: Path, name: str) -> dict[str, Path]:
    """The folder with the own sheet of each student; none where the course or the assignment is none of ours."""
    course = _ours(root)
    if course is None:
        return {}
    places = {each.id: root / "release" / each.id / name for each in students(course)}
    for student in places:
        restore_sheet(course, name, student)
    return {student: place for student, place in places.items() if place.is_dir()}


def _can_be_fetched(course: Course, name: str, student: str) -> bool:
    """Whether what nbgrader finds a page by lies beside it, put there from what was handed in where it is missing."""
    place = course.place("feedback", student, name)
    for each in BESIDE:
        if not _is_text(place / each) and (content := beside(course, name, student, each)):
            write_whole(place / each, content)
    return all(_is_text(place / each) for each in BESIDE)


def _is_text(file: Path) -> bool:
    """Whether nbgrader, which reads it as text, gets over it: a student may hand in any bytes by that name."""
    content = bytes_of(file, 1 << 10)
    try:
        return isinstance(content, bytes) and bool(content.decode())
    except UnicodeDecodeError:
        return False


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


def release_in_exchange(course: Course, name: str, force: bool) -> str:
    """Releases; what stands in the way is said in a sentence, empty when nothing does. Raises NoNbgrader, BrokenConfig."""
    need_nbgrader()
    from nbgrader.apps import NbGraderAPI
    from nbgrader.exchange import ExchangeFactory

    place = directory(course)
    config = place.config
    theirs = ExchangeFactory(config=config).release_assignment
    if not issubclass(theirs, ReleaseOwnSheets):
        return (
            f"{theirs.__module__}.{theirs.__name__}, which nbgrader_config.py names, gives everybody the same notebook, with the "
            f"chapter's numbers (ngshare has one folder for all); {INSTEAD}"
        )
    if force:
        config.ExchangeReleaseAssignment.force = True
        config.ReleaseOwnSheets.force = True
    with programs_on_path(), redirect_stderr(StringIO()):
        result = NbGraderAPI(place, config=config).release_assignment(name)
    if result["success"]:
        return ""
    lines = [
        line for line in f"{result.get('log', '')}\n{result.get('error', '')}".splitlines() if line.strip()
    ]
    failures = [line for line in lines if "CRITICAL" in line or "ERROR" in line or "ExchangeError" in line]
    return (failures or lines or ["nbgrader gave no reason"])[0].partition("] ")[2].strip() or (
        failures or lines
    )[0].strip()
