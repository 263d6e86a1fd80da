"""The names that Moodle and Canvas give to files of students when all are downloaded, and take back when they are uploaded."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from corollary.problem.roster import Student

# Moodle (mod/assign, downloader): "Ada Lovelace_17_assignsubmission_file_/week1.ipynb", without the last _ since 4.1, or all of it
# in one name where folders are switched off. No _ can stand in the name.
MOODLE = re.compile(
    r"(?P<name>[^_/]+)_(?P<participant>\d+)_assign(?:submission|feedback)_(?P<plugin>[a-z]+)(?:_(?P<file>.*))?$"
)
# Canvas (lib/content_zipper.rb): "lovelaceada_LATE_2001_5678_week1-1.ipynb", with "_LATE" only where it was.
CANVAS = re.compile(
    r"(?P<name>[^_/]+(?:_[^\d_/][^_/]*)*?)(?P<late>_LATE)?_(?P<user>\d+)_(?P<attachment>\d{1,20})_(?P<file>.+)$"
)
CANVAS_TEXT = re.compile(r"(?P<name>[^_/]+)(?P<late>_LATE)?_(?P<user>\d+)_(?:text|link)\.html$")
AGAIN = re.compile(r"(?:[ _]?\((\d{1,6})\)|[ _-]+(?:copy|kopi|kopie|copie)|-(\d{1,6}))$", re.IGNORECASE)
NAMELESS = ("participant", "teilnehm", "deltak", "anon")  # in the place of a name where marking is blind
CANVAS_IDS = ("ID", "SIS User ID", "SIS Login ID")  # in the order of Canvas's gradebook
# Columns of Canvas's own, whatever else is in the title: its import leaves them out, and says nothing.
_CANVAS_OWN = (
    re.compile(r"\b(?:current|final|override)\b"),
    re.compile(r"\b(?:scores?|points?|grades?|status)\b"),
)
LEFT_OUT = "Canvas leaves out a column with Final, Current or Override and Score, Points, Grade or Status in its title"
UNSAFE = re.compile(r'[\x00-\x1f/\\:*?"<>|_]+')


def is_left_out(title: str) -> bool:
    """True if Canvas takes a column of this title for one of its own."""
    return all(word.search(title.casefold()) for word in _CANVAS_OWN)


@dataclass(frozen=True, slots=True)
class LmsName:
    """What such a name says. `number` is Moodle's participant or Canvas's user; `attachment` is Canvas's file; `late`
    is None where the name does not say."""

    lms: str
    name: str
    number: str
    file: str
    attachment: str = ""
    late: bool | None = None

    @property
    def key(self) -> str:
        """The number with its LMS, such as "moodle 17"."""
        return f"{self.lms} {self.number}"


def lms_name(parts: Sequence[str]) -> LmsName | None:
    """What the names that lead to a file say; None when no LMS made them. The outermost counts: what lies inside a student's
    own archive was named by the student."""
    for at, part in enumerate(parts):
        inside = parts[at + 1 :]
        if match := MOODLE.match(part):
            return LmsName(
                "moodle",
                match["name"],
                match["participant"],
                "/".join(filter(None, (match["file"], *inside))),
            )
        if match := CANVAS.match(part):
            file, late = "/".join((match["file"], *inside)), bool(match["late"])
            return LmsName("canvas", match["name"], match["user"], file, match["attachment"], late)
        if match := CANVAS_TEXT.match(part):
            return LmsName("canvas", match["name"], match["user"], part, "", bool(match["late"]))
    return None


def canvas_ids(student: Student) -> dict[str, str]:
    """What Canvas knows a student by, under its own headings, where its gradebook was the roster; `ID` alone may be anybody's."""
    theirs = {heading: value for heading, value in student.ids if heading in CANVAS_IDS}
    return theirs if theirs.keys() != {"ID"} else {}


def moodle_folder(student: Student, participant: str, plugin: str = "file") -> str:
    """The folder whose files Moodle's "Upload multiple feedback files in a zip" gives to this participant."""
    return f"{file_words(student.name)}_{participant}_assignsubmission_{plugin}_"


def canvas_file(student: Student, user: str, attachment: str, file: str) -> str:
    """The name by which Canvas's bulk upload finds the submission that a file belongs to: user and attachment are looked up."""
    name = re.sub(r"[\W_]", "", f"{student.last_name}{student.first_name}" or student.id).lower()
    return f"{name if not name.isdecimal() else f'student{name}'}_{user}_{attachment}_{file}"


def file_words(text: str) -> str:
    """A text as a part of a file's name on every computer, without the _ that LMSs part names by."""
    return " ".join(UNSAFE.sub(" ", text).split()).strip(". ") or "student"


