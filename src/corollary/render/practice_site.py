"""The page to practise on as files: everything that it may be asked, worked out beforehand; judged in the browser by what marks."""

from __future__ import annotations

import json
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from typing import Any

from corollary.answers.registry import BUILT_IN, folder
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Wrong, word
from corollary.derive.load import NotDerivable
from corollary.formula.ball import Undefined
from corollary.grading.advice import advice
from corollary.grading.assign import NoVariant
from corollary.grading.key import Key
from corollary.grading.plain_key import NOT_JUDGED, judged, serialized
from corollary.messages import spoken
from corollary.notebook.packing import catalogues, texts_of
from corollary.practice.hints import Hints
from corollary.practice.practice import Practice
from corollary.problem.problem import Problem
from corollary.render.animation import animation
from corollary.render.markdown import html, inline
from corollary.render.practice_page import exercise_piece, more_numbers, practice_page, verdict_look
from corollary.render.pyodide import scripts, snapshot
from corollary.units.unit_table import rows_of_others

EXERCISES_FIRST = 3
STAND_INS = {"flint": "corollary.formula.plain_arb"}
ENTRIES = (
    "corollary.practice.offline",
    "corollary.grading.verdict_text",
    *(f"{folder(name)}.reading" for name in BUILT_IN),
    *(f"{folder(name)}.judging" for name in BUILT_IN if name not in NOT_JUDGED),
)


def python_files(pyodide: Path) -> Iterator[tuple[str, bytes]]:
    """Python, and the modules that read and judge. Raises NoPyodide."""
    for name, text in scripts(pyodide).items():
        yield f"pyodide/{name}", text.encode()
    yield "pyodide/reading.js", f"pyodideData.reading = {json.dumps(reading())};\n".encode()


def snapshot_file(pyodide: Path, practice: Practice) -> tuple[str, bytes]:
    """The same begun beforehand, so that the first answer is judged sooner. Raises NoSnapshot."""
    return "pyodide/snapshot.js", snapshot(pyodide, reading(), list(_first_asked(practice))).encode()


def _first_asked(practice: Practice) -> Iterator[tuple[str, ...]]:
    """Answers to some exercises, such as bring all into memory that is needed for others."""
    for problem in practice.problems[:EXERCISES_FIRST]:
        posed = practice.pose(problem.code, 0)
        key = json.dumps(serialized(posed.key))
        for part in filter(judged, posed.exercise.problem.parts):
            letters = "*".join(given.symbol for given in posed.exercise.problem.givens if not given.words)
            for text in ("12,5 m/s", "(3; 4) kN", letters, "word"):
                yield "read", key, part.id, json.dumps(text)
                yield "judge", key, part.id, json.dumps({part.id: text})


def reading() -> dict[str, Any]:
    """What `templates/carried_reader.py` begins with: the modules that read and judge, as texts, and what they are told."""
    carried = texts_of(ENTRIES, STAND_INS)
    return {
        "loader": files("corollary.notebook").joinpath("carried.py").read_text(encoding="utf-8"),
        "start": files("corollary.render")
        .joinpath("templates", "carried_reader.py")
        .read_text(encoding="utf-8"),
        "modules": dict(carried),
        "entries": ENTRIES,
        "units": rows_of_others(),
        "language": spoken(),
        "catalogues": dict(catalogues(name for name in carried if name not in STAND_INS)),
    }


def page_file(practice: Practice) -> bytes:
    """The page that is opened first."""
    looks = {
        word(verdict): verdict_look(verdict)
        for verdict in (Right(), Follows(()), Mistaken(""), Slip(""), Wrong(), Unread(""), Unmarked(""))
    }
    by_hand = {"compare": verdict_look(None), "unmarked": verdict_look(None)}
    return practice_page(practice, verdicts=looks | by_hand).encode()


def exercise_file(practice: Practice, problem: Problem, turns: int) -> bytes:
    """A problem with its printed numbers and others. Raises NotDerivable, NoVariant and Undefined where it has no answers at all."""
    found = list[dict[str, Any]]()
    for turn in range(turns if more_numbers(problem) else 1):
        try:
            found.append(_turn(practice, problem, turn))
        except (NotDerivable, NoVariant, Undefined):
            if turn == 0:
                raise
    return f"exercises[{json.dumps(problem.code)}] = {json.dumps(found, ensure_ascii=False)};\n".encode()


def _turn(practice: Practice, problem: Problem, turn: int) -> dict[str, Any]:
    posed = practice.pose(problem.code, turn)
    film = practice.motion(problem.code, turn)
    parts = list(posed.exercise.problem.parts)
    return {
        "html": exercise_piece(posed),
        "judged": [part.id for part in parts if judged(part)],
        "read": [part.id for part in parts if set(part.answer_types) <= set(BUILT_IN)],
        "steps": [html(step) for step in posed.worked_steps],
        "motion": animation(film) if film else "",
        "hints": {part.id: _as_html(posed.hints_by_known(part.id)) for part in parts},
        "advice": {part.id: list(map(inline, texts)) for part in parts if (texts := advice(posed.key, part))},
        "said": {text: inline(text) for text in _texts(posed.key)},
        "key": json.dumps(serialized(posed.key), separators=(",", ":")),
    }


def _as_html(hints: Hints) -> dict[str, Any] | list[str]:
    """Hints as HTML, by which parts are known."""
    if isinstance(hints, tuple):
        return [html(each) for each in hints]
    return {"part": hints.part, "known": _as_html(hints.known), "unknown": _as_html(hints.unknown)}


def _texts(key: Key) -> Iterator[str]:
    """What an author says of misconceptions, in Markdown."""
    solution = key.solution
    yield from (mistake.text for find in solution.unknowns for mistake in find.mistakes)
    yield from (text for choice in solution.choices.values() for text in choice.mistakes.values())
    yield from (text for forces in solution.forces.values() for text in forces.mistakes.values())
    yield from (text for example in solution.examples.values() for _values, text in example.apart)
