"""The page of laws, functions, units and letters is that of the code as it is now, and says an equation for every law."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import corollary.laws
from corollary.formula.functions import FUNCTIONS
from corollary.units.constants import CONSTANTS

TOP = Path(__file__).parents[2]
PAGE = (TOP / "docs" / "reference" / "laws.md").read_text(encoding="utf-8")


def test_the_page_is_up_to_date():
    done = subprocess.run([sys.executable, TOP / ".ci" / "author_reference.py", "--check"], check=False)
    assert done.returncode == 0, "python .ci/author_reference.py writes it anew"


def test_nothing_is_left_out():
    laws = dict(re.findall(r"^\| `(\w+)\(.*?\)` \| (.*?) \|", PAGE, re.MULTILINE))
    assert laws.keys() == {*corollary.laws.__all__} - {"Law", "law", "wrong"}
    assert [name for name, equation in laws.items() if "=" not in equation] == [
        "after_elastic"
    ]  # velocities, and no law
    for each in (*FUNCTIONS, *CONSTANTS, "ohm", "°C", "lambda"):
        assert f"`{each}`" in PAGE, each
