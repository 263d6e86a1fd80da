"""A chain of equalities as it is set: no side twice, and in lines that fit a page."""

from __future__ import annotations

import re

WIDEST = 75  # letters: about what fits on a line of A4 between the margins
FRACTION = re.compile(r"\\frac\{((?:[^{}]|\{[^{}]*\})*)\}\{((?:[^{}]|\{[^{}]*\})*)\}")
COMMAND = re.compile(r"\\(?:left|right|mathrm|cdot|sqrt|,)|[{}\\ ^]")


def without_repetition(steps: list[str]) -> list[str]:
    """A chain in which no side is the one before it in brackets: `(14.10) = 14.10` says nothing."""
    found: list[str] = []
    for step in steps:
        if found and _bare(found[-1]) == _bare(step):
            found.pop()
        found.append(step)
    return found


def _bare(step: str) -> str:
    return re.sub(r"\\left|\\right|[() ]", "", step)


def broken(steps: list[str]) -> list[str]:
    """A chain of equalities in lines that fit a page; a new line begins with its equals sign."""
    lines = [steps[0]]
    for step in steps[1:]:
        if width(lines[-1]) + width(step) > WIDEST and lines[-1] != steps[0]:
            lines.append(f"= {step}")
        else:
            lines[-1] += f" = {step}"
    return lines


def width(formula: str) -> int:
    """About how many letters wide a formula is set: the wider line of a fraction counts, commands do not."""
    while (inner := FRACTION.search(formula)) is not None:
        formula = formula[: inner.start()] + max(inner[1], inner[2], key=len) + formula[inner.end() :]
    return len(COMMAND.sub("", formula))
