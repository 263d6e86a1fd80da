"""Pyodide, Python for browsers, fetched from npm and written as scripts that a page loads without a network."""

from __future__ import annotations

import base64
import gzip
import json
import os
import shutil
import subprocess
import tarfile
import tempfile
from collections.abc import Mapping, Sequence
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any


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
