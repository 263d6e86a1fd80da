"""Huge pages hold what was there before, and a fork's writes are its own."""

from __future__ import annotations

import mmap
import os
import re
from pathlib import Path

import pytest

from corollary.sandbox.worker import huge_pages

SIZE = 16 << 20


def huge_kilobytes() -> int:
    found = re.search(r"AnonHugePages:\s+(\d+)", Path("/proc/self/smaps_rollup").read_text())
    return int(found[1]) if found else 0


@pytest.mark.whole
def test_memory_in_huge_pages_is_as_it_was():
    area = mmap.mmap(-1, SIZE, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
    marks = range(0, SIZE, 4096)
    for at in marks:
        area[at : at + 8] = at.to_bytes(8, "big")
    before = huge_kilobytes()
    maps = os.open("/proc/self/maps", os.O_RDONLY)
    huge_pages.use_huge_pages(maps)
    os.close(maps)
    assert all(area[at : at + 8] == at.to_bytes(8, "big") for at in marks)
    if huge_pages.libc.collapse(0, 0):  # the kernel knows how (Linux 6.1)
        assert huge_kilobytes() > before
    child = os.fork()
    if child == 0:
        area[0:8] = b"a child."
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0
    assert area[0:8] == bytes(8)
    area.close()
