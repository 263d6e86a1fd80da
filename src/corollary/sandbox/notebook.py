"""Reading a notebook file a student handed in, whatever is in it."""

from __future__ import annotations

import json
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import nbformat

from corollary.sandbox.file import MOST_BYTES, Unreadable, bytes_of
from corollary.sandbox.job import Cell

MOST_CELLS = 2_000
DEEPEST = 60


@dataclass(frozen=True, slots=True)
class Notebook:
    """A notebook in nbformat 4, every cell with an id of its own; `notes` say what had to be mended."""

    node: nbformat.NotebookNode
    notes: tuple[str, ...] = ()


def read_notebook(path: str | Path) -> Notebook | Unreadable:
    """The notebook in a file; never raises, whatever the file or its bytes."""
    content = bytes_of(path)
    return notebook_of(content) if isinstance(content, bytes) else content


def notebook_of(content: bytes) -> Notebook | Unreadable:
    """The notebook in these bytes; never raises."""
    if len(content) > MOST_BYTES:
        return Unreadable(
            f"The file is larger than {MOST_BYTES >> 20} MB: clear the outputs and hand it in again."
        )
    if not content.strip():
        return Unreadable("The file is empty.")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return Unreadable("The file is not text in UTF-8, so it is not a notebook.")
    try:
        raw = json.loads(text, parse_constant=lambda _: None)
    except RecursionError:
        return Unreadable("The file is nested too deeply to be a notebook.")
    except ValueError as error:
        return Unreadable(f"The file is not a notebook: its JSON is broken ({error}).")
    if not isinstance(raw, dict):
        return Unreadable("The file is JSON, but not a notebook: it does not begin with {.")
    if _depth(raw) > DEEPEST:
        return Unreadable("The file is nested too deeply to be a notebook.")
    return _mended(raw)


def code_cells(notebook: Notebook) -> tuple[Cell, ...]:
    """The code cells in their order, as they are to be run; empty ones too, since results may be hung on them."""
    return tuple(Cell(cell.id, cell.source) for cell in notebook.node.cells if cell.cell_type == "code")


def _mended(raw: dict) -> Notebook | Unreadable:
    notes: list[str] = []
    node: Any
    version = raw.get("nbformat")
    if type(version) is not int or not 1 <= version <= 4:
        if "cells" not in raw:
            return Unreadable("The file is JSON, but not a notebook: it has neither a version nor cells.")
        notes.append(f"the notebook's version {version!r:.20} is unknown: read as version 4")
        raw["nbformat"], raw["nbformat_minor"] = 4, 5
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            node = nbformat.from_dict(raw)
            if node.nbformat < 4:
                notes.append(f"upgraded from notebook version {node.nbformat}")
                node = nbformat.convert(node, 4)
    except Exception as error:  # the upgrader meets arbitrary data and says so in a dozen ways
        return Unreadable(f"The notebook is damaged: {type(error).__name__} while reading it.")
    cells = node.get("cells")
    if not isinstance(cells, list) or not cells:
        return Unreadable("The notebook has no cells.")
    if len(cells) > MOST_CELLS:
        return Unreadable(f"The notebook has {len(cells)} cells, more than {MOST_CELLS}.")
    node.cells = _sound_cells(cells, notes)
    if not node.cells:
        return Unreadable("The notebook has no cells that can be read.")
    if not isinstance(node.get("metadata"), dict):
        node.metadata = nbformat.NotebookNode()
    node.nbformat, node.nbformat_minor = 4, 5
    return Notebook(node, tuple(notes))


def _sound_cells(cells: list, notes: list[str]) -> list[Any]:
    sound, taken = [], set()
    for number, raw in enumerate(cells, 1):
        if not isinstance(raw, dict) or raw.get("cell_type") not in ("code", "markdown", "raw"):
            notes.append(f"cell {number} is left out: it is neither code nor text")
            continue
        cell: Any = nbformat.from_dict(raw)
        source = cell.get("source", "")
        if isinstance(source, list):
            source = "".join(line for line in source if isinstance(line, str))
        cell.source = _whole(source) if isinstance(source, str) else ""
        if not isinstance(cell.get("metadata"), dict):
            cell.metadata = nbformat.NotebookNode()
        name = cell.get("id")
        if not isinstance(name, str) or not name or len(name) > 64 or name in taken or not name.isascii():
            if isinstance(name, str) and name in taken:
                notes.append(f"cell {number} has the id of an earlier cell: it gets its own")
            name = _free_id(number, taken)
        taken.add(name)
        cell.id = name
        if cell.cell_type == "code":
            outputs = cell.get("outputs")
            cell.outputs = (
                [each for each in outputs if isinstance(each, dict)] if isinstance(outputs, list) else []
            )
            cell.setdefault("execution_count", None)
        sound.append(cell)
    return sound


def _free_id(number: int, taken: set[str]) -> str:
    name = f"cell-{number}"
    while name in taken:
        name += "x"
    return name


def _whole(text: str) -> str:
    """Without half surrogates, which JSON can write but no file can hold."""
    return text.encode("utf-8", "replace").decode("utf-8")


def _depth(raw: object) -> int:
    """How deeply lists and dictionaries lie in one another, counted without recursion."""
    deepest, waiting = 0, [(raw, 1)]
    while waiting and deepest <= DEEPEST:
        value, depth = waiting.pop()
        deepest = max(deepest, depth)
        if isinstance(value, dict):
            waiting.extend((each, depth + 1) for each in value.values())
        elif isinstance(value, list):
            waiting.extend((each, depth + 1) for each in value)
    return deepest
