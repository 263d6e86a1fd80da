"""The page to practise on: its frame, and the pieces that it asks for one by one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from corollary.answers.registry import answer_type
from corollary.answers.table.entry import heads as table_heads
from corollary.answers.verdict import Unmarked, Verdict
from corollary.grading.part_grades import PartGrade
from corollary.messages import catalogue, spoken
from corollary.notebook.worksheet import Exercise, Prompt
from corollary.practice.practice import Posed, Practice
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.problem.translation import in_language
from corollary.render.page import drawing, environment, page
from corollary.render.wording import look, wanted

_ = catalogue(__name__)


@dataclass(frozen=True, slots=True)
class Field:
    """How a part is answered on the page: `labels` name its text fields (one without a label, or one for each component);
    `columns` are the heads of a table, whose entries they are."""

    prompt: Prompt
    kind: str
    labels: tuple[str, ...] = ()
    text: str = ""
    columns: tuple[str, ...] = ()

    @property
    def part(self) -> str:
        return self.prompt.part.id


def practice_page(
    practice: Practice, verdicts: Mapping[str, str] | None = None, sheet: Sequence[tuple[str, int]] = ()
) -> str:
    """The frame: every problem by topic, and what the script says, in the reader's language. The exercises of a `sheet`, by code and
    number, come first.

    With the pieces of `verdicts` by their words it is a page of its own, answered from files beside it; else by a server.
    """
    titled = [in_language(each) for each in practice.problems]
    topics = [
        (topic.replace("_", " "), list(problems))
        for topic, problems in groupby(
            sorted(titled, key=lambda each: each.topic), key=lambda each: each.topic
        )
    ]
    return page(
        "practise.html",
        title=_("Practise"),
        lang=spoken(),
        style="practise.css",
        script=("animation.js", "ask_server.js" if verdicts is None else "ask_files.js", "practise.js"),
        sends=verdicts is None,
        loads=verdicts is not None,
        topics=topics,
        words=_words(),
        verdicts=verdicts or {},
        sheet=list(sheet),
    )


def exercise_piece(posed: Posed) -> str:
    """One exercise: what is asked, and a field for each part."""
    asked = posed.exercise
    return _piece(
        "practise_exercise.html",
        exercise=asked,
        drawing=drawing(asked),
        fields=[field(prompt) for prompt in asked.prompts],
        many=more_numbers(asked.problem),
        wanted=wanted,
    )


def verdict_piece(grade: PartGrade) -> str:
    """What is said of an answer."""
    by_person = marked_by_a_person(grade.part)
    seen = look(grade.verdict)
    return _piece(
        "practise_verdict.html",
        look=seen,
        phrase=_("Compare it with the worked solution below") if by_person else seen.phrase,
        feedback="" if by_person else grade.feedback,
    )


def verdict_look(verdict: Verdict | None) -> str:
    """What stands above the sentence on an answer; of none, that it is compared with the worked solution."""
    seen = look(verdict or Unmarked(""))
    phrase = seen.phrase if verdict else _("Compare it with the worked solution below")
    return _piece("practise_verdict.html", look=seen, phrase=phrase, feedback="")


def field(prompt: Prompt) -> Field:
    """The field that fits the answer type; "none" for what cannot be given on a page, such as a drawing."""
    part, its_type = prompt.part, answer_type(prompt.part.answer_type)
    if its_type.found_in == "figure":
        return Field(prompt, "none")
    if its_type.found_in in ("function", "cell"):
        text = its_type.blank(prompt.question) if its_type.found_in == "function" else ""
        return Field(prompt, "lines", text=text)
    if prompt.options:
        return Field(prompt, "options")
    if its_type.in_lines:
        return Field(prompt, "lines")
    if part.rows:
        return Field(prompt, "texts", tuple(map(str, part.components)), columns=table_heads(prompt.question))
    if part.components and its_type.lists_components:
        return Field(prompt, "texts", tuple(part.components))
    return Field(prompt, "texts", ("",))


def more_numbers(problem: Problem) -> bool:
    """Whether another turn has other numbers."""
    return any(given.grid.count > 1 for given in problem.givens)


def asked_parts(exercise: Exercise) -> Sequence[str]:
    """The parts that the page judges."""
    return [
        each.part.id
        for each in exercise.prompts
        if field(each).kind != "none" and not marked_by_a_person(each.part)
    ]


def marked_by_a_person(part: Part) -> bool:
    """Whether nothing but a comparison with the worked solution can say how good the answer is."""
    return answer_type(part.answer_type).found_in == "cell"


def _piece(template: str, **facts: object) -> str:
    return environment().get_template(template).render(**facts)


def _words() -> dict[str, str]:
    """What the page's script says."""
    return {
        "ended": _("The program behind this page has ended; start `corollary practise` again."),
        "missing": _("The file {file} is missing beside this page; copy the whole folder."),
        "empty": _("Write an answer first."),
        "checking": _("Checking …"),
        "noHint": _("There is no hint for this part."),
        "noMoreHints": _("That was the last hint. The worked solution below goes step by step."),
        "solved": _("All of it is right. It comes back in {days}."),
        "again": _("It comes back soon, with other numbers."),
        "dueAgain": _("due again"),
        "goOn": _("go on with it"),
        "result": _("Show the result"),
        "equations": _("Show the equations"),
        "try": _("Try it first; then look."),
        "day": _("1 day"),
        "days": _("{count} days"),
        "done": _("{done} of {count} solved"),
        "noneDue": _("Nothing is due and nothing new is left; choose any problem."),
        "notKept": _("This browser stores nothing for this page: your progress is lost when it is closed."),
    }
