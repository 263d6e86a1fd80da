"""What a student gets back: points, and for every part what was asked, how the answer was read, and what is said of it."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from corollary.answers.verdict import Unmarked, Unread
from corollary.grading.grade import Grade, Marked, PartGrade
from corollary.messages import catalogue
from corollary.notebook.worksheet import Prompt, exercise
from corollary.problem.problem_set import ProblemSet
from corollary.render.page import drawing, page
from corollary.render.wording import Look, look, spell
from corollary.sandbox.result import CellRun, Figure

_ = catalogue(__name__)
PNG = b"\x89PNG\r\n\x1a\n"


@dataclass(frozen=True, slots=True)
class Picture:
    """A student's figure: `source` is a data URI, empty when no picture could be drawn; `alt` says what it shows."""

    source: str
    alt: str


@dataclass(frozen=True, slots=True)
class AnsweredPart:
    prompt: Prompt
    grade: PartGrade
    look: Look
    pictures: tuple[Picture, ...]

    @property
    def answered(self) -> bool:
        """Whether there is an answer to show."""
        return bool(self.grade.answer) and not (
            isinstance(self.grade.verdict, Unread) and self.grade.verdict.blank
        )

    @property
    def introduction(self) -> str:
        """The words before the answer."""
        match self.grade.verdict:
            case Unread():
                return _("What you wrote:")
            case Unmarked():
                return _("Your answer:")
            case _:
                return _("Your answer, as read:")


@dataclass(frozen=True, slots=True)
class AnsweredExercise:
    """One exercise of the page; `solution` is Markdown, or empty when it is not shown."""

    grade: Grade
    statement: str
    drawing: Markup
    parts: tuple[AnsweredPart, ...]
    solution: str


def feedback_page(
    marked: Marked, problem_set: ProblemSet, *, solutions: Mapping[str, str] | None = None
) -> str:
    """The feedback of one student as a page of HTML that needs nothing beside it.

    `solutions` gives the worked solution (Markdown, with the student's numbers) by problem code; None shows none.
    """
    keys = [grade.variant.problem.answer_name(part.part) for grade in marked.grades for part in grade.parts]
    pictures = _pictures(marked.figures, keys)
    return page(
        "feedback.html",
        title=_("{title}: feedback for {name}", title=problem_set.title, name=marked.student.name),
        marked=marked,
        problem_set=problem_set,
        exercises=[_exercise(grade, pictures, solutions or {}) for grade in marked.grades],
        other_pictures=pictures.get("", ()),
        waiting=sum(part.waits for grade in marked.grades for part in grade.parts),
        before_late=sum(grade.points for grade in marked.grades),
        late=spell(max(60.0, marked.late)) if marked.late > 0 else "",
        stopped=[_stopped(run) for run in marked.runs if run.status in {"error", "timeout"}],
        not_run=sum(run.status == "not run" for run in marked.runs),
    )


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


def _exercise(
    grade: Grade, pictures: Mapping[str, tuple[Picture, ...]], solutions: Mapping[str, str]
) -> AnsweredExercise:
    asked = exercise(grade.variant)
    prompts = {prompt.part.id: prompt for prompt in asked.prompts}
    parts: list[AnsweredPart] = []
    for part in grade.parts:
        prompt = prompts[part.part.id]
        parts.append(AnsweredPart(prompt, part, look(part.verdict), pictures.get(prompt.key, ())))
    solution = solutions.get(asked.problem.code, "")
    return AnsweredExercise(grade, asked.statement, drawing(asked), tuple(parts), solution)


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


def _stopped(run: CellRun) -> tuple[str, str]:
    """The cell, and what stopped it."""
    if run.error:
        return run.id, run.error
    return run.id, (
        _("It ran too long and was stopped.") if run.status == "timeout" else _("It ended in an error.")
    )
