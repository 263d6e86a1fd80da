"""The entry point: a command imports what it needs and no grammars beside."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

RUN = """
import json, sys
from corollary.cli.main import main
sys.argv = ["corollary", "show", "X12.5", "--format", "ipynb", "-o", sys.argv[1]]
try:
    main()
finally:
    json.dump([name for name in ("nbformat", "jsonschema", "lark") if name in sys.modules], sys.stdout)
"""


def test_a_notebook_is_written_without_building_grammars_of_addresses(tmp_path: Path):
    place = tmp_path / "kick.ipynb"
    done = subprocess.run([sys.executable, "-c", RUN, place], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == ["nbformat", "jsonschema"]
    assert json.loads(place.read_text(encoding="utf-8"))["nbformat"] == 4


def test_the_package_runs_as_the_command():
    ran = [
        subprocess.run([sys.executable, "-m", "corollary", *asked], capture_output=True, text=True)
        for asked in (["scene", "kick"], ["scen"])
    ]
    assert [done.returncode for done in ran] == [0, 2]
    assert ran[0].stdout.startswith("kick: ")
    assert "corollary --help" in ran[1].stderr
