"""The page to practise on as files: everything that it may be asked, worked out beforehand, with Python for browsers, which judges."""

from __future__ import annotations

import base64
import gzip
import json
import os
import shutil
import subprocess
import tarfile
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from importlib.resources import as_file, files
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
from corollary.units.unit_table import rows_of_others


class NotFetched(LookupError):
    """npm has no such package, or no network."""


class NoNpm(LookupError):
    """npm is not installed."""


def unpacked(package: str, place: Path) -> Path:
    """The folder of a package (`name@version`), unpacked into the empty folder `place`. Raises NoNpm, NotFetched."""
    npm = shutil.which("npm")
    if npm is None:
        raise NoNpm(package)
    done = subprocess.run([npm, "pack", package, "--silent"], cwd=place, capture_output=True, check=False)
    packed = next(place.glob("*.tgz"), None)
    if done.returncode or packed is None:
        raise NotFetched(package)
    with tarfile.open(packed) as archive:
        archive.extractall(place, filter="data")
    return place / "package"


VERSION = "314.0.7"
LOADER, PROGRAM, BINARY, LIBRARY, LOCK = (
    "pyodide.js",
    "pyodide.asm.mjs",
    "pyodide.asm.wasm",
    "python_stdlib.zip",
    "pyodide-lock.json",
)
NEEDED = (LOADER, PROGRAM, BINARY, LIBRARY, LOCK)
# What a snapshot is put back into: the memory that the program begins with, which has 30 MiB of its own and does not grow for it.
PAGE, FEWEST_PAGES = 65_536, 1_024
MEMORY_SECTION, HEADER = 5, 8
LONGEST = 300.0  # seconds: node takes about ten


class NoPyodide(LookupError):
    """Pyodide is not there and cannot be fetched; one sentence says what to do."""


class NoSnapshot(RuntimeError):
    """Python could not be begun beforehand; one sentence says why."""


def fetched(cache: Path) -> Path:
    """The folder of Pyodide's files in the cache, fetched by npm the first time. Raises NoPyodide."""
    folder = cache / f"pyodide-{VERSION}"
    if all((folder / name).is_file() for name in NEEDED):
        return folder
    remedy = f"fetch it where there is one (npm pack pyodide@{VERSION}), unpack it, and name the folder with --pyodide FOLDER"
    cache.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=cache) as place:
        try:
            found = unpacked(f"pyodide@{VERSION}", Path(place))
        except NoNpm:
            raise NoPyodide(
                f"npm, which fetches Pyodide, is not installed: install it, or {remedy}"
            ) from None
        except NotFetched:
            raise NoPyodide(f"npm cannot fetch Pyodide without a network: {remedy}") from None
        shutil.rmtree(folder, ignore_errors=True)
        os.replace(found, folder)
    return folder


def scripts(folder: Path) -> Mapping[str, str]:
    """Pyodide as classic scripts by file name: pages opened from a file may load these, and neither modules nor data.

    Raises NoPyodide for a folder that has it not.
    """
    if missing := [name for name in NEEDED if not (folder / name).is_file()]:
        raise NoPyodide(
            f"{folder} has no {', '.join(missing)}: name a folder with the files of the npm package pyodide@{VERSION}"
        )
    lock = json.loads((folder / LOCK).read_text(encoding="utf-8"))
    program = (folder / PROGRAM).read_text(encoding="utf-8")
    program = program.replace(
        "export default _createPyodideModule;", "globalThis.pyodideProgram = _createPyodideModule;"
    )
    program = program.replace("import.meta.url", "document.baseURI")
    return {
        "pyodide.js": (folder / LOADER)
        .read_text(encoding="utf-8")
        .replace("//# sourceMappingURL", "// source map"),
        "program.js": program,
        "binary.js": _data("binary", gzip.compress(with_room((folder / BINARY).read_bytes()), mtime=0)),
        "library.js": _data("library", (folder / LIBRARY).read_bytes()),
        "lock.js": f"pyodideData.lock = {json.dumps({'info': lock['info'], 'packages': {}})};\n",
    }


def snapshot(folder: Path, begin: Mapping[str, Any], asked: Sequence[Sequence[str]]) -> str:
    """As a script: the memory of Python once it has begun and has answered what is asked, so that no browser has to do it again.

    It is made by node, and fits the files of this folder only. Raises NoSnapshot.
    """
    node = shutil.which("node")
    if node is None:
        raise NoSnapshot("node is not installed")
    with (
        as_file(files("corollary.render") / "templates" / "snapshot.mjs") as script,
        tempfile.TemporaryDirectory() as place,
    ):
        memory = Path(place) / "memory"
        try:
            done = subprocess.run(
                [node, str(script), str(folder.resolve()), str(memory)],
                input=json.dumps([begin, asked]).encode(),
                capture_output=True,
                timeout=LONGEST,
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise NoSnapshot(f"node was not done after {LONGEST:g} s") from None
        if done.returncode or not memory.is_file():
            lines = done.stderr.decode(errors="replace").strip().splitlines()
            raise NoSnapshot(next((line for line in reversed(lines) if "Error" in line), "node failed"))
        content = memory.read_bytes()
    if len(content) > FEWEST_PAGES * PAGE:
        raise NoSnapshot(
            f"what is begun takes {len(content) >> 20} MiB, more than the {FEWEST_PAGES * PAGE >> 20} MiB of its program"
        )
    return _data("snapshot", gzip.compress(content, mtime=0))


def with_room(binary: bytes) -> bytes:
    """A WebAssembly program that begins with memory enough for a snapshot: the least number of pages in its memory section is
    set, in as many bytes as it had. What has no such section is left as it is."""
    place = HEADER
    while place < len(binary):
        kind, (length, inside) = binary[place], _number(binary, place + 1)
        if kind == MEMORY_SECTION:
            _count, flags = _number(binary, inside)
            _flags, begin = _number(binary, flags)
            pages, end = _number(binary, begin)
            return binary[:begin] + _bytes_of(max(pages, FEWEST_PAGES), end - begin) + binary[end:]
        place = inside + length
    return binary


def _number(binary: bytes, place: int) -> tuple[int, int]:
    """An unsigned number in LEB128, and the place behind it."""
    number, shift = 0, 0
    while True:
        byte = binary[place]
        number |= (byte & 0x7F) << shift
        place, shift = place + 1, shift + 7
        if byte < 0x80:
            return number, place


def _bytes_of(number: int, length: int) -> bytes:
    """A number in LEB128, in this many bytes. Raises OverflowError where it takes more."""
    if number >> 7 * length:
        raise OverflowError(f"{number} does not fit into {length} bytes")
    return bytes(number >> 7 * place & 0x7F | (0x80 if place + 1 < length else 0) for place in range(length))


def _data(name: str, content: bytes) -> str:
    return f'pyodideData.{name} = "{base64.b64encode(content).decode()}";\n'


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
