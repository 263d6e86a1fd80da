"""Whole notebooks that are honest and look odd: they earn what the answers in them are worth."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from datetime import timedelta
from pathlib import Path

import nbformat
import pytest
from nbformat import NotebookNode

from corollary.answers.quantity import read_quantity
from corollary.answers.question import Question
from corollary.answers.registry import answer_type
from corollary.answers.verdict import Right, Unmarked, Unread, Verdict
from corollary.course.demo.players import right_sources
from corollary.formula.errors import ParseError
from corollary.grading.marking import mark
from corollary.grading.part_grades import Marked, PartGrade
from corollary.grading.solutions import Solutions
from corollary.notebook.notebook import filled_in, notebook
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.bank import chapter_bank, find
from corollary.problem.late_penalty import IN_TIME, Delay
from corollary.problem.problem_set import read_set
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.sandbox.file import Unreadable
from corollary.sandbox.isolation import UNKNOWN
from corollary.sandbox.job import ExecutionResult
from corollary.sandbox.notebook_file import Notebook, notebook_of
from corollary.sandbox.runner import Runner
from corollary.sandbox.tagged import value_of
from corollary.sandbox.worker.encode import encode
from corollary.units.unit import read_unit

CODES = ("X12.5", "S12.2", "X12.12", "E12.3.1s", "X12.11")
Marks = Callable[[NotebookNode], Mapping[str, Verdict]]
WORDS = "The ball loses momentum to the floor, which moves away; in the frame of the floor it turns round."
ASTROPY = """
import sys, types
import numpy as np
package, units, module = (types.ModuleType(name) for name in ("astropy", "astropy.units", "astropy.units.quantity"))
class Quantity:
    def __init__(self, value, unit):
        self.value, self.unit = value, unit
