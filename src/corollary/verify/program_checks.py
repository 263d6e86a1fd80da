"""The solution's own programs and figures, run and judged as a student's are: right as they stand, and not right once bent."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager, nullcontext
from pathlib import Path

from corollary.answers.registry import answer_type
from corollary.answers.verdict import Mistaken, Right, Verdict, Wrong, described
from corollary.derive.load import NotDerivable
from corollary.grading.judge import judge
from corollary.grading.key import Key
from corollary.grading.programs.judge_programs import code_of, plot_of
from corollary.grading.run_programs import ran
from corollary.guard import collecting
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.part import Part
from corollary.sandbox.runner import Runner
from corollary.sandbox.zygote import CannotStart
from corollary.verify.checked import Tally

BENT = """
def _bent(exact):
    return lambda **inputs: [-1.37 * number - 1 for number in np.ravel(exact(**inputs))]

{function} = _bent({function})
"""


@contextmanager
def unstarted() -> Generator[Runner]:
    """A runner for many problems, that starts with the first program and not before."""
    runner = Runner()
    try:
        yield runner
    finally:
        runner.__exit__(None, None, None)


def check_programs(bank: Bank, key: Key, tally: Tally, runner: Runner | None = None) -> None:
    """Each example is right; a program that returns other numbers, and axes with nothing in them, are wrong."""
    parts = [
        part
        for part in key.variant.problem.parts
        if answer_type(part.answer_type).found_in in ("function", "figure")
    ]
    if not parts:
        return
    path = bank.solution(key.variant.problem)
    try:
        with Runner() if runner is None else nullcontext(runner) as runner:
            for part in parts:
                try:
                    _check_part(runner, key, part, path, tally)
                except NotDerivable as error:  # of its inputs or its judge
                    tally.complain(f"{error} (part {part.id})")
    except CannotStart as error:
        tally.complain(f"{name_in_bank(path)}: its programs could not be run: {error}")


def _check_part(runner: Runner, key: Key, part: Part, path: Path, tally: Tally) -> None:
    """Raises NotDerivable where what the solution brings fails."""
    where = f"{name_in_bank(path)}:{_line(key, part)}: part {part.id}"
    for name, verdict in zip(
        part.answer_types, _verdicts(runner, key, part, path, example(key, part)), strict=True
    ):
        if not tally.check(isinstance(verdict, Right), "programs run"):
            tally.complain(f"{where}: the example's {name} should be right and is {described(verdict)}")
    for name, verdict in zip(
        part.answer_types, _verdicts(runner, key, part, path, bent(key, part)), strict=True
    ):
        if not tally.check(isinstance(verdict, Wrong | Mistaken), "programs run"):
            function = answer_type(name).found_in == "function"
            what = "the example with its numbers bent" if function else "a figure with nothing in it"
            tally.complain(f"{where}: {what} should be wrong and is {described(verdict)}")


def example(key: Key, part: Part) -> str:
    """The program and the figure that the solution shows, with the key's numbers in the figure."""
    plot = plot_of(key.solution, part)
    drawn = plot.example_for(key.variant.si) if plot is not None else ""
    return f"{_program(key, part)}\n{drawn}\n"


def bent(key: Key, part: Part) -> str:
    """The same program with every returned number changed, and an empty figure."""
    turned = BENT.format(function=part.function) if part.function else ""
    return (
        _program(key, part)
        + turned
        + ("\nplt.subplots()\n" if plot_of(key.solution, part) is not None else "")
    )


def _program(key: Key, part: Part) -> str:
    code = code_of(key.solution, part)
    return code.example_for(key.variant.si) if code is not None else ""


def _verdicts(runner: Runner, key: Key, part: Part, path: Path, source: str) -> tuple[Verdict, ...]:
    run = ran(runner, key, part.id, source)
    with collecting() as failures:
        verdicts = judge(key, {}, {part.id: run}, passing=(NotDerivable,))[part.id][0]
    if failures:  # it takes too long, or is no judge at all
        raise NotDerivable(path, _line(key, part), f"the judge fails: {failures[0].what}")
    return verdicts


def _line(key: Key, part: Part) -> int:
    entry = code_of(key.solution, part) or plot_of(key.solution, part)
    return entry.statement.line if entry is not None else 0
