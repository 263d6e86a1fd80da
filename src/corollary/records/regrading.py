"""Regrading: whose points change, by how much, and why."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import msgspec

from corollary.grading.submission import CREDIT, JUDGED_BY, LATE_SHARE, WEIGHTS, judged_by
from corollary.records.assignments import AssignedSheet
from corollary.records.deadlines import Deadlines, Terms
from corollary.records.files import Course
from corollary.records.marks import THE_PACKAGE, UNMARKED, PartRecord, Record
from corollary.records.notebook_archive import read_hand_in
from corollary.records.submissions import handed_in

CENT = 0.005  # half of the last decimal that anybody sees
NOTHING = PartRecord("", 0.0, 0.0)  # a part that was not there before, or is no longer


@dataclass(frozen=True, slots=True)
class PartChange:
    """One part, named as in the notebook (X12_5_a), before and after: its verdict, its points, and what these are out of;
    `by_hand`: a person gave the points, and no verdict is the program's."""

    part: str
    verdict_before: str
    verdict: str
    before: float
    after: float
    out_of_before: float
    out_of: float
    by_hand: bool = False


@dataclass(frozen=True, slots=True)
class Change:
    """One student whose marks change: points after lateness and what they are out of, before and after, every part that
    differs, and why."""

    student: str
    before: float
    after: float
    out_of_before: float
    out_of: float
    parts: tuple[PartChange, ...]
    why: str = ""

    @property
    def by(self) -> float:
        return self.after - self.before

    @property
    def moves_points(self) -> bool:
        """Whether any points move, or what they are out of; else a part is only called otherwise."""
        return (
            _differ(self.after, self.before)
            or _differ(self.out_of, self.out_of_before)
            or any(
                _differ(part.after, part.before) or _differ(part.out_of, part.out_of_before)
                for part in self.parts
            )
        )

    def because(self, why: str) -> Change:
        return replace(self, why=why)


def change(student: str, old: Record, new: Record) -> Change | None:
    """What is otherwise in the new marks of one student; None when nothing is."""
    parts = tuple(_parts(old.parts, new.parts))
    if not (parts or _differ(new.points, old.points) or _differ(new.out_of, old.out_of)):
        return None
    return Change(student, old.points, new.points, old.out_of, new.out_of, parts)


def largest_first(found: Iterable[Change]) -> tuple[Change, ...]:
    """The order in which people read them."""
    return tuple(sorted(found, key=lambda one: (-abs(one.by), one.student)))


def _parts(old: Mapping[str, PartRecord], new: Mapping[str, PartRecord]) -> Iterator[PartChange]:
    """Parts with another verdict, other points, or out of others."""
    for name in dict.fromkeys((*old, *new)):
        before, after = old.get(name, NOTHING), new.get(name, NOTHING)
        points = before.points, after.points, before.out_of, after.out_of
        by_hand = all(_is_by_hand(each) for each in (before, after) if each is not NOTHING)
        called_otherwise = before.verdict != after.verdict and not by_hand
        if called_otherwise or _differ(*points[:2]) or _differ(*points[2:]):
            yield PartChange(name, before.verdict, after.verdict, *points, by_hand)


def _is_by_hand(part: PartRecord) -> bool:
    return part.manual is not msgspec.UNSET and part.manual.score is not None


def _differ(one: float, other: float) -> bool:
    return abs(one - other) >= CENT


NOTEBOOK, TIME, DEADLINE = "the notebook", "when it was handed in", "the deadline"
_WITHOUT_A_RUN = frozenset({TIME, DEADLINE, LATE_SHARE, CREDIT, WEIGHTS})
_POINTS_OF = "the points or the rubric of "


def dependencies(
    course: Course,
    set_name: str,
    student: str,
    path: Path,
    assigned: AssignedSheet,
    terms: Terms,
    state: Mapping[str, bytes],
) -> dict[str, str]:
    """What one student's marks depend on, under the names that people read: a short digest of each, and the time of handing in as
    it is. `state` is what they share with everybody's."""
    content = read_hand_in(course, path)
    found = {
        NOTEBOOK: content if isinstance(content, bytes) else content.in_english.encode(),
        DEADLINE: repr((terms.due and terms.due.isoformat(), terms.excused)).encode(),
        "the numbers": assigned.numbers.encode(),
        **({"what is called otherwise": assigned.names.encode()} if assigned.names else {}),
        **state,
    }
    digests = {name: hashlib.sha256(each).hexdigest()[:12] for name, each in found.items()}
    return digests | {TIME: str(handed_in(course, set_name, student))}


def needs_no_run(names: Iterable[str]) -> bool:
    """Whether marks can be given again without running the notebook a second time, these being `changed`."""
    return all(name in _WITHOUT_A_RUN or name.startswith(_POINTS_OF) for name in names)


def is_handed_in_anew(old: Record, depends: Mapping[str, str]) -> bool:
    """Whether the student handed in another notebook since the marks were given, which alone says so: its time may be a file's
    that was lost or copied."""
    return old.depends.get(NOTEBOOK) != depends.get(NOTEBOOK)


def is_completed(old: Record, depends: Mapping[str, str], change: Change) -> bool:
    """Whether nothing changes but parts that waited because a package was missing: installing it was asked for by that."""
    waited = all(each.verdict_before == UNMARKED and not each.by_hand for each in change.parts)
    names = changed(old, depends)
    return waited and bool(names) and all(name.startswith(THE_PACKAGE) for name in names)


def is_extended(old: Record, depends: Mapping[str, str], change: Change, deadlines: Deadlines) -> bool:
    """Whether a student's marks change by nothing but more time that this student was given, or an excuse: whoever gave it has
    agreed to that. Time that is taken back takes marks, and is asked about."""
    lateness_alone = not change.parts and change.out_of == change.out_of_before and change.by > 0
    return lateness_alone and change.student in deadlines.extensions and changed(old, depends) == [DEADLINE]


def why(old: Record, depends: Mapping[str, str]) -> str:
    """A few words on why marks are others than before."""
    names = changed(old, depends)
    if not names:
        return "nothing was changed, but the notebook gave other results in this run"
    about: dict[str, str] = {}
    if TIME in names:
        now, before = (each[TIME].replace("+00:00", " UTC") for each in (depends, old.depends))
        about[TIME] = f"{TIME} ({now}; when it was marked: {before})"
    return f"changed: {', '.join(about.get(name, name) for name in names)}"


def changed(old: Record, depends: Mapping[str, str]) -> list[str]:
    """The names of what marks depend on that are not as they were when these were given."""
    names = [name for name in {**old.depends, **depends} if old.depends.get(name) != depends.get(name)]
    return _exactly(names, old.depends)


def _exactly(names: list[str], before: Mapping[str, str]) -> list[str]:
    """Where a problem's verdicts follow from the same as before, only its points or rubric are named as changed."""
    found: dict[str, None] = {}
    for name in names:
        code = name.removeprefix("the problem ").removeprefix("the solution of ")
        if code != name and judged_by(code) in before and judged_by(code) not in names:
            name = f"{_POINTS_OF}{code}"
        if not name.startswith(JUDGED_BY):
            found[name] = None
    return list(found)
