"""Pyodide, Python for browsers, as scripts that a page can load where nothing can be fetched: from a folder or a USB stick."""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
import tarfile
import tempfile
from collections.abc import Mapping
from pathlib import Path

VERSION = "314.0.7"
LOADER, PROGRAM, BINARY, LIBRARY, LOCK = (
    "pyodide.js",
    "pyodide.asm.mjs",
    "pyodide.asm.wasm",
    "python_stdlib.zip",
    "pyodide-lock.json",
)
NEEDED = (LOADER, PROGRAM, BINARY, LIBRARY, LOCK)


class NoPyodide(LookupError):
    """Pyodide is not there and cannot be fetched; one sentence says what to do."""


def fetched(cache: Path) -> Path:
    """The folder of Pyodide's files in the cache, fetched by npm the first time. Raises NoPyodide."""
    folder = cache / f"pyodide-{VERSION}"
    if all((folder / name).is_file() for name in NEEDED):
        return folder
    npm = shutil.which("npm")
    remedy = f"fetch it where there is one (npm pack pyodide@{VERSION}), unpack it, and name the folder with --pyodide FOLDER"
    if npm is None:
        raise NoPyodide(f"npm, which fetches Pyodide, is not installed: install it, or {remedy}")
    cache.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=cache) as place:
        done = subprocess.run(
            [npm, "pack", f"pyodide@{VERSION}", "--silent"],
            cwd=place,
            capture_output=True,
            text=True,
            check=False,
        )
        packed = next(Path(place).glob("pyodide-*.tgz"), None)
        if done.returncode or packed is None:
            raise NoPyodide(f"npm cannot fetch Pyodide without a network: {remedy}")
        with tarfile.open(packed) as archive:
            archive.extractall(place, filter="data")
        shutil.rmtree(folder, ignore_errors=True)
        os.replace(Path(place) / "package", folder)
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
        "binary.js": _data("binary", (folder / BINARY).read_bytes()),
        "library.js": _data("library", (folder / LIBRARY).read_bytes()),
        "lock.js": f"pyodideData.lock = {json.dumps({'info': lock['info'], 'packages': {}})};\n",
    }


def _data(name: str, content: bytes) -> str:
    return f'pyodideData.{name} = "{base64.b64encode(content).decode()}";\n'
