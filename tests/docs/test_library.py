"""Every Python block of docs/tutorial/library.md is run, one after the other, and what stands behind `# →` is what comes out."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Any

import pytest

PAGE = Path(__file__).parents[2] / "docs" / "tutorial" / "library.md"
BLOCKS = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
SHOWN = re.compile(r"^(?P<code>.*?)\s+# → (?P<value>.*)$")


@pytest.fixture(scope="module")
def names() -> dict[str, Any]:
    """What the blocks before have defined."""
    return {}


@pytest.mark.parametrize("block", BLOCKS, ids=[f"block {number}" for number in range(len(BLOCKS))])
def test_the_page_says_what_happens(block: str, names: dict[str, Any]) -> None:
    for statement in ast.parse(block).body:
        source = ast.get_source_segment(block, statement) or ""
        line = block.splitlines()[(statement.end_lineno or 1) - 1]
        shown = SHOWN.match(line)
        if isinstance(statement, ast.Expr) and shown:
            found = eval(source, names)
            assert repr(found).replace(r"\xa0", " ") == shown["value"], line
        else:
            exec(source, names)


def test_the_page_shows_something() -> None:
    assert len(BLOCKS) >= 6
    assert sum("# → " in block for block in BLOCKS) >= 5
