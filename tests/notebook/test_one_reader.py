"""`check`, where nothing is installed, and the marker say the same of every text, word for word."""

from __future__ import annotations

import ast
import json
import random
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
import pytest

from corollary.answers.answer import Answer, Blank, Chain, Formulas, Letter, Numbers, Prose, Unclear
from corollary.answers.registry import answer_type, judging
from corollary.formula.value import Items, Nothing, Text, Value
from corollary.notebook.notebook import check_source
from corollary.notebook.worksheet import Prompt, Worksheet, worksheet
from corollary.problem.bank import chapter_bank, load
from corollary.problem.problem_set import read_set
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.sandbox.protocol import Encoded, to_value
from corollary.sandbox.worker.encode import encode

TESTS = Path(__file__).parents[1]
CORPORA = ("answers", "formula", "grading", "notebook", "records", "units")
SEED = 9
LONGEST = 160
# Answers that `check` refused and the marker marked right, when there were two readers.
ONCE_DISAGREED: list[tuple[str, Any]] = [
    ("X12_2_a", "option b"),
    ("X12_2_a", "“b”"),
    ("X12_8_b", "-m v cos θ/M"),
    ("X12_8_a", "(m v cosθ, m v sinθ)"),
    ("X12_8_a", "m v cosθ î + m v sinθ ĵ"),
    ("E12_5_1_a", "(m_A+m_B)/m_A sqrt(2gh)"),
]
ALONE = """
import contextlib, io, json, sys
for name in ("corollary", "flint", "msgspec", "nbformat", "sympy", "numpy", "IPython"):
    sys.modules[name] = None
job = json.load(sys.stdin)
space = {}
exec(job["cell"], space)
lines = []
for name, value in job["tries"]:
    space[name] = value
    with contextlib.redirect_stdout(io.StringIO()) as out:
        space["check"](name)
    lines.append(out.getvalue())
json.dump(lines, sys.stdout)
"""

Try = tuple[str, Any]


@pytest.fixture(scope="module")
def sheet(tmp_path_factory: pytest.TempPathFactory) -> Worksheet:
    """One worksheet that asks everything the chapter asks."""
    bank = chapter_bank()
    problems = load(bank)
    path = tmp_path_factory.mktemp("sets") / "all.md"
    codes = "".join(f"  - {problem.code}\n" for problem in problems)
    path.write_text(f"---\ntitle: Everything\nproblems:\n{codes}---\nAll of it.\n", encoding="utf-8")
    return worksheet(read_set(bank, path), Student("ada"), map(chapter, problems))


@pytest.fixture(scope="module")
def prompts(sheet: Worksheet) -> dict[str, Prompt]:
    return {prompt.name: prompt for prompt in sheet.prompts if prompt.answer_types[0].found_in == "variable"}


@cache
def typed() -> tuple[str, ...]:
    """Every short text that stands in the tests of the rooms where answers are read."""
    found: dict[str, None] = {}
    for room in CORPORA:
        for path in sorted(TESTS.joinpath(room).glob("*.py")):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Constant) and isinstance(node.value, str):
                    found |= {node.value: None} if len(node.value) <= LONGEST else {}
    return tuple(found)


def own_samples(prompt: Prompt) -> list[Any]:
    """What the answer type makes of a right answer, whichever that is."""
    question = prompt.question
    symbols = [*question.symbol_names, "pi"]
    truth: Any = [8.6, -3.25, 0.0, 12.0, 1e-4, 7.0][: max(1, len(question.components))]
    if question.options:
        truth = question.options[0]
    elif prompt.answer_types[0].in_symbols:
        truth = "*".join(symbols)
    elif not prompt.answer_types[0].lists_components:
        truth = f"{symbols[0]} = {'*'.join(symbols)}\n{symbols[-1]}^2 = {symbols[0]}"
    return [sample.answer for sample in judging(prompt.part.answer_type).samples(truth, question)]


def sent(value: Any) -> Value:
    """A value as it reaches the marker."""
    return to_value(msgspec.convert(encode(value), Encoded))


def marked(prompt: Prompt, value: Any) -> str:
    """What `check` has to say, by the marker's reading."""
    plain = sent(value)
    answer = answer_type(prompt.part.answer_type).read(plain, prompt.question)
    return f"{prompt.name}: {in_words(answer)}\n"


def in_words(answer: Answer) -> str:
    match answer:
        case Blank():
            return "no answer yet"
        case Unclear(why):
            return f"cannot be read: {why}"
        case Numbers(figures=figures, as_read=as_read):
            remark = (
                f": {answer.misfit}" if answer.misfit else f", {answer.missing}" if answer.missing else ""
            )
            if answer.open_words and not remark:
                own = f"\u201c{answer.open_words}\u201d"
                return f"read as {as_read}; your teacher will read {own}; write only the number and its unit"
            same = figures[0] if len(set(figures)) == 1 else 0
            count = f" ({same} figure{'s' if same > 1 else ''})" if same else ""
            return f"read as {as_read}{remark}" if remark else f"read as {as_read}{count}"
        case Formulas(as_read=as_read) | Letter(as_read=as_read):
            return f"read as {as_read}"
        case Chain(lines):
            return f"read as {len(lines)} equation{'s' if len(lines) > 1 else ''}: "
        case Prose():
            raise AssertionError("words are read by a person")


