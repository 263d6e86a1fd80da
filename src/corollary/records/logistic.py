"""Logistic regression that has an answer for small classes too: Firth's penalty keeps it finite where all of one kind are right."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]

MOST_STEPS, LONGEST_STEP, SETTLED = 60, 2.0, 1e-8


@dataclass(frozen=True, slots=True)
class LogisticFit:
    """One coefficient a column, in logits for each unit of the column, and their standard errors."""

    coefficients: Numbers
    errors: Numbers


class NoFit(ArithmeticError):
    """The columns depend on each other, or the steps do not settle."""


def logistic_fit(columns: Numbers, right: Numbers) -> LogisticFit:
    """`columns` has a row for each answer (shape n × k, a column of ones among them), `right` is 0 or 1 for each.

    The estimate is Firth's (1993, doi:10.1093/biomet/80.1.27), as in Heinze and Schemper 2002 (doi:10.1002/sim.1047): the score
    is moved by half the leverages, which takes away the first order of the bias. Raises NoFit.
    """
    found = np.zeros(columns.shape[1])
    for _ in range(MOST_STEPS):
        chance, weighted, inverse = _information(columns, found)
        leverage = np.einsum("ij,jk,ik->i", weighted, inverse, columns)
        step = inverse @ (columns.T @ (right - chance + leverage * (0.5 - chance)))
        longest = float(np.abs(step).max())
        found = found + step * min(1.0, LONGEST_STEP / longest if longest else 1.0)
        if longest < SETTLED:
            return LogisticFit(found, np.sqrt(np.diag(inverse)))
    raise NoFit(f"the fit has not settled in {MOST_STEPS} steps")


def _information(columns: Numbers, at: Numbers) -> tuple[Numbers, Numbers, Numbers]:
    """The chance of each to be right, the columns by their weights, and the inverse of the information. Raises NoFit."""
    chance = 1 / (1 + np.exp(-np.clip(columns @ at, -35, 35)))
    weighted = columns * (chance * (1 - chance))[:, None]
    try:
        inverse = np.linalg.inv(weighted.T @ columns).astype(np.float64)
    except np.linalg.LinAlgError as error:
        raise NoFit("the columns depend on each other") from error
    if not np.all(np.isfinite(inverse)) or np.any(np.diag(inverse) <= 0):
        raise NoFit("the columns depend on each other")
    return chance, weighted, inverse
