"""A worksheet as a notebook: one file for one student and a whole set, which opens and runs wherever Jupyter and numpy do."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

import bz2
import json
import re
from base64 import b64encode, b85encode
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import lru_cache
from importlib.metadata import PackageNotFoundError, packages_distributions, version
from importlib.resources import files

import nbformat
from nbformat import NotebookNode

from corollary.answers.question import Question
from corollary.answers.registry import folder
from corollary.figure.svg import on_paper
from corollary.messages import N_, catalogue, in_convention, spoken
from corollary.notebook.cells import answer_cell, graded_cell, program_cell, reading_cell, written_cell
from corollary.notebook.locate import cell_id
from corollary.notebook.packing import catalogues, modules
from corollary.notebook.worksheet import Exercise, Prompt, Worksheet
from corollary.problem.dates import in_words
from corollary.problem.packages import listed
from corollary.units.unit_table import rows_of_others
from corollary.version import DISTRIBUTION, __version__

_ = catalogue(__name__)

CELL = """\
# {first}
# {second}
def corollary(carried=(
{carried}
)):
    import base64, bz2, json, sys
    if sys.version_info < (3, 11):
        return lambda *names: print({too_old!r})
    carried, loader = json.loads(bz2.decompress(base64.b85decode(carried))), {{"__name__": "corollary_carried"}}
    exec(carried["loader"], loader)
    return loader["checker"](carried, globals())

check = corollary()"""
LINE = (
    9000  # characters; VS Code breaks a line of 10 000 into a hundred lines of the screen, and folds no cell
)


def check_source(sheet: Worksheet) -> str:
    """The cell for one worksheet: it holds what is asked, and nothing of what is right. Raises NotCarried."""
    prompts = [prompt for prompt in sheet.prompts if prompt.answer_types[0].found_in != "cell"]
    return CELL.format(
        first=_(
            'Run this cell first: check("...") then says how an answer is read, never whether it is right.'
        ),
        second=_(
            "No answer is hidden in it, only the code that reads yours when they are marked, compressed; print(check.source) shows it."
        ),
        too_old=_("check needs Python 3.11 or newer; without it your answers still count"),
        carried=_of_set(tuple(prompts)),
    )


# By identity: everybody's questions are the same, only the numbers are not, and to hash them all takes longer than a notebook.
# What the questions are made of is held, so that its id stays its own.
_OF_SET: dict[tuple[str | int, ...], tuple[list[object], str]] = {}
MOST_SETS = 64


def _of_set(prompts: tuple[Prompt, ...]) -> str:
    made_of = [each for prompt in prompts for each in (prompt.problem, prompt.part)]
    key = (spoken(), *map(id, made_of))
    if key not in _OF_SET:
        if len(_OF_SET) >= MOST_SETS:
            _OF_SET.clear()
        _OF_SET[key] = list(made_of), _carried(spoken(), tuple(prompt.question for prompt in prompts))
    return _OF_SET[key][1]


@lru_cache(maxsize=64)
def _carried(code: str, questions: tuple[Question, ...]) -> str:
    types = tuple(sorted({question.types[0] for question in questions}))
    carried = {
        "loader": files("corollary.notebook").joinpath("carried.py").read_text(encoding="utf-8"),
        "versions": _versions(types),
        "folders": {name: folder(name) for name in types},
        "units": rows_of_others(),
        "questions": [question.as_data() for question in questions],
        "modules": dict(modules(types)),
        "language": code,
        "catalogues": dict(catalogues(modules(types))),
    }
    packed = b85encode(bz2.compress(json.dumps(carried, ensure_ascii=False).encode())).decode()
    return "\n".join(f"    {packed[at : at + LINE]!r}" for at in range(0, len(packed), LINE))


def _versions(types: tuple[str, ...]) -> dict[str, str]:
    """The packages that the code comes from, each with its version, as an installation names it."""
    others = {folder(name).partition(".")[0] for name in types} - {"corollary"}
    owners = dict(packages_distributions()) if others else dict[str, list[str]]()
    try:
        ours = version(DISTRIBUTION)  # between two releases with its commit
    except PackageNotFoundError:  # a checkout that nobody has installed
        ours = __version__
    return {DISTRIBUTION: ours} | {
        owner: version(owner) for package in sorted(others) for owner in owners.get(package, [])
    }


METADATA = {
    "kernelspec": {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"},
    "language_info": {
        "name": "python",
        "file_extension": ".py",
        "mimetype": "text/x-python",
        "pygments_lexer": "ipython3",
    },
}
HOW_TO_ANSWER = N_(
    """\
