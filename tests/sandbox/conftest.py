"""One warm parent for all tests of this folder."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from corollary.sandbox.job import Cell, ExecutionResult, FunctionCall, Job, Limits
from corollary.sandbox.runner import Runner

Run = Callable[..., ExecutionResult]


@pytest.fixture(scope="session")
def runner() -> Iterator[Runner]:
    with Runner(Limits(cell_seconds=5.0, total_seconds=30.0)) as running:
        yield running


@pytest.fixture
def run(runner: Runner) -> Run:
    def take(
        *sources: str,
        names: tuple[str, ...] = ("a", "b"),
        calls: tuple[FunctionCall, ...] = (),
        pictures: bool = False,
    ) -> ExecutionResult:
        return runner.execute(
            Job(
                tuple(Cell(f"c{i}", source) for i, source in enumerate(sources)),
                names,
                calls,
                pictures=pictures,
            )
        )

    return take
