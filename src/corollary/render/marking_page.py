"""The page for marking by hand: question and figure, every answer to a part under the other, the rubric, the keyboard first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from corollary.problem.problem_set import ProblemSet
from corollary.records.manual_marks import RubricItem
from corollary.records.near_miss_groups import AnswerGroup, PartToMark
from corollary.render.feedback_page import PageFacts
from corollary.render.markdown import html, inline
from corollary.render.page import page
from corollary.render.wording import item_points


@dataclass(frozen=True, slots=True)
class PartQuestion:
    """The question of one part with one student's numbers; all but `opens` are HTML. `opens`: the problem's statement was not
    on the page before."""

    statement: Markup
    drawing: Markup
    asked: Markup
    opens: bool = True


@dataclass(frozen=True, slots=True)
class MarkingProgress:
    """How far the marking is: students by their place on the page, and those who were done before."""

    places: Mapping[str, int]
    done_before: int
    in_all: int


def marking_page(
    problem_set: ProblemSet,
    parts: Sequence[PartToMark],
    ids: Mapping[tuple[str, int], str],
    *,
    names: Mapping[str, str] | None,
    questions: Mapping[str, PartQuestion],
    numbers: Mapping[tuple[str, str], str],
    progress: MarkingProgress,
) -> str:
    """One page that needs nothing but the server that gave it. `ids` names a group of answers, by part and place among its
    groups, for the mark that is sent back; `names` are the students' by their ids, None where the marking is anonymous. `questions`
    go by the part's key, `numbers` by student and problem, as Markdown in one line."""
    return page(
        "mark.html",
        title=f"{problem_set.title}: marking",
        script="mark.js",
        style=("report.css", "mark.css"),
        sends=True,
        formulas=True,
        heading=problem_set.title,
        parts=parts,
        ids=ids,
        names=names,
        questions=questions,
        numbers=numbers,
        progress=progress,
        item_points=item_points,
        ticked=ticked,
        rubric_record=rubric_record,
    )


def question_of(facts: PageFacts, key: str, before: set[str]) -> PartQuestion | None:
    """The question of a part from what a feedback page is made of; `before` takes the code of each problem that is shown."""
    for exercise in facts.exercises:
        for part in exercise.parts:
            if part.key == key:
                opens = exercise.code not in before
                before.add(exercise.code)
                options = "".join(
                    f"<li><b>{each.letter}</b> <span>{each.text}</span></li>" for each in part.options
                )
                asked = part.asked + (f'<ul class="options">{options}</ul>' if options else "")
                return PartQuestion(
                    Markup(exercise.statement), Markup(exercise.drawing), Markup(asked), opens
                )
    return None


def ticked(group: AnswerGroup, item: RubricItem) -> bool:
    """Whether a person has ticked the item for this answer."""
    rubric = None if group.given is None else group.given.rubric
    return rubric is not None and any(each.id == item.id for each in rubric)


def rubric_record(items: Sequence[RubricItem], out_of: float) -> list[dict[str, object]]:
    """The items as the page's program takes them."""
    return [
        {
            "id": item.id,
            "text": item.text,
            "html": inline(item.text),
            "points": round(item.share * out_of, 2),
            "share": item.share,
            "words": item_points(item, out_of),
        }
        for item in items
    ]


def details_html(asked: PartQuestion | None, numbers: str, model: str) -> dict[str, str]:
    """Question and model answer with one student's numbers, as HTML."""
    question = (
        "" if asked is None else f'{asked.statement}<div class="drawing">{asked.drawing}</div>{asked.asked}'
    )
    return {"question": question, "numbers": inline(numbers), "model": html(model)}
