"""Export targets of exercises, worksheets, problem sets and marks: one file a target, ours and other packages'.

Another package adds a target by an entry point of the group `corollary.exports` whose name is the target's and which names
its `Target`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING

from corollary.messages import did_you_mean
from corollary.notebook.worksheet import Exercise, Worksheet
from corollary.plug_ins import PlugInFault, fault, load, plug_ins
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student

if TYPE_CHECKING:
    from corollary.records.marks_table import MarksTable
    from corollary.render.lms_item import LmsItem
    from corollary.render.paper.print_run import PrintRun

GROUP = "corollary.exports"
FOR_EXERCISES = (
    "text",
    "md",
    "html",
    "ipynb",
    "pdf",
)  # known without loading them: help must not take a second
OURS = (
    *FOR_EXERCISES,
    "csv",
    "moodle-grades",
    "canvas-grades",
    "feedback-zip",
    "moodle",
    "moodle-stack",
    "qti",
    "canvas",
    "numbas",
    "site",
)


class UnknownTarget(LookupError):
    """Nothing can be exported to that; one sentence says to what it can."""


@dataclass(frozen=True, slots=True)
class MarksText:
    """A file of marks, with ids of students it had to leave out, and sentences for whoever imports it."""

    text: str
    absent: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class CarriedPart:
    """What became of a part: `how` it is asked there (empty: it is not), and what is lost, by name."""

    code: str
    part: str
    how: str
    lost: str = ""


@dataclass(frozen=True, slots=True)
class ItemFiles:
    """Questions of an LMS as files by name, what became of each part, and what is lost of them all, by name."""

    files: Mapping[str, bytes]
    parts: tuple[CarriedPart, ...]
    lost: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Target:
    """A target offers the functions for what it can be made of, and leaves the others out.

    `ending` is that of its files, without the dot. `exercise` writes one exercise for a student, with its worked solution in
    Markdown (or ""), as text or as bytes; `worksheet` one student's sheet, with worked solutions by the code of the problem; `problem_set` all
    sheets of a set at once, as files by name; `marks` a table of marks, for everybody on the roster, which has every column of a
    set when `every_column`; `feedback` an archive of what goes back to students, from files by their names in it; `paper` is the
    print run of sheets that are marked by hand, with their marking schemes; `items` an LMS's
    questions, from a name for the file, the variants of each problem one after the other, and whether each part is one question; `site` is a folder
    of pages about a bank, which have no sheets.
    """

    ending: str
    exercise: Callable[[Exercise, Student, str], str | bytes] | None = None
    worksheet: Callable[[Worksheet, Mapping[str, str]], str] | None = None
    problem_set: Callable[[ProblemSet, Sequence[Worksheet]], Mapping[str, bytes]] | None = None
    marks: Callable[[MarksTable], MarksText | str] | None = None
    every_column: bool = False
    feedback: Callable[[Mapping[str, bytes]], bytes] | None = None
    paper: type[PrintRun] | None = None
    items: Callable[[str, Sequence[LmsItem], bool], ItemFiles] | None = None
    site: bool = False


def target(name: str) -> Target:
    """The target of this name. Raises UnknownTarget, and PlugInFault for another package's that is none."""
    if name in OURS:
        return import_module(f"corollary.render.targets.{name.replace('-', '_')}").TARGET
    if (theirs := plug_ins(GROUP, OURS).get(name)) is None:
        raise UnknownTarget(
            f"{name} is not known{did_you_mean(name, names())}; choose one of {', '.join(names())}"
        )
    found = load(theirs, "the export")
    if not isinstance(found, Target):
        raise fault(theirs, "the export", "it is not a corollary.render.exports.Target")
    return found


def names() -> tuple[str, ...]:
    """The names of all targets, ours first."""
    return (*OURS, *sorted(plug_ins(GROUP, OURS)))


def names_for_exercises() -> tuple[str, ...]:
    """The names of those that one exercise can be shown as; a target that cannot be loaded is none of them."""
    found = [*FOR_EXERCISES]
    for name in sorted(plug_ins(GROUP, OURS)):
        try:
            found += [name] if target(name).exercise is not None else []
        except PlugInFault:
            continue
    return tuple(found)
