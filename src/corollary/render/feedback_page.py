"""The feedback page of a student, and the same as a notebook: points, and for every part the question, the reading and the verdict.

The page itself is put together from these and from the marks as they stand, so that it can be made again whenever a person
gives some, without the bank, the notebook or the solutions.
"""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from html import unescape

import msgspec
from markupsafe import Markup

from corollary.answers.verdict import Unmarked, Unread
from corollary.grading.part_grades import Grade, Marked, PartGrade
from corollary.grading.stopped_cells import package_state, why_stopped
from corollary.messages import catalogue, in_convention, spoken
from corollary.notebook.worksheet import Prompt, exercise
from corollary.problem.dates import in_words
from corollary.problem.problem_set import ProblemSet
from corollary.records.manual_marks import RequestDecision
from corollary.records.marks import PartRecord, Record
from corollary.records.regrade_requests import file_name
from corollary.render.markdown import html, inline
from corollary.render.page import drawing, page
from corollary.render.request_form import form_address, request_form
from corollary.render.wording import BLANK, BY_HAND, LOOKS, Look, earned, item_points, spell
from corollary.sandbox.job import CellRun, Figure
from corollary.sandbox.stop_kinds import CellStop, stop_of

_ = catalogue(__name__)

PNG = b"\x89PNG\r\n\x1a\n"


class Picture(msgspec.Struct, frozen=True):
    """A student's figure: `source` is a data URI, empty when no picture could be drawn; `alt` says what it shows."""

    source: str
    alt: str


class OptionFacts(msgspec.Struct, frozen=True):
    """An option of a choice; `text` is HTML."""

    letter: str
    text: str


class PartFacts(msgspec.Struct, frozen=True):
    """One part: `key` names it in the notebook, `title` and `asked` are HTML, `rubric` is for the student's eyes."""

    key: str
    id: str
    title: str
    asked: str
    options: tuple[OptionFacts, ...]
    pictures: tuple[Picture, ...]
    introduction: str
    blank: bool
    rubric: tuple[str, ...] = ()


class ExerciseFacts(msgspec.Struct, frozen=True):
    """One exercise; `statement`, `drawing` and `solution` are HTML, or empty."""

    code: str
    title: str
    statement: str
    drawing: str
    parts: tuple[PartFacts, ...]
    solution: str


class PageFacts(msgspec.Struct, frozen=True):
    """A whole page; `stopped` names the cells that stopped and why, `not_run` counts those that were not reached; `due` is the
    student's own deadline in words, `late` how the delay was reckoned."""

    set_title: str
    student: str
    exercises: tuple[ExerciseFacts, ...]
    other_pictures: tuple[Picture, ...] = ()
    stopped: tuple[tuple[str, str], ...] = ()
    not_run: int = 0
    due: str = ""
    late: str = ""
    set_name: str = ""

    @property
    def request_file(self) -> str:
        """What the form for regrading is called; empty where the set's name is not known."""
        return file_name(self.set_name) if self.set_name else ""

    @property
    def request_form(self) -> str:
        """The address of that form."""
        parts = (
            (exercise.code, part.id, unescape(TAG.sub("", part.title)))
            for exercise in self.exercises
            for part in exercise.parts
        )
        return form_address(request_form(self.set_name, self.set_title, parts))


def page_facts(
    marked: Marked,
    problem_set: ProblemSet,
    *,
    solutions: Mapping[str, str] | None = None,
    rubric: bool = False,
    due: datetime | None = None,
    late: str = "",
) -> PageFacts:
    """`due` is the student's own deadline. `solutions` gives the worked solution (Markdown, with the student's numbers) by problem code; None shows none. `rubric`:
    by what a person marks stands beside the answer."""
    parts = {
        grade.variant.problem.answer_name(
            part.part
        ): f"{grade.variant.problem.code} ({part.part.heading_letter})"
        for grade in marked.grades
        for part in grade.parts
    }
    pictures = _pictures(marked.figures, list(parts))
    return PageFacts(
        problem_set.title,
        marked.student.name,
        tuple(_exercise_facts(grade, pictures, solutions or {}, rubric) for grade in marked.grades),
        pictures.get("", ()),
        tuple(
            _stopped(run, stop, parts, problem_set)
            for run in marked.runs
            if (stop := stop_of(run)) is not None and stop.kind != "not run"
        ),
        sum(run.status == "not run" for run in marked.runs),
        "" if due is None else in_words(due),
        late,
        problem_set.name,
    )


