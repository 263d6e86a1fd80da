"""Many problems verified on a Dask cluster, in their order; a worker whose problem or programs are others verifies nothing."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Generator, Iterator
from contextlib import contextmanager
from threading import Lock
from typing import Any

from corollary.cluster import NoCluster, connect
from corollary.derive.load import NotDerivable
from corollary.messages import speak, spoken
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.verify.checked import Checked
from corollary.verify.program_checks import unstarted
from corollary.verify.side_by_side import Todo, VerifyEach, longest_first
from corollary.verify.unchanged import origin
from corollary.verify.verify import verify

_one_at_a_time = Lock()  # a worker may have several threads; the ball arithmetic is for one


def on_cluster(address: str) -> VerifyEach:
    """On the cluster whose scheduler is at this address; what a dying worker was at is done again by another.

    Entering raises NoCluster where there is none, and so does going on once it is lost or a worker refuses.
    """

    @contextmanager
    def each(todo: Todo, count: int) -> Generator[Iterator[Checked]]:
        if not todo:
            yield iter(())
            return
        client = connect(address)
        try:
            yield _in_order(client, todo, count)
        finally:
            client.close()

    return each


def verify_there(bank: Bank, problem: Problem, count: int, state: str, language: str) -> Checked:
    """In a worker. Raises NoCluster where the problem, its solution or the program is not the one that was meant."""
    with _one_at_a_time:
        speak(language)
        if _state(bank, problem, count) != state:
            raise NoCluster(
                f"a worker has another version of {problem.code} or of the program; put the same ones everywhere"
            )
        with unstarted() as runner:
            return verify(bank, problem, count, runner)


def _state(bank: Bank, problem: Problem, count: int) -> str:
    try:
        return origin(bank, problem, count)
    except NotDerivable as error:  # verified all the same: it is a complaint
        return str(error)


def _in_order(client: Any, todo: Todo, count: int) -> Iterator[Checked]:
    from distributed import CancelledError, KilledWorker

    def begun(bank: Bank, problem: Problem) -> Any:
        state = _state(bank, problem, count)
        return client.submit(verify_there, bank, problem, count, state, spoken(), pure=False)

    futures = {place: begun(*todo[place]) for place in longest_first(todo)}
    for place, (_, problem) in enumerate(todo):
        try:
            yield futures[place].result()
        except KilledWorker:
            raise NoCluster(
                f"the workers that verified {problem.code} died, one after another; verify it here, without --executor"
            ) from None
        except CancelledError:
            raise NoCluster(
                "the cluster was lost on the way; verify again: what held is not verified a second time"
            ) from None
