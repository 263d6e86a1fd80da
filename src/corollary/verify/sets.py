"""A set checked: whether it makes no difference to a student which problems of a pool they get."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from corollary.problem.problem import Problem
from corollary.problem.problem_set import Pool, ProblemSet


@dataclass(frozen=True, slots=True)
class CheckedPool:
    """`points` and `difficulties` are those of its problems, in their order; 0 where a problem says no difficulty."""

    deals: int
    codes: tuple[str, ...]
    points: tuple[float, ...]
    difficulties: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class CheckedSet:
    """`out_of` is what a sheet is out of, at most; `notes` are what its author may want to know."""

    name: str
    out_of: float
    pools: tuple[CheckedPool, ...]
    notes: tuple[str, ...]


def check_set(problem_set: ProblemSet, file: str) -> CheckedSet:
    """What can be said of a set that can be read; `file` is what it is called."""
    pools = tuple(_pool(problem_set, pool) for pool in problem_set.pools)
    notes = [
        f"{file}:{pool.line}: {sentence}"
        for pool, checked in zip(problem_set.pools, pools, strict=True)
        for sentence in _unequal(checked)
    ]
    notes += [f"{file}: {sentence}" for problem in problem_set.problems for sentence in _left_out(problem)]
    return CheckedSet(problem_set.name, problem_set.out_of, pools, tuple(notes))


def _pool(problem_set: ProblemSet, pool: Pool) -> CheckedPool:
    members = [problem for problem in problem_set.problems if problem.code in pool.codes]
    return CheckedPool(
        pool.count,
        tuple(problem.code for problem in members),
        tuple(map(problem_set.points, members)),
        tuple(problem.description.difficulty for problem in members),
    )


def _unequal(pool: CheckedPool) -> Iterator[str]:
    """What is not the same for everybody who gets problems of this pool."""
    if len(set(pool.points)) > 1:
        each = ", ".join(f"{code} {most:g}" for code, most in zip(pool.codes, pool.points, strict=True))
        yield f"the problems of this pool have unequal points ({each}); even them out with weight: or points:"
    rated = {code: level for code, level in zip(pool.codes, pool.difficulties, strict=True) if level}
    if len(set(rated.values())) > 1:
        each = ", ".join(f"{code} {level}" for code, level in rated.items())
        yield f"the problems of this pool are unequally difficult ({each}); some students get harder ones"
    if len(rated) < len(pool.codes):
        unrated = ", ".join(code for code in pool.codes if code not in rated)
        yield f"{unrated} of this pool: nothing says how difficult; give each `difficulty:` from 1 to 5"


def _left_out(problem: Problem) -> Iterator[str]:
    """Words about a part that the set does not ask for stay in the statement."""
    gone = [part for part in problem.as_written.parts if part.id not in {each.id for each in problem.parts}]
    for part in gone:
        for other in problem.parts:
            if f"({part.heading_letter})" in other.text:
                yield f"{problem.code}: part {other.id} speaks of ({part.heading_letter}), which the set leaves out"
