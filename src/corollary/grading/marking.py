"""A whole submission marked: its notebook run in isolation, its answers held against the key outside."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Unmarked, Unread
from corollary.formula.value import Nothing, Text, Value
from corollary.grading.grade import Grade, Marked, PartGrade
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.points import grade
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.judge import asks
from corollary.messages import catalogue
from corollary.notebook.content import with_names
from corollary.notebook.locate import answer_id, cells_by_id, code_to_run, plot_cells, written_text
from corollary.notebook.notebook import notebook as handed_out
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.sandbox.file import Unreadable
from corollary.sandbox.job import Cell, Job
from corollary.sandbox.notebook import Notebook
from corollary.sandbox.result import CellRun, ExecutionResult
from corollary.sandbox.runner import Runner

_ = catalogue(__name__)

Keys = Mapping[str, Key]


def mark(
    sheet: Worksheet,
    keys: Keys,
    notebook: Notebook | Unreadable,
    runner: Runner,
    secret: bytes,
    late: float,
    reveal: bool = False,
) -> Marked:
    """The marks of one submission; `late` in seconds; `reveal`: feedback may give right values. Never raises for what is in it."""
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
    share, trouble = late_share(sheet.problem_set, late), executed.trouble
    return Marked(
        sheet.student, grades, executed.cells, executed.figures, executed.isolation.line, trouble, late, share
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
    return replace(
        graded,
        parts=tuple(
            _explained(part, prompt, ran) for part, prompt in zip(graded.parts, prompts, strict=True)
        ),
    )


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


def _explained(part: PartGrade, prompt: Prompt, runs: Mapping[str, CellRun]) -> PartGrade:
    """A part without an answer, whose cell failed: the student reads why."""
    run = runs.get(answer_id(prompt.key, prompt.part))
    if not (isinstance(part.verdict, Unread) and part.verdict.blank) or run is None or run.status == "ok":
        return part
    sentence = {
        "error": _("No answer came out of this part: its cell stopped with {error}.", error=run.error),
        "timeout": _("No answer came out of this part: its cell ran out of time."),
        "not run": _("No answer came out of this part: its cell was not reached any more."),
    }[run.status]
    return replace(part, verdict=Unread(sentence, blank=True), feedback=sentence)


def late_share(problem_set: ProblemSet, late: float) -> float:
    """What is kept of the marks of work that came so many seconds after the deadline."""
    return problem_set.scheme.late if late > 0 else 1.0


def not_marked(sheet: Worksheet, why: str, late: float) -> Marked:
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
    return Marked(sheet.student, grades, (), (), "", why, late, late_share(sheet.problem_set, late))


def _unreadable(sheet: Worksheet, keys: Keys, why: str, late: float) -> Marked:
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
    return Marked(sheet.student, grades, (), (), "", sentence, late, 1.0)