def packed(facts: PageFacts) -> bytes:
    """The facts as compressed JSON; half a surrogate pair in a student's text, which no file can hold, is a question mark."""
    text = json.dumps(msgspec.to_builtins(facts), ensure_ascii=False).encode("utf-8", "replace")
    return zlib.compress(text)


def unpacked(content: bytes) -> PageFacts:
    """The facts that `packed` made a file of, or a version that did not compress. Raises msgspec.DecodeError for anything else."""
    try:
        text = content if content.startswith(b"{") else zlib.decompress(content)
    except zlib.error as error:
        raise msgspec.DecodeError(str(error)) from None
    return msgspec.json.decode(text, type=PageFacts)


def describe(figure: Figure) -> str:
    """A student's figure in a sentence, for those who cannot see it."""
    axes: list[str] = []
    for one in figure.axes:
        words = [_.plural("{count} curve", "{count} curves", len(one.lines))]
        words += [_("titled “{text}”", text=one.title)] if one.title else []
        words += [_("x axis “{text}”", text=one.xlabel)] if one.xlabel else []
        words += [_("y axis “{text}”", text=one.ylabel)] if one.ylabel else []
        axes.append(", ".join(words))
    return _("Your figure: {contents}", contents="; ".join(axes) or _("nothing is drawn in it"))


def _exercise_facts(
    grade: Grade, pictures: Mapping[str, tuple[Picture, ...]], solutions: Mapping[str, str], rubric: bool
) -> ExerciseFacts:
    asked = exercise(grade.variant)
    prompts = {prompt.part.id: prompt for prompt in asked.prompts}
    solution = solutions.get(asked.problem.code, "")
    return ExerciseFacts(
        asked.problem.code,
        asked.problem.title,
        html(asked.statement),
        str(drawing(asked)),
        tuple(_part_facts(prompts[part.part.id], part, pictures, rubric) for part in grade.parts),
        html(solution) if solution else "",
    )


def _part_facts(
    prompt: Prompt, part: PartGrade, pictures: Mapping[str, tuple[Picture, ...]], rubric: bool
) -> PartFacts:
    blank = isinstance(part.verdict, Unread) and part.verdict.blank
    return PartFacts(
        prompt.key,
        part.part.heading_letter,
        inline(part.part.title),
        html(prompt.text),
        tuple(OptionFacts(option.mark, inline(option.text)) for option in prompt.options),
        pictures.get(prompt.key, ()),
        _introduction(part) if part.answer and not blank else "",
        blank,
        part.verdict.rubric if rubric and isinstance(part.verdict, Unmarked) else (),
    )


def _introduction(part: PartGrade) -> str:
    """The words before the answer."""
    match part.verdict:
        case Unread():
            return _("What you wrote:")
        case Unmarked():
            return _("Your answer:")
        case _:
            return _("Your answer, as read:")


def _pictures(figures: Sequence[Figure], keys: Sequence[str]) -> dict[str, tuple[Picture, ...]]:
    """The pictures by the part whose cell drew them; under "" those of no part's."""
    found: dict[str, tuple[Picture, ...]] = {}
    for figure in figures:
        # X12_5_c_2_plot begins with X12_5_c_ and with X12_5_c_2_: the longest key is meant.
        owners = (key for key in keys if figure.cell == key or figure.cell.startswith(key + "_"))
        key = max(owners, key=len, default="")
        png = figure.png if figure.png is not None and figure.png.startswith(PNG) else None
        source = f"data:image/png;base64,{base64.b64encode(png).decode()}" if png else ""
        found[key] = (*found.get(key, ()), Picture(source, describe(figure)))
    return found


