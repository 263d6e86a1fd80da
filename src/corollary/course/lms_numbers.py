"""Several LMS numbers for one student: only the file under the number that is known to be the student's is taken."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import msgspec

from corollary.course.owner import Found
from corollary.messages import few
from corollary.problem.roster import Student
from corollary.records.lms_names import Directory, LmsName, canvas_ids, lms_name
from corollary.records.submissions import ACCEPTED, NOBODY, UNCHANGED, Arrival, digest_of, writable

NAMES = {"moodle": "Moodle", "canvas": "Canvas"}


@dataclass(frozen=True, slots=True)
class LmsNumbers:
    """Numbers such as "moodle 17". `by_id` are tied to a student by an id or an e-mail address (a worksheet, Canvas's gradebook),
    `earlier` by what was collected before."""

    by_id: Mapping[str, str]
    earlier: Mapping[str, str]

    def certain(self, student: str, lms: str) -> set[str]:
        return {number for number, whose in self.by_id.items() if whose == student and _is_of(lms, number)}

    def before(self, student: str, lms: str) -> set[str]:
        return {number for number, whose in self.earlier.items() if whose == student and _is_of(lms, number)}


def known_numbers(
    roster: Iterable[Student], earlier: Mapping[str, str], worksheet: Mapping[str, str]
) -> LmsNumbers:
    """`worksheet` has the numbers of rows that were recognized by an id."""
    of_canvas = {f"canvas {ids['ID']}": each.id for each in roster if "ID" in (ids := canvas_ids(each))}
    return LmsNumbers({**of_canvas, **worksheet}, earlier)


@dataclass(slots=True)
class OwnFiles:
    """Files that came under a number of their student, and those `refused`, with sentences on each conflict."""

    known: LmsNumbers
    roster: Mapping[str, Student]
    refused: list[Arrival] = field(default_factory=list[Arrival])
    conflicts: list[str] = field(default_factory=list[str])

    def of(self, met: Sequence[Found]) -> list[Found]:
        """Those to go on with. A second number is somebody else's: a namesake, or who took the student's display name."""
        groups: dict[tuple[str, str], list[Found]] = {}
        for each in met:
            if each.lms:
                groups.setdefault((each.student, each.lms.lms), []).append(each)
        same = {lms for lms in NAMES if self._is_same_assignment(lms, groups)}
        accepted = {id(each) for each in met if not each.lms}
        for (student, lms), theirs in groups.items():
            own = self._own(student, lms, theirs, lms in same)
            accepted |= {id(each) for each in theirs if own is None or _number(each) in own}
            if own is not None and (left := [each for each in theirs if _number(each) not in own]):
                self._refuse(student, lms, left, own, came=len(left) < len(theirs))
        return [each for each in met if id(each) in accepted]

    def strangers(self, arrivals: Iterable[Arrival]) -> set[str]:
        """The numbers of files that were taken from nobody, and that are not known to be a student's."""
        refused = {each.number for each in arrivals if each.outcome == NOBODY and each.number}
        return refused - self.known.earlier.keys() - self.known.by_id.keys()

    def _is_same_assignment(self, lms: str, groups: Mapping[tuple[str, str], Sequence[Found]]) -> bool:
        """True if a new number is a new person, since numbers of this assignment are known. Another assignment of the LMS gives all
        its students new numbers."""
        numbers = {_number(each) for (_, of), theirs in groups.items() if of == lms for each in theirs}
        if numbers & {*self.known.earlier, *self.known.by_id}:
            return True
        changed = [student for student, of in groups if of == lms and self.known.before(student, lms)]
        return len(changed) == 1

    def _own(self, student: str, lms: str, theirs: Sequence[Found], same: bool) -> Collection[str] | None:
        """The numbers whose files are taken; None where nothing speaks against any. `same`: the numbers of this assignment are known
        from a worksheet or an earlier collect, so that a new number is a new person."""
        named = [each for each in theirs if each.named] or theirs
        numbers = {_number(each) for each in named}
        others = {each for each in numbers if self.known.by_id.get(each, student) != student}
        certain, before = self.known.certain(student, lms), self.known.before(student, lms)
        if certain and (lms == "canvas" or same or numbers & certain):
            return certain
        if others:
            return numbers - others if len(numbers - others) == 1 else ()
        if len(before) == 1 and (same or numbers & before):
            return before
        return () if len(numbers) > 1 else None

    def _refuse(
        self, student: str, lms: str, left: Sequence[Found], own: Collection[str], *, came: bool
    ) -> None:
        """`came`: a file under the student's own number came, too."""
        who, name = self._called(student), NAMES[lms]
        numbers = sorted({_short(_number(each)) for each in left}, key=lambda each: (len(each), each))
        hers = ", ".join(sorted(map(_short, own)))
        owners = {self.known.by_id[_number(each)] for each in left if _number(each) in self.known.by_id} - {
            student
        }
        sheet = (
            "give Moodle's grading worksheet with --times (its addresses tell them apart), or "
            if lms == "moodle" and not any(_is_of(lms, number) for number in self.known.by_id)
            else ""
        )
        do = f"{sheet}rename the right file to {student}.ipynb and collect it again"
        if owners:
            because = f"the number is that of {' and '.join(map(self._called, sorted(owners)))}"
        elif own:
            because = f"{who} has the number {hers}"
        else:
            because = "nothing says which of them is the student's"
        for each in left:
            lms_words = (
                f"came under the name {each.lms.name}, {name} number {_short(_number(each))}"
                if each.lms
                else ""
            )
            arrival = each.arrival(NOBODY, f"{lms_words}; {because}; {do}")
            self.refused.append(msgspec.structs.replace(arrival, student=""))
        count = "one more number" if own and len(numbers) == 1 else f"{len(numbers)} numbers"
        files = few([writable(each.member.name) for each in left], 4)
        outcome = f"only the file under {hers} is taken" if came else "none of their files is taken"
        if own and not came:
            outcome += f" (the student's number is {hers})"
        self.conflicts.append(
            f"{who} has {count} in {name} ({few(numbers, 4)}): two people handed in under one name, and {outcome}, not {files}; {do}"
        )

    def _called(self, student: str) -> str:
        about = self.roster.get(student)
        return student if about is None else about.name_with_id


def as_they_came(
    met: Sequence[Found], arrivals: Sequence[Arrival], known: LmsNumbers, directory: Directory
) -> list[Found]:
    """The files, each that somebody renamed with the name under which the LMS gave it: its time and number are those of the
    hand-in, and not those of a copy on somebody's disk. It is known by its content; one that was saved again, where files under
    the student's name were refused and none was taken, by the number that is the student's. With none its time is not known."""
    by_digest: dict[str, dict[str, LmsName]] = {}
    refused, with_hand_in = list[LmsName](), set[str]()
    for each in arrivals:
        if lms := lms_name(each.file.split("/")):
            if each.digest:
                by_digest.setdefault(each.digest, {})[lms.key] = lms
            if each.outcome == NOBODY:
                refused.append(lms)
            elif each.outcome in (ACCEPTED, UNCHANGED):
                with_hand_in.add(each.student)
    return [
        each
        if each.lms
        else _as_it_came(
            each,
            by_digest.get(digest_of(each.content), {}),
            () if each.student in with_hand_in else refused,
            known,
            directory,
        )
        for each in met
    ]


def _as_it_came(
    each: Found,
    same_content: Mapping[str, LmsName],
    refused: Sequence[LmsName],
    known: LmsNumbers,
    directory: Directory,
) -> Found:
    if len(same_content) == 1:
        return replace(each, lms=next(iter(same_content.values())))
    theirs = [lms for lms in refused if directory.admits(lms, each.student)]
    if not theirs:
        return each
    own = [lms for lms in theirs if lms.key in known.certain(each.student, lms.lms)]
    return replace(each, lms=own[0]) if own else replace(each, member=replace(each.member, modified=None))


def _number(found: Found) -> str:
    return found.lms.key if found.lms else ""


def _short(number: str) -> str:
    return number.partition(" ")[2]


def _is_of(lms: str, number: str) -> bool:
    return number.startswith(f"{lms} ")
