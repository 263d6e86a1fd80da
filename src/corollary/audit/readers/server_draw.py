"""Draws of `generate` of a `server.py` at some seeds: run in isolation, and brought back as inert data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Self, final

from corollary.audit.text_file import text_of
from corollary.formula.value import Items, Text, Value
from corollary.sandbox.job import Cell, ExecutionResult, FunctionCall, Job, Limits
from corollary.sandbox.runner import Runner

SECONDS = 5.0  # for one seed
LIMITS = Limits(cell_seconds=10.0, total_seconds=60.0, memory_bytes=512 << 20, output_bytes=1 << 14, file_bytes=1 << 20)  # fmt: skip
LONGEST = 200  # characters of what a program says of its own failure
FUNCTION = "numbers_at"
ENDED_ITSELF = "it ended its own process, as os._exit does"
CALLER = """
import random
import numpy
WANTED = {wanted!r}
SERVER = {{"__name__": "server", "__file__": "server.py"}}
exec(compile({source!r}, "server.py", "exec"), SERVER)

def numbers_at(seed):
    random.seed(seed)
    numpy.random.seed(seed)
    data = {{"params": {{}}, "correct_answers": {{}}, "variant_seed": seed, "options": {{}}, "answers_names": {{}}}}
    if "generate" not in SERVER:
        raise NameError("server.py has no function generate(data)")
    returned = SERVER["generate"](data)
    data = returned if isinstance(returned, dict) else data
    return [[[name, data[where][name]] for name in names if name in data[where]] for where, names in WANTED]
"""


@dataclass(frozen=True, slots=True)
class ServerDraw:
    """What stands in `params` and `correct_answers` at one seed, by name; `trouble` is "" or why nothing does.

    `isolation` is the level at which the program ran, and the layers in force.
    """

    seed: int
    params: Mapping[str, Value]
    answers: Mapping[str, Value]
    isolation: str
    trouble: str = ""


@final
class ServerRuns:
    """Runs programs at the seeds 1, 2, …, each in a worker of its own; the first one starts what runs them.

    `require` is the least isolation level accepted.
    """

    def __init__(self, seeds: int, require: int) -> None:
        self.seeds, self.require = seeds, require
        self._stack = ExitStack()
        self._runner: Runner | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.close()
        self._runner = None

    def draws(self, path: Path, params: Sequence[str], answers: Sequence[str]) -> tuple[ServerDraw, ...]:
        """What the program gives for these names at each seed, or at the first alone where that fails.

        Raises Malformed where the file is no text, WeakIsolation and CannotStart where it cannot be run well enough here.
        """
        source = text_of(path)
        wanted = [("params", list(params)), ("correct_answers", list(answers))]
        cell = Cell("server", CALLER.format(wanted=wanted, source=source))
        first = self._run(cell, [1])
        if first[0].trouble or self.seeds == 1:
            return first
        return (*first, *self._run(cell, range(2, self.seeds + 1)))

    def _run(self, cell: Cell, seeds: Sequence[int]) -> tuple[ServerDraw, ...]:
        if self._runner is None:
            self._runner = self._stack.enter_context(Runner(LIMITS, self.require))
        calls = tuple(FunctionCall(str(each), FUNCTION, (("seed", each),), SECONDS) for each in seeds)
        result = self._runner.execute(Job((cell,), (), calls, pictures=False))
        return tuple(_draw(each, result) for each in seeds)


def _draw(seed: int, result: ExecutionResult) -> ServerDraw:
    (cell,), call = result.cells, result.calls[str(seed)]
    isolation = f"level {result.isolation.level} ({result.isolation.line})"
    match call.value:
        case Items((Items() as params, Items() as answers)) if not call.trouble:
            return ServerDraw(seed, _by_name(params), _by_name(answers), isolation)
        case _:
            ended = _ended(result.trouble) if result.trouble else ""
            its_own = "its time was up" if cell.status == "timeout" else cell.error
            why = (
                ended
                or its_own
                or call.trouble.replace("the function", "generate", 1)
                or "what it gave could not be read"
            )
            trouble = f"server.py was run and gave no numbers: {why[:LONGEST]}"
            return ServerDraw(seed, {}, {}, isolation, trouble)


def _ended(trouble: str) -> str:
    """Why the process ended, of the sentence on it."""
    return trouble.partition(": ")[2].partition(". ")[0].rstrip(".") or ENDED_ITSELF


def _by_name(pairs: Items) -> dict[str, Value]:
    found: dict[str, Value] = {}
    for pair in pairs.items:
        match pair:
            case Items((Text(name), value)):
                found[name] = value
            case _:
                continue
    return found
