"""The unit that a mistyped one was likely meant to be; a word that is none (`times`, `lost`) suggests nothing."""

from __future__ import annotations

from functools import lru_cache

from corollary.formula.misspelt import one_apart
from corollary.units.table import ENGLISH, UNITS, UNSUGGESTED


def suggested(symbol: str) -> str:
    """A unit that was likely meant: the same letters in another case, or a name of one with one letter amiss; else ""."""
    low = _suggestions(len(UNITS))
    if symbol.lower() in low:
        return low[symbol.lower()]
    if not 4 <= len(symbol) < 20:
        return ""
    names = (name for name in ENGLISH if name in UNITS and one_apart(symbol.lower(), name))
    return min(names, key=lambda name: (len(name), name), default="")


@lru_cache(maxsize=1)
def _suggestions(units: int) -> dict[str, str]:
    """Units by their small letters, for as many as there are by now."""
    return {known.lower(): known for known in UNITS if known not in UNSUGGESTED and known[0] != "K"}
