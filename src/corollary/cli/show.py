"""`corollary show`: one problem as a student sees it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from corollary.cli.chosen_variant import chosen_problem, chosen_variant
from corollary.cli.ending import HOLDS, answer, refuse, say
from corollary.messages import did_you_mean
from corollary.notebook.worksheet import Exercise, Prompt, exercise
from corollary.problem.roster import Student
from corollary.problem.variant import written
from corollary.render.exports import UnknownTarget, names_for_exercises, target
from corollary.units.unit import canonical


def run(
    code: str,
    bank: Path | None,
    student: str | None,
    course: Path | None,
    variant: int | None,
    solution: bool,
    fmt: str | None,
    output: Path | None,
    as_json: bool,
) -> int:
    if as_json and (fmt or output):
        refuse("--json is one document on standard output; leave out --format and --output")
    write = _writer(fmt or "text")
    if student is not None and variant is not None:
        refuse("--student and --variant both choose the numbers; give one of them")
    place, problem = chosen_problem(bank, course, code)
    chosen = chosen_variant(place, problem, student, course, variant)
    worked = ""
    if solution:
        from corollary.grading.solutions import Solutions  # needed for the answers only

        worked = Solutions(place).worked_solution(chosen)
    if as_json:
        answer(_record(exercise(chosen), worked))
        return HOLDS
    if fmt == "pdf" and output is None and sys.stdout.isatty():
        refuse("a PDF cannot be shown in a terminal; write it to a file with -o FILE")
    text = write(exercise(chosen), Student(student or "you"), worked)
    if output is not None:
        output.write_bytes(text if isinstance(text, bytes) else text.encode())
        say(f"written to {output}")
    elif isinstance(text, bytes):
        sys.stdout.buffer.write(text)
    else:
        print(text, end="" if text.endswith("\n") else "\n")
    return HOLDS


def _record(asked: Exercise, worked: str) -> dict[str, Any]:
    """The exercise with its numbers (in SI, and as they are printed), its texts in Markdown; `solution` only when asked for."""
    variant = asked.variant
    record = {
        "code": asked.problem.code,
        "name": asked.problem.name,
        "title": asked.problem.title,
        "topic": asked.problem.topic,
        "variant": variant.index,
        "given": variant.si,
        "printed": {symbol: written(variant, symbol) for symbol in variant.values},
        "statement": asked.statement,
        "figure": asked.figure_alt,
        "parts": {prompt.part.id: _part(prompt) for prompt in asked.prompts},
    }
    return record | ({"solution": worked} if worked else {})


def _part(prompt: Prompt) -> dict[str, Any]:
    part = prompt.part
    return {
        "title": part.title,
        "text": prompt.text,
        "kind": "+".join(part.answer_types),
        "unit": canonical(part.unit),
        "points": prompt.out_of,
        "components": list(part.components),
        **({"rows": list(part.rows), "columns": list(part.columns)} if part.rows else {}),
        **({"units": [canonical(each) for each in part.units]} if part.column_units else {}),
        "options": {option.letter: option.text for option in prompt.options},
    }


def _writer(fmt: str) -> Callable[[Exercise, Student, str], str | bytes]:
    """What writes one exercise in this format."""
    try:
        write = target(fmt).exercise
    except UnknownTarget:
        write = None
    if write is None:
        have = names_for_exercises()
        refuse(f"--format {fmt} is not known{did_you_mean(fmt, have)}; choose one of {', '.join(have)}")
    return write
