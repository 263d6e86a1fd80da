"""Where in a solution's file an author's word is spoken."""

from __future__ import annotations

import sys
from types import FrameType

from corollary.derive.statements import SOLUTION

WORDS = {
    "corollary.author",
    "corollary.misconceptions",
}  # the modules that hold the words: their own frames are nobody's line


def line_of_word() -> int:
    """The line of the author's own word in the solution."""
    return frame_of_word().f_lineno


def frame_of_word() -> FrameType:
    """The innermost frame of a solution's file, even where a word is spoken by a function of another file; else the caller's."""
    caller: FrameType | None = sys._getframe()  # pyright: ignore[reportPrivateUsage]
    while caller is not None and caller.f_globals.get("__name__") in {*WORDS, __name__}:
        caller = caller.f_back
    frame = caller
    while frame is not None and not str(frame.f_globals.get("__name__", "")).startswith(SOLUTION):
        frame = frame.f_back
    found = frame or caller
    assert found is not None  # a word is always spoken by somebody
    return found
