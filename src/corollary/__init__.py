"""Corollary derives the answers to physics exercises from the laws, and marks what students hand in."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from corollary.version import __version__

if TYPE_CHECKING:
    from corollary.answers.verdict import Verdict
    from corollary.api import UnknownPart, judge, key, load_bank, play, solve
    from corollary.derive.load import NotDerivable
    from corollary.derive.solution import Solution
    from corollary.formula.ball import Undefined
    from corollary.grading.key import Key
    from corollary.grading.part_grades import Grade, PartGrade
    from corollary.problem.bank import Bank, UnknownCode
    from corollary.problem.problem import Problem
    from corollary.problem.variant import OutOfRange
    from corollary.scenes.run import BadSetting, GuardFailed, Run

__all__ = [
    "BadSetting",
    "Bank",
    "Grade",
    "GuardFailed",
    "Key",
    "NotDerivable",
    "OutOfRange",
    "PartGrade",
    "Problem",
    "Run",
    "Solution",
    "Undefined",
    "UnknownCode",
    "UnknownPart",
    "Verdict",
    "__version__",
    "judge",
    "key",
    "load_bank",
    "play",
    "solve",
]

# Where each name lives. Loaded when it is first asked for, so that `import corollary` costs nothing.
_MODULES = {
    "corollary.api": ("UnknownPart", "judge", "key", "load_bank", "play", "solve"),
    "corollary.answers.verdict": ("Verdict",),
    "corollary.derive.load": ("NotDerivable",),
    "corollary.derive.solution": ("Solution",),
    "corollary.formula.ball": ("Undefined",),
    "corollary.grading.part_grades": ("Grade", "PartGrade"),
    "corollary.grading.key": ("Key",),
    "corollary.problem.bank": ("Bank", "UnknownCode"),
    "corollary.problem.problem": ("Problem",),
    "corollary.problem.variant": ("OutOfRange",),
    "corollary.scenes.run": ("BadSetting", "GuardFailed", "Run"),
}
_HOME = {name: module for module, names in _MODULES.items() for name in names}


def __getattr__(name: str) -> object:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = globals()[name] = getattr(import_module(_HOME[name]), name)
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