def _stopped(
    run: CellRun, stop: CellStop, parts: Mapping[str, str], problem_set: ProblemSet
) -> tuple[str, str]:
    """The cell, by its part where it has one, and what stopped it. `parts`: `X12.5 (a)` by the name of its answer."""
    name = max((key for key in parts if run.id.startswith(f"{key}_") or run.id == key), key=len, default="")
    cell = _("Cell of {part}", part=parts[name]) if name else _("A cell that you added")
    state = package_state(stop.about, problem_set.packages) if stop.kind == "package" else ""
    why = why_stopped(stop, problem_set.packages, state)
    return cell, f"{why[0].upper()}{why[1:]}."


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
    def ticked(self) -> list[tuple[str, str]]:
        """The items of the rubric that were ticked, each with what it added."""
        manual = self.record.manual
        items = () if manual is msgspec.UNSET or manual.score is None else manual.rubric or ()
        return [(item.text, item_points(item, self.record.out_of)) for item in items]

    @property
    def request(self) -> RequestDecision | None:
        """The request for regrading that was answered."""
        return None if self.record.manual is msgspec.UNSET else self.record.manual.request

    @property
    def points(self) -> str:
        """What it earned; a dash where a person has still to decide all of it."""
        waits = self.look is LOOKS["unmarked"] and not self.record.points
        return "–" if waits else earned(self.record.points)

    @property
    def folds(self) -> bool:
        """True if the part is right and nothing more is said of it than that."""
        whole = self.record.points >= self.record.out_of > 0
        return (
            whole
            and self.look is LOOKS["right"]
            and not (self.comment or self.feedback or self.ticked or self.request)
        )

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


TAG = re.compile(r"<[^>]*>")
# What Markdown would take for more than text, in an answer or in what a person wrote.
MARKED_UP = re.compile(r"([\\`*_\[\]<>#$|~!])")


def feedback_notebook(facts: PageFacts, record: Record) -> str:
    """The text of a notebook with the marks, the answers as they were read, and what is said of them."""
    total = _("of {out_of} points", out_of=earned(record.out_of))
    cells = [
        f"# {_literal(facts.set_title)}",
        _("Feedback for {name}", name=_literal(facts.student)),
        f"**{earned(record.points)}** {total}",
        *(_literal(note) for note in (facts.late, record.trouble, *record.notes) if note),
    ]
    texts = ["\n\n".join(cells)]
    for marked in marked_exercises(facts, record):
        texts.append(f"## {marked.facts.code} {_literal(marked.facts.title)}")
        texts += map(_of_part, marked.parts)
    return json.dumps(
        {
            "cells": [
                {"cell_type": "markdown", "id": f"feedback-{number}", "metadata": {}, "source": text}
                for number, text in enumerate(texts)
            ],
            "metadata": {},
            "nbformat": 4,
            "nbformat_minor": 5,
        },
        ensure_ascii=False,
    )


def _of_part(part: MarkedPart) -> str:
    marks = _("{points} of {out_of}", points=part.points, out_of=earned(part.record.out_of))
    texts = [
        f"### ({part.facts.id}) {_literal(unescape(TAG.sub('', part.facts.title)))}",
        f"**{part.look.phrase}** ({marks})",
        f"{part.facts.introduction} {_literal(part.answer)}" if part.facts.introduction else "",
        *(f"- {item} ({worth})" for item, worth in part.ticked),
        _literal(part.comment),
        part.feedback,
    ]
    return "\n\n".join(text for text in texts if text)


def _literal(text: str) -> str:
    return MARKED_UP.sub(r"\\\1", text)
