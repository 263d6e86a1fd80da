"""Many problems verified on all cores of this machine, in their order; each process runs programs with a runner of its own."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import Future
from contextlib import AbstractContextManager, contextmanager

from corollary.parallel import ProcessDied, Workers, cores
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.sandbox.folders import remove_abandoned
from corollary.sandbox.runner import Runner
from corollary.verify.checked import Checked
from corollary.verify.program_checks import unstarted
from corollary.verify.verify import not_verified, verify

Todo = Sequence[tuple[Bank, Problem]]
VerifyEach = Callable[[Todo, int], AbstractContextManager[Iterator[Checked]]]

_at_work: list[tuple[Todo, int, Runner]] = []  # of a worker process


@contextmanager
def verify_each(todo: Todo, count: int, jobs: int | None = None) -> Generator[Iterator[Checked]]:
    """Each problem over `count` variants, in at most so many processes (None: one for each core); few need no second one."""
    most = min(jobs or cores(), len(todo))
    with unstarted() as runner:
        if most < 2:
            yield (verify(*each, count, runner) for each in todo)
            return
        try:
            with Workers(most, _begin, todo, count) as processes:
                begun = {place: processes.submit(_there, place) for place in longest_first(todo)}
                yield _in_order([begun[place] for place in range(len(todo))], todo, count)
        finally:
            remove_abandoned()  # a process of a pool ends without a word: the folder of its runner is left


def longest_first(todo: Todo) -> list[int]:
    """The places of the problems, those with most parts first: a long one begun last would leave the other cores idle."""
    return sorted(range(len(todo)), key=lambda place: -len(todo[place][1].parts))


def _in_order(begun: Sequence[Future[Checked]], todo: Todo, count: int) -> Iterator[Checked]:
    for place, future in enumerate(begun):
        try:
            yield future.result()
        except ProcessDied:  # what a killed one was at, and where none is left what was to come
            yield _alone(place, todo, count)


def _alone(place: int, todo: Todo, count: int) -> Checked:
    """A problem in a process of its own, which may end with it."""
    with Workers(1, _begin, todo, count) as process:
        try:
            return process.submit(_there, place).result()
        except ProcessDied:
            bank, problem = todo[place]
            sentence = "ends the process that verifies it, as os._exit or too much memory do"
            return not_verified(problem, f"{bank.solution(problem).name}:1: {sentence}")


def _begin(todo: Todo, count: int) -> None:
    _at_work.append((todo, count, Runner()))


def _there(place: int) -> Checked:
    todo, count, runner = _at_work[0]
    return verify(*todo[place], count, runner)
