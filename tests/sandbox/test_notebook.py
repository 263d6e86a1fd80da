"""Any bytes at all are a notebook or a sentence on why they are none."""

from __future__ import annotations

import json
import os
from pathlib import Path

import nbformat
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from corollary.messages import language
from corollary.sandbox.file import Unreadable, bytes_of
from corollary.sandbox.notebook_file import Notebook, notebook_of


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
    notebook = notebook_of(path.read_bytes())
    assert isinstance(notebook, Notebook)
    assert [(cell.id, cell.source) for cell in notebook.node.cells[:1]] == [("one", "a = 1")]
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
    assert notebook.node.cells[0].source == "a = 1\nb = 2"


def test_a_byte_order_mark_and_odd_cells_are_survived() -> None:
    notebook = opened(
        b"\xef\xbb\xbf"
        + book(code(), "not a cell", {"cell_type": "heading"}, {"cell_type": "code", "source": 5})
    )
    assert len(notebook.node.cells) == 2
    assert len(notebook.notes) == 2


def _old(*worksheets: dict) -> bytes:
    return json.dumps({"nbformat": 3, "nbformat_minor": 0, "metadata": {}, "worksheets": worksheets}).encode()


WORKSHEET = {"cells": [{"cell_type": "code", "input": ["X12_5_a = 8.6"], "language": "python"}]}


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(_old(WORKSHEET), id="version 3 without outputs"),
        pytest.param(_old({"metadata": {}}, WORKSHEET), id="version 3 with a worksheet without cells"),
        pytest.param(_old(WORKSHEET, {"cells": None}), id="version 3 with a worksheet whose cells are null"),
        pytest.param(book(code("X12_5_a = 8.6", id="x"), code("b = 2", id="x")), id="one id twice"),
        pytest.param(book({"cell_type": "code", "source": "X12_5_a = 8.6"}), id="no metadata"),
        pytest.param(
            book(code("X12_5_a = 8.6", outputs=None, metadata=None)), id="outputs and metadata null"
        ),
        pytest.param(
            book(code("X12_5_a = 8.6"), metadata={"kernelspec": {"name": "ir", "language": "R"}}),
            id="kernel of R",
        ),
        pytest.param(book(code("X12_5_a = 8.6"), metadata={"a": float("nan")}), id="NaN"),
        pytest.param(
            book(
                code("X12_5_a = 8.6"),
                metadata={
                    "kernelspec": [1],
                    "language_info": {},
                    "title": 3,
                    "authors": 0,
                    "orig_nbformat": "3",
                },
            ),
            id="metadata of other types",
        ),
    ],
)
def test_an_answer_is_found_in_every_form_of_a_file(content: bytes) -> None:
    assert opened(content).node.cells[0].source == "X12_5_a = 8.6"


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
        (b"[" * 10**5, "nested"),
        (b'{"a":' * 10**5 + b"1" + b"}" * 10**5, "nested"),
        (b'{"nbformat":4,"cells":' + b"[" * 200 + b"]" * 200 + b"}", "nested"),
        (b" " * (20 * 2**20 + 1), "larger"),
        (b'{"cells": [' + b"{}," * 6_000_000 + b"{}]}", "values"),
        (b'{"cells": ' + b"[[]," * 4_000_000, "values"),
        (book(code(metadata={"x": [{}] * 120_000})), "values beside the outputs"),
        (b"1" * 10_000, "thousands of digits, so it is not a notebook"),
        (book(*[code()] * 2001), "more than"),
    ],
    ids=lambda each: str(len(each)),
)
def test_what_is_no_notebook_is_said_in_a_sentence(content: bytes, words: str) -> None:
    answer = notebook_of(content)
    assert isinstance(answer, Unreadable)
    assert words in answer.why
    assert answer.why.endswith(".")


def test_many_outputs_are_no_bomb_and_are_left_out() -> None:
    plotly = {"output_type": "display_data", "metadata": {}, "data": {"application/json": [0.25] * 200_000}}
    notebook = opened(book(code(outputs=[plotly]), code("b = '[,,{' * 3 # " + "[,{" * 400_000)))
    assert [cell.outputs for cell in notebook.node.cells] == [[], []]
    assert len(notebook.node.cells) == 2


def test_half_surrogates_are_replaced_wherever_they_stand() -> None:
    pictures = {"\ud800.png": {"image/png": "\udfff"}}
    text = {"cell_type": "markdown", "source": "\ud800", "metadata": {}, "attachments": pictures}
    about = {"\ud800": ["\ud800"], "whole": "\U0001f600"}
    notebook = opened(book(code("a = '\ud800'", id="x\udc00"), text, metadata=about))
    json.dumps(notebook.node, ensure_ascii=False).encode("utf-8")
    assert notebook.node.cells[0].source == "a = '?'"
    assert list(notebook.node.cells[1].attachments) == ["?.png"]
    assert notebook.node.metadata == {"?": ["?"], "whole": "\U0001f600"}


