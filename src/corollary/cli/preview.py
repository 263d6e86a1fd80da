"""`corollary preview`: a local page of one problem that follows what its author saves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from markupsafe import Markup

from corollary.cli.ending import HOLDS, expected, unforeseen
from corollary.cli.local_page import OnePageServer, edition, serve
from corollary.derive.load import NotDerivable
from corollary.figure.svg import NotADrawing
from corollary.grading.replay import forget_scenes
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import exercise
from corollary.problem.bank import Bank, home_of_file
from corollary.problem.diagnostic import Diagnostic, Malformed
from corollary.problem.reader import read_problem
from corollary.problem.variant import chapter
from corollary.render.page import drawing
from corollary.render.preview_page import Sheet, preview_page
from corollary.verify.drawn import Draw, drawn, keyed_parts

DRAWS = 20


def run(code: str, bank: Path | None, no_browser: bool, port: int) -> int:
    place, path = home_of_file(bank, code)
    server = OnePageServer(lambda: previewed(place, path), _takes_nothing, port, lambda: edition(place, path))
    serve(server, "it follows what you save; ctrl-C ends it", no_browser)
    return HOLDS


def _takes_nothing(posted: dict[str, Any]) -> None:
    raise ValueError("this page takes no requests")


def previewed(place: Bank, path: Path) -> str:
    """The page as the files are now; what is wrong with them stands on it."""
    now, heading = edition(place, path), path.stem
    complaints: list[Diagnostic] = []
    sheets: list[Sheet] = []
    redrawn, advice = 0, ""
    forget_scenes()
    try:
        problem = read_problem(path)
        heading, draws = f"{problem.code} {problem.title}", [Draw(chapter(problem), None, "")]
        solutions = Solutions(place)
        try:
            found = drawn(solutions.of(problem), DRAWS)
            draws, redrawn, advice = found.draws, found.redrawn, found.advice
        except NotDerivable as error:  # then at least what the problem asks is on the page
            complaints += _complaints(error)
        for draw in draws:
            sheets.append(_sheet(solutions, draw, complaints))
    except (
        Exception
    ) as error:  # an author's program may raise anything: the page says so and waits for the next
        complaints += _complaints(error)
    return preview_page(heading, sheets, redrawn, complaints, now, advice)


def _sheet(solutions: Solutions, draw: Draw, complaints: list[Diagnostic]) -> Sheet:
    asked, figure = exercise(draw.variant), Markup()
    try:
        figure = drawing(asked)
    except NotADrawing as error:
        complaint = Diagnostic(
            asked.problem.path, asked.problem.figure_line, f"the figure cannot be shown: {error}"
        )
        if complaint not in complaints:
            complaints.append(complaint)
    if draw.key is None:
        return Sheet(draw, asked, figure, (), "")
    return Sheet(draw, asked, figure, tuple(keyed_parts(draw.key)), solutions.worked_solution_of(draw.key))


def _complaints(error: Exception) -> list[Diagnostic]:
    """What an error says: each complaint with its file and line, or of no file."""
    match error:
        case Malformed():
            return error.complaints
        case NotDerivable():
            return [Diagnostic(error.path, error.line, error.sentence)]
        case _ if isinstance(error, expected()):
            return [Diagnostic(Path(), 0, str(error))]
        case _:
            return [Diagnostic(Path(), 0, unforeseen(error))]
