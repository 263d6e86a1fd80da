"""The owner of each collected file: by the name that an LMS or a person gave it, else by the notebook itself."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime

from corollary.grading.integrity import elsewhere, is_unedited, notes
from corollary.notebook.locate import origin
from corollary.notebook.worksheet import worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.assignments import AssignedSheet
from corollary.records.lms_names import Directory, LmsName, again, lms_name
from corollary.records.submissions import (
    NOBODY,
    UNUSABLE,
    WORKSHEET,
    Arrival,
    digest_of,
    numbers_of,
    stamp,
    writable,
)
from corollary.sandbox.archive import Member
from corollary.sandbox.file import Unreadable
from corollary.sandbox.notebook_file import notebook_of

LATER = "a later file was handed in"
PACKED = (".tar", ".gz", ".tgz", ".bz2", ".xz", ".zst", ".7z", ".rar")


@dataclass(frozen=True, slots=True)
class Found:
    """A notebook of this set, and whose it is."""

    student: str
    member: Member
    content: bytes
    lms: LmsName | None
    when: datetime | None
    why: str = ""
    time: str = ""  # where `when` is from: WORKSHEET, GUESSED, or the file
    latest: datetime | None = None  # after which it cannot have been handed in
    named: bool = True  # by whoever handed it in, where an LMS names who did

    @property
    def known(self) -> bool:
        """Whether `when` is when it was handed in, and not when an LMS wrote its archive (Canvas's LATE says no time)."""
        return self.time == WORKSHEET or (not self.time and (self.lms is None or self.lms.late is None))

    @property
    def order(self) -> tuple[bool, bool, datetime, datetime, int, int]:
        """What has the student's own name counts, then what has a known time, then the later, then the later by the date of
        the file, then what was named as a second or third."""
        attachment = int(self.lms.attachment or 0) if self.lms else 0
        stem = (self.lms.file if self.lms else self.member.parts[-1]).removesuffix(".ipynb")
        latest = self.latest or datetime.min.replace(tzinfo=UTC)
        when = (self.when or latest) if self.known else latest
        return self.named, self.known, when, latest, again(stem)[1], attachment

    def why_before(self, other: Found) -> str:
        """Why another notebook of the same student is taken and not this one."""
        name = writable(other.member.name)
        if self.content == other.content:
            return f"is the same as {name}"
        if other.known and not self.known:
            return f"has no time of handing in, but {name} has"
        if self.order[:3] != other.order[:3]:
            return LATER
        by = "has the later file date" if self.order[3] != other.order[3] else "comes last by name"
        if self.known:
            return f"was handed in at the same moment as {name}, which {by}"
        return f"has no time of handing in, nor has {name}, which {by}"

    def arrival(self, outcome: str, why: str) -> Arrival:
        """What became of it."""
        number = self.lms.key if self.lms else ""
        when = stamp(self.when) if self.when else ""
        digest = digest_of(self.content)
        return Arrival(self.student, self.member.name, when, outcome, why, digest, number, self.time)


def directory_of(
    roster: Sequence[Student], before: Sequence[Arrival], worksheet: Mapping[str, str]
) -> Directory:
    """With the numbers that came under names of the students themselves, and those of Moodle's worksheet."""
    return Directory(roster, numbers_before(roster, before), worksheet)


def numbers_before(roster: Sequence[Student], before: Sequence[Arrival]) -> dict[str, str]:
    """The numbers, such as "moodle 17", that came earlier under names of the students themselves, with the id of each. A number of
    a file without an LMS's name is that of a file which somebody renamed to its student."""
    names = Directory(roster)
    own: list[Arrival] = []
    for each in before:
        lms = lms_name(each.file.split("/"))
        if each.number and (lms is None or names.admits(lms, each.student)):
            own.append(each)
    return numbers_of(own)


def identified(
    member: Member,
    problem_set: ProblemSet,
    directory: Directory,
    roster: Mapping[str, Student],
    assigned: Mapping[str, AssignedSheet],
    conflicts: list[str],
    released: Callable[[str], bytes | None] = lambda student: None,
) -> Found | Arrival:
    """Whose a file is. The name that an LMS or a person gave it counts for more than what the notebook says of itself, for
    whoever has a neighbour's notebook cannot hand in as the neighbour. `released`: each student's sheet as it lies in the course."""
    lms = lms_name(member.parts)
    by_place = directory.of_file(member.parts, problem_set.name)
    number = lms.key if lms else ""
    namesakes = directory.namesakes(lms.name) if lms and by_place is None else []

    def left(student: str | None, outcome: str, why: str) -> Arrival:
        digest = digest_of(member.content) if isinstance(member.content, bytes) else ""
        return Arrival(student or "", member.name, "", outcome, why, digest, number)

    if member.content is None:
        packed = member.name.lower().endswith(PACKED)
        name = problem_set.name
        what = f"is not a zip archive; unpack it, or ask for {name}.ipynb" if packed else not_a_notebook(name)
        whose = f" ({_one_of(lms, namesakes)})" if lms and namesakes else ""
        return left(by_place, UNUSABLE if by_place else NOBODY, f"{what}{whose}")
    read = notebook_of(member.content) if isinstance(member.content, bytes) else member.content
    if isinstance(read, Unreadable) or isinstance(member.content, Unreadable):
        return left(by_place, UNUSABLE, read.in_english if isinstance(read, Unreadable) else "")
    says = origin(read.node)
    owner = by_place or (says.student if says.student in roster else None)
    person = lms is not None and again(lms.name)[0].casefold() not in problem_set.name.casefold()
    if by_place is None and lms and namesakes and (owner is None or not directory.admits(lms, owner)):
        made_for = f"was made for {says.student}; " if says.student else ""
        return left(None, NOBODY, f"{made_for}{_one_of(lms, namesakes)}")
    if by_place is None and owner is not None and lms and person and not directory.admits(lms, owner):
        why = f"was handed in by {lms.name}, who is not on the roster, and was made for {owner}"
        return left(
            None, NOBODY, f"{why}; add {lms.name} to the roster, or rename the file to the student's id"
        )
    if owner is None:
        whose = (
            f"was made for {says.student}, who is not on the roster"
            if says.student
            else "does not name its student"
        )
        return left(None, NOBODY, f"{whose}; rename the file to the student's id, and collect it again")
    if owner not in assigned:
        return left(
            owner,
            UNUSABLE,
            f"{owner} has no sheet of {problem_set.name}; run corollary generate {problem_set.name} again",
        )
    named = lms is None or by_place is not None
    if (says.set_name, says.student) == (problem_set.name, owner) and is_unedited(read.node, released(owner)):
        return Found(owner, member, member.content, lms, None, "", named=named)
    sheet = worksheet(problem_set, roster[owner], assigned[owner].variants)
    if elsewhere(sheet, read.node):
        name = problem_set.name
        other = f"has none of the exercises of {name}; ask for {name}.ipynb"
        return left(
            owner,
            UNUSABLE,
            f"is a notebook of {says.set_name}; ask for {name}.ipynb" if says.set_name else other,
        )
    if says.student and says.student != owner:
        conflicts.append(
            f"{writable(member.name)} was handed in by {owner} but made for {says.student}; it is marked with the numbers of {owner}"
        )
    another = says.student if says.student != owner else ""
    why = (
        f"made for {another}, marked with the numbers of {owner}"
        if another
        else " ".join(notes(sheet, read.node))
    )
    return Found(owner, member, member.content, lms, None, why, named=named)


def not_a_notebook(name: str) -> str:
    """The reason why a file of another kind is not taken."""
    return f"is not a notebook; ask for {name}.ipynb"


def _one_of(lms: LmsName, namesakes: Sequence[str]) -> str:
    """Who a name may be that several on the roster have, and how to tell."""
    sheet_first = "give Moodle's grading worksheet with --times, or " if lms.lms == "moodle" else ""
    return f"{lms.name} can be {' or '.join(namesakes)}; {sheet_first}rename the file to the id"