def checked(sheet: Worksheet, tries: list[Try]) -> list[str]:
    """What `check` prints for each, in one interpreter that has Python and nothing else."""
    job = json.dumps({"cell": check_source(sheet), "tries": tries})
    command = [sys.executable, "-S", "-I", "-c", ALONE]
    done = subprocess.run(command, input=job, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def disagreements(
    sheet: Worksheet, prompts: dict[str, Prompt], tries: list[Try]
) -> list[tuple[Try, str, str]]:
    return [
        (each, line, wanted)
        for each, line in zip(tries, checked(sheet, tries), strict=True)
        if not (line == (wanted := marked(prompts[each[0]], each[1])) or _chain(line, wanted))
    ]


def _chain(line: str, wanted: str) -> bool:
    """The equations of a proof stand behind their number."""
    return ": read as" in wanted and wanted.endswith(": \n") and line.startswith(wanted[:-1])


def one_of_each(prompts: dict[str, Prompt]) -> list[str]:
    """The question with most components, or most symbols, of each answer type."""
    sizes = {name: (len(each.part.components), len(each.problem.givens)) for name, each in prompts.items()}
    types = sorted({each.part.answer_type for each in prompts.values()})
    return [
        max(
            (name for name, each in prompts.items() if each.part.answer_type == its_type),
            key=lambda name: sizes[name],
        )
        for its_type in types
    ]


def test_on_answers_about_which_they_once_disagreed(sheet: Worksheet, prompts: dict[str, Prompt]):
    assert not disagreements(sheet, prompts, ONCE_DISAGREED)
    assert all(": read as " in line for line in checked(sheet, ONCE_DISAGREED))


def test_on_samples_of_every_question(sheet: Worksheet, prompts: dict[str, Prompt]):
    tries = [(name, value) for name, prompt in prompts.items() for value in own_samples(prompt)]
    assert len(tries) > 500
    assert not disagreements(sheet, prompts, tries)


@pytest.mark.parametrize("every", [30, pytest.param(1, marks=pytest.mark.whole)])
def test_on_the_texts_of_the_corpora(sheet: Worksheet, prompts: dict[str, Prompt], every: int):
    names = one_of_each(prompts)
    assert {prompts[name].part.answer_type for name in names} == {
        "value", "vector", "expression", "choice", "example", "proof"
    }  # fmt: skip
    tries: list[Try] = [
        (name, text)
        for place, text in enumerate(typed()[::every])
        for at, name in enumerate(names)
        if (place + at) % 3 == 0  # each text on two types, those beside it on the others
    ]
    assert len(typed()) > 1500
    assert not disagreements(sheet, prompts, tries)


@pytest.mark.parametrize("count", [500, pytest.param(5000, marks=pytest.mark.whole)])
def test_on_texts_made_by_chance(sheet: Worksheet, prompts: dict[str, Prompt], count: int):
    dice = random.Random(SEED)
    names = list(prompts)
    tries = [(name := dice.choice(names), _changed(dice, prompts[name])) for _ in range(count)]
    lines = checked(sheet, tries)
    assert sum(": read as " in line for line in lines) > count / 10
    assert sum(": cannot be read" in line for line in lines) > count / 10
    assert not disagreements(sheet, prompts, tries)


def _changed(dice: random.Random, prompt: Prompt) -> Any:
    """An answer that was typed somewhere, or a sample of this very question, with a few signs changed; now and then a list."""
    count = len(prompt.part.components)
    if count and dice.random() < 0.3:
        return [_one(dice, prompt) for _ in range(count + dice.choice((-1, 0, 0, 0, 0)))]
    return _one(dice, prompt)


def _one(dice: random.Random, prompt: Prompt) -> Any:
    own = own_samples(prompt)
    base = dice.choice(own) if dice.random() < 0.5 else dice.choice(typed())
    if not isinstance(base, str):
        return base
    signs = list(base)
    for _ in range(dice.choice((0, 1, 1, 2, 3))):
        place = dice.randrange(len(signs) + 1)
        other = dice.choice(dice.choice(typed()) or " ")
        signs[place : place + dice.choice((0, 1))] = dice.choice(([other], [], [other, " "]))
    return "".join(signs)


def test_the_marker_says_it_in_the_same_words(prompts: dict[str, Prompt]):
    """A list of what is no text, and a value from which no answer can be read."""
    vector = next(prompt for prompt in prompts.values() if prompt.part.answer_type == "vector")
    assert isinstance(
        vector.answer_types[0].read(Items((Nothing(), Nothing()), (2,)), vector.question), Blank
    )
    refused = vector.answer_types[0].read(sent({1: 1}), vector.question)
    assert refused == Unclear("it is a dictionary whose keys are not names: give the number itself", "dict")
    assert vector.answer_types[0].preview(Text(""), vector.question).text == "no answer yet"