def again(stem: str) -> tuple[str, int]:
    """A file's name without what browsers and LMSs append to a second one of the name (`week1 (1)`, `week1-1`), and its number."""
    match = AGAIN.search(stem)
    return (stem[: match.start()], int(match[1] or match[2] or 1)) if match else (stem, 0)


class Directory:
    """Finds the student that a name or number of an LMS, or the name of a file, means; None when it is nobody or several."""

    def __init__(
        self,
        students: Iterable[Student],
        numbers: Mapping[str, str] | None = None,
        worksheet: Mapping[str, str] | None = None,
    ):
        """`numbers` are those of an LMS that are known from elsewhere, with the id of the student; those of a `worksheet`, which
        may be another assignment's, only tell apart those who have one name."""
        self._students = tuple(students)
        self._by_number, self._in_worksheet = dict(numbers or {}), dict(worksheet or {})
        self._names: dict[str, set[str]] = {}
        self._ids: dict[str, set[str]] = {}
        self._words: dict[str, set[str]] = {}
        for each in self._students:
            words = {_letters(word) for word in f"{each.first_name} {each.last_name}".split()}
            if len(words) > 1:
                self._words[each.id] = words
            first, last = _letters(each.first_name), _letters(each.last_name)
            for name in {first + last, last + first} - {""}:
                self._names.setdefault(name, set()).add(each.id)
            for given in {each.id, each.email, *(value for _, value in each.ids)} - {""}:
                self._ids.setdefault(given.casefold(), set()).add(each.id)

    def by_id(self, given: str) -> str | None:
        return _only(self._ids.get(given.casefold(), set()))

    def by_name(self, name: str) -> str | None:
        return _only(self._names.get(_letters(name), set()))

    def namesakes(self, name: str) -> list[str]:
        """The ids of those who have this name; none where it is one student's, or nobody's."""
        met = sorted(self._names.get(_letters(name), set()))
        return met if len(met) > 1 else []

    def of_lms(self, found: LmsName) -> str | None:
        """By number where that is known (Canvas's is in its gradebook), else by name."""
        if (known := self._by_number.get(found.key)) is not None:
            return known
        if found.lms == "canvas":
            theirs = {each.id for each in self._students if dict(each.ids).get("ID") == found.number}
            if theirs:
                return _only(theirs)
        theirs = self._in_worksheet.get(found.key)
        namesake = theirs if theirs in self.namesakes(found.name) else None
        return self.by_name(found.name) or self.by_id(found.name) or namesake

    def admits(self, found: LmsName, student: str) -> bool:
        """Whether a name of an LMS may be this student's: a group or a middle name may stand with it, marking may be blind, and
        the roster may have no names. Another person's may not."""
        if (
            found.name.rpartition("-")[2].strip().lower().startswith(NAMELESS)
            or self.of_lms(found) == student
        ):
            return True
        letters = {_letters(word) for word in re.split(r"[\s,.-]+", found.name)} - {""}
        for each in self._students:
            own = {
                _letters(word) for word in re.split(r"[\s,.-]+", f"{each.first_name} {each.last_name}")
            } - {""}
            if each.id == student:
                apart = own <= letters or (len(letters) > 1 and letters <= own)
                return (
                    not own
                    or apart
                    or (found.lms == "canvas" and all(word in _letters(found.name) for word in own))
                )
        return False

    def of_file(self, parts: Sequence[str], set_name: str) -> str | None:
        """By what an LMS says of a file, else by the names of the folders around it and its own."""
        lms = lms_name(parts)
        return self.of_lms(lms) if lms else self.of_parts(parts, set_name)

    def of_parts(self, parts: Sequence[str], set_name: str) -> str | None:
        """By the names of the folders around a file and its own: whose id or whose whole name stands in the first that has one."""
        for part in parts:
            stem = again(re.sub(r"(\.ipynb(\.txt|\.json)?|\.zip)$", "", part))[0]
            rest = re.sub(re.escape(set_name), " ", stem, flags=re.IGNORECASE)
            words = [word for word in re.split(r"[\s_,;()+]+|(?<=\w)-(?=\w)", rest) if word]
            whole = [rest.strip(" _-"), *re.split(r"[\s_,;()+]+", rest), *words]
            met = {found for word in whole if word and (found := self.by_id(word)) is not None}
            letters = {_letters(word) for word in words}
            met |= {student for student, own in self._words.items() if own <= letters}
            if not met and (named := self.by_name(rest)) is not None:
                met.add(named)
            if met:
                return _only(met)
        return None


def _only(found: set[str]) -> str | None:
    return next(iter(found)) if len(found) == 1 else None


def _letters(text: str) -> str:
    """The letters of a name, without accents, blanks and case."""
    return "".join(each for each in unicodedata.normalize("NFKD", text).casefold() if each.isalnum())
