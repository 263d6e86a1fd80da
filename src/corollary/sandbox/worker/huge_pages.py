"""The zygote's memory in huge pages, of which a fork copies one entry where it would copy 512."""

import os

from . import libc

_HUGE = 2 << 20  # on x86-64 and most of arm64; elsewhere the kernel refuses, and nothing is lost


def use_huge_pages(maps):
    """Moves what the heap holds into huge pages, as far as it lies together; `maps` is a descriptor of /proc/self/maps.

    A worker that writes still copies the 4 kB it writes to, no more.
    """
    for start, end in _heap(maps):
        for place in range(-(-start // _HUGE) * _HUGE, end // _HUGE * _HUGE, _HUGE):
            libc.collapse(place, _HUGE)


def _heap(maps):
    """Where memory of this process alone begins and ends: written to, and of no file."""
    text = b"".join(iter(lambda: os.read(maps, 1 << 16), b"")).decode()
    for line in text.splitlines():
        addresses, permissions, _, _, _, *name = line.split(maxsplit=5)
        if permissions == "rw-p" and name in ([], ["[heap]"]):
            start, _, end = addresses.partition("-")
            yield int(start, 16), int(end, 16)