**How to answer**

1. Run everything once: *Run ▸ Run All Cells*. The folded cell below defines `check`.
2. Put your answer in place of `None`: a number in the unit asked for, or text with a unit of your own, such as `"3,2 km/h"`.
   Give three figures; zeros at the end of a whole number count as far as two (200 is 2.0e2).
3. Run the cell below your answer: it says how your answer is **read**, not whether it is right.
4. Where *Your answer here.* stands, double-click and write. Then save, and hand in this one file."""
)
OF_CHAPTER = re.compile(r"[A-Z]+12\.")
EQUATION_NUMBERS = N_(
    "5. Equation numbers in your feedback, such as (12.29), are those of the chapter *Momentum, Impulse, and Collisions*."
)
RUN_FIRST = N_("Run the folded cell above first: Run ▸ Run All Above Selected Cell.")
CLOSING = N_(
    """\
---

**Before you hand in:** *Kernel ▸ Restart Kernel and Run All Cells*. The last cell then says how every answer is read. Save."""
)


def notebook(sheet: Worksheet) -> NotebookNode:
    """The notebook of one student. Raises ValueError when two parts of the set would share a name."""
    cells = list(_cells(sheet))
    if twice := [name for name, count in Counter(cell.id for cell in cells).items() if count > 1]:
        raise ValueError(
            f"two cells of {sheet.problem_set.name} would be called {twice[0]}; rename one of the parts"
        )
    about = {"corollary": {"set": sheet.problem_set.name, "student": sheet.student.id}}
    return NotebookNode(
        cells=cells, metadata=nbformat.from_dict(METADATA | about), nbformat=4, nbformat_minor=5
    )


def filled_in(sheet: Worksheet, sources: Mapping[str, str]) -> str:
    """The text of a student's notebook file, with other sources in the cells of these ids."""
    nb = notebook(sheet)
    for cell in nb.cells:
        cell.source = sources.get(cell.id, cell.source)
    return file_text(nb)


def file_text(nb: NotebookNode) -> str:
    """The text of an .ipynb file: what nbformat writes, put together of the cells' texts, of which most are everybody's."""
    if not nb.cells or any(cell.get("outputs") or "nbgrader" not in cell.metadata for cell in nb.cells):
        return nbformat.writes(nb) + "\n"
    cells = ",\n  ".join(map(_cell_text, nb.cells))
    rest = _json({name: value for name, value in nb.items() if name != "cells"})
    return f'{{\n "cells": [\n  {cells}\n ],{rest[1:]}\n'


def _cell_text(cell: NotebookNode) -> str:
    """A cell of a sheet that was not run, as it stands in the file."""
    metadata = json.dumps(cell.metadata | {"nbgrader": cell.metadata["nbgrader"] | {"checksum": CHECKSUM}})
    around = _around(cell.cell_type, cell.get("id", ""), metadata)
    return f"{around[0]}{cell.metadata['nbgrader']['checksum']}{around[1]}{_lines(cell.source)}{around[2]}"


CHECKSUM, SOURCE = "the checksum", "the source"


@lru_cache(maxsize=1024)
def _around(kind: str, name: str, metadata: str) -> tuple[str, str, str]:
    """The text before the checksum of a cell, between it and the source, and behind: the same on everybody's sheet."""
    cell: dict[str, object] = {"cell_type": kind, "metadata": json.loads(metadata), "source": SOURCE}
    cell |= {"id": name} if name else {}
    cell |= {"execution_count": None, "outputs": []} if kind == "code" else {}
    before, _, rest = _json(cell).replace("\n", "\n  ").partition(CHECKSUM)
    between, _, behind = rest.rpartition(json.dumps(SOURCE))
    return before, between, behind


@lru_cache(maxsize=1024)
def _lines(source: str) -> str:
    """A source as the list of its lines."""
    lines = ",\n    ".join(
        [json.dumps(line, ensure_ascii=False) for line in source.splitlines(keepends=True)]
    )
    return f"[\n    {lines}\n   ]" if lines else "[]"


def _json(data: object) -> str:
    return json.dumps(data, ensure_ascii=False, indent=1, sort_keys=True, separators=(",", ": "))


