"""What a number of answers tells of the truth behind them: an estimate, and the interval that holds the truth 95 times in 100."""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist
from typing import Final

import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.float64]

BOTH_SIDES: Final = NormalDist().inv_cdf(0.975)
LEAST_PAIRS: Final = 8  # of fewer pairs the interval of a correlation is a guess


@dataclass(frozen=True, slots=True)
class Estimate:
    """A value, and between what the truth is believed to be, at 95 %."""

    value: float
    low: float
    high: float


def share(count: int, of: int) -> Estimate:
    """`count` of `of` answers as a share, with the interval of Wilson 1927 (doi:10.1080/01621459.1927.10502953), which holds for
    few answers too. Raises ValueError where there are none."""
    if of <= 0:
        raise ValueError("a share of no answers is not defined")
    found, z2 = count / of, BOTH_SIDES**2
    middle = (found + z2 / (2 * of)) / (1 + z2 / of)
    reach = BOTH_SIDES / (1 + z2 / of) * math.sqrt(found * (1 - found) / of + z2 / (4 * of * of))
    return Estimate(found, max(0.0, min(found, middle - reach)), min(1.0, max(found, middle + reach)))


def correlation(first: Numbers, second: Numbers) -> Estimate | None:
    """Pearson's correlation of two arrays of one length; None for fewer than eight pairs, and where one of them is constant.

    The interval is made on Fisher's scale, artanh(r), with the standard error that the data themselves have (the influence of
    each pair, Devlin, Gnanadesikan and Kettenring 1975, doi:10.1093/biomet/62.3.531): neither needs to be normal, and one may be
    of zeros and ones.
    """
    if len(first) < LEAST_PAIRS or not np.ptp(first) or not np.ptp(second):
        return None
    x, y = _standardized(first), _standardized(second)
    r = float(np.mean(x * y))
    if 1 - abs(r) < 1e-12:
        return Estimate(r, r, r)
    influence = x * y - r * (x * x + y * y) / 2
    spread = float(influence.std(ddof=1)) / math.sqrt(len(x) - 3) / (1 - r * r)
    reach = BOTH_SIDES * spread
    return Estimate(r, math.tanh(math.atanh(r) - reach), math.tanh(math.atanh(r) + reach))


def _standardized(values: Numbers) -> Numbers:
    return (values - values.mean()) / values.std()
