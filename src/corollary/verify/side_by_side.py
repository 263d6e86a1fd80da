"""Many problems verified in their order: on all cores, on a Dask cluster, or not again where nothing changed."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import Future
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import asdict
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from threading import Lock
from typing import Any

from corollary import plug_ins, user_cache
from corollary.derive.load import NotDerivable, source
from corollary.messages import speak, spoken
from corollary.parallel import NoCluster, ProcessDied, Workers, connect, cores
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import name_in_bank
from corollary.problem.packed_pictures import packed_file, unused
from corollary.problem.problem import Problem
from corollary.sandbox.folders import remove_abandoned
from corollary.sandbox.runner import Runner
from corollary.verify.checked import Checked, from_data
from corollary.verify.obligations.obligation import Settled
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
            sentence = "ends the verifying process, as os._exit or too much memory does"
            return not_verified(problem, f"{name_in_bank(bank.solution(problem))}:1: {sentence}")


def _begin(todo: Todo, count: int) -> None:
    _at_work.append((todo, count, Runner()))


def _there(place: int) -> Checked:
    todo, count, runner = _at_work[0]
    return verify(*todo[place], count, runner)


LIBRARIES = ("sympy", "python-flint", "numpy", "scipy", "z3-solver", "matplotlib", "numba")
"""What a verdict may depend on besides our own programs."""
PLUG_INS = ("corollary.laws", "corollary.banks", "corollary.answers")


@contextmanager
def verify_changed(
    todo: Todo, count: int, verify_those: VerifyEach = verify_each, *, anew: bool = False
) -> Generator[Iterator[Checked]]:
    """As `verify_those` does it, in the same order; what held before, and is the same, is not verified again, unless `anew`.
    Complaints are not kept."""
    before = [None if anew else _recalled(bank, problem, count) for bank, problem in todo]
    changed = [each for each, found in zip(todo, before, strict=True) if found is None]
    with verify_those(changed, count) as verified:

        def in_order() -> Iterator[Checked]:
            for (bank, problem), found in zip(todo, before, strict=True):
                yield found if found is not None else _written(next(verified), bank, problem, count)

        yield in_order()


def _recalled(bank: Bank, problem: Problem, count: int) -> Checked | None:
    with suppress(NotDerivable, ValueError, TypeError, KeyError):
        text = user_cache.read(_name(problem), origin(bank, problem, count))
        if text is not None:
            found: dict[str, Any] = json.loads(text)
            found["obligations"] = tuple(Settled(**each) for each in found["obligations"])
            found["mutation"] = from_data(found["mutation"])
            for name in ("complaints", "notes", "unread"):
                found[name] = tuple(found[name])
            found["why"] = tuple((reason, times) for reason, times in found["why"])
            return Checked(**found)
    return None


def _written(checked: Checked, bank: Bank, problem: Problem, count: int) -> Checked:
    if checked.ok:
        with suppress(NotDerivable):
            text = json.dumps(asdict(checked), ensure_ascii=False).encode()
            user_cache.write(_name(problem), origin(bank, problem, count), text)
    return checked


def _name(problem: Problem) -> str:
    return user_cache.name_of(f"verified-{problem.name}", problem.path)


def origin(bank: Bank, problem: Problem, count: int) -> str:
    """Tells apart whatever could be verified differently: the problem with its translations, its solution, all programs.

    Raises NotDerivable where the solution cannot be read.
    """
    beside = sorted(problem.path.parent.glob(f"{problem.path.stem}*.md"))
    texts = [packed_file(path) for path in beside if path.is_file()]
    own = source(bank, problem) if bank.solution(problem).is_file() else b""
    parts = (
        _programs(),
        plug_ins.state(PLUG_INS).encode(),
        str(count).encode(),
        repr(problem).encode(),
        own,
        repr(unused(problem.path)).encode(),
        *texts,
    )
    return hashlib.sha256(b"\0".join(parts)).hexdigest()


@cache
def _programs() -> bytes:
    found = [platform.python_version()]
    for library in LIBRARIES:
        try:
            found.append(f"{library} {version(library)}")
        except PackageNotFoundError:
            found.append(f"{library} is not there")
    return hashlib.sha256(f"{found} {user_cache.programs(['.'])}".encode()).digest()


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
            yield _in_order_there(client, todo, count)
        finally:
            client.close()

    return each


def verify_there(bank: Bank, problem: Problem, count: int, state: str, language: str) -> Checked:
    """In a worker. Raises NoCluster where the problem, its solution or the program is not the one that was meant."""
    with _one_at_a_time:
        speak(language)
        if _state(bank, problem, count) != state:
            raise NoCluster(
                f"a worker has another version of {problem.code} or of corollary; install the same version on all workers"
            )
        with unstarted() as runner:
            return verify(bank, problem, count, runner)


def _state(bank: Bank, problem: Problem, count: int) -> str:
    try:
        return origin(bank, problem, count)
    except NotDerivable as error:  # verified all the same: it is a complaint
        return str(error)


def _in_order_there(client: Any, todo: Todo, count: int) -> Iterator[Checked]:
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
                "the connection to the cluster was lost; verify again: what held is not verified a second time"
            ) from None
