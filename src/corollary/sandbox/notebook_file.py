"""Reading a notebook file a student handed in, whatever is in it."""

# pyright: reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from typing import Any

import nbformat

from corollary.messages import N_
from corollary.sandbox.file import MOST_BYTES, Unreadable, too_large

MOST_CELLS = 2_000
DEEPEST = 60
# 20 MB of "{}," would become ten million objects, a gigabyte and minutes. These bounds keep any file below about 300 MB and
# two seconds; a thousand cells with their outputs have some 20 000 values, a plot of plotly's some 100 000.
MOST_VALUES = 500_000
MOST_INPUT_VALUES = 100_000  # without the outputs, which nobody needs: all cells are run again

_STRING = re.compile(rb'"[^"\\]*+(?:\\.[^"\\]*+)*+"', re.DOTALL)
_HALF_SURROGATE = re.compile(r"\\u[dD][89a-fA-F]")
_CELL_ID = re.compile(r"[A-Za-z0-9_-]{1,64}")  # as nbformat 4.5 has it


@dataclass(frozen=True, slots=True)
class Notebook:
    """A notebook in nbformat 4, every cell with an id of its own; `notes` say what had to be mended."""

    node: nbformat.NotebookNode
    notes: tuple[str, ...] = ()


def notebook_of(content: bytes) -> Notebook | Unreadable:
    """The notebook in these bytes; never raises."""
    if len(content) > MOST_BYTES:
        return too_large(MOST_BYTES)
    if not content.strip():
        return Unreadable(N_("The file is empty."))
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return Unreadable(N_("The file is not text in UTF-8, so it is not a notebook."))
    if _values_in(content) > MOST_VALUES:
        message = N_("The file holds more than {most} values: clear the outputs and hand it in again.")
        return Unreadable(message, {"most": MOST_VALUES})
    try:
        raw = json.loads(text, parse_constant=lambda _: None)
    except RecursionError:
        return Unreadable(N_("The file is nested too deeply to be a notebook."))
    except json.JSONDecodeError as error:
        message = N_("The file is not a notebook: its JSON is broken in line {line}, column {column}.")
        return Unreadable(message, {"line": error.lineno, "column": error.colno})
    except ValueError:  # more digits than Python turns into a number
        return Unreadable(N_("The file has a number of thousands of digits, so it is not a notebook."))
    if not isinstance(raw, dict):
        return Unreadable(N_("The file is JSON, but not a notebook: it does not begin with {."))
    _drop_outputs(raw)
    depth, count = _measure(raw)
    if depth > DEEPEST:
        return Unreadable(N_("The file is nested too deeply to be a notebook."))
    if count > MOST_INPUT_VALUES:
        message = N_("The file holds more than {most} values beside the outputs of its cells.")
        return Unreadable(message, {"most": MOST_INPUT_VALUES})
    if _HALF_SURROGATE.search(text):
        raw = _whole_texts(raw)
    return _mended(raw)


def _mended(raw: dict) -> Notebook | Unreadable:
    notes: list[str] = []
    version = raw.get("nbformat")
    if type(version) is not int or not 1 <= version <= 4:
        if "cells" not in raw:
            return Unreadable(N_("The file is JSON, but not a notebook: it has neither a version nor cells."))
        notes.append(f"the notebook's version {version!r:.20} is unknown: read as version 4")
        version = 4
    elif version < 4:
        notes.append(f"upgraded from notebook version {version}")
    cells = raw.get("cells") if version == 4 else _cells_of_old(raw)
    if not isinstance(cells, list) or not cells:
        return Unreadable(N_("The notebook has no cells."))
    if len(cells) > MOST_CELLS:
        message = N_("The notebook has {count} cells, more than {most}.")
        return Unreadable(message, {"count": len(cells), "most": MOST_CELLS})
    sound = _sound_cells(cells, notes)
    if not sound:
        return Unreadable(N_("The notebook has no cells that can be read."))
    node = nbformat.NotebookNode(
        metadata=nbformat.from_dict(_sound_metadata(raw.get("metadata"))),
        nbformat=4,
        nbformat_minor=5,
        cells=sound,
    )
    return Notebook(node, tuple(notes))


def _sound_metadata(metadata: object) -> dict:
    """The notebook's metadata without what nbformat's schema refuses: one student's kernel stops no command of nbgrader's."""
    found = dict(metadata) if isinstance(metadata, dict) else {}
    kernel, language = found.get("kernelspec"), found.get("language_info")
    if isinstance(kernel, dict) and isinstance(kernel.get("name"), str):
        named = kernel.get("display_name")
        found["kernelspec"] = {**kernel, "display_name": named if isinstance(named, str) else kernel["name"]}
    else:
        found.pop("kernelspec", None)
    if not (isinstance(language, dict) and isinstance(language.get("name"), str)):
        found.pop("language_info", None)
    for name, kind in (("title", str), ("authors", list), ("orig_nbformat", int)):
        if not isinstance(found.get(name), kind):
            found.pop(name, None)
    return found