Quantity.__module__ = "astropy.units.quantity"
"""


@pytest.fixture(scope="module")
def sheet(tmp_path_factory: pytest.TempPathFactory) -> Worksheet:
    bank = chapter_bank()
    path: Path = tmp_path_factory.mktemp("set") / "odd.md"
    path.write_text(f"---\ntitle: Odd\nproblems: [{', '.join(CODES)}]\n---\n")
    return worksheet(read_set(bank, path), Student("ada"), [chapter(find(bank, code)) for code in CODES])


@pytest.fixture(scope="module")
def marked(sheet: Worksheet) -> Iterator[Callable[[NotebookNode], Marked]]:
    solutions = Solutions(chapter_bank())
    keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
    with Runner() as runner:

        def of(node: NotebookNode) -> Marked:
            book = notebook_of(nbformat.writes(node).encode())
            assert isinstance(book, Notebook)
            return mark(sheet, keys, book, runner, b"secret", IN_TIME)

        yield of


@pytest.fixture(scope="module")
def marks(marked: Callable[[NotebookNode], Marked]) -> Marks:
    """The verdicts on a notebook, by the name of the answer: of two (program and figure) the worse."""
    return lambda node: {
        grade.variant.problem.answer_name(part.part): part.verdict
        for grade in marked(node).grades
        for part in grade.parts
    }


@pytest.fixture(scope="module")
def _whole(sheet: Worksheet) -> str:
    solutions = Solutions(chapter_bank())
    keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
    written = {prompt.key: WORDS for prompt in sheet.prompts if prompt.part.answer_type == "explain"}
    return filled_in(sheet, right_sources(sheet, keys) | written)


@pytest.fixture
def whole(_whole: str) -> NotebookNode:
    """A notebook in which everything is right."""
    return nbformat.reads(_whole, as_version=4)


def all_right(found: Mapping[str, Verdict]) -> bool:
    """Full marks, but for what a person reads."""
    return len(found) > 15 and all(isinstance(each, Right | Unmarked) for each in found.values())


def set_answer(node: NotebookNode, name: str, source: str) -> None:
    next(cell for cell in node.cells if cell.id == f"{name}_answer").source = source


def test_metadata_and_ids_both_lost(marks: Marks, whole: NotebookNode):
    for cell in whole.cells:
        cell.metadata = NotebookNode()
        del cell["id"]
    whole.metadata = NotebookNode()
    whole.nbformat_minor = 4
    found = marks(whole)
    assert all_right(found), found
    assert [name for name, each in found.items() if isinstance(each, Unmarked)] == ["X12_11_c"]


def test_a_module_that_a_cell_writes_is_imported(marks: Marks, whole: NotebookNode):
    module = "%%writefile helper.py\ndef momentum(m, v):\n    return m * v\n"
    whole.cells.insert(3, nbformat.v4.new_code_cell("import os\nos.listdir('.')\nimport json"))
    whole.cells.insert(4, nbformat.v4.new_code_cell(module))
    set_answer(whole, "X12_5_a", "import helper\nX12_5_a = helper.momentum(0.43, 20)")
    set_answer(whole, "X12_5_b", "from helper import momentum\nX12_5_b = momentum(m=0.43, v=20)")
    assert all_right(marks(whole))


def test_quantities_of_pint_as_they_are(marks: Marks, whole: NotebookNode):
    set_answer(
        whole,
        "X12_5_a",
        "import pint\nureg = pint.UnitRegistry()\nm, v = 0.43 * ureg.kg, ureg.Quantity('72 km/h')\nX12_5_a = m * v",
    )
    set_answer(whole, "X12_5_b", "X12_5_b = (m * v).to('newton * second')")
    set_answer(whole, "X12_5_c", "X12_5_c = (m * v / (100 * ureg.ms)).to(ureg.kilonewton)")
    set_answer(
        whole,
        "S12_2_a",
        "import numpy as np\nS12_2_a = 2.5 * ureg.kg * np.array([3.0, -4.0]) * ureg.m / ureg.s",
    )
    set_answer(whole, "S12_2_b", "S12_2_b = (S12_2_a[0]**2 + S12_2_a[1]**2)**0.5")
    assert all_right(marks(whole))


def test_quantities_of_astropy_as_they_are(marks: Marks, whole: NotebookNode):
    """Astropy is 80 MB; what is read of its quantities is their class, `value` and `unit`."""
    set_answer(whole, "X12_5_a", ASTROPY + "X12_5_a = Quantity(8.6, 'kg m / s')")
    set_answer(whole, "X12_5_c", "X12_5_c = Quantity(np.float64(0.086), 'kN')")
    set_answer(whole, "S12_2_a", "S12_2_a = Quantity(np.array([7.5, -10.0]), 'kg m / s')")
    set_answer(whole, "S12_2_b", "S12_2_b = Quantity(12.5, 'kg m s-1')")
    assert all_right(marks(whole))


def test_dictionaries_arrays_texts_and_words(marks: Marks, whole: NotebookNode):
    set_answer(whole, "X12_5_a", "X12_5_a = '8,6'")
    set_answer(whole, "X12_5_b", "X12_5_b = '8.6\\u200b kg\\u200dm/s'")
    set_answer(whole, "S12_2_a", "S12_2_a = {'y': -10, 'x': '7.5 kg m/s'}")
    set_answer(whole, "S12_2_c", "S12_2_c = 'the momentum only'")
    set_answer(whole, "X12_12_a", "X12_12_a = ['1.476 m/s to the left', '2.951 m/s to the right']")
    assert all_right(marks(whole))
    set_answer(whole, "S12_2_a", "import numpy as np\nS12_2_a = np.array([[7.5], [-10]])")
    set_answer(
        whole, "X12_12_a", "X12_12_a = {'block': '2.951 m/s to the right', 'sphere': '1.476 m/s to the left'}"
    )
    assert all_right(marks(whole))


def test_half_a_surrogate_ends_in_a_sentence(marks: Marks, whole: NotebookNode):
    """The one that `check` and `corollary read` say; the question mark of somebody unsure stays allowed."""
    text, asked = "8.6 \ud800", Question("a", "X12_5_a", ("value",), unit=read_unit("kg m/s"))
    read = read_quantity(text, asked.unit)
    assert isinstance(read, ParseError)
    assert "does not belong in a unit" in read.why
    assert read.why in answer_type("value").preview(value_of(encode(text)), asked).text
    set_answer(whole, "X12_5_a", "X12_5_a = '8.6 \\ud800'")
    found = marks(whole)["X12_5_a"]
    assert isinstance(found, Unread)
    assert read.why in found.why
    set_answer(whole, "X12_5_a", "X12_5_a = '8.6 kg m/s?'")
    assert all_right(marks(whole))


class NoRoom:
    """Stands for a runner whose machine fails while it runs a notebook, or never."""

    def __init__(self, trouble: str):
        self._trouble = trouble

    def execute(self, job: object) -> ExecutionResult:
        return ExecutionResult((), {}, {}, (), UNKNOWN, self._trouble, machine_failed=True)


@pytest.mark.parametrize("late", [IN_TIME, Delay(60.0, 1, 0.5, "late")])
def test_where_our_machine_fails_nothing_is_held_against_the_student(sheet: Worksheet, whole, late: Delay):
    """Whether it fails before the notebook is opened or while it runs: no points yet, every part for a person, the reason said."""
    solutions = Solutions(chapter_bank())
    keys = {each.problem.code: solutions.key(each.variant) for each in sheet.exercises}
    book = notebook_of(nbformat.writes(whole).encode())
    why = "There is no room left on the disk."
    for received in (book, Unreadable(why, machine_failed=True)):
        marked = mark(sheet, keys, received, NoRoom(why), b"secret", late)
        assert marked.machine_failed
        assert (marked.trouble, marked.late) == (why, late.seconds)
        parts = [part for grade in marked.grades for part in grade.parts]
        assert len(parts) > 15
        assert all(isinstance(part.verdict, Unmarked) and part.points == 0.0 for part in parts)
    assert not mark(sheet, keys, Unreadable("It is a picture."), NoRoom(why), b"secret", late).machine_failed


def test_what_comes_in_time_keeps_all_marks(problem_set_with_a_late_rule):
    due = problem_set_with_a_late_rule.due
    for seconds, share in ((0, 1.0), (-5, 1.0), (1, 0.5)):
        assert problem_set_with_a_late_rule.delay(due, due + timedelta(seconds=seconds)).share == share


@pytest.fixture
def problem_set_with_a_late_rule(tmp_path):
    path = tmp_path / "late.md"
    path.write_text(
        "---\ntitle: Late\ndue: 2026-12-01\ncredit: {late: 0.5}\nproblems:\n  - X12.5\n---\nAn introduction.\n",
        encoding="utf-8",
    )
    return read_set(chapter_bank(), path)


@pytest.mark.parametrize(
    ("source", "sentence"),
    [
        ("X12_5_a = 9.3 kg m/s", 'write X12_5_a = "9.3 kg m/s"'),
        ("X12_5_a = 9,3 kg m/s  # mine", 'write X12_5_a = "9,3 kg m/s"'),
        ("X12_5_a = m*v", 'write X12_5_a = "m*v"'),
        ("X12_5_a = -8.6 N s, to the left", 'write X12_5_a = "-8.6 N s, to the left"'),
        ("9.3", "Your cell gives X12_5_a no value"),
        ("'9.3 kg m/s'", "Your cell gives X12_5_a no value"),
        ("9.3 kg m/s", "Your cell gives X12_5_a no value"),
        ("x12_5_a = 9.3", "Your cell gives X12_5_a no value"),
        ("p = 9.3", "Your cell gives X12_5_a no value"),
        ("X12_5_a = None   # 9.3 kg m/s", "Your cell gives X12_5_a no value"),
        ("X12_5_a = None\n# 9.3 kg m/s", "Your cell gives X12_5_a no value"),
        ("X12_5_a: 9.3", "Your cell gives X12_5_a no value"),
        ("X12_5_a == 9.3", "Your cell gives X12_5_a no value"),
        ('"X12_5_a" == "9.3 kg m/s"', "Your cell gives X12_5_a no value"),
    ],
)
def test_what_was_written_without_giving_an_answer_waits_for_a_person(
    marked: Callable[[NotebookNode], Marked], whole: NotebookNode, source: str, sentence: str
):
    set_answer(whole, "X12_5_a", source)
    found = marked(whole)
    part = next(grade for grade in found.grades if grade.variant.problem.code == "X12.5")["a"]
    assert isinstance(part.verdict, Unmarked)
    assert sentence in part.feedback
    assert part.answer == source.removeprefix("X12_5_a = None\n")
    (note,) = found.notes
    assert "The cell of X12_5_a gives no answer" in note
    assert source.splitlines()[-1].split("#")[-1].strip() in note


def test_an_answer_cell_that_became_text_waits_for_a_person(
    marked: Callable[[NotebookNode], Marked], whole: NotebookNode
):
    cell = next(cell for cell in whole.cells if cell.id == "X12_5_a_answer")
    cell.cell_type, cell.source = "markdown", "X12_5_a = 9.3 kg m/s"
    del cell["outputs"], cell["execution_count"]
    found = marked(whole)
    part = next(grade for grade in found.grades if grade.variant.problem.code == "X12.5")["a"]
    assert isinstance(part.verdict, Unmarked)
    assert "9.3 kg m/s" in found.notes[0]


def test_an_answer_in_a_text_elsewhere_waits_for_a_person(
    marked: Callable[[NotebookNode], Marked], whole: NotebookNode, sheet: Worksheet
):
    blank = next(each for each in notebook(sheet).cells if each.id == "X12_5_a_answer").source
    set_answer(whole, "X12_5_a", blank)
    whole.cells.insert(5, nbformat.v4.new_markdown_cell("My answer:\n\n- X12_5_a = 9.3 kg m/s"))
    (note,) = marked(whole).notes
    assert "9.3 kg m/s" in note


@pytest.mark.parametrize(
    "change",
    [
        lambda blank: blank,
        lambda blank: "",
        lambda blank: "X12_5_a = None",
        lambda blank: "X12_5_a = ''  # ?",
        lambda blank: blank + "  \n\n",
        lambda blank: "import numpy as np\n" + blank,
        lambda blank: blank + '\ncheck("X12_5_a")',
    ],
)
def test_a_cell_without_an_answer_is_blank(
    marked: Callable[[NotebookNode], Marked],
    whole: NotebookNode,
    sheet: Worksheet,
    change: Callable[[str], str],
):
    blank = next(each for each in notebook(sheet).cells if each.id == "X12_5_a_answer").source
    set_answer(whole, "X12_5_a", change(blank))
    found = marked(whole)
    part = next(grade for grade in found.grades if grade.variant.problem.code == "X12.5")["a"]
    assert part.feedback == "No answer was given."
    assert not found.notes


@pytest.mark.parametrize(
    ("source", "typed"),
    [
        ("{name}: {right}", ": {right}"),
        ("{name} == {right}", "== {right}"),
        ("{name} := {right}", ":= {right}"),
        ("{right} N s", "{right} N s"),
        ("'{right} N s'", "'{right} N s'"),
        ("# {right} kg m/s", "# {right} kg m/s"),
        ("#{name} = {right}", "= {right}"),
        ("{name} = None\n{right}", "{right}"),
        ("{lower} = {right}", "= {right}"),
        ("{name} is {right} N s", "is {right} N s"),
    ],
)
def test_a_right_value_that_no_cell_gave_to_its_name_is_a_near_miss(
    marked: Callable[[NotebookNode], Marked],
    whole: NotebookNode,
    source: str,
    typed: str,
):
    fill = {"name": "X12_5_a", "lower": "x12_5_a", "right": "8.6"}
    set_answer(whole, "X12_5_a", source.format(**fill))
    part = next(grade for grade in marked(whole).grades if grade.variant.problem.code == "X12.5")["a"]
    assert isinstance(part.verdict, Unmarked)
    assert not part.points
    assert part.near is not None
    assert (part.near.kind, part.near.text) == ("value not given to its name", typed.format(**fill))


@pytest.mark.parametrize(
    "source",
    ["# 11.8", "X12_5_a == 11.8", "X12_5_a -= 8.6", "m = 0.43\nX12_5_a == 8.6", "X12_5_a == not 8.6"],
)
def test_what_is_wrong_or_no_value_is_no_near_miss(
    marked: Callable[[NotebookNode], Marked], whole: NotebookNode, source: str
):
    set_answer(whole, "X12_5_a", source)
    part = next(grade for grade in marked(whole).grades if grade.variant.problem.code == "X12.5")["a"]
    assert part.near is None


def part_of(found: Marked, name: str) -> PartGrade:
    named = {
        grade.variant.problem.answer_name(part.part): part for grade in found.grades for part in grade.parts
    }
    return named[name]


@pytest.mark.parametrize(
    ("answer", "below", "verdict"),
    [
        ("X12_5_a = mine*fast", ("mine, fast = 0.43, 20",), Right),
        ("X12_5_a = of(mine, fast)", ("def of(a, b):\n    return a*b", "mine = 0.43; fast = 20"), Right),
        (
            "X12_5_a = mine*fast",
            ("mine, fast = 0.43, 20", "fast = 3"),
            Unmarked,
        ),  # made in two ways: the order may matter
        ("total = total + 1\nX12_5_a = 8.6*total*mine", ("mine = 1; total = 0",), Unmarked),  # not twice
        ("parts.append(mine)\nX12_5_a = sum(parts)", ("mine = 8.6; parts = []",), Unmarked),
        (
            "X12_5_b = 1e9\nX12_5_a = mine*fast",
            ("mine, fast = 0.43, 20",),
            Right,
        ),  # what is given below it stays
    ],
)
def test_only_where_the_order_of_cells_makes_no_difference_is_one_of_them_run_again(
    marked: Callable[[NotebookNode], Marked],
    whole: NotebookNode,
    answer: str,
    below: tuple[str, ...],
    verdict: type,
):
    set_answer(whole, "X12_5_a", answer)
    whole.cells += [nbformat.v4.new_code_cell(source) for source in below]
    found = marked(whole)
    part = part_of(found, "X12_5_a")
    assert isinstance(part.verdict, verdict), part
    assert bool(part.points) == (verdict is Right)
    assert isinstance(part_of(found, "X12_5_b").verdict, Right)


@pytest.mark.parametrize(
    ("kind", "source"),
    [
        ("code", "8.6"),
        ("code", "my_p = 8.6"),
        ("code", "m = 0.43\nprint(m*20)"),
        ("markdown", "The momentum is 8.6 kg m/s"),
        ("question", "My answer: 8.6 kg m/s"),
    ],
)
def test_an_answer_beside_its_cell_is_shown_to_a_person(
    marked: Callable[[NotebookNode], Marked], whole: NotebookNode, kind: str, source: str
):
    set_answer(whole, "X12_5_a", "X12_5_a = None")
    at = next(index for index, cell in enumerate(whole.cells) if cell.id == "X12_5_a_answer")
    if kind == "question":
        whole.cells[at - 1].source += f"\n\n{source}"
    else:
        new = nbformat.v4.new_code_cell if kind == "code" else nbformat.v4.new_markdown_cell
        whole.cells.insert(at + 1, new(source))
    found = part_of(marked(whole), "X12_5_a")
    assert isinstance(found.verdict, Unmarked)
    assert (found.answer, found.points) == (source, 0.0)
