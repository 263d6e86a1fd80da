"""`corollary practise`: a page on this machine to practise on."""

from __future__ import annotations

import errno
import json
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, cast

from corollary.answers.verdict import Wrong
from corollary.cli.ending import HOLDS, refuse, say
from corollary.cli.local_page import OnePageServer, serve
from corollary.cli.open_sets import course_in, not_to_be_practised, say_broken, with_sets
from corollary.derive.load import NotDerivable
from corollary.formula.ball import Undefined
from corollary.practice.offline import known
from corollary.practice.practice import Answer, Posed, Practice, practice
from corollary.problem.bank import open_bank
from corollary.render.animation import animation
from corollary.render.markdown import html
from corollary.render.practice_page import (
    asked_parts,
    exercise_piece,
    marked_by_a_person,
    practice_page,
    verdict_piece,
)

USUAL_PORT = 8412  # always the same, if it is free: a browser keeps what was done by the address of the page
MOST_TURNS = 100_000
NUMBERED = re.compile(r"([^/]+)/(\d{1,5})")


def run(
    wanted: tuple[str, ...],
    bank: Path | None,
    left_out: tuple[str, ...],
    no_browser: bool,
    port: int,
    course: Path | None = None,
) -> int:
    words, first = _with_numbers(wanted)
    opened, around = open_bank(bank), course_in(course)
    try:
        found = practice(
            opened, with_sets(opened, words, around), not_to_be_practised(opened, left_out, around)
        )
    except LookupError as error:
        refuse(str(error))
    say_broken(found)
    known = {each.code for each in found.problems}
    sheet = [(code, turn) for code, turn in first if code in known]
    serve(_server(found, port, sheet), "ctrl-C ends it, and your browser keeps what you did", no_browser)
    return HOLDS


def _with_numbers(words: Sequence[str]) -> tuple[list[str], list[tuple[str, int]]]:
    """The words without the numbers of `X12.6/17`, and those exercises: what a practice sheet names."""
    found = [NUMBERED.fullmatch(each) for each in words]
    codes = [each if one is None else one[1] for each, one in zip(words, found, strict=True)]
    return codes, [(one[1], int(one[2])) for one in found if one is not None]


def _server(found: Practice, port: int, sheet: Sequence[tuple[str, int]] = ()) -> OnePageServer:
    """On the port that is asked for; else on the usual one, or any where that is in use."""

    def at(place: int) -> OnePageServer:
        return OnePageServer(
            lambda: practice_page(found, sheet=sheet), lambda posted: answered(found, posted), place
        )

    try:
        return at(port or USUAL_PORT)
    except OSError as error:
        if error.errno not in (errno.EADDRINUSE, errno.EACCES):
            raise
        if port:
            refuse(f"port {port} cannot be used ({error.strerror}); choose another with --port")
        say(f"port {USUAL_PORT} is in use: another port is used, with progress of its own in the browser")
        return at(0)


def answered(found: Practice, posted: dict[str, Any]) -> str:
    """What the page asks for, as JSON. Raises ValueError with a sentence for what cannot be answered."""
    try:
        ask, code, turn = posted["ask"], str(posted["code"]), int(posted["turn"])
        if not 0 <= turn < MOST_TURNS:
            raise ValueError("there are fewer turns")
        if ask == "motion":
            return json.dumps(_motion(found, code, turn))
        return json.dumps(ANSWERS[ask](found.pose(code, turn), posted))
    except (KeyError, TypeError, IndexError):
        raise ValueError("this page belongs to an earlier run; reload it") from None
    except (LookupError, NotDerivable, Undefined) as error:
        raise ValueError(str(error)) from None


def _exercise(posed: Posed, posted: dict[str, Any]) -> dict[str, Any]:
    return {"html": exercise_piece(posed), "judged": asked_parts(posed.exercise)}


def _read(posed: Posed, posted: dict[str, Any]) -> dict[str, Any]:
    found = posed.preview(str(posted["part"]), _answer(posted["answer"]))
    return {"ok": found.ok, "text": found.text}


def _judge(posed: Posed, posted: dict[str, Any]) -> dict[str, Any]:
    answers = cast(dict[str, object], posted["answers"])
    given = {part: _answer(each) for part, each in answers.items()}
    grade = posed.judged(str(posted["part"]), given, max(0, int(posted.get("wrongBefore", 0))))
    return {
        "html": verdict_piece(grade),
        "right": known(grade.verdict),
        "wrong": isinstance(grade.verdict, Wrong),
        "person": marked_by_a_person(grade.part),
    }


def _hints(posed: Posed, posted: dict[str, Any]) -> dict[str, Any]:
    right = frozenset(map(str, cast(list[object], posted["right"])))
    return {"hints": [html(each) for each in posed.hints(str(posted["part"]), right)]}


def _step(posed: Posed, posted: dict[str, Any]) -> dict[str, Any]:
    place, steps = int(posted["place"]), posed.worked_steps
    return {"html": html(steps[place]), "last": place + 1 >= len(steps)}


def _motion(found: Practice, code: str, turn: int) -> dict[str, Any]:
    film = found.motion(code, turn)
    return {"html": animation(film) if film else ""}


def _answer(posted: object) -> Answer:
    """A text, or one for each component."""
    return [str(each) for each in cast(list[object], posted)] if isinstance(posted, list) else str(posted)


ANSWERS: dict[str, Callable[[Posed, dict[str, Any]], dict[str, Any]]] = {
    "exercise": _exercise,
    "read": _read,
    "judge": _judge,
    "hints": _hints,
    "step": _step,
}
