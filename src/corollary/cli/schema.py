"""`corollary schema`: the JSON schema of a problem's front matter, by which an editor completes and checks it."""

from __future__ import annotations

from corollary.cli.ending import HOLDS, answer
from corollary.problem.schema import schema


def run() -> int:
    answer(schema())
    return HOLDS
