"""Estimates and effects in words, for a terminal and for a page."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from corollary.render.wording import percent

if TYPE_CHECKING:  # which bring numpy
    from corollary.records.statistics import Estimate, FeatureEffect

TOO_FEW = "Too few answers to tell whether the numbers drawn made a difference."
EFFECTS = "Numbers drawn: effect on the odds, in logits for a standard deviation"


def between(each: Estimate) -> str:
    """The estimate and its interval."""
    return f"{each.value:.2f} ({each.low:.2f} to {each.high:.2f})"


def percent_between(each: Estimate) -> str:
    """The same of a share, in per cent."""
    return f"{percent(each.value)} ({percent(each.low)} to {percent(each.high)})"


def in_all(effects: Sequence[FeatureEffect]) -> str:
    """How many effects were looked for and found, and how many would have been missed."""
    if not effects:
        return TOO_FEW
    sure = sum(each.adjusted < 0.05 for each in effects)
    blind = sum(each.power < 0.8 for each in effects)
    return (
        f"{len(effects)} {'effect' if len(effects) == 1 else 'effects'} looked for, {sure} found at 5 % of all together; of {blind} half a logit would be missed"
        f" more than once in five times"
    )
