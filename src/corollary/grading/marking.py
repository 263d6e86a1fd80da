"""A whole submission marked: its notebook run in isolation, its answers held against the key outside."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Unmarked, Unread
from corollary.formula.value import Nothing, Text, Value
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.near_misses import with_near_misses
from corollary.grading.part_grades import Grade, Marked, PartGrade
from corollary.grading.points import grade
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.judge_programs import asks
from corollary.messages import catalogue
from corollary.notebook.content import with_names
from corollary.notebook.locate import (
    answer_id,
    cells_by_id,
    code_to_run,
    plot_cells,
    written_elsewhere,
    written_text,
)
from corollary.notebook.notebook import notebook as handed_out
from corollary.notebook.unbound import one_line, unquoted, value_without_name
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.problem.late_penalty import Delay
from corollary.sandbox.file import Unreadable
from corollary.sandbox.job import Cell, CellRun, ExecutionResult, Job
from corollary.sandbox.notebook_file import Notebook
from corollary.sandbox.runner import Runner

_ = catalogue(__name__)

Keys = Mapping[str, Key]
WITHOUT_QUOTES = ("SyntaxError", "IndentationError", "NameError")  # what a missing pair of quotes ends in


def mark(
    sheet: Worksheet,
    keys: Keys,
    notebook: Notebook | Unreadable,
    runner: Runner,
    secret: bytes,
    late: Delay,
    reveal: bool = False,
) -> Marked:
    """The marks of one submission; `reveal`: feedback may give right values. Never raises for what is in it."""
    if isinstance(notebook, Unreadable):
        if notebook.machine_failed:
            return replace(not_marked(sheet, notebook.why, late), machine_failed=True)
        return _unreadable(sheet, keys, notebook.why, late)
    notebook = replace(notebook, node=with_names(notebook.node, sheet))
    executed = runner.execute(_job(sheet, keys, notebook, secret))
    if executed.machine_failed:
        return replace(not_marked(sheet, executed.trouble, late), machine_failed=True)
    grades = tuple(
        _grade(sheet, keys, exercise.problem.code, notebook, executed, secret, reveal)
        for exercise in sheet.exercises
    )
    return Marked(
        sheet.student,
        grades,
        executed.cells,
        executed.figures,
        executed.isolation.line,
        executed.trouble,
        late.seconds,
        late.share,
        tuple(_unbound(sheet, grades, notebook)),
    )


def _job(sheet: Worksheet, keys: Keys, notebook: Notebook, secret: bytes) -> Job:
    """What is asked of the notebook: nothing in it comes from the key but inputs for the student's functions."""
    calls = [
        ask
        for prompt in sheet.prompts
        if answer_type(prompt.part.answer_type).found_in == "function"
        for ask in asks(
            keys[prompt.problem.code].solution,
            keys[prompt.problem.code].variant,
            prompt.part,
            secret,
            sheet.student.id,
        )
    ]
    cells = tuple(Cell(name, source) for name, source in code_to_run(notebook.node, handed_out(sheet)))
    names = [
        name
        for prompt in sheet.prompts
        if answer_type(prompt.part.answer_type).found_in == "variable"
        for name in (prompt.name, prompt.key)
    ]
    return Job(cells, tuple(dict.fromkeys(names)), tuple(calls))


def _grade(
    sheet: Worksheet,
    keys: Keys,
    code: str,
    notebook: Notebook,
    executed: ExecutionResult,
    secret: bytes,
    reveal: bool,
) -> Grade:
    prompts = [prompt for prompt in sheet.prompts if prompt.problem.code == code]
    plots = plot_cells(notebook.node, sheet)
    answers = {prompt.part.id: _answer(prompt, notebook, executed) for prompt in prompts}
    elsewhere = tuple(figure for figure in executed.figures if figure.cell not in plots.values())
    runs = {
        prompt.part.id: ProgramRun(
            executed.calls,
            tuple(figure for figure in executed.figures if figure.cell == plots.get(prompt.key)),
            True,
            elsewhere,
            tuple(
                figure
                for figure in executed.figures
                if figure.cell in plots.values() and figure.cell != plots.get(prompt.key)
            ),
        )
        for prompt in prompts
    }
    problem_set = sheet.problem_set
    judged = judge(keys[code], answers, runs, secret=secret, student=sheet.student.id)
    graded = grade(
        keys[code],
        judged,
        problem_set.scheme,
        problem_set.weight(keys[code].variant.problem),
        reveal=reveal,
    )
    ran = _runs(notebook, executed)
    explained = tuple(
        _explained(part, prompt, notebook, ran) for part, prompt in zip(graded.parts, prompts, strict=True)
    )
    written, nameless = dict(answers), dict[str, str]()
    for prompt in prompts:
        part = prompt.part.id
        if isinstance(answers[part], Nothing):
            text = written_elsewhere(notebook.node, prompt)
            if bare := unquoted(prompt.name, text):
                written[part] = Text(bare)
                continue
            value, line = value_without_name(text, prompt.name)
            if value:
                written[part], nameless[part] = Text(value), line
    return with_near_misses(keys[code], replace(graded, parts=explained), written, nameless)