def _cells(sheet: Worksheet) -> Iterator[NotebookNode]:
    yield reading_cell("title", _title(sheet))
    of_chapter = any(OF_CHAPTER.match(exercise.problem.code) for exercise in sheet.exercises)
    numbers = f"\n{_(EQUATION_NUMBERS)}" if of_chapter else ""
    yield reading_cell("how_to_answer", _(HOW_TO_ANSWER) + numbers + _packages(sheet))
    yield program_cell("setup", check_source(sheet), folded=True)
    for exercise in sheet.exercises:
        yield from _exercise_cells(exercise)
    yield reading_cell("closing", _(CLOSING))
    yield program_cell("check_all", _checking(""))


def _packages(sheet: Worksheet) -> str:
    """What cells may import, where the set or its course declares it."""
    if sheet.problem_set.packages is None or all(
        each.found_in == "cell" for prompt in sheet.prompts for each in prompt.answer_types
    ):
        return ""
    names = ", ".join(f"`{each}`" for each in listed(sheet.problem_set.packages))
    return "\n\n" + _(
        "Your cells may import these packages, which are there when they are marked: {names}.", names=names
    )


def _exercise_cells(exercise: Exercise) -> Iterator[NotebookNode]:
    prefix = exercise.problem.prefix
    yield reading_cell(
        f"{prefix}_statement", _heading(exercise) + "\n\n" + exercise.statement + _letters(exercise)
    )
    if exercise.figure:
        yield reading_cell(f"{prefix}_figure", picture(exercise.figure, exercise.figure_alt))
    for prompt in exercise.prompts:
        yield from _part_cells(prompt)


def _letters(exercise: Exercise) -> str:
    """The letters that a formula may use where a number is asked for; "" where a part that is answered in formulas lists them."""
    types = [prompt.answer_types[0] for prompt in exercise.prompts]
    symbols = ", ".join(
        f"`{each.name}`" for prompt in exercise.prompts[:1] for each in prompt.question.symbols
    )
    if not symbols or not any(each.formulas_too for each in types) or any(each.in_symbols for each in types):
        return ""
    return "\n\n" + _("*A number may also be given as a formula of {symbols}.*", symbols=symbols)


def _part_cells(prompt: Prompt) -> Iterator[NotebookNode]:
    key, question = prompt.key, prompt.question
    yield reading_cell(f"{key}_text", _question(prompt))
    for each in prompt.answer_types:
        if each.found_in == "cell":
            yield written_cell(key, each.blank(question), prompt.out_of)
            return
        yield answer_cell(cell_id(key, each), each.blank(question))
    yield graded_cell(key, _checking(f'"{question.name}"'), prompt.out_of)


def _checking(names: str) -> str:
    """A check; it fails where it is not defined, as after a restart: nbgrader takes silence for full marks."""
    return f'assert "check" in globals(), {json.dumps(_(RUN_FIRST), ensure_ascii=False)}\ncheck({names})'


def picture(svg: str, alt: str) -> str:
    """An SVG drawing as Markdown that carries it along, on a light sheet that is readable in a dark theme too."""
    words = " ".join(alt.replace("[", "(").replace("]", ")").split())
    return f"![{words}](data:image/svg+xml;base64,{b64encode(on_paper(svg).encode()).decode()})"


def points(number: float) -> str:
    """`1.5 points`."""
    return _.plural(
        "{number} point", "{number} points", 1 if number == 1 else 2, number=in_convention(f"{number:g}")
    )


def _title(sheet: Worksheet) -> str:
    about = sheet.problem_set
    facts = [f"**{sheet.student.name}**"] if sheet.student.id else []
    if about.due is not None:
        facts.append(_("due {moment}", moment=in_words(about.due)))
    facts.append(points(sum(prompt.out_of for prompt in sheet.prompts)))
    texts = (f"# {about.title}", " · ".join(facts), about.late_rule, about.introduction)
    return "\n\n".join(filter(None, texts))


def _heading(exercise: Exercise) -> str:
    total = points(sum(prompt.out_of for prompt in exercise.prompts))
    return f"---\n\n## {exercise.problem.code} {exercise.problem.title}\n\n*{total}*"


def _question(prompt: Prompt) -> str:
    part = prompt.part
    lines = [f"#### ({part.heading_letter}) {part.title} ({points(prompt.out_of)})"]
    if prompt.text:
        lines.append(prompt.text)
    if prompt.options:
        lines.append("\n".join(f"- **({option.mark})** {option.text}" for option in prompt.options))
    if expected := prompt.answer_types[0].heading(prompt.question):
        lines.append(f"*{expected}*")
    return "\n\n".join(lines)
