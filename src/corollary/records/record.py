"""How marks are recorded: a part, a row of the report, a submission; the program's own, or merged with what persons gave."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import assert_never

import msgspec

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong, word
from corollary.grading.grade import Marked, NearMiss
from corollary.grading.record import marked_record
from corollary.records.manual import ManualMark, OfStudent
from corollary.version import __version__

RIGHT, WRONG, UNMARKED = (word(verdict) for verdict in (Right(), Wrong(), Unmarked("")))


class Row(msgspec.Struct, frozen=True):
    """One part of one student, points before lateness. `verdict` is its word, `error` the mistake or slip, `why` the rest;
    `by_hand`: a person gave the points."""

    student: str
    problem: str
    part: str
    verdict: str
    points: float
    out_of: float
    error: str = ""
    why: str = ""
    by_hand: bool = False
    rubric: tuple[str, ...] = ()
    again: bool = (
        False  # a person marked it, and is to look again: the answer is another now, or its points are
    )
    near: NearMiss | None = None  # another reading by which an answer that earned nothing would be right

    @property
    def waits(self) -> bool:
        return self.verdict == UNMARKED or self.again

    @property
    def near_miss(self) -> NearMiss | None:
        """The other reading, as long as no person has decided on the answer."""
        return None if self.by_hand and not self.again else self.near


class HandedIn(msgspec.Struct, frozen=True):
    """One submission as a whole: points after lateness; `late` in seconds; `trouble` a sentence, or empty; `notes` tell
    what was noticed."""

    student: str
    name: str
    points: float
    out_of: float
    late: float = 0.0
    late_share: float = 1.0
    trouble: str = ""
    isolation: str = ""
    notes: tuple[str, ...] = ()


class PartRecord(msgspec.Struct, frozen=True):
    """One part as it was marked; a mistake, a slip or a rubric only where the verdict has one, and `manual` only where a
    person gave something (never in the files of the program's own marks). `basis` says what the points go by where the verdict
    does not."""

    verdict: str
    points: float
    out_of: float
    answer: str = ""
    feedback: str = ""
    mistake: str | msgspec.UnsetType = msgspec.UNSET
    slip: str | msgspec.UnsetType = msgspec.UNSET
    rubric: tuple[str, ...] | msgspec.UnsetType = msgspec.UNSET
    manual: ManualMark | msgspec.UnsetType = msgspec.UNSET
    basis: tuple[str, ...] | msgspec.UnsetType = msgspec.UNSET


class Record(msgspec.Struct, frozen=True):
    """How a student's marks in one set came about: answers, verdicts, variants, isolation, and the fingerprint of all that
    they depend on. Parts go by their name in the notebook (X12_5_a); `late` in seconds; `answers` holds a digest of what the
    student wrote for each, `depends` says what else the marks depend on, by name: a digest of each, and when it was handed in."""

    points: float
    out_of: float
    parts: dict[str, PartRecord]
    fingerprint: str
    handed_in: HandedIn
    rows: tuple[Row, ...]
    variants: dict[str, int | None] = {}
    isolation: str = ""
    trouble: str = ""
    late: float = 0.0
    late_share: float = 1.0
    notes: tuple[str, ...] = ()
    version: str = ""
    answers: dict[str, str] = {}
    depends: dict[str, str] = {}

    def why_again(self, part: str, mark: ManualMark) -> str:
        """Why a person is to look again at what a person gave, `mark` being out of what the part earns now; empty when not."""
        if mark.score is None and not mark.extra_credit:
            return ""
        if self.is_other_answer(part, mark):
            if mark.score is None:
                return f"the answer has changed since a person gave it {mark.extra_credit:g} as extra credit"
            return "the answer has changed since a person marked it"
        out_of = self.parts[part].out_of
        if mark.first is not None:
            score, most = mark.first
            return f"given {score:g} of {most:g}, now out of {out_of:g}"
        if mark.score is not None and mark.score > out_of + 1e-9:
            return f"given {mark.score:g} by hand, but it earns no more than {out_of:g}"
        return ""

    def is_other_answer(self, part: str, mark: ManualMark) -> bool:
        """Whether a person's mark was given for another answer than the one that lies there now."""
        now = self.answers.get(part, "")
        return bool(mark.answer and now) and mark.answer != now


def record_of(
    marked: Marked,
    fingerprint: str,
    answers: Mapping[str, str] = MappingProxyType({}),
    depends: Mapping[str, str] = MappingProxyType({}),
) -> Record:
    """What is recorded of a submission's marks; `answers` is a digest of what was written for each part, `depends` of all else."""
    about = {
        "fingerprint": fingerprint,
        "handed_in": handed_in(marked),
        "rows": rows(marked),
        "answers": dict(answers),
        "depends": dict(depends),
    }
    return msgspec.convert(marked_record(marked) | about | {"version": __version__}, Record)


def handed_in(marked: Marked) -> HandedIn:
    """The submission as a whole."""
    return HandedIn(
        marked.student.id,
        marked.student.name,
        marked.points,
        marked.out_of,
        marked.late,
        marked.late_share,
        marked.trouble,
        marked.isolation,
        marked.notes,
    )


def rows(marked: Marked) -> tuple[Row, ...]:
    """One row for each part of one submission."""
    return tuple(
        Row(
            marked.student.id,
            grade.variant.problem.code,
            part.part.id,
            word(part.verdict),
            part.points,
            part.out_of,
            *_reasons(part.verdict),
            rubric=part.verdict.rubric if isinstance(part.verdict, Unmarked) else (),
            near=part.near,
        )
        for grade in marked.grades
        for part in grade.parts
    )


def _reasons(verdict: Verdict) -> tuple[str, str]:
    """The mistake or slip, and what else there is to know."""
    match verdict:
        case Right(note):
            return "", note
        case Follows(earlier):
            return "", f"from {', '.join(earlier)}"
        case Mistaken(mistake, earlier):
            return mistake, f"from {', '.join(earlier)}" if earlier else ""
        case Slip(slip):
            return slip, ""
        case Wrong(why) | Unread(why) | Unmarked(why):
            return "", why
        case _:
            assert_never(verdict)


def with_manual(record: Record, given: OfStudent) -> Record:
    """The marks as they stand: what a person gave counts in the place of the program's, and lateness applies to it as well."""
    given = {part: mark for part, mark in out_of_now(given, record).items() if mark.is_given}
    if not given:
        return record
    parts = {name: _part_with(part, given.get(name)) for name, part in record.parts.items()}
    points = round(sum(part.points for part in parts.values()) * record.late_share, 6)
    names = zip(record.rows, record.parts, strict=True)  # rows and parts are of one order
    rows = tuple(_row_with(row, parts[name], record, name) for row, name in names)
    whole = msgspec.structs.replace(record.handed_in, points=points)
    return msgspec.structs.replace(record, points=points, parts=parts, rows=rows, handed_in=whole)


def out_of_now(given: OfStudent, record: Record) -> OfStudent:
    """What a person gave for the parts of a record, out of the points that they earn in it."""
    return {
        part: mark.out_of_now(record.parts[part].out_of)
        for part, mark in given.items()
        if part in record.parts
    }


def changed_by_points(given: OfStudent, record: Record) -> OfStudent:
    """Those of them that are other scores now, for their part earns other points."""
    return {part: mark for part, mark in out_of_now(given, record).items() if mark is not given[part]}


def _part_with(part: PartRecord, mark: ManualMark | None) -> PartRecord:
    if mark is None:
        return part
    score = part.points if mark.score is None else mark.score
    counts = (
        mark.score is not None or part.verdict != UNMARKED
    )  # as in nbgrader: nothing is added to no score
    earned = round(score + ((mark.extra_credit or 0.0) if counts else 0.0), 6)
    verdict = part.verdict if mark.score is None else _verdict_by_hand(part, mark.score)
    return msgspec.structs.replace(part, verdict=verdict, points=earned, manual=mark)


def _verdict_by_hand(part: PartRecord, score: float) -> str:
    """All points are for a right answer; for fewer the program's verdict stands, unless it was that one or none."""
    if score >= part.out_of:
        return RIGHT
    return WRONG if part.verdict in {RIGHT, UNMARKED} else part.verdict


def _row_with(row: Row, part: PartRecord, record: Record, name: str) -> Row:
    if part.manual is msgspec.UNSET:
        return row
    by_hand = part.manual.score is not None
    again = record.why_again(name, part.manual)
    why = again or ("" if by_hand else row.why)
    error = "" if by_hand and part.verdict == RIGHT else row.error
    return msgspec.structs.replace(
        row,
        verdict=part.verdict,
        points=part.points,
        error=error,
        why=why,
        by_hand=by_hand,
        again=bool(again),
    )