def _answer(prompt: Prompt, notebook: Notebook, executed: ExecutionResult) -> Value:
    if answer_type(prompt.part.answer_type).found_in == "cell":
        text = written_text(notebook.node, prompt)
        return Text(text) if text else Nothing()
    value = executed.values.get(prompt.name, Nothing())
    if isinstance(
        value, Nothing
    ):  # of a sheet, or from a habit, that has the part's id in place of its letter
        value = executed.values.get(prompt.key, value)
    return value


def _runs(notebook: Notebook, executed: ExecutionResult) -> dict[str, CellRun]:
    """How the cell of each answer fared, by the name it was handed out with."""
    by_id = {run.id: run for run in executed.cells}
    return {
        name: by_id[cell.id] for name, cell in cells_by_id(notebook.node).items() if cell.get("id") in by_id
    }


def _explained(part: PartGrade, prompt: Prompt, notebook: Notebook, runs: Mapping[str, CellRun]) -> PartGrade:
    """A part without an answer: where something was written for it a person reads that; where its cell failed the student reads
    why."""
    if not (isinstance(part.verdict, Unread) and part.verdict.blank):
        return part
    run = runs.get(answer_id(prompt.key, prompt.part))
    status, error = (
        ("ok", "") if run is None or run.error.startswith(WITHOUT_QUOTES) else (run.status, run.error)
    )
    if status == "ok":
        return _left_to_a_person(part, prompt, notebook)
    sentence = {
        "error": _("No answer was found: the cell of this part stopped with {error}.", error=error),
        "timeout": _("No answer was found: the cell of this part ran too long and was stopped."),
        "not run": _("No answer was found: the cell of this part was not run."),
    }[status]
    return replace(part, verdict=Unread(sentence, blank=True), feedback=sentence)


def _left_to_a_person(part: PartGrade, prompt: Prompt, notebook: Notebook) -> PartGrade:
    """A part whose cell was changed and gives its name no value, or whose answer stands where none is looked for."""
    text = written_elsewhere(notebook.node, prompt)
    if not text:
        return part
    bare = unquoted(prompt.name, text)
    sentence = (
        _(
            "Your text has no quotes, so Python could not read it; write {line}. Your teacher will mark it.",
            line=f'{prompt.name} = "{one_line(bare)}"',
        )
        if bare
        else _(
            "Your cell gives {name} no value. Your teacher will mark what you wrote in it.",
            name=prompt.name,
        )
    )
    return replace(part, verdict=Unmarked(sentence), answer=text, feedback=sentence)


def _unbound(sheet: Worksheet, grades: Iterable[Grade], notebook: Notebook) -> Iterator[str]:
    """A note on each part that waits for a person because its cell gives no answer."""
    parts = {(grade.variant.problem.code, part.part.id): part for grade in grades for part in grade.parts}
    for prompt in sheet.prompts:
        part, text = parts[prompt.problem.code, prompt.part.id], written_elsewhere(notebook.node, prompt)
        if text and part.waits and part.answer == text:
            yield _(
                "The cell of {name} gives no answer; your teacher will read its text: {text}",
                name=prompt.name,
                text=one_line(text),
            )


def not_marked(sheet: Worksheet, why: str, late: Delay) -> Marked:
    """A submission that could not be marked through no fault of its student: no points yet, and a person decides on every part."""
    grades = tuple(
        Grade(
            exercise.variant,
            tuple(
                PartGrade(prompt.part, Unmarked(why), 0.0, prompt.out_of, "", why)
                for prompt in exercise.prompts
            ),
        )
        for exercise in sheet.exercises
    )
    return Marked(sheet.student, grades, (), (), "", why, late.seconds, late.share)


def _unreadable(sheet: Worksheet, keys: Keys, why: str, late: Delay) -> Marked:
    """A file that is no notebook: nothing can be read, every part says so, and the report asks a person to look."""
    sentence = _("The notebook could not be opened. {why}", why=why)
    grades = tuple(
        Grade(
            keys[exercise.problem.code].variant,
            tuple(
                PartGrade(prompt.part, Unread(sentence), 0.0, prompt.out_of, "", sentence)
                for prompt in exercise.prompts
            ),
        )
        for exercise in sheet.exercises
    )
    return Marked(sheet.student, grades, (), (), "", sentence, late.seconds, 1.0)
