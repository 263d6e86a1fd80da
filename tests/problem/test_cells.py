"""Cells of a CSV file are found as the csv module finds them, and changing one leaves every other byte alone."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.problem.csv_table import read_cells

TEXT = st.text(st.sampled_from('ab,;"\n é='), max_size=6)


@given(
    rows=st.lists(st.lists(TEXT, min_size=2, max_size=3), min_size=1, max_size=5), all_quoted=st.booleans()
)
def test_they_are_those_of_the_csv_module(rows: list[list[str]], all_quoted: bool, tmp_path_factory) -> None:
    text = io.StringIO()
    quoting = csv.QUOTE_ALL if all_quoted else csv.QUOTE_MINIMAL
    csv.writer(text, delimiter=";", quoting=quoting).writerows([["id", "grade"], *rows])
    path = tmp_path_factory.mktemp("cells") / "marks.csv"
    path.write_bytes(text.getvalue().encode())
    cells = read_cells(path, frozenset({"id", "grade"}))
    read = list(csv.reader(io.StringIO(text.getvalue(), newline=""), delimiter=";"))
    filled = [tuple(cell.strip() for cell in row) for row in read if any(cell.strip() for cell in row)]
    assert [cells.values(row) for row in range(len(cells.rows))] == filled
    assert cells.changed({}) == path.read_bytes()
    last = len(filled) - 1
    changed = cells.changed({(last, 0): 'x;"y"'}).decode()
    again = [
        row
        for row in csv.reader(io.StringIO(changed, newline=""), delimiter=";")
        if any(c.strip() for c in row)
    ]
    assert again[last][0] == 'x;"y"'
    assert [[cell.strip() for cell in row] for row in again[:last]] == [list(row) for row in filled[:last]]


FORMS = [
    ("utf-8", b"", "\n", ","),
    ("utf-8", b"\xef\xbb\xbf", "\r\n", ";"),
    ("cp1252", b"", "\r\n", ";"),
    ("utf-16-le", b"\xff\xfe", "\r\n", "\t"),
    ("utf-16-be", b"\xfe\xff", "\n", ","),
]


@pytest.mark.parametrize(("encoding", "mark", "newline", "delimiter"), FORMS)
def test_encoding_mark_delimiter_and_ends_of_lines_stay(
    encoding: str, mark: bytes, newline: str, delimiter: str, tmp_path: Path
) -> None:
    rows = [
        ["id", "Grade", "note"],
        ["007", "", " as it is "],
        ["łu" if "16" in encoding else "æø", '"-"', '"a ""b"""'],
    ]
    text = newline.join(delimiter.join(row) for row in rows)
    path = tmp_path / "marks.csv"
    path.write_bytes(mark + text.encode(encoding))
    cells = read_cells(path, frozenset({"id", "grade"}))
    written = cells.changed({(1, 1): "4.5", (2, 1): "3"})
    expected = text.replace(f"007{delimiter}", f"007{delimiter}4.5").replace('"-"', '"3"')
    assert written == mark + expected.encode(encoding)
