"""The tolerances that a method is run with."""

from __future__ import annotations

TOLERANCES = tuple(10.0 ** (-0.75 * i) for i in range(3, 20))
"""From 6e-3 to 6e-15, three quarters of a power of ten apart."""

ONCE = (1e-15,)
"""A model that has no setting is run once."""
