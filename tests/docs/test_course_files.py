"""The page on a course's files: each kind of record that the program writes has its row, and no row is of something else."""

from __future__ import annotations

import ast
import re
from pathlib import Path

REPOSITORY = Path(__file__).parents[2]
PAGE = (REPOSITORY / "docs" / "reference" / "course_files.md").read_text(encoding="utf-8")


def kinds_written() -> set[str]:
    """The first argument of each `course.record(kind, name)`."""
    calls = (
        node
        for path in (REPOSITORY / "src" / "corollary").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "record"
    )
    first = (call.args[0] for call in calls if len(call.args) == 2)
    return {each.value for each in first if isinstance(each, ast.Constant) and isinstance(each.value, str)}


def rows(heading: str) -> list[str]:
    section = PAGE.partition(f"## {heading}")[2].partition("\n## ")[0]
    return re.findall(r"^\| (`[^|]*) \|", section, re.MULTILINE)


def test_each_kind_of_record_has_its_row_and_each_row_is_written():
    known = {name for row in rows("`.corollary/`") for name in re.findall(r"`([\w.]+)", row)}
    written = kinds_written()
    assert len(written) > 8
    assert known == written | {"key", "roster.csv", "demonstration", "lock"}


def test_each_command_that_is_said_to_write_a_file_is_there():
    from corollary.cli.commands import app

    named = set(re.findall(r"`corollary (\w+)", PAGE))
    assert len(named) > 5
    assert named <= set(app.commands)
