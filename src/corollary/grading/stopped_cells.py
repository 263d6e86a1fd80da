"""Stopped cells of one notebook: which part has no answer because of which, and whether it waits for a person."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from corollary.grading.cell_order import CellOrder
from corollary.messages import catalogue
from corollary.notebook.locate import answer_id, cells_by_id, plot_id, ran_to_its_end
from corollary.notebook.worksheet import Prompt
from corollary.problem.packages import listed, state_of_package
from corollary.sandbox.job import Cell, CellRun, ExecutionResult, Limits
from corollary.sandbox.stop_kinds import CellStop, Kind, stop_by, stop_of

if TYPE_CHECKING:
    from corollary.sandbox.notebook_file import Notebook

_ = catalogue(__name__)

OF_THIS_MACHINE = ("version", "file", "network", "process", "time", "memory", "crash", "input", "not run")
"""Kinds of stops that the student's own computer need not have met: there the cell may have run to its end."""
HIDDEN = ("corollary",)  # never there for a notebook, installed or not


@dataclass(frozen=True, slots=True)
class StoppedCell:
    """A cell that stopped, and the `parts` (X12_5_a) that have no answer because of it. `waits`: they are left to a person, because
    the cell may well have run on the student's computer. `state` is that of a missing package."""

    kind: Kind
    about: str
    error: str
    parts: tuple[str, ...] = ()
    waits: bool = False
    state: str = ""

    @property
    def stop(self) -> CellStop:
        return CellStop(self.kind, self.about)


@dataclass(frozen=True, slots=True)
class Stops:
    """The stopped cells of a notebook by their index, and for each index of a cell that stopped, or a name that has no value, the
    index of the cell that is to blame.

    `cells` also has those that ran to their end without a package that they import (`try: import pandas`); `doubted` are the cells
    that may give something else where it is installed, each with the index of the one that imports it.
    """

    cells: Mapping[int, StoppedCell]
    of_cells: Mapping[str, int]
    of_names: Mapping[str, int]
    doubted: Mapping[str, int]

    def of_part(self, prompt: Prompt, notebook: Notebook) -> int | None:
        """The cell to blame where a part has no answer."""
        for name in (prompt.name, prompt.key):
            if name in self.of_names:
                return self.of_names[name]
        return _first(self.of_cells, prompt, notebook)

    def doubt_of(self, prompt: Prompt, notebook: Notebook) -> int | None:
        """The cell that imports a missing package, where what a part's cell gives may depend on it."""
        return _first(self.doubted, prompt, notebook)

    def of_error(self, error: str) -> CellStop | None:
        """What an error inside a student's function comes from: a missing package, in whatever cell it was to be imported."""
        stop = stop_by(error)
        if stop.kind == "name" and stop.about in self.of_names:
            cell = self.cells[self.of_names[stop.about]]
            return CellStop("package", cell.about) if cell.kind == "package" else None
        return stop if stop.kind == "package" else None


def _first(by_cell: Mapping[str, int], prompt: Prompt, notebook: Notebook) -> int | None:
    """The index found for the first of a part's own cells that has one."""
    named = cells_by_id(notebook.node)
    for own in (answer_id(prompt.key, prompt.part), plot_id(prompt.key, prompt.part)):
        cell = named.get(own) if own else None
        if cell is not None and (found := by_cell.get(cell.get("id", ""))) is not None:
            return found
    return None


def stops_in(
    cells: Sequence[Cell],
    order: CellOrder,
    executed: ExecutionResult,
    notebook: Notebook,
    packages: Sequence[str] | None,
) -> Stops:
    """Follow the names: what a stopped cell was to make is missing below it, until another cell makes it."""
    found: dict[int, StoppedCell] = {}
    of_cells: dict[str, int] = {}
    of_names: dict[str, int] = {}
    doubted: dict[str, int] = {}
    doubted_names: dict[str, int] = {}
    ran_well = ran_to_its_end(notebook.node)
    for index, (cell, run) in enumerate(zip(cells, executed.cells, strict=True)):
        names, stop = order.cells[index], stop_of(run)
        read = names.reads.union(*names.of_functions.values())
        origin = next((doubted_names[name] for name in sorted(read) if name in doubted_names), None)
        for name in names.makes:
            doubted_names.pop(name, None)
        made = names.makes.keys() if origin is not None else set[str]()
        if stop is None:
            for name in names.makes:
                of_names.pop(name, None)
            for package, around in names.imports.items():
                if (state := package_state(package, packages)) != "installed":
                    error = f"No module named '{package}'"
                    found[index] = StoppedCell("package", package, error, (), state == "missing", state)
                    origin, made = index, made | around
        if origin is not None:
            doubted[cell.id] = origin
            doubted_names |= dict.fromkeys(made, origin)
        if stop is None:
            continue
        blame = of_names.get(stop.about, index) if stop.kind == "name" else index
        if blame == index:
            found[index] = _stopped(stop, run, packages, ran_well.get(run.id, False))
        of_cells[cell.id] = blame
        of_names |= dict.fromkeys(names.makes, blame)
    return Stops(found, of_cells, of_names, doubted)


