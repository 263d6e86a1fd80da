"""One runner with narrow limits for the hostile notebooks, and a look after each whether the next one works."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from fractions import Fraction

import pytest

from corollary.formula.value import Exact, Real
from corollary.sandbox.job import Cell, ExecutionResult, FunctionCall, Job, Limits
from corollary.sandbox.runner import Runner

from .kernel import promised

SECRET = "the key to part a is 8.6"


@pytest.fixture(scope="session")
def narrow_runner() -> Iterator[Runner]:
    limits = Limits(
        cell_seconds=1.0, total_seconds=5.0, memory_bytes=512 << 20, output_bytes=100_000, file_bytes=4 << 20
    )
    os.environ["COURSE_SECRET"] = SECRET
    without = frozenset(
        os.environ.get("ADVERSARY_WITHOUT", "").split()
    )  # layers left out, by benchmarks/adversary.py
    try:
        with Runner(limits, without=without) as running:
            possible = promised(without)
            assert running.isolation.level >= possible, (
                f"level {possible} is possible here: {running.isolation}"
            )
            if (
                possible < 2 and not without
            ):  # where layers are left out on purpose, what gets through is what is asked
                pytest.skip(f"this kernel has not the features for it: {running.isolation.line}")
            yield running
    finally:
        del os.environ["COURSE_SECRET"]


@pytest.fixture
def run(narrow_runner: Runner) -> Iterator[Callable[..., ExecutionResult]]:
    def take(
        *sources: str,
        names: tuple[str, ...] = ("a", "b"),
        calls: tuple[FunctionCall, ...] = (),
        pictures: bool = False,
    ) -> ExecutionResult:
        cells = tuple(Cell(f"c{number}", source) for number, source in enumerate(sources))
        return narrow_runner.execute(Job(cells, names, calls, pictures=pictures))

    yield take
    after = take("import os\nfiles = len(os.listdir('.'))\na = 2.5", names=("a", "files"))
    assert after.trouble == ""
    assert after.values == {"a": Real(2.5), "files": Exact(Fraction(0))}
