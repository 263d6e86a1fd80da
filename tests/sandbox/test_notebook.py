"""Any bytes at all are a notebook or a sentence on why they are none."""

from __future__ import annotations

import json
import os
from pathlib import Path

import nbformat
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from corollary.sandbox.file import MOST_BYTES, Unreadable
from corollary.sandbox.notebook import Notebook, code_cells, notebook_of, read_notebook


def code(source: str = "a = 1", **more: object) -> dict:
    return {
        "cell_type": "code",
        "source": source,
        "metadata": {},
        "outputs": [],
        "execution_count": None,
        **more,
    }


def book(*cells: object, **more: object) -> bytes:
    return json.dumps(
        {"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": list(cells), **more}
    ).encode()


def opened(content: bytes) -> Notebook:
    notebook = notebook_of(content)
    assert isinstance(notebook, Notebook), notebook
    nbformat.validate(notebook.node)
    return notebook


def test_an_ordinary_notebook_is_read(tmp_path: Path) -> None:
    path = tmp_path / "kick.ipynb"
    path.write_bytes(
        book(code(id="one"), {"cell_type": "markdown", "source": ["x", "y"], "metadata": {}, "id": "two"})
    )
    notebook = read_notebook(path)
    assert isinstance(notebook, Notebook)
    assert [(cell.id, cell.source) for cell in code_cells(notebook)] == [("one", "a = 1")]
    assert notebook.node.cells[1].source == "xy"


def test_missing_and_repeated_ids_are_mended() -> None:
    notebook = opened(book(code(id="x"), code(id="x"), code(), code(id=7), code(id="cell-2")))
    ids = [cell.id for cell in notebook.node.cells]
    assert ids[0] == "x"
    assert len(set(ids)) == 5
    assert any("earlier cell" in note for note in notebook.notes)


def test_an_old_notebook_is_upgraded() -> None:
    old = {
        "nbformat": 3,
        "nbformat_minor": 0,
        "metadata": {"name": "old"},
        "worksheets": [
            {
                "cells": [
                    {"cell_type": "code", "input": ["a = 1\n", "b = 2"], "outputs": [], "language": "python"}
                ],
                "metadata": {},
            }
        ],
    }
    notebook = opened(json.dumps(old).encode())
    assert code_cells(notebook)[0].source == "a = 1\nb = 2"


def test_a_byte_order_mark_and_odd_cells_are_survived() -> None:
    notebook = opened(
        b"\xef\xbb\xbf"
        + book(code(), "not a cell", {"cell_type": "heading"}, {"cell_type": "code", "source": 5})
    )
    assert len(notebook.node.cells) == 2
    assert len(notebook.notes) == 2


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "empty"),
        (b"   ", "empty"),
        (b"\xff\xfe\x00", "UTF-8"),
        (b"{", "broken"),
        (b"[1]", "does not begin"),
        (b"{}", "neither"),
        (b'{"nbformat": 4, "cells": []}', "no cells"),
        (b'{"nbformat": 4, "cells": {}}', "no cells"),
        (b'{"nbformat": 4, "cells": [3]}', "no cells"),
        (b'{"nbformat": 3}', ""),
        (b'{"nbformat": 2, "worksheets": 7}', ""),
        (b"[" * 10**6, "nested"),
        (b'{"a":' * 10**5 + b"1" + b"}" * 10**5, "nested"),
        (b'{"nbformat":4,"cells":' + b"[" * 200 + b"]" * 200 + b"}", "nested"),
        (b" " * (MOST_BYTES + 1), "larger"),
        (b"1" * 10_000, "not a notebook"),
        (book(*[code()] * 2001), "more than"),
    ],
    ids=lambda each: str(len(each)),
)
def test_what_is_no_notebook_is_said_in_a_sentence(content: bytes, words: str) -> None:
    answer = notebook_of(content)
    assert isinstance(answer, Unreadable)
    assert words in answer.why
    assert answer.why.endswith(".")


def test_files_that_are_none_are_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "real").write_bytes(book(code()))
    (tmp_path / "link").symlink_to(tmp_path / "real")
    for name in ("pipe", "link", "absent", ".", "bad\0name"):
        assert isinstance(read_notebook(tmp_path / name), Unreadable), name


@given(some.binary(max_size=200))
@settings(max_examples=100)
def test_any_bytes_are_answered(content: bytes) -> None:
    assert isinstance(notebook_of(content), Notebook | Unreadable)


_JSON = some.recursive(
    some.none() | some.booleans() | some.integers() | some.floats() | some.text(max_size=8),
    lambda inner: (
        some.lists(inner, max_size=3)
        | some.dictionaries(
            some.sampled_from(
                ["cells", "nbformat", "metadata", "source", "cell_type", "outputs", "id", "worksheets"]
            ),
            inner,
            max_size=4,
        )
    ),
    max_leaves=12,
)


@given(
    some.lists(
        some.fixed_dictionaries(
            {"cell_type": some.sampled_from(["code", "markdown", "raw"])},
            optional={
                "source": _JSON,
                "metadata": _JSON,
                "outputs": _JSON,
                "id": _JSON,
                "attachments": _JSON,
            },
        ),
        max_size=4,
    ),
    _JSON,
    some.sampled_from([1, 2, 3, 4, 5, "4", None]),
)
@settings(max_examples=150, deadline=None)
def test_any_json_in_the_shape_of_a_notebook_is_answered(
    cells: list, metadata: object, version: object
) -> None:
    answer = notebook_of(json.dumps({"nbformat": version, "metadata": metadata, "cells": cells}).encode())
    if isinstance(answer, Notebook):
        ids = [cell.id for cell in answer.node.cells]
        assert len(ids) == len(set(ids))
        assert all(isinstance(cell.source, str) for cell in code_cells(answer))
