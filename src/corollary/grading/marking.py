"""A whole submission marked: its notebook run in isolation, its answers held against the key outside."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Right, Unmarked, Unread
from corollary.formula.value import Nothing, Text, Value
from corollary.grading.cell_order import CellOrder, cell_order
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.near_misses import with_near_misses
from corollary.grading.other_readings import text_typed
from corollary.grading.part_grades import Grade, Marked, PartGrade
from corollary.grading.points import grade
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.judge_programs import asks
from corollary.grading.stopped_cells import (
    Stops,
    label,
    may_differ,
    needs_person,
    no_answer,
    package_state,
    stops_in,
    why_stopped,
    with_parts,
)
from corollary.messages import catalogue
from corollary.notebook.content import with_names
from corollary.notebook.locate import (
    answer_id,
    cells_by_id,
    code_to_run,
    plot_cells,
    written_elsewhere,
    written_into_question,
    written_text,
)
from corollary.notebook.notebook import notebook as handed_out
from corollary.notebook.unbound import one_line, unquoted, value_without_name
from corollary.notebook.worksheet import Prompt, Worksheet
from corollary.problem.late_penalty import Delay
from corollary.sandbox.file import Unreadable
from corollary.sandbox.job import Cell, ExecutionResult, Job
from corollary.sandbox.notebook_file import Notebook
from corollary.sandbox.runner import Runner
from corollary.sandbox.stop_kinds import CellStop, stop_of

if TYPE_CHECKING:
    from nbformat import NotebookNode

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
    given_out = handed_out(sheet)
    job, order = _job(sheet, keys, notebook, given_out, secret)
    executed = runner.execute(job)
    if executed.machine_failed:
        return replace(not_marked(sheet, executed.trouble, late), machine_failed=True)
    came = _came_back(sheet, notebook, given_out, job, order, executed)
    grades = tuple(_grade(came, keys, exercise.problem.code, secret, reveal) for exercise in sheet.exercises)
    return Marked(
        sheet.student,
        grades,
        executed.cells,
        executed.figures,
        executed.isolation.line,
        executed.trouble,
        late.seconds,
        late.share,
        (*_unbound(came, grades), *_run_again(came)),
        with_parts(came.stops, came.lost, came.packages),
    )


@dataclass(frozen=True, slots=True)
class _CameBack:
    """A notebook that was run, with the sources of its sheet (`ours`).

    `values` are the answers, with those that a `second` run of a cell gave for certain (`accepted` are the parts that it made
    right); of those in `uncertain` the order of the cells cannot be known. `lost` has the parts without an answer, each with the
    index of the cell to blame; `packages` those that a part's function missed; of those in `texts` a person reads a text that
    gives no value.
    """

    sheet: Worksheet
    notebook: Notebook
    job: Job
    order: CellOrder
    executed: ExecutionResult
    values: Mapping[str, Value]
    second: frozenset[str]
    uncertain: Mapping[str, Value]
    stops: Stops
    ours: Mapping[str, str]
    lost: dict[str, int] = field(default_factory=dict[str, int])
    packages: dict[str, str] = field(default_factory=dict[str, str])
    texts: set[str] = field(default_factory=set[str])
    accepted: set[str] = field(default_factory=set[str])

    def own_cell(self, prompt: Prompt) -> NotebookNode | None:
        """The cell that a part's answer is written in."""
        return cells_by_id(self.notebook.node).get(answer_id(prompt.key, prompt.part))

    def index_of(self, cell: NotebookNode | None) -> int | None:
        name = cell.get("id") if cell is not None else None
        return next((index for index, each in enumerate(self.job.cells) if name and each.id == name), None)

    def error_of(self, cell: NotebookNode | None) -> str:
        index = self.index_of(cell)
        return "" if index is None else self.executed.cells[index].error

    def is_above_its_names(self, cell: NotebookNode | None) -> bool:
        """Whether a cell stopped at a name that a cell below it makes, and may not be run a second time."""
        index = self.index_of(cell)
        if index is None or self.job.cells[index].again:
            return False
        stop = stop_of(self.executed.cells[index])
        return stop is not None and stop.kind == "name" and self.order.made_below(index, stop.about)

    def package_missed(self, prompt: Prompt) -> str:
        """The package that a part's function missed when it was called; empty where none did."""
        for key, call in self.executed.calls.items():
            if key.rpartition("/")[0] == prompt.key and (stop := self.stops.of_error(call.error)) is not None:
                state = package_state(stop.about, self.sheet.problem_set.packages)
                return stop.about if state != "not allowed" else ""
        return ""


