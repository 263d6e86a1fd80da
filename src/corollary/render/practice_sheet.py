"""A student's practice sheet as a page and as a notebook; neither holds an answer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from corollary.messages import catalogue
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.problem_set import ProblemSet, Scheme
from corollary.problem.roster import Student
from corollary.problem.variant import Variant
from corollary.render.targets.html import write_worksheet

_ = catalogue(__name__)
NAME = "practice"


@dataclass(frozen=True, slots=True)
class PracticeLine:
    """What a student reads above an exercise: the mistake, where it was met (sets and parts), and the exercise's number on the page to
    practise on."""

    sentence: str
    met: Mapping[str, tuple[str, ...]]
    variant: Variant
    turn: int


def practice_files(student: Student, lines: Sequence[PracticeLine], site: str) -> dict[str, bytes]:
    """The files of one sheet, by name. `site` is the address of a page to practise on, or empty. Raises Malformed."""
    problems = tuple(line.variant.problem for line in lines)
    title, weights = _("Practice for you"), (1.0,) * len(problems)
    whole = ProblemSet(NAME, title, _introduction(lines, site), problems, weights, None, Scheme(), "no")
    sheet = worksheet(whole, student, [line.variant for line in lines])
    return {
        f"{NAME}.html": write_worksheet(sheet, {}).encode(),
        f"{NAME}.ipynb": file_text(notebook(sheet)).encode(),
    }


def _introduction(lines: Sequence[PracticeLine], site: str) -> str:
    opening = _(
        "These exercises are chosen by mistakes in your own work. Their numbers are new. You hand in nothing, and nobody gives marks."
    )
    codes = " ".join(f"{line.variant.problem.code}/{line.turn}" for line in lines)
    if site:
        links = ", ".join(f"[{code}]({site}#{code})" for code in codes.split())
        checked = _("To have your answers checked, with hints, open: {links}.", links=links)
    else:
        checked = _(
            "To have your answers checked, with hints, run `corollary practise {codes}` where Corollary is installed.",
            codes=codes,
        )
    return "\n\n".join([opening, "\n".join(_line(line) for line in lines), checked])


def _line(line: PracticeLine) -> str:
    where = ", ".join(f"{name} ({', '.join(parts)})" for name, parts in line.met.items())
    return f"- **{line.variant.problem.code}**: {where}: {line.sentence}"
