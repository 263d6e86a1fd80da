"""The table of what real clients gave is that of the records."""

from __future__ import annotations

import runpy
from pathlib import Path

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


def test_the_table_of_clients_is_that_of_the_records():
    made = runpy.run_path(str(BENCHMARKS / "clients.py"))["tables"]()
    assert made == (BENCHMARKS / "results" / "clients.md").read_text(encoding="utf-8")
    assert "Moodle, marks and files" in made