def _came_back(
    sheet: Worksheet,
    notebook: Notebook,
    given_out: NotebookNode,
    job: Job,
    order: CellOrder,
    executed: ExecutionResult,
) -> _CameBack:
    certain, uncertain = dict[str, Value](), dict[str, Value]()
    for index, found in executed.again.items():
        (certain if order.is_certain(index) else uncertain).update(found)
    values, second = executed.values | certain, frozenset(certain)
    stops = stops_in(job.cells, order, executed, notebook, sheet.problem_set.packages)
    ours = {cell.id: str(cell.source) for cell in given_out.cells}
    return _CameBack(sheet, notebook, job, order, executed, values, second, uncertain, stops, ours)


def _run_again(came: _CameBack) -> Iterator[str]:
    """A note where cells stand in another order than they were run in."""
    if came.accepted:
        yield _(
            "Some cells use names that only cells below them make, so they were run a second time, after all others. "
            "Put the cells in order: Kernel, Restart Kernel and Run All Cells must work."
        )


def _job(
    sheet: Worksheet, keys: Keys, notebook: Notebook, given_out: NotebookNode, secret: bytes
) -> tuple[Job, CellOrder]:
    """What is asked of the notebook, and its cells' names: nothing in it comes from the key but inputs for the student's functions."""
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
    sources = code_to_run(notebook.node, given_out)
    order = cell_order([source for _, source in sources])
    cells = tuple(
        Cell(name, source, order.may_run_again(index)) for index, (name, source) in enumerate(sources)
    )
    names = [
        name
        for prompt in sheet.prompts
        if answer_type(prompt.part.answer_type).found_in == "variable"
        for name in (prompt.name, prompt.key)
    ]
    return Job(cells, tuple(dict.fromkeys(names)), tuple(calls)), order


