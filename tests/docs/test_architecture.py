"""The sizes of rooms and walks that the page on the architecture states are those of the code."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).parents[2]


def test_the_sizes_of_rooms_and_walks_are_those_of_the_code():
    done = subprocess.run([sys.executable, TOP / ".ci" / "rooms.py", "--check"], check=False)
    assert done.returncode == 0, "python .ci/rooms.py writes them anew"
