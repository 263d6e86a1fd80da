"""Closed forms in every arithmetic: how fast a value comes, and how many last places it may be off."""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from corollary.derive.failing import NotDerivable
from corollary.mark.solutions import Solutions
from corollary.problem.bank import chapter_bank, load
from corollary.problem.draw import sample
from corollary.quantity.arithmetic.balls import certified_value
from corollary.quantity.arithmetic.double_double import double_double
from corollary.quantity.arithmetic.doubles import doubles, vectorised
from corollary.quantity.arithmetic.intervals import midpoint
from corollary.quantity.ball import Exactly, Undefined, certified
from corollary.quantity.tree import Name, Tree, names

LETTERS_AT_LEAST = 1
COPIES = 1000


@dataclass(frozen=True, slots=True)
class Formula:
    """One closed form, with the givens of some variants (exact, and as doubles) and the certified values there."""

    name: str
    tree: Tree
    exact: tuple[dict[str, Exactly], ...]
    near: tuple[dict[str, float], ...]
    true: tuple[float, ...]