def _grade(came: _CameBack, keys: Keys, code: str, secret: bytes, reveal: bool) -> Grade:
    sheet, notebook, executed = came.sheet, came.notebook, came.executed
    prompts = [prompt for prompt in sheet.prompts if prompt.problem.code == code]
    plots = plot_cells(notebook.node, sheet)
    answers = {prompt.part.id: _answer(prompt, came) for prompt in prompts}
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
    explained = tuple(
        _explained(part, prompt, came) for part, prompt in zip(graded.parts, prompts, strict=True)
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


def _answer(prompt: Prompt, came: _CameBack) -> Value:
    if answer_type(prompt.part.answer_type).found_in == "cell":
        text = written_text(came.notebook.node, prompt)
        return Text(text) if text else Nothing()
    value = came.values.get(prompt.name, Nothing())
    if isinstance(
        value, Nothing
    ):  # of a sheet, or from a habit, that has the part's id in place of its letter
        value = came.values.get(prompt.key, value)
    return value


def _explained(part: PartGrade, prompt: Prompt, came: _CameBack) -> PartGrade:
    """A part without an answer: where something was written for it a person reads that; where a cell stopped the student reads why,
    and a person decides where the student's own computer need not have stopped it."""
    blank = isinstance(part.verdict, Unread) and part.verdict.blank
    if {prompt.name, prompt.key} & came.second:
        return _by_second_run(part, prompt, came)
    run_for_it = any(each.found_in in {"function", "figure"} for each in prompt.answer_types)
    loses = not part.waits and part.points < part.out_of
    doubt = came.stops.doubt_of(prompt, came.notebook) if loses else None
    if not blank and doubt is None and not (run_for_it and loses):
        return part
    if blank and (uncertain := came.uncertain.get(prompt.name, came.uncertain.get(prompt.key))) is not None:
        return _waiting(part, _order_matters(), text_typed(uncertain))
    own = came.own_cell(prompt)
    source = str(own.source) if own is not None else ""
    error = came.error_of(own)
    if blank and came.is_above_its_names(own):
        sentence = _(
            "Your cell uses a name that only a cell below it makes, and cannot be run twice. Your teacher will mark this part."
        )
        return _waiting(part, sentence, source)
    blame = came.stops.of_part(prompt, came.notebook)
    if doubt is not None and (blame is None or not came.stops.cells[blame].waits):
        blame = doubt
    own_fault = blame is None or blame == came.index_of(own)
    if blank and own_fault and error.startswith(WITHOUT_QUOTES):
        left = _left_to_a_person(part, prompt, came)
        if left is not part:
            return left
    if run_for_it and (package := came.package_missed(prompt)):
        came.packages[prompt.key] = package
        why = why_stopped(CellStop("package", package))
        return _waiting(part, needs_person(label(prompt), why), source)
    if blame is None:
        return _left_to_a_person(part, prompt, came) if blank else part
    cell = came.stops.cells[blame]
    if not blank and not cell.waits:
        return part
    came.lost[prompt.key] = blame
    why = why_stopped(cell.stop, came.sheet.problem_set.packages, cell.state)
    if not own_fault or own is None:
        why = _("it needs a cell that stopped: {why}", why=why)
    if cell.waits and blame == doubt:
        return _waiting(part, may_differ(label(prompt), cell.about), source)
    if cell.waits:
        return _waiting(part, needs_person(label(prompt), why), source)
    sentence = no_answer(label(prompt), why)
    return replace(part, verdict=Unread(sentence, blank=True), feedback=sentence)


def _by_second_run(part: PartGrade, prompt: Prompt, came: _CameBack) -> PartGrade:
    """A part whose value came when its cell was run a second time: what is not right may be due to the order of the cells, or the
    names may be letters of a formula that another exercise's cells happen to make."""
    if isinstance(part.verdict, Right | Follows):
        came.accepted.add(prompt.key)
        return part
    left = _left_to_a_person(part, prompt, came)
    value = came.values.get(prompt.name, came.values.get(prompt.key, Nothing()))
    return left if left is not part else _waiting(part, _order_matters(), text_typed(value))


def _order_matters() -> str:
    return _(
        "Your cells stand in another order than you ran them in, and the order makes a difference here. "
        "Your teacher will mark this part."
    )


def _waiting(part: PartGrade, sentence: str, answer: str) -> PartGrade:
    """The part without points, for a person to mark by this text."""
    return replace(part, verdict=Unmarked(sentence), points=0.0, answer=answer, feedback=sentence)


def _left_to_a_person(part: PartGrade, prompt: Prompt, came: _CameBack) -> PartGrade:
    """A part whose cell was changed and gives its name no value, or whose answer stands where none is looked for."""
    text = written_elsewhere(came.notebook.node, prompt) or written_into_question(
        came.notebook.node, came.ours, prompt
    )
    if not text:
        return part
    came.texts.add(prompt.key)
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
    return _waiting(part, sentence, text)


def _unbound(came: _CameBack, grades: Iterable[Grade]) -> Iterator[str]:
    """A note on each part that waits for a person because its cell gives no answer."""
    parts = {(grade.variant.problem.code, part.part.id): part for grade in grades for part in grade.parts}
    for prompt in came.sheet.prompts:
        part = parts[prompt.problem.code, prompt.part.id]
        if prompt.key in came.texts and part.waits:
            yield _(
                "The cell of {name} gives no answer; your teacher will read its text: {text}",
                name=prompt.name,
                text=one_line(part.answer),
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