def _stopped(stop: CellStop, run: CellRun, packages: Sequence[str] | None, ran_well: bool) -> StoppedCell:
    state, waits = "", stop.kind in OF_THIS_MACHINE and ran_well
    if stop.kind == "package":
        state = package_state(stop.about, packages)
        waits = state != "not allowed"
    return StoppedCell(stop.kind, stop.about, run.error, (), waits, state)


def package_state(module: str, declared: Sequence[str] | None) -> str:
    """The state of a package that a notebook could not import."""
    return "not allowed" if module in HIDDEN else state_of_package(module, declared)


def with_parts(stops: Stops, lost: Mapping[str, int], packages: Mapping[str, str]) -> tuple[StoppedCell, ...]:
    """The stopped cells in their order, each with the parts `lost` by it; `packages` are those that a part's own function missed."""
    blamed = {*stops.of_cells.values(), *lost.values()}
    cells = [
        replace(cell, parts=tuple(part for part, by in lost.items() if by == index))
        for index, cell in stops.cells.items()
        if index in blamed
    ]
    by_package: dict[str, list[str]] = {}
    for part, package in packages.items():
        by_package.setdefault(package, []).append(part)
    inside = [
        StoppedCell("package", package, f"No module named '{package}'", tuple(parts), True, "missing")
        for package, parts in by_package.items()
    ]
    return (*cells, *inside)


SECONDS = Limits().cell_seconds


def why_stopped(stop: CellStop, packages: Sequence[str] | None = None, state: str = "missing") -> str:
    """What a student reads of a cell that stopped: no class of an exception, but what it needed or what to write."""
    about = stop.about
    match stop.kind:
        case "package" if state == "not allowed":
            names = ", ".join(listed(packages))
            return _(
                "it imports {package}, and this sheet's packages are {names}", package=about, names=names
            )
        case "package":
            return _("it imports {package}, which is missing on the computer that marks", package=about)
        case "version":
            return _("it uses {what}, which is not there on the computer that marks", what=about)
        case "file":
            return _("it opens the file {file}; only the notebook itself is run", file=about)
        case "network":
            return _("it needs the network, which is not there when answers are marked")
        case "process":
            return _("it starts another program or thread, which is not possible when answers are marked")
        case "time":
            return _("it ran longer than {seconds} s", seconds=f"{SECONDS:g}")
        case "memory":
            return _("it needed more memory than a notebook may use")
        case "crash":
            return _("Python ended in it ({message})", message=about)
        case "input":
            return _("it asks for input, and nobody sits at the keyboard; write the value into the cell")
        case "exit":
            return _("it ends the program, as sys.exit() does; leave that line out")
        case "magic":
            return _(
                "it uses {magic}, which is not known here, or does not stand in the first line of its cell",
                magic=about,
            )
        case "syntax":
            return _("Python cannot read it ({message})", message=about)
        case "name":
            return _("it uses {name}, which no cell above it has given a value", name=about)
        case "not run":
            return _("it was not run, because the notebook was ended before it")
        case "error":
            return (
                _("it ended in an error ({message})", message=about) if about else _("it ended in an error")
            )


def needs_person(name: str, why: str) -> str:
    """What a student reads of a part that waits because of a stopped cell."""
    return _(
        "No answer was found. The cell of {part} stopped: {why}. Your teacher will mark it.",
        part=name,
        why=why,
    )


def may_differ(name: str, package: str) -> str:
    """What a student reads of a part that waits because its cell gets by without a package."""
    return _(
        "What the cell of {part} gives may depend on {package}, which is missing on the computer that marks. "
        "Your teacher will mark it.",
        part=name,
        package=package,
    )


def no_answer(name: str, why: str) -> str:
    """What a student reads of a part that has no answer because of a stopped cell."""
    return _("No answer was found. The cell of {part} stopped: {why}.", part=name, why=why)


def label(prompt: Prompt) -> str:
    """A part as students see it: `X12.5 (a)`."""
    return f"{prompt.problem.code} ({prompt.part.heading_letter})"
