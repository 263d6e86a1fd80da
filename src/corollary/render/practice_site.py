"""The page to practise on as files: everything that it may be asked, worked out beforehand; judged by Python in the browser."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any

from corollary.answers.registry import folder
from corollary.answers.verdict import Mistaken, Right, Slip, Unmarked, Unread, Wrong, word
from corollary.derive.load import NotDerivable
from corollary.formula.ball import Undefined
from corollary.grading.assign import NoVariant
from corollary.grading.prepared import prepared
from corollary.grading.verdict_text import sentence
from corollary.messages import catalogue, spoken
from corollary.notebook.packing import catalogues, modules
from corollary.practice.posed import Posed
from corollary.practice.practice import Practice
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.render.animation import animation
from corollary.render.markdown import html
from corollary.render.practice_page import exercise_piece, more_numbers, practice_page, verdict_look
from corollary.render.pyodide import scripts
from corollary.units.table import rows_of_others

_ = catalogue(__name__)

JUDGED = ("value", "vector", "choice")
BESIDES = ("corollary.answers.prepared", "corollary.grading.verdict_text")


def reading_files(pyodide: Path) -> Iterator[tuple[str, bytes]]:
    """The page, Python, and the modules that read and judge. Raises NoPyodide."""
    for name, text in scripts(pyodide).items():
        yield f"pyodide/{name}", text.encode()
    carried = modules(JUDGED, BESIDES)
    data = {
        "loader": files("corollary.notebook").joinpath("carried.py").read_text(encoding="utf-8"),
        "start": files("corollary.render").joinpath("templates", "reading.py").read_text(encoding="utf-8"),
        "modules": dict(carried),
        "folders": {name: folder(name) for name in JUDGED},
        "units": rows_of_others(),
        "language": spoken(),
        "catalogues": dict(catalogues(carried)),
    }
    yield "pyodide/reading.js", f"pyodideData.reading = {json.dumps(data)};\n".encode()


def page_file(practice: Practice) -> bytes:
    """The page that is opened first."""
    looks = {
        word(verdict): verdict_look(verdict)
        for verdict in (Right(), Mistaken(""), Slip(""), Wrong(), Unread(""), Unmarked(""))
    }
    by_hand = {"compare": verdict_look(None), "unmarked": verdict_look(None)}
    return practice_page(practice, verdicts=looks | by_hand).encode()


def exercise_file(practice: Practice, problem: Problem, turns: int) -> bytes | None:
    """A problem with its printed numbers and others; none where it has no answers at all."""
    found = list[dict[str, Any]]()
    for turn in range(turns if more_numbers(problem) else 1):
        try:
            found.append(_turn(practice, problem, turn))
        except (NotDerivable, NoVariant, Undefined):
            if turn == 0:
                return None
    return f"exercises[{json.dumps(problem.code)}] = {json.dumps(found, ensure_ascii=False)};\n".encode()


def _turn(practice: Practice, problem: Problem, turn: int) -> dict[str, Any]:
    posed = practice.pose(problem.code, turn)
    film = practice.motion(problem.code, turn)
    parts = list(posed.exercise.problem.parts)
    asked = {part.id: prepared(posed.key, part) for part in parts}
    return {
        "html": exercise_piece(posed),
        "judged": [part for part, data in asked.items() if data is not None],
        "steps": [html(step) for step in posed.worked_steps],
        "motion": animation(film) if film else "",
        "parts": {part.id: _part(posed, part, parts, asked[part.id]) for part in parts},
    }


def _part(posed: Posed, part: Part, parts: list[Part], asked: dict[str, Any] | None) -> dict[str, Any]:
    """`hints` by how many of the first parts are known; `said` has the HTML of what stands in Markdown."""
    known = [
        frozenset(each.id for each in parts[:count] if each is not part) for count in range(len(parts) + 1)
    ]
    texts = dict[str, str]()
    for verdict in _verdicts(asked or {}):
        text = sentence(verdict)
        texts[text] = html(text)
    hints = [[html(each) for each in posed.hints(part.id, right)] for right in known]
    return {"asked": asked, "hints": hints, "said": texts}


def _verdicts(asked: Mapping[str, Any]) -> Iterator[Mistaken | Slip]:
    for text in asked.get("overlooked", {}).values():
        yield Mistaken(text)
    for way in asked.get("ways", ()):
        yield from (Mistaken(text) for _values, text in way["misconceptions"] or ())
        yield from (Slip(text) for _values, text in way["slips"] or ())
