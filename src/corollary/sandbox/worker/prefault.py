"""Memory that a fork shares: kept in large pages, and what every notebook writes to copied before the clock runs."""

import os
import re

import numpy

from . import libc

_SMALL, _LARGE = 4 << 10, 2 << 20
_PRIVATE = re.compile(rb"^([0-9a-f]+)-([0-9a-f]+) rw-p \S+ \S+ 0 ", re.MULTILINE)
_PRESENT, _ALONE = numpy.uint64(1 << 63), numpy.uint64(1 << 56)
_GAP = 1


def join(maps):
    """Joins what this process has written so far into large pages, where the kernel will: a fork has then less to copy.
    `maps` is its open /proc/self/maps."""
    for begin, end in _private(maps):
        for address in range(-(-begin // _LARGE) * _LARGE, end - _LARGE + 1, _LARGE):
            libc.advise(address, _LARGE, libc.MADV_COLLAPSE)


def written(maps, machine):
    """The runs of pages, as (address, bytes), that this fork has written to and so no longer shares with its parent.
    `maps` is the parent's; `machine` is a descriptor of /proc."""
    runs = []
    descriptor = os.open("self/pagemap", os.O_RDONLY, dir_fd=machine)
    for begin, end in _private(maps):
        entries = numpy.frombuffer(
            os.pread(descriptor, (end - begin) // _SMALL * 8, begin // _SMALL * 8), numpy.uint64
        )
        own = numpy.flatnonzero((entries & _PRESENT != 0) & (entries & _ALONE != 0))
        for run in numpy.split(own, numpy.flatnonzero(numpy.diff(own) > _GAP) + 1):
            if len(run):
                runs.append((begin + int(run[0]) * _SMALL, int(run[-1] - run[0] + 1) * _SMALL))
    os.close(descriptor)
    return runs


def copy(runs):
    """Writes to these pages, as it were: the child has them for its own, without a fault for each."""
    for address, count in runs:
        libc.advise(address, count, libc.MADV_POPULATE_WRITE)


def _private(maps):
    text = b""
    while part := os.pread(maps, 1 << 20, len(text)):
        text += part
    return [(int(begin, 16), int(end, 16)) for begin, end in _PRIVATE.findall(text)]
