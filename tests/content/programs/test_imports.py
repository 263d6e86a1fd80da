"""What solutions and judges of programs import from Corollary, in every bank: what is documented for authors, and nothing else."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

TOP = Path(__file__).parents[3]
BANKS = {
    "chapter": TOP / "solutions",
    **{path.parent.name: path for path in (TOP / "examples" / "banks").glob("*/src/*/solutions")},
}
OFFERED = (
    "corollary.author",
    "corollary.laws",
    "corollary.misconceptions",
    "corollary.programs",
    "corollary.scenes.",
)
IN_SCENES = ("corollary.formula.ball", "corollary.formula.functions")
"""What ready-made scenes evaluate their formulas in."""


@pytest.mark.parametrize("bank", BANKS)
def test_only_what_is_offered_to_authors_is_imported(bank):
    files = list(BANKS[bank].rglob("*.py"))
    imported = {
        (str(path.relative_to(BANKS[bank])), node.module)
        for path in files
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("corollary.")
    }
    assert not {
        (path, name)
        for path, name in imported
        if not name.startswith((*OFFERED, *IN_SCENES) if Path(path).parts[0] == "scenes" else OFFERED)
    }
    judges = {name for path, name in imported if Path(path).name.startswith("judge_")}
    assert judges <= {"corollary.programs"}


def test_judges_are_there():
    assert sum(1 for folder in BANKS.values() for _ in folder.rglob("*.py")) > 100
    assert sum(1 for folder in BANKS.values() for _ in folder.rglob("judge_*.py")) >= 11
