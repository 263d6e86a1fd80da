"""The table of stopped cells of a class: what stopped them, whose, which parts have no answer because of it, what to do."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from corollary.grading.stopped_cells import StoppedCell
from corollary.messages import few
from corollary.problem.packages import INSTALLED_AS, is_installed, is_of_another_system
from corollary.problem.roster import name_with_id
from corollary.records.marks import Record

MOST_NAMES = 10
OWN_MISTAKES = ("error", "name", "syntax")
"""Kinds that students meet while they try things; they are listed where they cost an answer."""
BY_HAND = "look at the cells"


@dataclass(frozen=True, slots=True)
class StoppedRow:
    """One reason, with the ids and the names of the students, the parts (X12_5_a, and `labels` as X12.5 a) that have no answer
    because of it, and whether these wait for a person."""

    kind: str
    about: str
    what: str
    students: tuple[str, ...]
    names: tuple[str, ...]
    parts: tuple[str, ...]
    waits: bool
    to_do: str
    labels: tuple[str, ...] = ()

    @property
    def who(self) -> str:
        """`2: Ada Lovelace (ada), Ben (ben)`, at most ten of them."""
        return f"{len(self.students)}: {self.names_in_short}"

    @property
    def names_in_short(self) -> str:
        return few(self.names, MOST_NAMES)


def stopped_rows(records: Iterable[Record], set_name: str) -> tuple[StoppedRow, ...]:
    """Return the rows, those first that wait for a person, then those that cost most parts."""
    found: dict[tuple[str, str, str, bool], list[tuple[Record, StoppedCell]]] = {}
    for record in records:
        for cell in record.stopped:
            if cell.parts or cell.kind not in OWN_MISTAKES:
                about = cell.error if cell.kind == "error" else cell.about
                waits = cell.waits and bool(cell.parts)
                found.setdefault((cell.kind, about, cell.state, waits), []).append((record, cell))
    rows = [_row(set_name, cells) for cells in found.values()]
    return tuple(
        sorted(
            rows, key=lambda row: (not row.waits, row.kind != "package", -len(row.parts), -len(row.students))
        )
    )


def _row(set_name: str, cells: Sequence[tuple[Record, StoppedCell]]) -> StoppedRow:
    cell = cells[0][1]
    waits = cell.waits and bool(cell.parts)  # as all cells of the row
    students = {
        one.student: name_with_id(one.name, one.student) for record, _ in cells for one in (record.handed_in,)
    }
    labels = {
        name: f"{row.problem} {row.part}"
        for record, each in cells
        for name, row in zip(record.parts, record.rows, strict=True)
        if name in each.parts
    }
    parts = sorted(labels)
    about = cell.error if cell.kind == "error" else cell.about
    to_do = (
        _package(cell, set_name) if cell.kind == "package" else _to_do(replace(cell, waits=waits), set_name)
    )
    return StoppedRow(
        cell.kind, about, _what(cell), tuple(students), tuple(students.values()), tuple(parts), waits, to_do,
        tuple(labels[part] for part in parts),
    )  # fmt: skip


def _what(cell: StoppedCell) -> str:
    match cell.kind:
        case "package":
            return (
                f"the package {cell.about} is missing"
                if cell.state == "missing"
                else f"the package {cell.about} ({cell.state})"
            )
        case "version":
            return f"not in the versions installed here: {cell.about}"
        case "file":
            return f"opens a file: {cell.about}"
        case "network":
            return "needs the network"
        case "process":
            return "starts a program or a thread"
        case "time":
            return "ran too long and was stopped"
        case "memory":
            return "needed too much memory"
        case "crash":
            return f"Python ended ({cell.about})"
        case "input":
            return "asks for input()"
        case "exit":
            return "sys.exit()"
        case "magic":
            return f"the magic {cell.about} is not known, or not in the first line"
        case "name":
            return f"the name {cell.about} has no value"
        case "syntax":
            return f"not Python: {cell.about}"
        case "not run":
            return "not run, because the notebook was ended before"
        case _:
            return cell.error or "ended in an error"


def _package(cell: StoppedCell, set_name: str) -> str:
    name, again = cell.about, f"corollary grade {set_name}"
    if cell.state == "not allowed":
        return "nothing: it is not among the packages that are declared, and the parts count as not answered"
    if cell.state == "installed":
        return f"it is installed and cannot be imported in isolation: corollary mark {set_name}"
    if is_installed(name):
        return f"it is installed by now: {again}"
    if is_of_another_system(name):
        return f"only another system has it (Windows, Google Colab): corollary mark {set_name}"
    declare = f"declare in the set, under packages:, what students may use, without {name}, and {again}"
    if name in INSTALLED_AS:
        return f"pip install {INSTALLED_AS[name]} into this environment and {again}; or {declare}"
    return f"not a package that is known here, perhaps a file of the student's own: corollary mark {set_name}; or {declare}"


def _to_do(cell: StoppedCell, set_name: str) -> str:
    if cell.waits:
        return f"the cells ran on the students' computers: corollary mark {set_name}"
    return {
        "time": "look whether it is an endless loop or a long calculation",
        "memory": "look at what the cells make",
        "input": "students write the value into the cell instead",
        "exit": "students leave the line out; what stands above it counts",
        "magic": "students leave it out, or move it to the first line of its cell",
        "name": "look at the cells: the name may be misspelt, or its cell was deleted",
    }.get(cell.kind, BY_HAND)


def stopped_record(row: StoppedRow) -> dict[str, object]:
    """A row as plain data."""
    return {
        "kind": row.kind, "about": row.about, "what": row.what, "count": len(row.students), "students": list(row.students),
        "parts": list(row.parts), "waits": row.waits, "do": row.to_do,
    }  # fmt: skip