def _cells_of_old(raw: dict) -> list[object]:
    """The cells of nbformat 1 to 3, named as version 4 has them. nbformat's own upgrade trusts what is in them: a heading of level
    10^9 takes a gigabyte there, and nobody knows how long."""
    found: list[object] = []
    for sheet in (*_list(raw.get("worksheets")), raw):
        cells = _list(sheet.get("cells") if isinstance(sheet, dict) else None)
        found += [_renamed(each) if isinstance(each, dict) else each for each in cells]
    return found


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _renamed(cell: dict) -> dict:
    kind, source = cell.get("cell_type"), cell.get("source", cell.get("text", ""))
    if kind == "code":
        source = cell.get("input", cell.get("code", source))
    elif kind == "heading":
        level = cell.get("level")
        hashes = "#" * (min(max(level, 1), 6) if type(level) is int else 1)
        source = f"{hashes} {' '.join(_joined(source).split())}"
    kind = kind if kind in ("code", "raw") else "markdown" if isinstance(kind, str) else kind
    return {"cell_type": kind, "source": source, "metadata": cell.get("metadata"), "id": cell.get("id")}


def _joined(source: object) -> str:
    """A cell's text, which may be parted into its lines."""
    if isinstance(source, list):
        return "".join(line for line in source if isinstance(line, str))
    return source if isinstance(source, str) else ""


def _sound_cells(cells: list, notes: list[str]) -> list[Any]:
    sound, ids = [], set()
    for number, raw in enumerate(cells, 1):
        if not isinstance(raw, dict) or raw.get("cell_type") not in ("code", "markdown", "raw"):
            notes.append(f"cell {number} is left out: it is neither code nor text")
            continue
        cell: Any = nbformat.from_dict({**raw, "source": _joined(raw.get("source"))})
        if not isinstance(cell.get("metadata"), dict):
            cell.metadata = nbformat.NotebookNode()
        name = cell.get("id")
        if not isinstance(name, str) or not _CELL_ID.fullmatch(name) or name in ids:
            if isinstance(name, str) and name in ids:
                notes.append(f"cell {number} has the id of an earlier cell: it gets its own")
            name = _free_id(number, ids)
        ids.add(name)
        cell.id = name
        if cell.cell_type == "code":
            cell.outputs = []
            cell.setdefault("execution_count", None)
        sound.append(cell)
    return sound


def _free_id(number: int, ids: set[str]) -> str:
    name = f"cell-{number}"
    while name in ids:
        name += "x"
    return name


def _values_in(content: bytes) -> int:
    """How many values a JSON text holds at least, counted without making any of them."""
    if _commas_and_brackets(content) <= MOST_VALUES:
        return 0
    return _commas_and_brackets(_STRING.sub(b"", content))


def _commas_and_brackets(content: bytes) -> int:
    return content.count(b",") + content.count(b"[") + content.count(b"{")


def _drop_outputs(raw: dict) -> None:
    """In nbformat 4, and in the worksheets of 2 and 3."""
    for sheet in (raw, *_list(raw.get("worksheets"))):
        for cell in _list(sheet.get("cells") if isinstance(sheet, dict) else None):
            if isinstance(cell, dict) and "outputs" in cell:
                cell["outputs"] = []


def _measure(raw: object) -> tuple[int, int]:
    """How deeply lists and dictionaries lie in one another, and how many values there are; counted without recursion."""
    deepest, count, waiting = 1, 1, [(raw, 1)]
    while waiting and deepest <= DEEPEST and count <= MOST_INPUT_VALUES:
        value, depth = waiting.pop()
        inside = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
        if inside:
            deepest, count = max(deepest, depth + 1), count + len(inside)
            waiting += [(each, depth + 1) for each in inside if isinstance(each, dict | list)]
    return deepest, count


def _whole_texts(raw: Any) -> Any:
    """All texts, names of attachments too, without half surrogates, which JSON can write but no file can hold."""
    if isinstance(raw, str):
        return raw.encode("utf-8", "replace").decode("utf-8")
    if isinstance(raw, list):
        return [_whole_texts(each) for each in raw]
    if isinstance(raw, dict):
        return {_whole_texts(name): _whole_texts(each) for name, each in raw.items()}
    return raw