@pytest.mark.parametrize("name", ["../../x", "a b", "x\n", "<b>", "", "x" * 65])
def test_an_id_that_is_none_is_replaced(name: str) -> None:
    assert opened(book(code(id=name))).node.cells[0].id == "cell-1"


def test_files_that_are_none_are_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "real").write_bytes(book(code()))
    (tmp_path / "link").symlink_to(tmp_path / "real")
    for name in ("pipe", "link", "absent", ".", "bad\0name"):
        assert isinstance(bytes_of(tmp_path / name), Unreadable), name


def test_a_link_a_device_and_a_huge_file_are_refused_by_name(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to("/dev/zero")
    with (tmp_path / "sparse").open("wb") as file:
        file.truncate(40 << 30)
    for path, words in (
        (tmp_path / "link", "is a link"),
        (Path("/dev/zero"), "not a file"),
        (tmp_path / "sparse", "larger than 20 MB"),
        (tmp_path / "x" / "y", "cannot be opened"),
    ):
        answer = bytes_of(path)
        assert isinstance(answer, Unreadable)
        assert words in answer.why
        assert answer.why.endswith(".")
    growing = bytes_of(Path("/proc/self/status"), 10)
    assert isinstance(growing, Unreadable)
    assert growing.why == "The file is larger than 10 bytes: clear the outputs and hand it in again."


@pytest.mark.parametrize(("code", "begins"), [("de", "Die Datei "), ("nb", "Filen ")])
def test_why_it_is_refused_is_said_in_the_students_language_and_recorded_in_one(
    code: str, begins: str, tmp_path: Path
) -> None:
    (tmp_path / "link").symlink_to("/dev/zero")
    contents = (b"", b"\xff", b'{"cells": [', b"[]", b"[" * 20_000, b'{"a": ' + b"1" * 5_000 + b"}")
    for refused in (*map(notebook_of, contents), bytes_of(tmp_path / "link"), bytes_of(tmp_path / "none")):
        assert isinstance(refused, Unreadable)
        english = refused.why
        with language(code):
            assert refused.why.startswith(begins), refused.why
            assert refused.why != english == refused.in_english


def test_no_folder_on_the_way_may_be_a_link(tmp_path: Path) -> None:
    (tmp_path / "submitted" / "ada" / "week1").mkdir(parents=True)
    (tmp_path / "submitted" / "ada" / "week1" / "n").write_bytes(b"x")
    (tmp_path / "submitted" / "bob").symlink_to(tmp_path / "submitted" / "ada")
    (tmp_path / "submitted" / "eve").mkdir()
    (tmp_path / "submitted" / "eve" / "week1").symlink_to(tmp_path / "submitted" / "ada" / "week1")
    below = tmp_path / "submitted"
    assert bytes_of(below / "ada" / "week1" / "n", within=below) == b"x"
    for student in ("bob", "eve"):
        answer = bytes_of(below / student / "week1" / "n", within=below)
        assert isinstance(answer, Unreadable)
        assert "link" in answer.why
    assert isinstance(bytes_of(tmp_path / "elsewhere", within=below), Unreadable)


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
        assert all(isinstance(cell.source, str) for cell in answer.node.cells)


OLD = {"cell_type": "heading", "level": 10**9, "source": "x"}


@pytest.mark.parametrize("level", [10**9, -(10**9), 10**400, 1e308, True, "2", None, [10**9], {}])
@pytest.mark.parametrize("version", [1, 2, 3])
def test_a_heading_of_an_old_notebook_is_as_deep_as_headings_are(level: object, version: int) -> None:
    cells = [{**OLD, "level": level}, {"cell_type": "code", "input": "a = 1", "code": "a = 1"}]
    old = {"nbformat": version, "worksheets": [{"cells": cells}], "cells": []}
    notebook = opened(json.dumps(old).encode())
    heading, answer = notebook.node.cells
    assert heading.source in {"# x", "###### x", "## x"}
    assert answer.source == "a = 1"


ANYTHING = some.recursive(
    some.none() | some.booleans() | some.integers() | some.floats() | some.text(max_size=4),
    lambda inner: (
        some.lists(inner, max_size=3)
        | some.dictionaries(
            some.sampled_from(
                ["cells", "worksheets", "cell_type", "source", "input", "level", "metadata", "id", "outputs"]
            ),
            inner,
            max_size=4,
        )
    ),
    max_leaves=8,
)


@settings(max_examples=150, deadline=None)
@given(some.sampled_from([1, 2, 3, 4, "4", True, 1e308, 10**9, None]), ANYTHING, ANYTHING, ANYTHING)
def test_whatever_stands_where_cells_should_is_a_notebook_or_a_sentence(
    version: object, cell: object, cells: object, metadata: object
) -> None:
    for sheet in ([cell], cells):
        raw = {"nbformat": version, "nbformat_minor": metadata, "metadata": metadata, "cells": sheet}
        for about in (raw, {**raw, "worksheets": [{"cells": sheet}, cell, raw]}):
            found = notebook_of(json.dumps(about).encode())
            if isinstance(found, Notebook):
                nbformat.validate(found.node)
            else:
                assert found.why
