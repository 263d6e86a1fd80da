"""What a student gets back: points, and for every part what was asked, how the answer was read, and what is said of it."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from corollary.answers.verdict import Unmarked, Unread
from corollary.grading.grade import Grade, Marked, PartGrade
from corollary.notebook.worksheet import Prompt, exercise
from corollary.problem.problem_set import ProblemSet
from corollary.render.drawing import drawing
from corollary.render.page import page
from corollary.render.verdict_look import Look, look
from corollary.sandbox.result import CellRun, Figure

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
                return "What you wrote:"
            case Unmarked():
                return "Your answer:"
            case _:
                return "Your answer, as read:"


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
        title=f"{problem_set.title}: feedback for {marked.student.name}",
        marked=marked,
        problem_set=problem_set,
        exercises=[_exercise(grade, pictures, solutions or {}) for grade in marked.grades],
        other_pictures=pictures.get("", ()),
        waiting=sum(part.waits for grade in marked.grades for part in grade.parts),
        before_late=sum(grade.points for grade in marked.grades),
        late=spell(marked.late) if marked.late > 0 else "",
        stopped=[_stopped(run) for run in marked.runs if run.status in {"error", "timeout"}],
        not_run=sum(run.status == "not run" for run in marked.runs),
    )


def spell(seconds: float) -> str:
    """A length of time in its two leading units: 2 days 3 h, 5 min."""
    minutes = max(1, round(seconds / 60))
    days, hours, minutes = minutes // 1440, minutes // 60 % 24, minutes % 60
    words = [
        f"{days} day{'s' * (days > 1)}" if days else "",
        f"{hours} h" if hours else "",
        f"{minutes} min" if minutes else "",
    ]
    return " ".join([word for word in words if word][:2])


def describe(figure: Figure) -> str:
    """A student's figure in a sentence, for those who cannot see it."""
    axes = []
    for one in figure.axes:
        shows = f"{len(one.lines)} curve{'s' * (len(one.lines) != 1)}"
        labels = (("titled", one.title), ("x axis", one.xlabel), ("y axis", one.ylabel))
        axes.append(", ".join([shows, *(f"{name} “{text}”" for name, text in labels if text)]))
    return "Your figure: " + ("; ".join(axes) or "nothing is drawn in it")


def _exercise(
    grade: Grade, pictures: Mapping[str, tuple[Picture, ...]], solutions: Mapping[str, str]
) -> AnsweredExercise:
    asked = exercise(grade.variant)
    prompts = {prompt.part.id: prompt for prompt in asked.prompts}
    parts = []
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
        key = max(
            (key for key in keys if figure.cell == key or figure.cell.startswith(key + "_")),
            key=len,
            default="",
        )
        drawn = figure.png is not None and figure.png.startswith(PNG)
        source = (
            "data:image/png;base64," + base64.b64encode(figure.png).decode() if drawn and figure.png else ""
        )
        found[key] = (*found.get(key, ()), Picture(source, describe(figure)))
    return found


def _stopped(run: CellRun) -> tuple[str, str]:
    """The cell, and what stopped it."""
    return run.id, run.error or (
        "It ran too long and was stopped." if run.status == "timeout" else "It ended in an error."
    )
