"""The page of ready-made scenes is that of the code as it is now, and has every scene with all its settings."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from corollary.derive.ready_scenes import ready_scenes

SCENES = ready_scenes()

TOP = Path(__file__).parents[2]


def test_the_page_is_up_to_date():
    done = subprocess.run([sys.executable, TOP / ".ci" / "scenes_reference.py", "--check"], check=False)
    assert done.returncode == 0, "python .ci/scenes_reference.py writes it anew"


def test_every_setting_is_there():
    page = (TOP / "docs" / "reference" / "ready_scenes.md").read_text(encoding="utf-8")
    told = {part.partition("`")[0]: part for part in page.split("\n## `")[1:]}
    assert told.keys() == set(SCENES)
    for name, part in told.items():
        for setting in SCENES[name].settings:
            assert f"| `{setting.name}` | {setting.meaning} | {setting.unit} |" in part
