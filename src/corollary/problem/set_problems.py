"""Problems of a set: of one bank or several, whole or in part, and pools of which each student gets a few."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

from corollary.plug_ins import PlugInFault
from corollary.problem.bank import CHAPTER, Bank, UnknownCode, find, open_bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.front_matter import Node, Reader, TableNode, TextNode
from corollary.problem.part import Part
from corollary.problem.problem import Problem

MOST_POINTS = 1000


@dataclass(frozen=True, slots=True)
class Pool:
    """Any `count` of the problems with these codes, other ones for each student; `line` is where the set says so."""

    count: int
    codes: tuple[str, ...]
    line: int = 0


@dataclass(frozen=True, slots=True)
class Listed:
    """The problems of a set with their weights, in its order, those of pools too."""

    problems: tuple[Problem, ...]
    weights: tuple[float, ...]
    pools: tuple[Pool, ...]


def read_problems(bank: Bank, front: Reader) -> Listed:
    """What stands under `problems:`; what is wrong with it is complained of."""
    usual = front.text("bank", "")
    chosen: list[tuple[Problem, float]] = []
    pools: list[Pool] = []
    for node in front.list_of("problems"):
        if isinstance(node, TableNode) and "any" in node.entries:
            row = Reader(front.path, node, "a pool of the set", front.complaints)
            count = row.fraction("any")
            named = list(row.list_of("of"))
            members = [each for one in named for each in _listed(bank, usual, front, one, chosen)]
            row.finish()
            if count is not None and not (count.denominator == 1 and 1 <= count < len(named)):
                row.complain(
                    node.line,
                    f"any: {count} of {len(named)} problems; a pool deals some of its problems, at least one and not all",
                )
            pools.append(Pool(int(count or 1), tuple(each.code for each in members), node.line))
        else:
            list(_listed(bank, usual, front, node, chosen))
    problems, weights = zip(*chosen, strict=True) if chosen else ((), ())
    return Listed(problems, weights, tuple(pools))


def _listed(
    bank: Bank, usual: str, front: Reader, node: Node, chosen: list[tuple[Problem, float]]
) -> Iterator[Problem]:
    """One row, put behind those chosen already; nothing where it cannot be."""
    weight: Fraction | None = Fraction(1)
    row = None
    if isinstance(node, TableNode):
        row = Reader(front.path, node, "a problem of the set", front.complaints)
        code, weight, place = row.text("code"), row.fraction("weight", "1"), row.text("bank", usual)
    elif isinstance(node, TextNode):
        code, place = node.text, usual
    else:
        front.complain(
            node.line,
            "a problem of the set is a code, or {code: X12.5, weight: 2}, or {any: 2, of: [X12.4, X12.5]}",
        )
        return
    try:
        problem = _found(bank, place, code, front.path)
    except (UnknownCode, Malformed, PlugInFault) as error:
        front.complain(node.line, str(error))
        return
    if any(problem.code == other.code for other, _ in chosen):
        front.complain(node.line, f"{code} is in the set twice")
    if weight is not None and not 0 <= weight <= MOST_POINTS:
        front.complain(node.line, f"{code} has weight: {weight}; give a number from 0 to 1000")
    if row is not None:
        problem = _adapted(problem, row)
        row.finish()
    chosen.append((problem, float(1 if weight is None else weight)))
    yield problem


def _found(bank: Bank, place: str, code: str, path: Path) -> Problem:
    """The problem of this code, or of `BANK/CODE`. Raises UnknownCode, Malformed, PlugInFault."""
    named, slash, short = code.rpartition("/")
    if slash and not code.endswith(".md"):
        place, code = named, short
    return find(_bank_named(bank, place, path) if place else bank, code)


def _bank_named(bank: Bank, name: str, path: Path) -> Bank:
    """One of the banks at hand by its folder's name, a folder beside the set, the chapter's, or that of an installed package."""
    here = [each for each in bank.each if each.folder.name == name and name != CHAPTER]
    beside = path.parent / name
    return here[0] if here else open_bank(beside if (beside / "problems").is_dir() else Path(name))


def _adapted(problem: Problem, row: Reader) -> Problem:
    """With the parts that the set asks for, and the points it gives for them; itself where it says nothing of either."""
    ids = {part.id: part for part in problem.parts}
    wanted = [node for node in row.list_of("parts") if isinstance(node, TextNode)]
    points: dict[str, float] = {}
    table = row.table_of("points")
    given = Reader(row.path, table, f"the points of {problem.code}", row.complaints)
    for part in table.entries:
        number = given.fraction(part)
        if number is not None and not 0 <= number <= MOST_POINTS:
            given.complain(
                table.entries[part].line,
                f"{problem.code} {part} has {number} points; give a number from 0 to 1000",
            )
        points[part] = float(number or 0)
    for name, line in (
        *((node.text, node.line) for node in wanted),
        *((name, node.line) for name, node in table.entries.items()),
    ):
        if name not in ids:
            row.complain(line, f"{problem.code} has no part {name}; it has {', '.join(ids)}")
    left = {node.text for node in wanted} or set(ids)
    if unasked := [name for name in points if name in ids and name not in left]:
        row.complain(
            table.line,
            f"{problem.code}: part {unasked[0]} has points and is not among `parts`; leave one out",
        )
    if not wanted and not points:
        return problem
    parts: list[Part] = [
        replace(part, points=points.get(part.id, part.points)) for part in problem.parts if part.id in left
    ]
    return replace(problem, parts=tuple(parts), written=problem)
