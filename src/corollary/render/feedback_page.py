"""The feedback page of a student: points, and for every part the question, the reading and the verdict."""

from __future__ import annotations

import re
from dataclasses import dataclass

import msgspec
from markupsafe import Markup

from corollary.messages import catalogue, in_convention, spoken
from corollary.records.marks import PartRecord, Record
from corollary.render.feedback_facts import ExerciseFacts, PageFacts, PartFacts
from corollary.render.page import page
from corollary.render.wording import BLANK, BY_HAND, LOOKS, Look, spell

_ = catalogue(__name__)

HYPHEN_AS_MINUS = re.compile(r"(?<![\w.^])-(?=[\d.])")


@dataclass(frozen=True, slots=True)
class MarkedPart:
    """One part of the page, with its marks."""

    facts: PartFacts
    record: PartRecord
    look: Look

    @property
    def asked(self) -> Markup:
        return Markup(self.facts.asked)

    @property
    def title(self) -> Markup:
        return Markup(self.facts.title)

    @property
    def options(self) -> list[tuple[str, Markup]]:
        return [(option.letter, Markup(option.text)) for option in self.facts.options]

    @property
    def answer(self) -> str:
        """The answer as it was read; as it was written, where it was not."""
        record = self.record
        if record.verdict in {"unread", "unmarked"}:
            return record.answer
        return HYPHEN_AS_MINUS.sub("\u2212", in_convention(record.answer))

    @property
    def comment(self) -> str:
        """What a person said of it."""
        manual = self.record.manual
        return "" if manual is msgspec.UNSET else manual.comment or ""

    @property
    def feedback(self) -> str:
        """What the program says of it; nothing where a person decided, or where the look says it."""
        if self.look is BY_HAND or self.record.feedback == f"{self.look.phrase}.":
            return ""
        return self.record.feedback


@dataclass(frozen=True, slots=True)
class MarkedExercise:
    """One exercise of the page, with its marks."""

    facts: ExerciseFacts
    parts: tuple[MarkedPart, ...]

    @property
    def points(self) -> float:
        return sum(part.record.points for part in self.parts)

    @property
    def out_of(self) -> float:
        return sum(part.record.out_of for part in self.parts)

    @property
    def statement(self) -> Markup:
        return Markup(self.facts.statement)

    @property
    def drawing(self) -> Markup:
        return Markup(self.facts.drawing)

    @property
    def solution(self) -> Markup:
        return Markup(self.facts.solution)


def feedback_page(facts: PageFacts, record: Record) -> str:
    """The feedback of one student as a page of HTML that needs nothing beside it; `record` holds the marks as they stand."""
    return page(
        "feedback.html",
        lang=spoken(),
        title=_("{title}: feedback for {name}", title=facts.set_title, name=facts.student),
        facts=facts,
        record=record,
        exercises=marked_exercises(facts, record),
        waiting=sum(row.waits for row in record.rows),
        again={key for key, row in zip(record.parts, record.rows, strict=True) if row.again},
        before_late=sum(part.points for part in record.parts.values()),
        late=spell(max(60.0, record.late)) if record.late > 0 else "",
    )


def marked_exercises(facts: PageFacts, record: Record) -> list[MarkedExercise]:
    """The exercises of a page with the marks as they stand."""
    return [_exercise(each, record) for each in facts.exercises]


def _exercise(facts: ExerciseFacts, record: Record) -> MarkedExercise:
    return MarkedExercise(facts, tuple(_part(each, record.parts[each.key]) for each in facts.parts))


def _part(facts: PartFacts, record: PartRecord) -> MarkedPart:
    manual = record.manual
    if manual is not msgspec.UNSET and manual.score is not None:
        return MarkedPart(facts, record, BY_HAND)
    return MarkedPart(facts, record, BLANK if facts.blank else LOOKS[record.verdict])
